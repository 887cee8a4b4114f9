#pragma once
/// Masks near coefficients that were rounded.

#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>

#include <optional>
#include <vector>

namespace subcert {

/// The mask with so many sum rules that is next to the coefficients times `factor`, up to rounding far below the
/// accuracy; no coefficient was changed by more than `change`.
struct NearbyMask {
  LaurentPolynomial symbol;
  int sum_rules;
  Rational factor, change;
};

/// With as many sum rules as masks have that differ by no more than `accuracy` times the factor, one at least. The
/// factor is 1 where the sum is the arity, up to the errors of all coefficients; where it is 1 or the root of the
/// arity, as filters are printed, it makes it the arity. Nothing where it is none of these, or no mask is so near.
/// Domain: at least arity coefficients, the first of index `first`; accuracy > 0. Error: next in the sum of squares.
/// Cost: a linear system for each order.
std::optional<NearbyMask> nearby_mask(const std::vector<Rational>& coefficients, long first, int arity,
                                      const Rational& accuracy);

}  // namespace subcert
