#include "uniform_symbol.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace subcert::theorems {
namespace {

constexpr int boxed_octaves = 7;  ///< cells are split into boxes below R 2^7

/// b^(r)(w), r < count, for b(w) = w / sin w and 0 < w < pi.
std::vector<Real> derivatives_of_b(const Real& w, int count) {
  std::vector<Real> sine, b;
  Real factorial(1, w.bits());
  const Real s = sin(w), c = cos(w);
  for (int k = 0; k < count; ++k) {
    if (k > 0) factorial = factorial * k;
    const Real& wave = k % 2 == 0 ? s : c;
    sine.push_back((k % 4 < 2 ? wave : -wave) / factorial);
    Real rest = k == 0 ? w : Real(k == 1 ? 1 : 0, w.bits());
    for (int i = 1; i <= k; ++i) rest = rest - sine[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(k - i)];
    b.push_back(rest / s);
  }
  factorial = Real(1, w.bits());
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
void raise(Real& largest, const Real& value) { largest = max(largest, abs(value)); }

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
  std::vector<Real> limit;
  for (const Rational& kappa : kappa_.limit) limit.emplace_back(kappa, bits);
  for (int r = 0; r < degree; ++r) {
    full_.push_back(sum(kappa_.value, r));
    limit_.push_back(sum(limit, r));
    rise_.push_back(sum(kappa_.slope, r));
    drift_.push_back(sum(kappa_.derivative, r));
  }
  end_ = derivatives_of_b(Real::pi(bits).scaled(-1), degree);
}

SincSum UniformSymbol::sum(const std::vector<Real>& coefficients, int r) const {
  std::vector<Real> result(static_cast<std::size_t>(std::max(degree_ - r, 1)), Real(0, bits_));
  for (int q = 0; 2 * q < degree_; ++q) {
    if (2 * q < r) continue;
    const Real term = coefficients[static_cast<std::size_t>(q)] * Real(binomial(2 * q, r), bits_);
    result[static_cast<std::size_t>(2 * q - r)] += q % 2 == 0 ? term : -term;
  }
  return SincSum(result);
}

/// b^(r)(pi/2) M_1^-r.
Real UniformSymbol::weight(int r) const { return end_[static_cast<std::size_t>(r)] / M_.pow(r); }

Real UniformSymbol::difference_over(const Rational& low, const Rational& high) const {
  const Real v = Real::containing({low, high}, bits_);
  const Real reach = min(Real::pi(bits_).scaled(-1), Real(high, bits_) / N_);
  const Real rho = Real(Rational((high - low) / 2), bits_) + reach.scaled(-1);
  const std::vector<Real> b = derivatives_of_b(reach, degree_);
  const SincTable table(Real(Rational((low + high) / 2), bits_), degree_ + 9);
  const Real half = Real(Rational(1, 2), bits_);
  const Real ratio = join(N_ / (N_ + half), N_ / (N_ - half));

  Real sum = v * v * join(Real(Rational(1, 6), bits_), (b[0] - 1) / reach.pow(2)) * full_[0].over(table, rho);
  sum += v * v * limit_[0].derivative().derivative().over(table, rho).scaled(-3);
  sum += ratio * ratio * rise_[0].over(table, rho);
  if (degree_ > 1) sum += v * join(Real(Rational(1, 3), bits_), b[1] / reach) * ratio * full_[1].over(table, rho);
  for (int r = 2; r < degree_; ++r) {
    const Real factor = r == 2 ? ratio * ratio : join(Real(0, bits_), N_.pow(2) / M_.pow(r));
    sum += join(Real(derivative_of_b_at_zero(r), bits_), b[static_cast<std::size_t>(r)]) * factor *
           full_[static_cast<std::size_t>(r)].over(table, rho);
  }
  return abs(sum);
}

/// By the maximum principle |f(z)| <= (|z|/rho)^(d+1) max |f| on |z| = rho; the best of a few rho >= R.
template <class Bound>
Real UniformSymbol::by_maximum_principle(const Bound& bound) const {
  std::optional<Real> best;
  for (long rho = radius; rho <= 7; ++rho) {
    const Real value = bound(Real(rho, bits_)) / Real(rho, bits_).pow(degree_ + 1);
    if (!best || value.is_less(*best)) best = value;
  }
  return *best;
}

Real UniformSymbol::disc_difference() const {
  return by_maximum_principle([this](const Real& rho) { return difference_on_disc(rho); });
}

Real UniformSymbol::disc_slope() const {
  return by_maximum_principle([this](const Real& rho) { return slope_on_disc(rho); });
}

Real UniformSymbol::difference_on_disc(const Real& R) const {
  const Real reach = R / N_, wide = R + reach.scaled(-1);
  const std::vector<Real> b = derivatives_of_b(reach, degree_);
  const Real ratio = N_ / M_;
  Real sum = R * R * (b[0] - 1) / reach.pow(2) * full_[0].on_disc(wide);
  sum += R * R * limit_[0].derivative().derivative().on_disc(wide).scaled(-3);
  sum += ratio * ratio * rise_[0].on_disc(wide);
  if (degree_ > 1) sum += R * b[1] / reach * ratio * full_[1].on_disc(wide);
  for (int r = 2; r < degree_; ++r)
    sum += b[static_cast<std::size_t>(r)] * N_.pow(2) / M_.pow(r) * full_[static_cast<std::size_t>(r)].on_disc(wide);
  return sum;
}

Real UniformSymbol::slope_on_disc(const Real& R) const {
  const Real twice = (1 / M_.pow(2)).scaled(1);
  const std::vector<Real> b = derivatives_of_b(R / M_, degree_);
  Real sum(bits_);
  for (int r = 0; r < degree_; ++r) {
    const auto i = static_cast<std::size_t>(r);
    sum += b[i] / M_.pow(r) *
           (R * full_[i].derivative().on_disc(R) + full_[i].on_disc(R) * r + twice * drift_[i].on_disc(R));
  }
  return sum;
}

Real UniformSymbol::slope() const {
  const Real twice = (1 / M_.pow(2)).scaled(1);
  const Rational end = Rational(radius) * power(Rational(2), boxed_octaves);
  Real largest(0, bits_);
  for_boxes(radius, end, [&](const Rational& low, const Rational& high) {
    const Real v = Real::containing({low, high}, bits_), rho(Rational((high - low) / 2), bits_);
    const SincTable table(Real(Rational((low + high) / 2), bits_), degree_ + 9);
    Real sum(bits_);
    for (int r = 0; r < degree_; ++r) {
      const auto i = static_cast<std::size_t>(r);
      const Real part = abs(v * full_[i].derivative().over(table, rho)) + abs(full_[i].over(table, rho)) * r +
                        twice * abs(drift_[i].over(table, rho));
      sum += r == 0 ? part : weight(r) * part;
    }
    raise(largest, sum);
  });
  const Real from(end, bits_);
  Real beyond(bits_);
  for (int r = 0; r < degree_; ++r) {
    const auto i = static_cast<std::size_t>(r);
    const Real part = full_[i].derivative().decay(from) + full_[i].decay(from) * r / from +
                      twice * drift_[i].decay(from) / from;
    beyond += r == 0 ? part : weight(r) * part;
  }
  raise(largest, beyond);
  return largest;
}

Real UniformSymbol::decay(const Rational& from) const {
  const Rational end = std::max(from, Rational(Rational(radius) * power(Rational(2), boxed_octaves)));
  Real largest(0, bits_);
  if (from < end)
    for_boxes(from, end, [&](const Rational& low, const Rational& high) {
      const Real v = Real::containing({low, high}, bits_), rho(Rational((high - low) / 2), bits_);
      const SincTable table(Real(Rational((low + high) / 2), bits_), degree_ + 9);
      Real sum(bits_);
      for (int r = 0; r < degree_; ++r) {
        const Real part = abs(full_[static_cast<std::size_t>(r)].over(table, rho));
        sum += r == 0 ? part : weight(r) * part;
      }
      raise(largest, v * sum);
    });
  Real beyond(bits_);
  for (int r = 0; r < degree_; ++r) {
    const Real part = full_[static_cast<std::size_t>(r)].decay(Real(end, bits_));
    beyond += r == 0 ? part : weight(r) * part;
  }
  raise(largest, beyond);
  return largest;
}

UniformSymbol::Growth UniformSymbol::growth(const Rational& from) const {
  const Real half(Rational(1, 2), bits_), shrink = 1 - half / N_;
  const Real start = Real(from, bits_) * shrink, ratio = N_ / M_, right = Real::pi(bits_).scaled(-1);
  Growth result;
  result.first = ((end_[0] - 1) / right.pow(2) * full_[0].decay(start) +
                  limit_[0].derivative().derivative().decay(start).scaled(-3)) /
                 shrink;
  Real rest = ratio * ratio * rise_[0].decay(start);
  for (int r = 2; r < degree_; ++r)
    rest += end_[static_cast<std::size_t>(r)] * N_.pow(2) / M_.pow(r) * full_[static_cast<std::size_t>(r)].decay(start);
  result.zeroth = rest / start;
  if (degree_ > 1) result.zeroth += end_[1] / right * ratio * full_[1].decay(start) / shrink;
  return result;
}

UniformSymbol::Cell UniformSymbol::cell(int octave, int part) const {
  const Rational scale = Rational(radius) * power(Rational(2), octave);
  const Rational low = scale * (1 + Rational(part, parts)), high = scale * (1 + Rational(part + 1, parts));
  Cell result{Real(0, bits_), Real(0, bits_), Real(0, bits_)};
  if (octave < boxed_octaves) {
    for_boxes(low, high, [&](const Rational& left, const Rational& right) {
      const SincTable table(Real(Rational((left + right) / 2), bits_), degree_ + 9);
      raise(result.transform, limit_[0].over(table, Real(Rational((right - left) / 2), bits_)));
      raise(result.difference, difference_over(left, right));
    });
    result.factor = result.transform + result.difference / N_.pow(2);
    return result;
  }
  const Growth rate = growth(low);
  const Real v(low, bits_), top(high, bits_);
  const Real reach = min(Real::pi(bits_).scaled(-1), top / N_);
  const Real G = N_ * N_ / (N_ * N_ - Real(Rational(1, 4), bits_));
  // M w >= v M_1/N_1.
  const Rational start = low * Rational(9, 10);
  if (!Real(start, bits_).is_less(v * M_ / N_)) throw std::logic_error("UniformSymbol: n_1 is too small");
  result.transform = limit_[0].decay(v) / v;
  result.difference = rate.first * top + rate.zeroth;
  result.factor = max(result.transform, decay(start) * reach / sin(reach) * G / v);
  return result;
}

}  // namespace subcert::theorems
