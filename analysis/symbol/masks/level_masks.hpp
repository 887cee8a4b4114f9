#pragma once
/// Masks that change from level to level.

#include "mask.hpp"

#include <vector>

namespace subcert {

/// f_{k+1} = S_k f_k with S_k by the masks of `first`, one for each level, and then by those of `again` in turn.
/// Canonical: a mask at least, all of one dilation; without `again` nothing is known of the levels after `first`.
struct LevelMasks {
  std::vector<LatticeMask> first = {};
  std::vector<LatticeMask> again = {};

  /// The number of the mask at a level, those of `first` before those of `again`. Errors: throws Error where there is
  /// none.
  std::size_t number_at(std::size_t level) const;
  const LatticeMask& at(std::size_t level) const { return mask(number_at(level)); }
  const LatticeMask& mask(std::size_t number) const {
    return number < first.size() ? first[number] : again[number - first.size()];
  }
};

/// a_(L-1)(z) a_(L-2)(z^a) ... a_0(z^(a^(L-1))): L levels as one, the coarsest first; of matrices, as those of an
/// equation, the product in the opposite order. Domain: one variable, one arity a, one number of components, a^L at
/// most 2^30. Errors: throws Error for none, and where all products of matrices are 0.
LatticeMask levels_as_one(const std::vector<LatticeMask>& levels);

}  // namespace subcert
