
#include "classical.hpp"

#include "local_regression.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>

namespace subcert {
Mask bspline_mask(int degree, int arity) {
  require(degree >= 1, "bspline_mask: need degree >= 1, got {}", degree);
  require(arity >= 2, "bspline_mask: need arity >= 2, got {}", arity);
  const LaurentPolynomial power_of_ones = LaurentPolynomial::all_ones(arity).pow(degree + 1);
  return {(power_of_ones * LaurentPolynomial(power(Rational(arity), -degree))).shifted(-(power_of_ones.length() / 2)),
          arity};
}

Mask deslauriers_dubuc_mask(int n, int arity) {
  require(n >= 1, "deslauriers_dubuc_mask: need n >= 1, got {}", n);
  require(arity >= 2, "deslauriers_dubuc_mask: need arity >= 2, got {}", arity);
  LocalRegression scheme{{{0, 0, 0}}, 2 * n - 1};
  for (int k = 1; k < arity; ++k) scheme.rules.push_back({-n + 1, n, Rational(k, arity)});
  return regression_mask(scheme);
}

Mask pseudo_spline_mask(const Rational& m, int l) {
  const Rational twice = 2 * m;
  require(denominator(twice) == 1 && 0 <= l && l < m,
          "pseudo_spline_mask: need 2m whole and 0 <= l < m, got m = {}, l = {}", to_text(m), l);
  // cos^2 and sin^2 of half the angle.
  const LaurentPolynomial cosine({Rational(1, 4), Rational(1, 2), Rational(1, 4)}, -1),
      sine({Rational(-1, 4), Rational(1, 2), Rational(-1, 4)}, -1);
  LaurentPolynomial sum;
  Rational binomial = 1;
  for (int j = 0; j <= l; ++j) {
    sum += LaurentPolynomial(binomial) * sine.pow(j) * cosine.pow(l - j);
    binomial *= (m + l - j) / (j + 1);
  }
  const int orders = numerator(twice).convert_to<int>();
  const LaurentPolynomial smoothing = LaurentPolynomial({Rational(1, 2), Rational(1, 2)}, 0).pow(orders);
  return {LaurentPolynomial(2) * smoothing.shifted(-(orders + 1) / 2) * sum, 2};
}

Mask four_point_mask(const Rational& w) { return classical_families().front().mask().at(w); }

const std::vector<ClassicalFamily>& classical_families() {
  const auto family = [](std::string name, std::string title, std::string example,
                         std::vector<std::string> coefficients, int arity) {
    struct Made {
      std::once_flag once;
      std::optional<ParametricMask> mask;
    };
    return ClassicalFamily{
        std::move(name), std::move(title), std::move(example),
        [coefficients = std::move(coefficients), arity, made = std::make_shared<Made>()]() -> const ParametricMask& {
          std::call_once(made->once, [&] {
            std::vector<RationalFunction> functions;
            for (const std::string& coefficient : coefficients)
              functions.push_back(RationalFunction::parse(coefficient, "w"));
            made->mask = ParametricMask(functions, -static_cast<long>(functions.size() / 2), arity);
          });
          return *made->mask;
        }};
  };
  const auto exponential_six_point = [&] {
    const std::string a = "(1+2*w)*(1+2*w+2*w^2)*(4*w^2+2*w-1)/(32*w^3*(1+w)^2)",
                      b = "-(1+4*w)*(4*w^2+2*w-1)/(64*w^3*(1+w)^2)", c = "(1+2*w)/(64*w^3*(1+w)^2)";
    return family("exponential-six-point",
                  "interpolatory 6-point scheme for 1, x, cos(tx) and x cos(tx) with w = cos t", "1/2",
                  {c, "0", b, "0", a, "1", a, "0", b, "0", c}, 2);
  };
  static const std::vector<ClassicalFamily> all{
      family("four-point", "4-point scheme with tension", "1/16", {"-w", "0", "1/2+w", "1", "1/2+w", "0", "-w"}, 2),
      family("six-point", "interpolatory 6-point scheme with the parameter", "1/100",
             {"w", "0", "-1/16-3*w", "0", "9/16+2*w", "1", "9/16+2*w", "0", "-1/16-3*w", "0", "w"}, 2),
      family("dual-four-point", "dual 4-point scheme with tension", "1/128",
             {"-5*w", "-7*w", "1/4+3*w", "3/4+9*w", "3/4+9*w", "1/4+3*w", "-7*w", "-5*w"}, 2),
      family("j-spline", "J-spline with the parameter", "3/2",
             {"-1/16+1/16*w", "1/8*w", "9/16-1/16*w", "1-1/4*w", "9/16-1/16*w", "1/8*w", "-1/16+1/16*w"}, 2),
      family("corner-cutting", "corner cutting with the ratio", "1/4", {"w", "1-w", "1-w", "w"}, 2),
      family("ternary-three-point", "ternary interpolatory 3-point scheme with the parameter", "5/18",
             {"-1/3+w", "0", "w", "4/3-2*w", "1", "4/3-2*w", "w", "0", "-1/3+w"}, 3),
      family("ternary-four-point", "ternary interpolatory 4-point scheme with the parameter", "1/11",
             {"-1/18+1/6*w", "-1/18-1/6*w", "0", "7/18-1/2*w", "13/18+1/2*w", "1", "13/18+1/2*w", "7/18-1/2*w", "0",
              "-1/18-1/6*w", "-1/18+1/6*w"},
             3),
      family(
          "conic-four-point", "interpolatory 4-point scheme for conics with w = cos t", "1/2",
          {"-1/(8*w+8*w^2)", "0", "(1+4*w+4*w^2)/(8*w+8*w^2)", "1", "(1+4*w+4*w^2)/(8*w+8*w^2)", "0", "-1/(8*w+8*w^2)"},
          2),
      exponential_six_point(),
      family("exponential-bspline", "exponential B-spline of order 4 with w = cos t", "1/2",
             {"1/(4+4*w)", "1/2", "(1+2*w)/(2+2*w)", "1/2", "1/(4+4*w)"}, 2)};
  return all;
}

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
    rounded.push_back(to_multiple(*enclosure.lower, unit, Rounding::nearest));
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
