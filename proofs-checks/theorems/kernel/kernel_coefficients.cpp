#include "kernel_coefficients.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert::theorems {
namespace {

/// A polynomial in tau, lowest coefficient first.
using TauPolynomial = std::vector<Rational>;

TauPolynomial product_of(const TauPolynomial& a, const TauPolynomial& b) {
  if (a.empty() || b.empty()) return {};
  TauPolynomial result(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) result[i + k] += a[i] * b[k];
  return result;
}

void add_to(TauPolynomial& a, const TauPolynomial& b, const Rational& factor) {
  if (a.size() < b.size()) a.resize(b.size(), 0);
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
}

/// b_l of the recurrence p_{l+1} = t p_l - b_l p_{l-1} of the monic polynomials that are orthogonal on the points x/M.
TauPolynomial recurrence(int l) {
  const Rational square = Rational(l) * l, size = 4 * square - 1;
  return {square / size, -square * square / size};
}

/// The coefficients of p_0, p_1, ... in the Legendre polynomials, and their values at t_0, odd ones divided by t_0.
struct Orthogonal {
  std::vector<std::vector<TauPolynomial>> p;
  std::vector<TauPolynomial> value, square;  ///< square: the mean of p_l^2 over the points, times the number of them
};

Orthogonal orthogonal_polynomials(int degree, const Rational& y) {
  Orthogonal result;
  for (int l = 0; l <= degree; ++l) {
    const auto size = static_cast<std::size_t>(l) + 1;
    std::vector<TauPolynomial> next(size);
    TauPolynomial value, square{1};
    if (l == 0) {
      next[0] = {1};
      value = {1};
    } else {
      // t P_k = ((k+1) P_{k+1} + k P_{k-1})/(2k+1).
      const auto& last = result.p.back();
      for (std::size_t k = 0; k < last.size(); ++k) {
        const auto number = static_cast<long>(k);
        add_to(next[k + 1], last[k], Rational(number + 1, 2 * number + 1));
        if (k > 0) add_to(next[k - 1], last[k], Rational(number, 2 * number + 1));
      }
      // t_0 times the last value: t_0^2 = y^2 tau.
      add_to(value, l % 2 == 1 ? result.value.back() : product_of({0, Rational(y * y)}, result.value.back()), 1);
      if (l > 1) {
        const TauPolynomial b = recurrence(l - 1);
        const auto& before = result.p[result.p.size() - 2];
        for (std::size_t k = 0; k < before.size(); ++k) add_to(next[k], product_of(b, before[k]), -1);
        add_to(value, product_of(b, result.value[result.value.size() - 2]), -1);
      }
      square = product_of(result.square.back(), recurrence(l));
    }
    result.p.push_back(std::move(next));
    result.value.push_back(std::move(value));
    result.square.push_back(std::move(square));
  }
  return result;
}

/// Of a function f of tau: f, (f - f(0))/tau, f'.
struct Three {
  Ball value, slope, derivative;
};

Three evaluate(const TauPolynomial& polynomial, const Ball& tau) {
  const slong bits = tau.bits();
  Three result{Ball(bits), Ball(bits), Ball(bits)};
  for (std::size_t i = polynomial.size(); i-- > 0;) {
    result.derivative = result.derivative * tau + result.value;
    if (i > 0) result.slope = result.slope * tau + Ball(polynomial[i], bits);
    result.value = result.value * tau + Ball(polynomial[i], bits);
  }
  return result;
}

Rational at_zero(const TauPolynomial& polynomial) { return polynomial.empty() ? Rational(0) : polynomial.front(); }

/// The sum of top_s/bottom_s.
Three sum_of_quotients(const std::vector<TauPolynomial>& top, const std::vector<const TauPolynomial*>& bottom,
                       const Ball& tau) {
  const slong bits = tau.bits();
  Three sum{Ball(bits), Ball(bits), Ball(bits)};
  for (std::size_t s = 0; s < top.size(); ++s) {
    const Three f = evaluate(top[s], tau), g = evaluate(*bottom[s], tau);
    const Ball start(Rational(at_zero(top[s]) / at_zero(*bottom[s])), bits);
    const Ball slope = (f.slope - start * g.slope) / g.value, value = start + tau * slope;
    sum.slope += slope;
    sum.value += value;
    sum.derivative += (f.derivative - value * g.derivative) / g.value;
  }
  return sum;
}

void join_into(std::vector<Ball>& list, std::size_t l, const Ball& value) {
  if (l < list.size())
    list[l] = join(list[l], value);
  else
    list.push_back(value);
}

/// Of the kernel the part with the l of one parity.
KernelCoefficients part(const Orthogonal& polynomials, int parity, const Rational& last, slong bits) {
  KernelCoefficients result;
  const std::size_t size = polynomials.p.size();
  constexpr int pieces = 16;
  for (int piece = 0; piece < pieces; ++piece) {
    const Ball tau = Ball::containing({Rational(last * piece / pieces), Rational(last * (piece + 1) / pieces)}, bits);
    for (std::size_t l = 0; l < size; ++l) {
      std::vector<TauPolynomial> top;
      std::vector<const TauPolynomial*> bottom;
      Rational limit = 0;
      for (std::size_t s = l; s < size && static_cast<int>(l % 2) == parity; s += 2) {
        top.push_back(product_of(polynomials.value[s], polynomials.p[s][l]));
        bottom.push_back(&polynomials.square[s]);
        limit += at_zero(top.back()) / at_zero(*bottom.back());
      }
      const Three three = sum_of_quotients(top, bottom, tau);
      if (piece == 0) result.limit.push_back(limit);
      join_into(result.value, l, three.value);
      join_into(result.slope, l, three.slope);
      join_into(result.derivative, l, three.derivative);
    }
  }
  return result;
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

KernelParts kernel_parts(int degree, const Rational& y, const Rational& last, slong bits) {
  require(degree >= 0 && last * degree * degree < 1, "kernel_parts: need 0 <= degree and last < 1/degree^2");
  const Orthogonal polynomials = orthogonal_polynomials(degree, y);
  return {part(polynomials, 0, last, bits), part(polynomials, 1, last, bits)};
}

}  // namespace subcert::theorems
