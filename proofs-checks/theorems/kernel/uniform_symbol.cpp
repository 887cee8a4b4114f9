#include "uniform_symbol.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace subcert::theorems {
namespace {

/// b^(r)(w), r < count, for b(w) = w / sin w and 0 < w < pi.
std::vector<Ball> derivatives_of_b(const Ball& w, int count) {
  std::vector<Ball> sine, b;
  Ball factorial(1, w.bits());
  const Ball s = sin(w), c = cos(w);
  for (int k = 0; k < count; ++k) {
    if (k > 0) factorial = factorial * k;
    const Ball& wave = k % 2 == 0 ? s : c;
    sine.push_back((k % 4 < 2 ? wave : -wave) / factorial);
    Ball rest = k == 0 ? w : Ball(k == 1 ? 1 : 0, w.bits());
    for (int i = 1; i <= k; ++i) rest = rest - sine[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(k - i)];
    b.push_back(rest / s);
  }
  factorial = Ball(1, w.bits());
  for (int k = 1; k < count; ++k) {
    factorial = factorial * k;
    b[static_cast<std::size_t>(k)] *= factorial;
  }
  return b;
}

/// b^(r)(0).
Rational derivative_of_b_at_zero(int r) {
  if (r % 2 == 1) return 0;
  // t/sin t has the coefficients of t/sinh t without their signs.
  Rational value = reciprocal_sinc(r / 2 + 1).back();
  if (value < 0) value = -value;
  for (int k = 2; k <= r; ++k) value *= k;
  return value;
}

/// The larger of both, upper ends only.
void raise(Ball& largest, const Ball& value) { largest = max(largest, abs(value)); }

/// Boxes of width at most 1/8 that cover [low, high].
template <class Visit>
void for_boxes(const Rational& low, const Rational& high, Visit visit) {
  const int count = static_cast<int>(Rational((high - low) * 8).convert_to<double>()) + 1;
  for (int i = 0; i < count; ++i)
    visit(Rational(low + (high - low) * i / count), Rational(low + (high - low) * (i + 1) / count));
}

/// The coefficients of K^(r)/r! in the Legendre polynomials, one after the other in r, as those of P_r in the spherical
/// Bessel functions: times i^(l-r), and times i^(l-r-1) where the l of K are odd.
std::vector<BesselSum> bessel_sums(std::vector<Ball> kernel, int count, int parity) {
  std::vector<BesselSum> result;
  const slong bits = kernel.front().bits();
  for (int r = 0; r < count; ++r) {
    std::vector<Ball> c = kernel;
    for (int l = 0; l < static_cast<int>(c.size()); ++l)
      if (((l - r - parity) / 2) % 2 != 0) c[static_cast<std::size_t>(l)] = -c[static_cast<std::size_t>(l)];
    result.emplace_back(c);
    // P_l' = the sum of (2k+1) P_k over k = l-1, l-3, ...
    Ball above[2] = {Ball(bits), Ball(bits)};
    for (std::size_t l = kernel.size(); l-- > 0;) {
      const Ball derivative = above[(l + 1) % 2] * (2 * static_cast<long>(l) + 1);
      above[l % 2] += kernel[l];
      kernel[l] = derivative / (r + 1);
    }
    if (kernel.size() > 1) kernel.pop_back();
  }
  return result;
}

}  // namespace

UniformSymbol::UniformSymbol(Evaluation evaluation, int degree, const Rational& first_N, slong bits)
    : evaluation_(evaluation),
      degree_(degree),
      boxed_octaves_(std::max(7, static_cast<int>(std::ceil(2 * std::log2(degree))))),
      bits_(bits),
      N_(first_N, bits),
      M_(evaluation == Evaluation::dual ? first_N : Rational(first_N - Rational(1, 2)), bits) {
  const Rational M = evaluation == Evaluation::dual ? first_N : Rational(first_N - Rational(1, 2));
  const KernelParts kernel = kernel_parts(degree, is_dual() ? Rational(1, 2) : Rational(0), 1 / (M * M), bits);
  std::vector<Ball> limit;
  for (const Rational& omega : kernel.even.limit) limit.emplace_back(omega, bits);
  const int orders = is_dual() ? degree + 1 : degree;
  full_ = bessel_sums(kernel.even.value, orders, 0);
  limit_ = bessel_sums(limit, 1, 0);
  limit_.push_back(limit_.front().derivative().derivative());
  rise_ = bessel_sums(kernel.even.slope, 1, 0);
  if (is_dual()) {
    odd_ = bessel_sums(kernel.odd.value, orders, 1);
  } else {
    drift_ = bessel_sums(kernel.even.derivative, orders, 0);
    for (const BesselSum& P : full_) steep_.push_back(P.derivative());
  }
  end_ = derivatives_of_b(Ball::pi(bits).scaled(-1), orders);
}

Ball UniformSymbol::difference_over(const Rational& low, const Rational& high) const {
  const Ball v = Ball::containing({low, high}, bits_), one(1, bits_), zero(bits_);
  const Ball reach = min(Ball::pi(bits_).scaled(-1), Ball(high, bits_) / N_);
  const Ball half_width(Rational((high - low) / 2), bits_), half = one.scaled(-1);
  // The primal rules are evaluated at v (1 + 1/(2N)) and v (1 - 1/(2N)).
  const Ball rho = is_dual() ? half_width : half_width + reach.scaled(-1);
  const Ball ratio = is_dual() ? one : join(N_ / (N_ + half), N_ / (N_ - half));
  const std::vector<Ball> b = derivatives_of_b(reach, static_cast<int>(orders()));
  const BesselTable table(Ball(Rational((low + high) / 2), bits_), limit_[1].needs());
  std::vector<Ball> P;
  for (const BesselSum& sum : full_) P.push_back(sum.over(table, rho));

  Ball sum = v * v * join(Ball(Rational(1, 6), bits_), (b[0] - 1) / reach.pow(2)) * P[0];
  sum += ratio * ratio * rise_[0].over(table, rho);
  if (!is_dual()) sum += v * v * limit_[1].over(table, rho).scaled(-3);
  if (orders() > 1) sum += v * join(Ball(Rational(1, 3), bits_), b[1] / reach) * ratio * P[1];
  for (std::size_t r = 2; r < orders(); ++r) {
    const Ball factor = r == 2 ? ratio * ratio : join(zero, N_.pow(2) / M_.pow(static_cast<long>(r)));
    sum += join(Ball(derivative_of_b_at_zero(static_cast<int>(r)), bits_), b[r]) * factor * P[r];
  }
  if (is_dual()) {
    Ball even(bits_), odd(bits_);
    for (std::size_t r = 0; r < orders(); ++r) {
      const Ball factor = join(Ball(derivative_of_b_at_zero(static_cast<int>(r)), bits_), b[r]) *
                          (r == 0 ? one : join(zero, 1 / M_.pow(static_cast<long>(r))));
      even += factor * P[r];
      odd += factor * odd_[r].over(table, rho);
    }
    const Ball angle = reach.scaled(-1);
    sum += v * join(half, sin(angle) / reach) * odd.scaled(-1);
    sum = sum - v * v * join(one.scaled(-3), (1 - cos(angle)) / reach.pow(2)) * even;
  }
  return abs(sum);
}

/// By the maximum principle |f(z)| <= (|z|/rho)^order max |f| on |z| = rho; the best of a few rho >= 1.
template <class Bound>
UniformSymbol::Disc UniformSymbol::by_maximum_principle(int order, const Bound& bound) const {
  std::optional<Disc> best;
  for (long rho = 1; rho <= std::max(7, degree_ + 4); ++rho) {
    const Ball value = bound(Ball(rho, bits_)) / Ball(rho, bits_).pow(order);
    if (!best || value.is_less(best->bound)) best = Disc{value, rho};
  }
  return *best;
}

UniformSymbol::Disc UniformSymbol::disc_difference() const {
  return by_maximum_principle(degree_ + 1, [this](const Ball& rho) { return difference_on_disc(rho); });
}

UniformSymbol::Disc UniformSymbol::disc_slope(int order) const {
  return by_maximum_principle(order, [this](const Ball& rho) { return slope_on_disc(rho); });
}

Ball UniformSymbol::difference_on_disc(const Ball& R) const {
  const Ball reach = R / N_, wide = is_dual() ? R : R + reach.scaled(-1), one(1, bits_);
  const std::vector<Ball> b = derivatives_of_b(reach, static_cast<int>(orders()));
  const Ball ratio = is_dual() ? one : N_ / M_;
  Ball sum = R * R * (b[0] - 1) / reach.pow(2) * full_[0].on_disc(wide);
  sum += ratio * ratio * rise_[0].on_disc(wide);
  if (!is_dual()) sum += R * R * limit_[1].on_disc(wide).scaled(-3);
  if (orders() > 1) sum += R * b[1] / reach * ratio * full_[1].on_disc(wide);
  for (std::size_t r = 2; r < orders(); ++r)
    sum += b[r] * N_.pow(2) / M_.pow(static_cast<long>(r)) * full_[r].on_disc(wide);
  if (is_dual()) {
    // |sin y| <= |y| cosh |y| and |1 - cos y| <= |y|^2/2 cosh |y|, cosh <= exp.
    const Ball growth = exp(reach.scaled(-1));
    for (std::size_t r = 0; r < orders(); ++r)
      sum += b[r] / M_.pow(static_cast<long>(r)) * growth *
             (R * R * full_[r].on_disc(R).scaled(-3) + R * odd_[r].on_disc(R).scaled(-2));
  }
  return sum;
}

Ball UniformSymbol::slope_on_disc(const Ball& R) const {
  const Ball twice = (1 / M_.pow(2)).scaled(1), growth = exp((R / M_).scaled(-1));
  const std::vector<Ball> b = derivatives_of_b(R / M_, static_cast<int>(orders()));
  Ball sum(bits_);
  for (std::size_t r = 0; r < orders(); ++r) {
    const auto order = static_cast<long>(r);
    const Ball part = is_dual() ? growth * (odd_[r].on_disc(R) + R * full_[r].on_disc(R))
                                : R * steep_[r].on_disc(R) + full_[r].on_disc(R) * order + twice * drift_[r].on_disc(R);
    sum += b[r] / M_.pow(order) * part;
  }
  return sum;
}

Ball UniformSymbol::slope_over(const Rational& low, const Rational& high) const {
  const Ball v = Ball::containing({low, high}, bits_), rho(Rational((high - low) / 2), bits_), one(1, bits_);
  const BesselTable table(Ball(Rational((low + high) / 2), bits_), limit_[1].needs());
  const Ball twice = (1 / M_.pow(2)).scaled(1);
  const Ball angle = min(Ball::pi(bits_).scaled(-1), Ball(high, bits_) / M_).scaled(-1);
  Ball sum(bits_);
  for (std::size_t r = 0; r < orders(); ++r) {
    const Ball P = full_[r].over(table, rho);
    Ball part(bits_);
    if (!is_dual()) {
      part = abs(v * steep_[r].over(table, rho)) + abs(P) * static_cast<long>(r) +
             twice * abs(drift_[r].over(table, rho));
    } else {
      const Ball odd = odd_[r].over(table, rho);
      part = r == 0 ? abs(join(one, cos(angle)) * odd - v * join(one, sin(angle) / angle) * P) : abs(odd) + v * abs(P);
    }
    sum += r == 0 ? part : weight(r) * part;
  }
  return sum;
}

Ball UniformSymbol::slope() const {
  const Rational end = power(Rational(2), boxed_octaves_);
  Ball largest(0, bits_);
  for_boxes(1, end, [&](const Rational& low, const Rational& high) { raise(largest, slope_over(low, high)); });
  const Ball from(end, bits_), twice = (1 / M_.pow(2)).scaled(1);
  Ball beyond(bits_);
  for (std::size_t r = 0; r < orders(); ++r) {
    const Ball part = is_dual() ? odd_[r].decay(from) / from + full_[r].decay(from)
                                : steep_[r].decay(from) + full_[r].decay(from) * static_cast<long>(r) / from +
                                      twice * drift_[r].decay(from) / from;
    beyond += r == 0 ? part : weight(r) * part;
  }
  raise(largest, beyond);
  return largest;
}

Ball UniformSymbol::decay(const Rational& from) const {
  const Rational end = std::max(from, power(Rational(2), boxed_octaves_));
  // sin(w/2) < 3/4 and t_0 = 1/(2N).
  const Ball share = Ball(Rational(3, 8), bits_) / M_;
  Ball largest(0, bits_);
  if (from < end)
    for_boxes(from, end, [&](const Rational& low, const Rational& high) {
      const Ball v = Ball::containing({low, high}, bits_), rho(Rational((high - low) / 2), bits_);
      const BesselTable table(Ball(Rational((low + high) / 2), bits_), limit_[1].needs());
      Ball sum(bits_);
      for (std::size_t r = 0; r < orders(); ++r) {
        Ball part = abs(full_[r].over(table, rho));
        if (is_dual()) part += share * abs(odd_[r].over(table, rho));
        sum += r == 0 ? part : weight(r) * part;
      }
      raise(largest, v * sum);
    });
  Ball beyond(bits_);
  for (std::size_t r = 0; r < orders(); ++r) {
    Ball part = full_[r].decay(Ball(end, bits_));
    if (is_dual()) part += share * odd_[r].decay(Ball(end, bits_));
    beyond += r == 0 ? part : weight(r) * part;
  }
  raise(largest, beyond);
  return largest;
}

UniformSymbol::Growth UniformSymbol::growth(const Rational& from) const {
  const Ball one(1, bits_), shrink = is_dual() ? one : 1 - 1 / N_.scaled(1);
  const Ball start = Ball(from, bits_) * shrink, ratio = N_ / M_, right = Ball::pi(bits_).scaled(-1);
  Growth result;
  result.first = (end_[0] - 1) / right.pow(2) * full_[0].decay(start);
  if (!is_dual()) result.first += limit_[1].decay(start).scaled(-3);
  result.first = result.first / shrink;
  Ball rest = ratio * ratio * rise_[0].decay(start);
  for (std::size_t r = 2; r < orders(); ++r)
    rest += end_[r] * N_.pow(2) / M_.pow(static_cast<long>(r)) * full_[r].decay(start);
  result.zeroth = rest / start;
  if (orders() > 1) result.zeroth += end_[1] / right * ratio * full_[1].decay(start) / shrink;
  if (is_dual())
    for (std::size_t r = 0; r < orders(); ++r) {
      result.first += weight(r) * full_[r].decay(start).scaled(-3);
      result.zeroth += weight(r) * odd_[r].decay(start).scaled(-2);
    }
  return result;
}

UniformSymbol::Cell UniformSymbol::cell(int octave, int part) const {
  const Rational scale = power(Rational(2), octave);
  const Rational low = scale * (1 + Rational(part, parts)), high = scale * (1 + Rational(part + 1, parts));
  Cell result{Ball(0, bits_), Ball(0, bits_), Ball(0, bits_)};
  if (octave < boxed_octaves_) {
    for_boxes(low, high, [&](const Rational& left, const Rational& right) {
      const BesselTable table(Ball(Rational((left + right) / 2), bits_), limit_[1].needs());
      raise(result.transform, limit_[0].over(table, Ball(Rational((right - left) / 2), bits_)));
      raise(result.difference, difference_over(left, right));
    });
    return result;
  }
  const Growth rate = growth(low);
  const Ball v(low, bits_), top(high, bits_);
  const Ball reach = min(Ball::pi(bits_).scaled(-1), top / N_);
  const Ball G = N_ * N_ / (N_ * N_ - Ball(Rational(1, 4), bits_));
  // M w >= v M_1/N_1.
  const Rational start = low * Rational(9, 10);
  if (!Ball(start, bits_).is_less(v * M_ / N_)) throw std::logic_error("UniformSymbol: N_1 is too small");
  result.transform = limit_[0].decay(v) / v;
  result.difference = rate.first * top + rate.zeroth;
  result.factor = max(result.transform, decay(start) * reach / sin(reach) * G / v);
  return result;
}

}  // namespace subcert::theorems
