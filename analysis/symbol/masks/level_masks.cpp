#include "level_masks.hpp"

#include "matrix_masks.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert {

std::size_t LevelMasks::number_at(std::size_t level) const {
  if (level < first.size()) return level;
  require(!again.empty(), "levels: need a mask for level {}, got {}", level, first.size());
  return first.size() + (level - first.size()) % again.size();
}

LatticeMask levels_as_one(const std::vector<LatticeMask>& levels) {
  require(!levels.empty(), "levels: need a mask, got none");
  if (levels.front().components() == 1) {
    LaurentPolynomial symbol(1);
    int arity = 1;
    for (std::size_t k = levels.size(); k-- > 0;) {
      symbol *= levels[k].curve().symbol().dilated(arity);
      arity *= levels[k].arity();
    }
    return Mask(symbol, arity);
  }
  LatticeMask result = levels.front();
  int arity = result.arity();
  for (std::size_t k = 1; k < levels.size(); ++k) {
    const LatticeMask& next = levels[k];
    arity *= next.arity();
    std::vector<LatticeMask::Term> terms;
    for (const LatticeMask::Term& before : result.terms())
      for (const LatticeMask::Term& after : next.terms())
        if (before.column == after.row)
          terms.push_back({{next.arity() * before.exponents[0] + after.exponents[0]},
                           before.row,
                           after.column,
                           before.coefficient * after.coefficient});
    result = matrix_mask(terms, result.components(), Dilation::multiple(1, arity));
  }
  return result;
}

}  // namespace subcert
