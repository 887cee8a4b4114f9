#include "level_masks.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert {

std::size_t LevelMasks::number_at(std::size_t level) const {
  if (level < first.size()) return level;
  require(!again.empty(), "levels: need a mask for level {}, got {}", level, first.size());
  return first.size() + (level - first.size()) % again.size();
}

Mask levels_as_one(const std::vector<Mask>& levels) {
  LaurentPolynomial symbol(1);
  int arity = 1;
  for (std::size_t k = levels.size(); k-- > 0;) {
    symbol *= levels[k].symbol().dilated(arity);
    arity *= levels[k].arity();
  }
  return Mask(symbol, arity);
}

}  // namespace subcert
