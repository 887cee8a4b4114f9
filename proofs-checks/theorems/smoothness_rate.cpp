#include "smoothness_rate.hpp"

#include "proofs.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/ball_transition.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace subcert::theorems {
namespace {

constexpr int word_length = 8;   ///< of the words that are tried
constexpr int circle_bits = 14;  ///< 2^14 cells of the circle
constexpr slong det_bits = 320;  ///< of determinants: an elimination loses about one for each row

/// 2 pi x.
Ball angle(const Rational& x) { return Ball::pi(proof_bits).scaled(1) * exactly(x); }

/// m(w) for real w that is not a multiple of pi.
Ball half_symbol(int n, const Ball& w) {
  const Ball even = exactly(2 * n), odd = exactly(2 * n - 1);
  return ((sin(even * w) / even + sin(odd * w) / odd) / sin(w)).scaled(-1);
}

/// The transform of phi_b at 2 pi k, k odd. |b(w) - 1| <= (mu + 1) w^2 for small w, as 0 <= 1 - m(w) <= mu w^2 with mu
/// = 2 n^2/3, and 0 <= 1/cos(w/2)^2 - 1 <= w^2/2 for w <= 1; that bounds the factors left out.
Ball transform(int n, int k) {
  constexpr int factors = 90;
  Ball product = exactly(Rational(4 * n - 1, 3)), w = Ball::pi(proof_bits) * k;
  for (int j = 0; j < factors; ++j) {
    w = w.scaled(-1);
    product *= half_symbol(n, w) / cos(w.scaled(-1)).pow(2);
  }
  // The sum of |b - 1| over w/2, w/4, ... is at most (mu + 1) w^2/3, and |log(1 + t)| <= 2 |t| for |t| <= 1/2.
  const Ball rest = (exactly(Rational(2 * n * n, 3)) + 1) * w * w;
  return product * (exactly(1).widened(rest.scaled(1)));
}

/// h_n as twice a sum of cosines.
class Harmonics {
 public:
  explicit Harmonics(int n) {
    for (int k = 1; 2 * k < 4 * n - 1; k += 2) {
      coefficients_.push_back(transform(n, k).scaled(1));
      doubles_.push_back(coefficients_.back().middle());
    }
    double largest = 0;
    for (double c : doubles_) largest = std::max(largest, std::abs(c));
    // What is small is bounded by its modulus where cells are bounded.
    while (kept_ < doubles_.size() && std::any_of(doubles_.begin() + static_cast<std::ptrdiff_t>(kept_), doubles_.end(),
                                                  [&](double c) { return std::abs(c) > 1e-6 * largest; }))
      ++kept_;
    for (std::size_t i = kept_; i < coefficients_.size(); ++i) rest_ += abs(coefficients_[i]);
  }

  double near(double x) const {
    double sum = 0;
    for (std::size_t i = 0; i < doubles_.size(); ++i)
      sum += doubles_[i] * std::cos(2 * std::numbers::pi * static_cast<double>(2 * i + 1) * x);
    return sum;
  }

  Ball at(const Rational& x) const {
    Ball sum(proof_bits);
    for (std::size_t i = 0; i < coefficients_.size(); ++i)
      sum += coefficients_[i] * cos(angle(x * static_cast<long>(2 * i + 1)));
    return sum;
  }

  /// Not below h_n on |y - x| <= radius: Taylor's polynomial of order 1.
  Ball above(const Rational& x, const Rational& radius) const {
    Ball value = rest_, slope(proof_bits), curvature(proof_bits);
    const Ball r = angle(radius);
    for (std::size_t i = 0; i < kept_; ++i) {
      const long k = static_cast<long>(2 * i + 1);
      const Ball a = angle(x * k);
      value += coefficients_[i] * cos(a);
      slope += coefficients_[i] * sin(a) * k;
      curvature += abs(coefficients_[i]) * (k * k);
    }
    return value + abs(slope) * r + curvature * r * r / 2;
  }

 private:
  std::vector<Ball> coefficients_;
  std::vector<double> doubles_;
  std::size_t kept_ = 0;
  Ball rest_ = Ball(proof_bits);
};

/// The periodic point whose binary digits repeat `length` digits of `digits`.
Rational periodic_point(int length, int digits) { return Rational(digits, (1 << length) - 1); }

Rational doubled(const Rational& x) { return 2 * x < 1 ? Rational(2 * x) : Rational(2 * x - 1); }

/// The digits of the word with the largest mean, in floating point; of those with one mean a shortest.
std::string best_word(const Harmonics& h) {
  double best = -1;
  std::string word;
  for (int length = 1; length <= word_length; ++length)
    for (int digits = 0; digits < std::max(1, (1 << length) - 1); ++digits) {
      Rational x = length == 1 ? Rational(0) : periodic_point(length, digits);
      double sum = 0;
      for (int j = 0; j < length; ++j, x = doubled(x)) sum += h.near(x.convert_to<double>());
      if (sum / length <= best * (1 + 1e-9)) continue;
      best = sum / length;
      word.clear();
      for (int j = length - 1; j >= 0; --j) word += (digits >> j & 1) == 1 ? '1' : '0';
    }
  return word;
}

Ball mean_over(const Harmonics& h, const std::string& word) {
  int digits = 0;
  for (char digit : word) digits = 2 * digits + (digit - '0');
  const int length = static_cast<int>(word.size());
  Rational x = periodic_point(length, digits);
  Ball sum(proof_bits);
  for (int j = 0; j < length; ++j, x = doubled(x)) sum += h.at(x);
  return sum / length;
}

/// A bound of beta_n from above: the largest h + u(2x) - u(x) for a function u that is constant on cells. Every u gives
/// a bound; this one sums what an orbit gains over `guess`.
Ball largest_mean(const Harmonics& h, double guess) {
  constexpr std::size_t count = std::size_t{1} << circle_bits;
  std::vector<Ball> top;
  for (std::size_t i = 0; i < count / 2; ++i)
    top.push_back(h.above(Rational(static_cast<long>(2 * i + 1), static_cast<long>(2 * count)),
                          Rational(1, static_cast<long>(2 * count))));
  for (std::size_t i = 0; i < count / 2; ++i) top.push_back(top[count / 2 - 1 - i]);  // h is even
  std::vector<double> gain(count, 0), heights;
  for (const Ball& one : top) heights.push_back(one.middle());
  const auto next = [&](const std::vector<double>& u, std::size_t i) {
    return std::max(u[2 * i % count], u[(2 * i + 1) % count]);
  };
  for (int round = 0; round < 3 * circle_bits; ++round) {
    std::vector<double> sum(count);
    for (std::size_t i = 0; i < count; ++i) sum[i] = std::max(0.0, heights[i] - guess + next(gain, i));
    gain = std::move(sum);
  }
  Ball largest = top[0];
  for (std::size_t i = 0; i < count; ++i)
    largest = max(largest, top[i] + exactly(Rational(next(gain, i))) - exactly(Rational(gain[i])));
  return largest;
}

/// det(t - A) for the product A of the transition matrices of a word.
class WordDeterminant {
 public:
  WordDeterminant(int n, const std::string& word) {
    const Mask mask = divided_difference_scheme(primal_mask(n, 1), 2);
    const Transition<Ball> transition(mask.symbol().coefficients(), 2, det_bits);
    const std::size_t size = transition.width();
    rows_.assign(size, std::vector<Ball>(size, Ball(det_bits)));
    BallVector from(size), to(size);
    for (std::size_t k = 0; k < size; ++k) {
      for (std::size_t j = 0; j < size; ++j) from.set(j, Ball(j == k ? 1 : 0, det_bits));
      // x_i = (x_{i-1} + digit)/2: the first digit of a point belongs to what is applied last.
      for (auto digit = word.rbegin(); digit != word.rend(); ++digit) {
        transition.apply(*digit - '0', from, to);
        std::swap(from, to);
      }
      for (std::size_t j = 0; j < size; ++j) rows_[j][k] = -from.at(j, det_bits);
    }
  }

  Ball operator()(const Rational& t) const {
    std::vector<std::vector<Ball>> shifted = rows_;
    for (std::size_t j = 0; j < shifted.size(); ++j) shifted[j][j] += Ball(t, det_bits);
    return determinant(shifted, det_bits);
  }

 private:
  std::vector<std::vector<Ball>> rows_;  ///< -A
};

/// Contains an eigenvalue - 1 of the product near 1 + guess: det(t - A) changes its sign. Absent ends where it does
/// not.
Enclosure eigenvalue_near(const WordDeterminant& value, double guess) {
  constexpr int most_steps = 12;
  double before = guess * 1.001, now = guess;
  const auto at = [&](double t) { return value(1 + Rational(t)); };
  Ball left = at(before), right = at(now);
  for (int step = 0;; ++step) {
    const double next = now + (now - before) * (right / (left - right)).middle();
    if (!std::isfinite(next) || step == most_steps) return {};
    before = std::exchange(now, next);
    if (std::abs(now - before) < 1e-4 * std::abs(now)) break;
    left = std::exchange(right, at(now));
  }
  const Rational root(now), little(1, 100'000), below = root * (1 - little), above = root * (1 + little);
  const Ball zero(det_bits);
  return value(1 + below).is_less(zero) && zero.is_less(value(1 + above)) ? Enclosure{below, above} : Enclosure{};
}

Enclosure logarithm(const Enclosure& excess, int length) {
  if (!excess.is_bounded()) return {};
  const Ball t = Ball::containing(excess, det_bits);
  return (log(t + 1) / length).enclosure(proof_bits);
}

}  // namespace

SmoothnessRate smoothness_rate(int n) {
  if (n < 2 || n > 64) fail(ErrorKind::domain, "smoothness_rate: need 2 <= n <= 64, got {}", n);
  const Harmonics h(n);
  SmoothnessRate rate{n, best_word(h), {}, {}, {}};
  const Ball mean = mean_over(h, rate.word);
  rate.predicted = mean.enclosure();
  rate.largest = {rate.predicted.lower, largest_mean(h, mean.middle()).enclosure().upper};
  const int length = static_cast<int>(rate.word.size());
  const Ball excess = exp(mean * length) - 1;
  rate.product = logarithm(eigenvalue_near(WordDeterminant(n, rate.word), excess.middle()), length);
  return rate;
}

}  // namespace subcert::theorems
