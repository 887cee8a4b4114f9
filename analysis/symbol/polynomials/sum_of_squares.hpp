#pragma once
/// Proofs that a Laurent polynomial is not negative on the unit circle.

#include "laurent_polynomial.hpp"

#include <optional>

namespace subcert {

/// d p(z) = square(z) square(1/z) h(z), d the denominator of p, and |e_1| + |e_2| + ... <= e_0/2 for the coefficients
/// of e(z) = h(z) - factor(z) factor(1/z): so p is a sum of squares.
struct SumOfSquares {
  LaurentPolynomial square;  ///< integer coefficients without a common factor, lowest exponent 0
  LaurentPolynomial factor;  ///< coefficients that are integers over 2^bits, lowest exponent 0 or zero
  int bits = 0;

  bool proves(const LaurentPolynomial& p) const;
};

/// Domain: p(z) = p(1/z), not zero, p >= 0 on the unit circle. Errors: nothing where p has values near 0 but not 0,
/// below 2^-500 of the largest. Cost: a factorisation, and the zeros of p. Ref: Fejer and Riesz; the zeros of p - delta
/// inside the circle make `factor`.
std::optional<SumOfSquares> sum_of_squares(const LaurentPolynomial& p);

}  // namespace subcert
