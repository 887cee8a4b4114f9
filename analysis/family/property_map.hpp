#pragma once
/// For which values of two parameters a scheme has a property, with proof.

#include "property_range.hpp"

#include <array>

namespace subcert {

/// Closed.
struct Rectangle {
  std::array<Rational, 2> low, high;  ///< of v and of w
};

/// On all of a rectangle the property holds (yes), for none of its values (no), or neither is proved.
struct MapCell {
  Rectangle rectangle;
  Truth holds = Truth::unknown;
  std::string reason = {};  ///< why it is not decided
};

struct PropertyMap {
  int sum_rules = 0;           ///< that hold for all values
  std::vector<MapCell> cells;  ///< they cover the rectangle that was asked for, and have no inner point in common
  bool complete = true;        ///< all cells that are not decided are as small as they may be

  /// The share of the area with this answer.
  Rational share(Truth holds) const;
};

struct MapOptions {
  int resolution = 64;  ///< cells along each side, at most; rounded up to a power of 2
  int jobs = 1;
  Budget budget{Deadline::in(60)};
};

/// Decides a property over a rectangle by cells that are quartered: proved by the joint spectral radius of the control
/// matrices of a cell, refuted by an eigenvalue of one product that is too large all over the cell, and by the
/// stability of the shifts. Domain: coset sums 1 for all values; `convergent`, and `smooth` or `holder` with an order
/// below the number of sum rules; 1 <= resolution <= 1024; arity * (degree in v + 1) * (degree in w + 1) at most 64.
/// Errors: throws Error. Error: none; what is not decided is left `unknown`. Cost: one joint spectral radius for each
/// cell. Ref: docs/families.md.
PropertyMap property_map(const BiparametricMask& mask, const RangeProperty& property, const Rectangle& rectangle,
                         const MapOptions& options);

}  // namespace subcert
