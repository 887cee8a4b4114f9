#include "uniform_symbol.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace subcert::theorems {
namespace {

constexpr int boxed_octaves = 7;  ///< cells are split into boxes below R 2^7

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

}  // namespace

UniformSymbol::UniformSymbol(int degree, int first_n, slong bits)
    : degree_(degree),
      bits_(bits),
      N_(Rational(4 * first_n - 1, 2), bits),
      M_(2 * first_n - 1, bits),
      kappa_(kernel_coefficients(degree, Rational(1, (2 * first_n - 1) * (2 * first_n - 1)), bits)) {
  std::vector<Ball> limit;
  for (const Rational& kappa : kappa_.limit) limit.emplace_back(kappa, bits);
  for (int r = 0; r < degree; ++r) {
    full_.push_back(sum(kappa_.value, r));
    limit_.push_back(sum(limit, r));
    rise_.push_back(sum(kappa_.slope, r));
    drift_.push_back(sum(kappa_.derivative, r));
  }
  end_ = derivatives_of_b(Ball::pi(bits).scaled(-1), degree);
}

SincSum UniformSymbol::sum(const std::vector<Ball>& coefficients, int r) const {
  std::vector<Ball> result(static_cast<std::size_t>(std::max(degree_ - r, 1)), Ball(0, bits_));
  for (int q = 0; 2 * q < degree_; ++q) {
    if (2 * q < r) continue;
    const Ball term = coefficients[static_cast<std::size_t>(q)] * Ball(binomial(2 * q, r), bits_);
    result[static_cast<std::size_t>(2 * q - r)] += q % 2 == 0 ? term : -term;
  }
  return SincSum(result);
}

/// b^(r)(pi/2) M_1^-r.
Ball UniformSymbol::weight(int r) const { return end_[static_cast<std::size_t>(r)] / M_.pow(r); }

Ball UniformSymbol::difference_over(const Rational& low, const Rational& high) const {
  const Ball v = Ball::containing({low, high}, bits_);
  const Ball reach = min(Ball::pi(bits_).scaled(-1), Ball(high, bits_) / N_);
  const Ball rho = Ball(Rational((high - low) / 2), bits_) + reach.scaled(-1);
  const std::vector<Ball> b = derivatives_of_b(reach, degree_);
  const SincTable table(Ball(Rational((low + high) / 2), bits_), degree_ + 9);
  const Ball half = Ball(Rational(1, 2), bits_);
  const Ball ratio = join(N_ / (N_ + half), N_ / (N_ - half));

  Ball sum = v * v * join(Ball(Rational(1, 6), bits_), (b[0] - 1) / reach.pow(2)) * full_[0].over(table, rho);
  sum += v * v * limit_[0].derivative().derivative().over(table, rho).scaled(-3);
  sum += ratio * ratio * rise_[0].over(table, rho);
  if (degree_ > 1) sum += v * join(Ball(Rational(1, 3), bits_), b[1] / reach) * ratio * full_[1].over(table, rho);
  for (int r = 2; r < degree_; ++r) {
    const Ball factor = r == 2 ? ratio * ratio : join(Ball(0, bits_), N_.pow(2) / M_.pow(r));
    sum += join(Ball(derivative_of_b_at_zero(r), bits_), b[static_cast<std::size_t>(r)]) * factor *
           full_[static_cast<std::size_t>(r)].over(table, rho);
  }
  return abs(sum);
}

/// By the maximum principle |f(z)| <= (|z|/rho)^(d+1) max |f| on |z| = rho; the best of a few rho >= R.
template <class Bound>
Ball UniformSymbol::by_maximum_principle(const Bound& bound) const {
  std::optional<Ball> best;
  for (long rho = radius; rho <= 7; ++rho) {
    const Ball value = bound(Ball(rho, bits_)) / Ball(rho, bits_).pow(degree_ + 1);
    if (!best || value.is_less(*best)) best = value;
  }
  return *best;
}

Ball UniformSymbol::disc_difference() const {
  return by_maximum_principle([this](const Ball& rho) { return difference_on_disc(rho); });
}

Ball UniformSymbol::disc_slope() const {
  return by_maximum_principle([this](const Ball& rho) { return slope_on_disc(rho); });
}

Ball UniformSymbol::difference_on_disc(const Ball& R) const {
  const Ball reach = R / N_, wide = R + reach.scaled(-1);
  const std::vector<Ball> b = derivatives_of_b(reach, degree_);
  const Ball ratio = N_ / M_;
  Ball sum = R * R * (b[0] - 1) / reach.pow(2) * full_[0].on_disc(wide);
  sum += R * R * limit_[0].derivative().derivative().on_disc(wide).scaled(-3);
  sum += ratio * ratio * rise_[0].on_disc(wide);
  if (degree_ > 1) sum += R * b[1] / reach * ratio * full_[1].on_disc(wide);
  for (int r = 2; r < degree_; ++r)
    sum += b[static_cast<std::size_t>(r)] * N_.pow(2) / M_.pow(r) * full_[static_cast<std::size_t>(r)].on_disc(wide);
  return sum;
}

Ball UniformSymbol::slope_on_disc(const Ball& R) const {
  const Ball twice = (1 / M_.pow(2)).scaled(1);
  const std::vector<Ball> b = derivatives_of_b(R / M_, degree_);
  Ball sum(bits_);
  for (int r = 0; r < degree_; ++r) {
    const auto i = static_cast<std::size_t>(r);
    sum += b[i] / M_.pow(r) *
           (R * full_[i].derivative().on_disc(R) + full_[i].on_disc(R) * r + twice * drift_[i].on_disc(R));
  }
  return sum;
}

Ball UniformSymbol::slope() const {
  const Ball twice = (1 / M_.pow(2)).scaled(1);
  const Rational end = Rational(radius) * power(Rational(2), boxed_octaves);
  Ball largest(0, bits_);
  for_boxes(radius, end, [&](const Rational& low, const Rational& high) {
    const Ball v = Ball::containing({low, high}, bits_), rho(Rational((high - low) / 2), bits_);
    const SincTable table(Ball(Rational((low + high) / 2), bits_), degree_ + 9);
    Ball sum(bits_);
    for (int r = 0; r < degree_; ++r) {
      const auto i = static_cast<std::size_t>(r);
      const Ball part = abs(v * full_[i].derivative().over(table, rho)) + abs(full_[i].over(table, rho)) * r +
                        twice * abs(drift_[i].over(table, rho));
      sum += r == 0 ? part : weight(r) * part;
    }
    raise(largest, sum);
  });
  const Ball from(end, bits_);
  Ball beyond(bits_);
  for (int r = 0; r < degree_; ++r) {
    const auto i = static_cast<std::size_t>(r);
    const Ball part = full_[i].derivative().decay(from) + full_[i].decay(from) * r / from +
                      twice * drift_[i].decay(from) / from;
    beyond += r == 0 ? part : weight(r) * part;
  }
  raise(largest, beyond);
  return largest;
}

Ball UniformSymbol::decay(const Rational& from) const {
  const Rational end = std::max(from, Rational(Rational(radius) * power(Rational(2), boxed_octaves)));
  Ball largest(0, bits_);
  if (from < end)
    for_boxes(from, end, [&](const Rational& low, const Rational& high) {
      const Ball v = Ball::containing({low, high}, bits_), rho(Rational((high - low) / 2), bits_);
      const SincTable table(Ball(Rational((low + high) / 2), bits_), degree_ + 9);
      Ball sum(bits_);
      for (int r = 0; r < degree_; ++r) {
        const Ball part = abs(full_[static_cast<std::size_t>(r)].over(table, rho));
        sum += r == 0 ? part : weight(r) * part;
      }
      raise(largest, v * sum);
    });
  Ball beyond(bits_);
  for (int r = 0; r < degree_; ++r) {
    const Ball part = full_[static_cast<std::size_t>(r)].decay(Ball(end, bits_));
    beyond += r == 0 ? part : weight(r) * part;
  }
  raise(largest, beyond);
  return largest;
}

UniformSymbol::Growth UniformSymbol::growth(const Rational& from) const {
  const Ball half(Rational(1, 2), bits_), shrink = 1 - half / N_;
  const Ball start = Ball(from, bits_) * shrink, ratio = N_ / M_, right = Ball::pi(bits_).scaled(-1);
  Growth result;
  result.first = ((end_[0] - 1) / right.pow(2) * full_[0].decay(start) +
                  limit_[0].derivative().derivative().decay(start).scaled(-3)) /
                 shrink;
  Ball rest = ratio * ratio * rise_[0].decay(start);
  for (int r = 2; r < degree_; ++r)
    rest += end_[static_cast<std::size_t>(r)] * N_.pow(2) / M_.pow(r) * full_[static_cast<std::size_t>(r)].decay(start);
  result.zeroth = rest / start;
  if (degree_ > 1) result.zeroth += end_[1] / right * ratio * full_[1].decay(start) / shrink;
  return result;
}

UniformSymbol::Cell UniformSymbol::cell(int octave, int part) const {
  const Rational scale = Rational(radius) * power(Rational(2), octave);
  const Rational low = scale * (1 + Rational(part, parts)), high = scale * (1 + Rational(part + 1, parts));
  Cell result{Ball(0, bits_), Ball(0, bits_), Ball(0, bits_)};
  if (octave < boxed_octaves) {
    for_boxes(low, high, [&](const Rational& left, const Rational& right) {
      const SincTable table(Ball(Rational((left + right) / 2), bits_), degree_ + 9);
      raise(result.transform, limit_[0].over(table, Ball(Rational((right - left) / 2), bits_)));
      raise(result.difference, difference_over(left, right));
    });
    result.factor = result.transform + result.difference / N_.pow(2);
    return result;
  }
  const Growth rate = growth(low);
  const Ball v(low, bits_), top(high, bits_);
  const Ball reach = min(Ball::pi(bits_).scaled(-1), top / N_);
  const Ball G = N_ * N_ / (N_ * N_ - Ball(Rational(1, 4), bits_));
  // M w >= v M_1/N_1.
  const Rational start = low * Rational(9, 10);
  if (!Ball(start, bits_).is_less(v * M_ / N_)) throw std::logic_error("UniformSymbol: n_1 is too small");
  result.transform = limit_[0].decay(v) / v;
  result.difference = rate.first * top + rate.zeroth;
  result.factor = max(result.transform, decay(start) * reach / sin(reach) * G / v);
  return result;
}

}  // namespace subcert::theorems
