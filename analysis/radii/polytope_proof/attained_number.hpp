#pragma once
/// What number a radius is that products attain.

#include <subcert/analysis/symbol/numbers/rational_complex.hpp>
#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>

namespace subcert {

/// The number |z|^(1/length), z the zero of the polynomial next to the point. Canonical: the polynomial is irreducible,
/// with integer coefficients and lowest exponent 0; the point is nearer to z than to any other zero, real if z is, and
/// z itself if that is rational.
struct AttainedNumber {
  LaurentPolynomial polynomial;
  RationalComplex point;
  std::size_t length = 1;
};

/// factor times the number. Domain: factor > 0.
AttainedNumber scaled(const AttainedNumber& number, const Rational& factor);

/// p(z). Domain: no negative exponents.
RationalComplex value_at(const LaurentPolynomial& p, const RationalComplex& z);

}  // namespace subcert
