#pragma once
/// Lower bounds for the Hoelder exponent from norms of the difference scheme.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstdint>

namespace subcert {

/// The bound after L levels: with m sum rules, b = the divided difference scheme of order m and N = ||S_b^L||, the
/// limits have Hoelder exponent at least m - log_arity(N) / L, wherever that is positive. `norm` is N, exact;
/// `exponent` encloses the bound, to 1e-20 or better.
struct HolderBound {
  int levels;
  Rational norm;
  Enclosure exponent;
};

/// What a norm of this level proves. Domain: norm > 0.
HolderBound holder_bound(int level, const Rational& norm, int sum_rules, int arity);

struct HolderBounds {
  int sum_rules = 0;
  /// One for each of the levels 1, 2, ... that were finished within the time.
  std::vector<HolderBound> levels;
  std::uint64_t visited = 0;
  /// Domain of both: at least one level.
  const HolderBound& last() const { return levels.back(); }
  /// The largest of all levels; the bounds need not grow with the level.
  const HolderBound& best() const;
};

/// Domain: coset sums 1 (so at least one sum rule), levels >= 1. The first level is always finished. Errors: throws
/// Error. Cost: that of level_norms. Ref: [DL02, sec. 4.2], [Rio92].
HolderBounds holder_bounds(const Mask& mask, int levels, const Deadline& deadline = {});

}  // namespace subcert
