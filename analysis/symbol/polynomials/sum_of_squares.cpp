#include "sum_of_squares.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include "complex_roots.hpp"
#include "real_roots.hpp"

#include <algorithm>

namespace subcert {
namespace {

LaurentPolynomial autocorrelation(const LaurentPolynomial& p) { return p * p.reversed(); }

/// The zeros on the unit circle, half of each: they have even multiplicities, and their factors are their own reversals
/// up to a sign.
LaurentPolynomial half_of_zeros(const LaurentPolynomial& p) {
  LaurentPolynomial square(1);
  for (const auto& [factor, multiplicity] : irreducible_factors(p.shifted(-p.lowest())))
    if (factor.length() > 1 && has_root_on_unit_circle(factor)) square *= factor.pow(multiplicity / 2);
  return square;
}

/// q with q(z) q(1/z) nearly p, which is positive on the circle; nothing where the zeros are not told apart.
std::optional<LaurentPolynomial> spectral_factor(const LaurentPolynomial& p, int bits) {
  const slong precision = 2 * bits + 64;
  std::vector<ComplexBall> product{ComplexBall(Ball(1, precision))};
  long inside = 0;
  for (const ComplexBall& zero : complex_roots(p.shifted(-p.lowest()), precision)) {
    if (!abs(zero).is_less(Ball(1, precision))) continue;
    ++inside;
    product.push_back(ComplexBall(Ball(0, precision)));
    for (std::size_t k = product.size(); k-- > 0;)
      product[k] = (k > 0 ? product[k - 1] : ComplexBall(Ball(0, precision))) + zero * product[k] * Ball(-1, precision);
  }
  if (inside != p.highest()) return std::nullopt;
  Ball square(0, precision);
  for (const ComplexBall& c : product) square += c.real() * c.real();
  const Ball scale = sqrt(Ball(p.coefficient(0), precision) / square);
  const Rational unit = power(Rational(2), bits);
  std::vector<Rational> rounded;
  for (const ComplexBall& c : product) {
    const Enclosure value = (c.real() * scale).enclosure();
    if (!value.is_bounded()) return std::nullopt;
    rounded.push_back(Rational(to_integer(*value.lower * unit, Rounding::nearest)) / unit);
  }
  return LaurentPolynomial(rounded, 0);
}

}  // namespace

bool SumOfSquares::proves(const LaurentPolynomial& p) const {
  const auto rest = (p * LaurentPolynomial(Rational(p.denominator()))).exact_quotient(autocorrelation(square));
  if (!rest) return false;
  const LaurentPolynomial e = rest->shifted(-(rest->lowest() + rest->highest()) / 2) - autocorrelation(factor);
  Rational margin = e.coefficient(0);
  for (long k = 1; !e.is_zero() && k <= e.highest(); ++k) margin -= 2 * abs(e.coefficient(k));
  return margin >= 0;
}

std::optional<SumOfSquares> sum_of_squares(const LaurentPolynomial& p) {
  require(!p.is_zero() && p.reversed() == p, "sum_of_squares: need p(z) = p(1/z), not zero, got {}", p.to_text());
  SumOfSquares result{half_of_zeros(p), {}, 0};
  if (result.proves(p)) return result;
  const LaurentPolynomial h = *(p * LaurentPolynomial(Rational(p.denominator())))
                                   .exact_quotient(autocorrelation(result.square));
  const LaurentPolynomial centred = h.shifted(-(h.lowest() + h.highest()) / 2);
  // What is left is positive; the more nearly 0 it is somewhere, the more digits are needed.
  for (int digits = 8; digits <= 512; digits *= 2) {
    const Rational margin = centred.coefficient(0) * power(Rational(2), -digits);
    result.bits = digits + 24;
    const auto factor = spectral_factor(centred - LaurentPolynomial(margin), result.bits);
    if (!factor) continue;
    result.factor = *factor;
    if (result.proves(p)) return result;
  }
  return std::nullopt;
}

}  // namespace subcert
