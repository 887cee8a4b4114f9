#pragma once
/// Certified extremes and the sign of basic limit functions of several variables.

#include "limit_range.hpp"

namespace subcert {

/// An enclosure of the extreme value, and the point where phi has the end that faces 0; none where that is 0, outside
/// the support.
struct AttainedExtreme {
  Enclosure value;
  std::vector<Rational> point;
};

/// phi over R^s: maximum, minimum (0 or below), and whether phi >= 0 everywhere; `no` names a point.
struct MultivariateLimitRange {
  AttainedExtreme maximum;
  AttainedExtreme minimum;
  Decision nonnegative;
  bool complete = false;    ///< both widths are as asked for; else time, memory or precision ran out
  std::uint64_t cells = 0;  ///< cells looked at
};

/// Branch and bound over the tiles M^-n (i + Gamma) of a set of digits, in exact arithmetic. Domain: a scheme that
/// converges, with any dilation. Error: widths at most relative_width times the largest |phi| where `complete`. Errors:
/// throws Error, as limit_values of several variables. Cost: a few hundred cells a level where phi is C^1 with sum
/// rules of order 2 and its extremes are isolated, each with a sparse product. Proof: docs/surfaces.md.
MultivariateLimitRange limit_range(const LatticeMask& mask, const LimitOptions& options = {});

}  // namespace subcert
