#include "kernel_coefficients.hpp"

#include <subcert/analysis/symbol/ball_solvers.hpp>
#include <subcert/analysis/symbol/error.hpp>

namespace subcert::theorems {
namespace {

/// The sum of x^2l over the points of one rule, divided by M^(2l+1), as a polynomial in tau = 1/M^2.
std::vector<Rational> power_sum(int l) {
  const std::vector<Rational> beta = reciprocal_sinc(l + 1);
  std::vector<Rational> result;
  for (int i = 0; i <= l; ++i) {
    Rational ratio = 1;  // (2l)! / (2(l-i)+1)!
    for (int k = 2 * (l - i) + 2; k <= 2 * l; ++k) ratio *= k;
    if (i == 0) ratio /= 2 * l + 1;
    result.push_back(beta[static_cast<std::size_t>(i)] * ratio);
  }
  return result;
}

/// Of a polynomial: its value, (value - value at 0) / tau, its derivative.
struct Three {
  Ball value, slope, derivative;
};

Three evaluate(const std::vector<Rational>& polynomial, const Ball& tau) {
  const slong bits = tau.bits();
  Three result{Ball(bits), Ball(bits), Ball(bits)};
  for (std::size_t i = polynomial.size(); i-- > 0;) {
    result.derivative = result.derivative * tau + result.value;
    if (i > 0) result.slope = result.slope * tau + Ball(polynomial[i], bits);
    result.value = result.value * tau + Ball(polynomial[i], bits);
  }
  return result;
}

std::vector<Ball> solved(const std::vector<std::vector<Ball>>& matrix, const std::vector<Ball>& right, slong bits) {
  const auto result = solve(matrix, right, bits);
  if (!result) fail(ErrorKind::undecided, "kernel_coefficients: the moment system is not proved regular");
  return *result;
}

/// kappa(0): k_d(t) is half the sum of kappa_q(0) t^2q.
std::vector<Rational> limit_coefficients(std::size_t size) {
  std::vector<Rational> result;
  for (std::size_t q = 0; q < size; ++q) {
    Rational sum = 0;  // (4h+1) P_2h(0) times the coefficient of t^2q in P_2h
    for (std::size_t h = q; h < size; ++h) {
      const int l = 2 * static_cast<int>(h), k = static_cast<int>(h - q);
      Rational term = (2 * l + 1) * binomial(l, l / 2) * binomial(l, k) * binomial(2 * l - 2 * k, l) /
                      power(Rational(4), l);
      sum += (h + static_cast<std::size_t>(k)) % 2 == 0 ? term : Rational(-term);
    }
    result.push_back(sum);
  }
  return result;
}

/// slope and derivative for tau in [low, high].
std::pair<std::vector<Ball>, std::vector<Ball>> slopes(const std::vector<Rational>& limit, const Rational& low,
                                                       const Rational& high, slong bits) {
  const std::size_t size = limit.size();
  const Ball tau = Ball::containing({low, high}, bits);
  std::vector<std::vector<Ball>> moments(size);
  std::vector<std::vector<Three>> entries(size);
  for (std::size_t p = 0; p < size; ++p)
    for (std::size_t q = 0; q < size; ++q) {
      entries[p].push_back(evaluate(power_sum(static_cast<int>(p + q)), tau));
      moments[p].push_back(entries[p].back().value);
    }
  std::vector<Ball> right(size, Ball(bits));
  for (std::size_t p = 0; p < size; ++p)
    for (std::size_t q = 0; q < size; ++q) right[p] = right[p] - entries[p][q].slope * Ball(limit[q], bits);
  const std::vector<Ball> slope = solved(moments, right, bits);
  right.assign(size, Ball(bits));
  for (std::size_t p = 0; p < size; ++p)
    for (std::size_t q = 0; q < size; ++q)
      right[p] = right[p] - entries[p][q].derivative * (Ball(limit[q], bits) + tau * slope[q]);
  return {slope, solved(moments, right, bits)};
}

}  // namespace

Rational binomial(int n, int k) {
  Rational result = 1;
  for (int i = 1; i <= k; ++i) result *= Rational(n - k + i, i);
  return result;
}

std::vector<Rational> reciprocal_sinc(int count) {
  std::vector<Rational> sinh{1}, result{1};
  for (int i = 1; i < count; ++i) {
    sinh.push_back(sinh.back() / ((2 * i) * (2 * i + 1)));
    Rational sum = 0;
    for (int k = 1; k <= i; ++k) sum -= sinh[static_cast<std::size_t>(k)] * result[static_cast<std::size_t>(i - k)];
    result.push_back(sum);
  }
  return result;
}

KernelCoefficients kernel_coefficients(int degree, const Rational& last, slong bits) {
  const auto size = static_cast<std::size_t>(degree + 1) / 2;
  KernelCoefficients result{limit_coefficients(size), {}, {}, {}};
  constexpr int pieces = 16;
  for (int i = 0; i < pieces; ++i) {
    const auto [slope, derivative] = slopes(result.limit, last * i / pieces, last * (i + 1) / pieces, bits);
    if (i == 0) {
      result.slope = slope;
      result.derivative = derivative;
    }
    for (std::size_t q = 0; q < size; ++q) {
      result.slope[q] = join(result.slope[q], slope[q]);
      result.derivative[q] = join(result.derivative[q], derivative[q]);
    }
  }
  const Ball tau = Ball::containing({Rational(0), last}, bits);
  for (std::size_t q = 0; q < size; ++q) result.value.push_back(Ball(result.limit[q], bits) + tau * result.slope[q]);
  return result;
}

}  // namespace subcert::theorems
