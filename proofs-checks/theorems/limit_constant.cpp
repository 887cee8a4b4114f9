#include "limit_constant.hpp"

#include "kernel/kernel.hpp"

#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace subcert::theorems {
namespace {

void need(bool condition, const char* function, const char* inequality, long got) {
  require(condition, "{}: need {}, got {}", function, inequality, got);
}

/// Where to stop: the sum over k > terms of Phi(k pi)^2 is at most `tail`.
struct Truncation {
  long terms;
  Ball tail;
};

/// sup |Phi| on the real line, where |khat(s)| <= decay / s for s >= from. Ref: [LC, Lemma 4].
Ball supremum(const Kernel& kernel, const Rational& from, const Rational& decay) {
  const int d = kernel.degree();
  Rational reach = 2 * (from > decay ? from : decay);
  int halvings = 0;
  while (reach * reach > d + 2 || 2 * kernel.flatness() * power(reach, d + 1) > power(Rational(2), d + 1) - 1) {
    reach /= 2;
    ++halvings;
  }
  // The remaining factors give at most e^1.
  return exp(Ball(1, kernel.bits())) * sqrt(Ball(kernel.squared_bound(), kernel.bits())).pow(halvings);
}

/// The fewest terms for which the bound of [LC, Lemma 4] falls below 2^-wanted. Floating point searches for the
/// parameters; the returned tail is the bound itself, in balls.
Truncation truncation(const Kernel& kernel, double wanted) {
  const int d = kernel.degree();
  double best = std::numeric_limits<double>::infinity();
  Rational best_from, best_decay;
  int best_octaves = 0;
  for (int step = 2; step <= 16; ++step) {
    const Rational from = Rational(step * (d + 1), 2), decay = kernel.decay(from);
    const Ball bound = supremum(kernel, from, decay);
    const double log_bound = std::log2(bound.middle());
    const double log_ratio = std::log2(to_double(decay) / M_PI);
    for (int octaves = 1; octaves <= 60; ++octaves) {
      const double exponent = 2 * octaves - 1;
      const double log_terms = (wanted + 2 * log_bound + octaves * (octaves + 1.0) + 2 * octaves * log_ratio -
                                std::log2(exponent)) /
                               exponent;
      const double terms = std::max(std::exp2(std::min(log_terms, 60.0)), std::ldexp(to_double(from) / M_PI, octaves)) +
                           2;
      if (terms < best) {
        best = terms;
        best_from = from;
        best_decay = decay;
        best_octaves = octaves;
      }
    }
  }
  if (best > 1e7) fail(ErrorKind::size, "limit_constant: need at most 10^7 terms for these digits");
  const auto terms = static_cast<long>(best);
  const slong bits = kernel.bits();
  const Ball pi = Ball::pi(bits), factor = Ball(best_decay, bits) / pi / terms;
  if (!Ball(best_from, bits).scaled(best_octaves).is_at_most(pi * terms))
    throw std::logic_error("limit_constant: the truncation lies outside the domain of its bound");
  return {terms, supremum(kernel, best_from, best_decay).pow(2) *
                     factor.pow(2 * best_octaves).scaled(static_cast<slong>(best_octaves) * (best_octaves + 1)) *
                     terms / (2 * best_octaves - 1)};
}

/// 0 <= x <= bound.
Ball between_zero_and(const Ball& bound) { return bound.scaled(-1).widened(bound.scaled(-1)); }

Ball sum_of_squares(const Kernel& kernel, double wanted) {
  const Truncation stop = truncation(kernel, wanted);
  const slong bits = kernel.bits();
  const Ball pi = Ball::pi(bits);
  std::vector<Ball> values{Ball(1, bits)};
  Ball sum(Rational(1, 2), bits);
  for (long k = 1; k <= stop.terms; ++k) {
    const Ball half = pi * k / 2;
    Ball value = k % 2 == 0 ? kernel.transform(half) * values[static_cast<std::size_t>(k / 2)] : kernel.product(pi * k);
    sum += value.pow(2);
    if (2 * k <= stop.terms) values.push_back(std::move(value));
  }
  return (sum + between_zero_and(stop.tail)).scaled(-1);
}

Ball quadrature(Kernel& kernel, double wanted) {
  const Truncation stop = truncation(kernel, wanted);
  const slong bits = kernel.bits();
  const auto square_of_product = [&kernel](const ComplexBall& s) {
    const ComplexBall value = kernel.product(s.bits() > kernel.bits() ? ComplexBall(s.get(), kernel.bits()) : s);
    return value * value;
  };
  const ComplexBall end(Ball::pi(bits) * stop.terms);
  const ComplexBall integral = subcert::integral(square_of_product, ComplexBall(bits), end, static_cast<slong>(wanted),
                                                 bits);
  const Ball pi = Ball::pi(bits);
  return (integral.real() + between_zero_and(pi * stop.tail)) / pi.scaled(1);
}

void check_arguments(const char* function, int degree, int digits, int most_digits) {
  need(degree >= 0 && degree <= 99, function, "0 <= degree <= 99", degree);
  need(digits >= 1 && digits <= most_digits, function, most_digits == 60 ? "1 <= digits <= 60" : "1 <= digits <= 100",
       digits);
}

/// Raises the precision until the ball is narrow enough.
Enclosure to_digits(const char* function, int digits, const std::function<Ball(slong bits, double wanted)>& value) {
  const Rational width = power(Rational(10), -digits);
  const double wanted = digits * std::log2(10.0) + 4;
  for (slong extra = 40; extra <= 5120; extra *= 2) {
    Enclosure result = value(static_cast<slong>(wanted) + extra, wanted).enclosure();
    if (result.is_bounded() && *result.upper - *result.lower <= width) return result;
  }
  fail(ErrorKind::undecided, "{}: the balls did not become narrow enough", function);
}

}  // namespace

Rational kernel_moment(int degree, int order) {
  need(degree >= 0 && degree <= 99, "kernel_moment", "0 <= degree <= 99", degree);
  need(order >= 0 && order <= 1000, "kernel_moment", "0 <= order <= 1000", order);
  // The sum over q of (2q + 1/2) P_{2q}(0) times the moment of P_{2q}, which is
  // 2^(2q+1) order! ((order + 2q)/2)! / (((order - 2q)/2)! (order + 2q + 1)!).
  if (order % 2 == 1) return 0;
  Rational sum = 0, moment = Rational(2, order + 1);
  for (int q = 0; q <= degree / 2; ++q) {
    sum += Rational(4 * q + 1, 2) * (q % 2 == 0 ? central(q) : Rational(-central(q))) * moment;
    moment *= Rational(order - 2 * q) / (order + 2 * q + 3);
  }
  return sum;
}

Enclosure kernel_transform(int degree, const Rational& s, int digits) {
  check_arguments("kernel_transform", degree, digits, 100);
  require(absolute(s) <= 1'000'000, "kernel_transform: need |s| <= 10^6");
  return to_digits("kernel_transform", digits,
                   [&](slong bits, double) { return Kernel(degree, bits).transform(Ball(s, bits)); });
}

Enclosure limit_transform(int degree, const Rational& s, int digits) {
  check_arguments("limit_transform", degree, digits, 100);
  require(absolute(s) <= 1'000'000, "limit_transform: need |s| <= 10^6");
  return to_digits("limit_transform", digits,
                   [&](slong bits, double) { return Kernel(degree, bits).product(Ball(s, bits)); });
}

Enclosure limit_constant(int degree, int digits) {
  check_arguments("limit_constant", degree, digits, 100);
  return to_digits("limit_constant", digits,
                   [&](slong bits, double wanted) { return sum_of_squares(Kernel(degree, bits), wanted); });
}

Enclosure limit_constant_by_quadrature(int degree, int digits) {
  check_arguments("limit_constant_by_quadrature", degree, digits, 60);
  return to_digits("limit_constant_by_quadrature", digits, [&](slong bits, double wanted) {
    Kernel kernel(degree, bits);
    return quadrature(kernel, wanted);
  });
}

}  // namespace subcert::theorems
