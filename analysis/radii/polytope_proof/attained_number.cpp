#include "attained_number.hpp"

#include <subcert/analysis/symbol/polynomials/real_roots.hpp>

namespace subcert {

AttainedNumber scaled(const AttainedNumber& number, const Rational& factor) {
  const Rational scale = power(factor, static_cast<long>(number.length));
  std::vector<Rational> coefficients;
  for (long k = 0; k <= number.polynomial.highest(); ++k)
    coefficients.push_back(number.polynomial.coefficient(k) / power(scale, k));
  const LaurentPolynomial stretched(coefficients, 0);
  return {irreducible_factors(stretched).front().polynomial, scale * number.point, number.length};
}

RationalComplex value_at(const LaurentPolynomial& p, const RationalComplex& z) {
  RationalComplex value;
  for (long k = p.is_zero() ? -1 : p.highest(); k >= 0; --k) value = value * z + RationalComplex{p.coefficient(k), 0};
  return value;
}

}  // namespace subcert
