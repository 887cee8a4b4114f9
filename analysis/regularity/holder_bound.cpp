#include "holder_bound.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>

namespace subcert {

const HolderBound& HolderBounds::best() const {
  return *std::max_element(levels.begin(), levels.end(), [](const HolderBound& a, const HolderBound& b) {
    return *a.exponent.lower < *b.exponent.lower;
  });
}

HolderBounds holder_bounds(const Mask& mask, int levels, const Deadline& deadline) {
  require(is_affine(mask), "holder_bounds: need coset sums 1, got {}", mask.symbol().to_mask_text());
  const int rules = sum_rules(mask);
  const LevelNorms powers = level_norms(divided_difference_scheme(mask, rules), levels, deadline);
  HolderBounds result{rules, {}, powers.visited};
  for (std::size_t l = 0; l < powers.norms.size(); ++l) {
    const int level = static_cast<int>(l) + 1;
    const Enclosure logarithm = log_ratio(powers.norms[l], mask.arity());
    result.levels.push_back(
        {level, powers.norms[l], {rules - *logarithm.upper / level, rules - *logarithm.lower / level}});
  }
  return result;
}

}  // namespace subcert
