#pragma once
/// For which values of several parameters a scheme has a property, with proof.

#include "property_range.hpp"

#include <subcert/analysis/symbol/polynomials/box.hpp>

namespace subcert {

/// On all of a box the property holds (yes), for none of its values (no), or neither is proved.
struct MapCell {
  Box box;
  Truth holds = Truth::unknown;
  std::string reason = {};  ///< why it is not decided
};

struct PropertyMap {
  int sum_rules = 0;           ///< that hold for all values
  std::vector<MapCell> cells;  ///< they cover the box that was asked for, and have no inner point in common
  bool complete = true;        ///< all cells that are not decided are as small as they may be

  /// The share of the area, or volume, with this answer.
  Rational share(Truth holds) const;
};

struct MapOptions {
  int resolution = 64;  ///< cells along each side, at most; rounded up to a power of 2
  int jobs = 1;
  Budget budget{Deadline::in(60)};
};

/// Decides a property over a box of two or three letters by cells that are halved in each of them: proved by the joint
/// spectral radius of the control matrices of a cell, refuted by an eigenvalue of one product that is too large all
/// over the cell, and by the stability of the shifts. Domain: coset sums 1 for all values, or a mask of matrices; as
/// many letters as the mask has; `convergent`, and `smooth`, `holder` or, of matrices, `hermite` with an order below
/// the number of sum rules; 1 <= resolution <= 1024; arity * (degree in the first letter + 1) * (degree in the second +
/// 1) ... at most 64. Errors: throws Error. Error: none; what is not decided, as where a denominator may vanish, is
/// left `unknown`. Cost: one joint spectral radius for each cell. Ref: docs/families.md.
PropertyMap property_map(const ParametricMask& mask, const RangeProperty& property, const Box& box,
                         const MapOptions& options);

}  // namespace subcert
