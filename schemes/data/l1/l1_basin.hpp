#pragma once
/// Where the reweighted fits of a window are so near to least squares that their limits are as smooth.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <optional>

namespace subcert::data {

/// Let q = degree + 1, S the rule with any number of fits and delta > 0, L that of least squares, |D^q f| the supremum
/// of the q-th differences. If |D^q f| <= radius * sqrt(delta), then |D^q S f| <= contraction * |D^q f| and
/// |S f - L f| <= error * |D^q f|^3 / delta.
struct L1Basin {
  Rational linear;       ///< |D^q L f| <= linear * |D^q f|, and for some f not less
  Rational residual;     ///< of all fits: at most residual * |D^q f|
  Rational radius;       ///< rounded down to three decimals
  Rational contraction;  ///< below 1
  Rational error;
};

/// Nothing where least squares does not contract q-th differences in one step. Domain: 0 <= degree <= 3, degree + 2 <=
/// points <= degree + 17, arity >= 2. Errors: throws a domain error. Cost: 2^(points - degree - 1) products of a
/// vector. Ref: docs/l1.md, section 10.
std::optional<L1Basin> l1_basin(int points, int degree, int arity = 2);

}  // namespace subcert::data
