#include "uniform_symbol.hpp"

#include <subcert/analysis/symbol/flint.hpp>

#include <arb_mat.h>

#include <optional>
#include <stdexcept>

namespace subcert::theorems {
namespace {

constexpr int boxed_octaves = 7;  ///< cells are split into boxes below R 2^7

/// Contains both balls and all between them.
Real join(const Real& a, const Real& b) {
  Real result(std::max(a.bits(), b.bits()));
  arb_union(result.get(), a.get(), b.get(), result.bits());
  return result;
}

Rational binomial(int n, int k) {
  Rational result = 1;
  for (int i = 1; i <= k; ++i) result *= Rational(n - k + i, i);
  return result;
}

/// Coefficients of t/sinh(t) in t^2.
std::vector<Rational> reciprocal_sinc(int count) {
  std::vector<Rational> sinh{1}, result{1};
  for (int i = 1; i < count; ++i) {
    sinh.push_back(sinh.back() / ((2 * i) * (2 * i + 1)));
    Rational sum = 0;
    for (int k = 1; k <= i; ++k)
      sum -= sinh[static_cast<std::size_t>(k)] * result[static_cast<std::size_t>(i - k)];
    result.push_back(sum);
  }
  return result;
}

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
  Real value, slope, derivative;
};

Three evaluate(const std::vector<Rational>& polynomial, const Real& tau) {
  const slong bits = tau.bits();
  Three result{Real(bits), Real(bits), Real(bits)};
  for (std::size_t i = polynomial.size(); i-- > 0;) {
    result.derivative = result.derivative * tau + result.value;
    if (i > 0) result.slope = result.slope * tau + Real(polynomial[i], bits);
    result.value = result.value * tau + Real(polynomial[i], bits);
  }
  return result;
}

class Matrix {
 public:
  Matrix(slong rows, slong columns) { arb_mat_init(value_, rows, columns); }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
  ~Matrix() { arb_mat_clear(value_); }
  void set(std::size_t i, std::size_t j, const Real& x) {
    arb_set(arb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j)), x.get());
  }
  Real at(std::size_t i, std::size_t j, slong bits) const {
    Real result(bits);
    arb_set(result.get(), arb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j)));
    return result;
  }
  arb_mat_struct* get() { return value_; }

 private:
  arb_mat_t value_;
};

std::vector<Real> solve(Matrix& matrix, const std::vector<Real>& right, slong bits) {
  Matrix column(static_cast<slong>(right.size()), 1), solution(static_cast<slong>(right.size()), 1);
  for (std::size_t i = 0; i < right.size(); ++i) column.set(i, 0, right[i]);
  if (!arb_mat_solve_precond(solution.get(), matrix.get(), column.get(), bits))
    throw std::runtime_error("kernel_coefficients: the moment system is not proved regular");
  std::vector<Real> result;
  for (std::size_t i = 0; i < right.size(); ++i) result.push_back(solution.at(i, 0, bits));
  return result;
}

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
    for (int i = 1; i <= k; ++i)
      rest = rest - sine[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(k - i)];
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

/// kappa(0): k_d(t) is half the sum of kappa_q(0) t^2q.
std::vector<Rational> limit_coefficients(std::size_t size) {
  std::vector<Rational> result;
  for (std::size_t q = 0; q < size; ++q) {
    Rational sum = 0;  // (4h+1) P_2h(0) times the coefficient of t^2q in P_2h
    for (std::size_t h = q; h < size; ++h) {
      const int l = 2 * static_cast<int>(h), k = static_cast<int>(h - q);
      Rational term = (2 * l + 1) * binomial(l, l / 2) * binomial(l, k) * binomial(2 * l - 2 * k, l) / power(Rational(4), l);
      sum += (h + static_cast<std::size_t>(k)) % 2 == 0 ? term : Rational(-term);
    }
    result.push_back(sum);
  }
  return result;
}

/// slope and derivative for tau in [low, high].
std::pair<std::vector<Real>, std::vector<Real>> slopes(const std::vector<Rational>& limit, const Rational& low,
                                                       const Rational& high, slong bits) {
  const std::size_t size = limit.size();
  const Real tau = Real::containing({low, high}, bits);
  Matrix moments(static_cast<slong>(size), static_cast<slong>(size));
  std::vector<std::vector<Three>> entries(size);
  for (std::size_t p = 0; p < size; ++p)
    for (std::size_t q = 0; q < size; ++q) {
      entries[p].push_back(evaluate(power_sum(static_cast<int>(p + q)), tau));
      moments.set(p, q, entries[p].back().value);
    }
  std::vector<Real> right(size, Real(bits));
  for (std::size_t p = 0; p < size; ++p)
    for (std::size_t q = 0; q < size; ++q) right[p] = right[p] - entries[p][q].slope * Real(limit[q], bits);
  const std::vector<Real> slope = solve(moments, right, bits);
  right.assign(size, Real(bits));
  for (std::size_t p = 0; p < size; ++p)
    for (std::size_t q = 0; q < size; ++q)
      right[p] = right[p] - entries[p][q].derivative * (Real(limit[q], bits) + tau * slope[q]);
  return {slope, solve(moments, right, bits)};
}

}  // namespace

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
  const Real tau = Real::containing({Rational(0), last}, bits);
  for (std::size_t q = 0; q < size; ++q) result.value.push_back(Real(result.limit[q], bits) + tau * result.slope[q]);
  return result;
}

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
