// What the coefficients of a mask say of its limits on a unit square, as hulls: section 5.11 of
// ../../certificates/SPEC.md.
#pragma once

#include "../scheme.hpp"
#include "dilation.hpp"

#include <map>
#include <set>

namespace subcert_check {

/// A mask of two variables, its dilation m times the unit matrix.
struct LatticeMask {
  std::int64_t arity = 2;
  std::map<Point, mpz_class> coefficients;  // none 0
  mpz_class denominator = 1;

  mpz_class at(const Point& k) const;
  /// The data that limits on the square from 0 to 1 depend on.
  std::set<Point> window() const;
  /// m a / (1 + z^e + ... + z^((m-1)e)), e the unit vector of the axis. Rejects one with a negative coefficient, or
  /// where the coefficients of a class do not sum to 1.
  LatticeMask of_differences(std::size_t axis) const;
};

/// Rejects a mask or a dilation of another kind.
LatticeMask lattice_mask(const Mask& mask, const Dilation& dilation);

}  // namespace subcert_check
