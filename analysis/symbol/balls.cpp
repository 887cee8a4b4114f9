#include "balls.hpp"

#include "rational_matrix.hpp"

#include <cstdlib>

namespace subcert {

Enclosure Ball::enclosure(slong bits) const {
  if (!arb_is_finite(value_)) return {};
  arf_t low, high;
  arf_init(low);
  arf_init(high);
  arb_get_interval_arf(low, high, value_, bits);
  Enclosure result{flint::to_rational(low), flint::to_rational(high)};
  arf_clear(low);
  arf_clear(high);
  return result;
}

RationalComplex exact_middle(const ComplexBall& a) {
  return {flint::to_rational(arb_midref(acb_realref(a.get()))), flint::to_rational(arb_midref(acb_imagref(a.get())))};
}

ComplexBall ball_around(const RationalComplex& value, slong bits) {
  ComplexBall result(bits);
  acb_set_arb_arb(result.get(), Ball(value.re, bits).get(), Ball(value.im, bits).get());
  return result;
}

ComplexBall value_at(const LaurentPolynomial& p, const ComplexBall& z) {
  ComplexBall result(z.bits());
  arb_fmpz_poly_evaluate_acb(result.get(), flint::IntegerPolynomial(p).get(), z.get(), z.bits());
  for (long k = 0; k < p.lowest(); ++k) result *= z;
  acb_div_fmpz(result.get(), result.get(), flint::Whole(p.denominator()).get(), z.bits());
  return result;
}

namespace {

/// p(2^exponent z) up to a power of z and a factor.
LaurentPolynomial stretched(const LaurentPolynomial& p, long exponent) {
  std::vector<Rational> coefficients;
  for (long k = p.lowest(); k <= p.highest(); ++k)
    coefficients.push_back(p.coefficient(k) * power(Rational(2), exponent * (k - p.lowest())));
  return {coefficients, 0};
}

}  // namespace

std::vector<ComplexBall> complex_roots(const LaurentPolynomial& p, slong bits) {
  const slong count = p.length() - 1;
  if (count == 0) return {};
  // Zeros that are about as large as 1 are found fast.
  constexpr long near_enough = 32;
  const long size = (binary_exponent(p.coefficient(p.lowest())) - binary_exponent(p.coefficient(p.highest()))) / count;
  std::vector<ComplexBall> result;
  if (std::abs(size) > near_enough) {
    for (const ComplexBall& zero : complex_roots(stretched(p, size), bits)) result.push_back(zero.scaled(size));
    return result;
  }
  const flint::IntegerPolynomial polynomial(p);
  acb_ptr roots = _acb_vec_init(count);
  arb_fmpz_poly_complex_roots(roots, polynomial.get(), 0, bits);
  for (slong i = 0; i < count; ++i) result.emplace_back(roots + i, bits);
  _acb_vec_clear(roots, count);
  return result;
}

}  // namespace subcert
