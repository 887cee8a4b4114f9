#include "daubechies.hpp"

#include <subcert/analysis/symbol/balls.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/rational_matrix.hpp>

#include <algorithm>

namespace subcert {
namespace {

const LaurentPolynomial& half_sum() {
  static const LaurentPolynomial value({Rational(1, 2), Rational(1, 2)}, 0);
  return value;
}

/// sum over k < n of binomial(n-1+k, k) s^k with s = sin^2 of half the angle.
LaurentPolynomial completing_factor(int n) {
  const LaurentPolynomial sine({Rational(-1, 4), Rational(1, 2), Rational(-1, 4)}, -1);
  LaurentPolynomial sum, power = 1;
  Rational binomial = 1;
  for (int k = 0; k < n; ++k) {
    sum += LaurentPolynomial(binomial) * power;
    power *= sine;
    binomial *= Rational(n + k, k + 1);
  }
  return sum;
}

}  // namespace

RoundedMask daubechies_mask(int n) {
  require(n >= 1 && n <= 40, "daubechies_mask: need 1 <= n <= 40, got {}", n);
  const long bits = 200 + 100L * n;
  const slong precision = 2 * bits;
  // 2 q(z), from the zeros inside of the unit circle.
  std::vector<ComplexBall> q{ComplexBall(Ball(2, precision))};
  int inside = 0;
  const LaurentPolynomial square = completing_factor(n).shifted(n - 1);
  const Ball one(1, precision);
  for (const ComplexBall& zero : n == 1 ? std::vector<ComplexBall>{} : complex_roots(square, precision)) {
    if (!(zero.magnitude() < 1)) continue;
    ++inside;
    const ComplexBall unit = ComplexBall(one) / (ComplexBall(one) - zero);
    q.emplace_back(precision);
    for (std::size_t i = q.size(); i-- > 0;) q[i] = (i > 0 ? q[i] - zero * q[i - 1] : q[i]) * unit;
  }
  require(inside == n - 1, "daubechies_mask: need {} zeros inside of the unit circle, got {}", n - 1, inside);
  std::vector<Rational> rounded;
  Rational distance = 0, sum = 0;
  const Rational unit = power(Rational(2), -bits);
  for (const ComplexBall& c : q) {
    const Enclosure enclosure = c.real().enclosure();
    rounded.push_back(unit * Rational(to_integer(*enclosure.lower / unit, Rounding::nearest)));
    sum += rounded.back();
    distance = std::max({distance, abs(*enclosure.lower - rounded.back()), abs(*enclosure.upper - rounded.back())});
  }
  // The sum is 2 again; the other factor has a sum of 1, so that the mask is not further away than 2 q.
  rounded.front() += 2 - sum;
  distance += abs(2 - sum);
  distance = n == 1 ? Rational(0) : power(Rational(2), binary_exponent(distance) + 1);
  return {{half_sum().pow(n) * LaurentPolynomial(rounded, 0), 2}, {distance, n}};
}

Mask dual_spline_mask(int n, int m) {
  require(n >= 1 && m >= 1 && (n + m) % 2 == 0, "dual_spline_mask: need n, m >= 1 with an even sum, got {} and {}", n,
          m);
  const LaurentPolynomial symbol = LaurentPolynomial(2) * half_sum().pow(m) * completing_factor((n + m) / 2);
  return {symbol.shifted(-(m / 2)), 2};
}

}  // namespace subcert
