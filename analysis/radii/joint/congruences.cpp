#include "congruences.hpp"

#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <cmath>

namespace subcert::radius {
namespace {

constexpr std::size_t most_rows = 22;

/// The places (i, k), i <= k, of a symmetric matrix, row by row.
std::vector<std::pair<std::size_t, std::size_t>> places_of(std::size_t size) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = i; k < size; ++k) result.emplace_back(i, k);
  return result;
}

/// On the coordinates at these places.
BallMatrix operator_on_symmetric(const std::vector<BallMatrix>& matrices, slong bits) {
  const auto places = places_of(matrices.front().size());
  BallMatrix result(places.size(), std::vector<Ball>(places.size(), Ball(0L, bits)));
  for (const BallMatrix& a : matrices)
    for (std::size_t row = 0; row < places.size(); ++row)
      for (std::size_t column = 0; column < places.size(); ++column) {
        const auto [k, l] = places[row];
        const auto [i, j] = places[column];
        result[row][column].add_product(a[k][i], a[l][j]);
        if (i != j) result[row][column].add_product(a[k][j], a[l][i]);
      }
  return result;
}

/// About the spectral radius, in floating point.
double rough_radius(const BallMatrix& map, std::size_t size) {
  constexpr int rounds = 400;
  const auto places = places_of(size);
  std::vector<double> middles, x;
  for (const auto& row : map)
    for (const Ball& entry : row) middles.push_back(entry.middle());
  for (const auto& [i, k] : places) x.push_back(i == k ? 1 : 0);
  double growth = 0;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> next(x.size(), 0);
    for (std::size_t r = 0; r < x.size(); ++r)
      for (std::size_t c = 0; c < x.size(); ++c) next[r] += middles[r * x.size() + c] * x[c];
    double trace = 0;
    for (std::size_t r = 0; r < x.size(); ++r)
      if (places[r].first == places[r].second) trace += next[r];
    if (!(trace > 0) || !std::isfinite(trace)) return 0;
    growth = round == 0 ? trace / static_cast<double>(size) : trace;
    for (double& entry : next) entry /= trace;
    x = std::move(next);
  }
  return growth;
}

/// X with s X - sum of A X A^T = 1 tells on which side of the spectral radius s is.
class Resolvent {
 public:
  Resolvent(const BallMatrix& map, std::size_t size, slong bits)
      : map_(map), size_(size), bits_(bits), places_(places_of(size)) {}

  /// The coordinates of X.
  std::optional<std::vector<Ball>> at(const Rational& s) const {
    BallMatrix system = map_;
    std::vector<Ball> right;
    for (std::size_t r = 0; r < system.size(); ++r) {
      for (Ball& entry : system[r]) entry = -entry;
      system[r][r] += Ball(s, bits_);
      right.emplace_back(places_[r].first == places_[r].second ? 1L : 0L, bits_);
    }
    return solve(system, right, bits_);
  }
  Ball trace(const std::vector<Ball>& x) const {
    Ball result(0L, bits_);
    for (std::size_t r = 0; r < x.size(); ++r)
      if (places_[r].first == places_[r].second) result += x[r];
    return result;
  }
  bool is_above(const Rational& s) const {
    const auto x = at(s);
    if (!x) return false;
    BallMatrix full(size_, std::vector<Ball>(size_, Ball(bits_)));
    for (std::size_t r = 0; r < x->size(); ++r)
      full[places_[r].first][places_[r].second] = full[places_[r].second][places_[r].first] = (*x)[r];
    return is_positive_definite(full, bits_);
  }
  bool is_below(const Rational& s) const {
    const auto x = at(s);
    return x && trace(*x).is_less(Ball(0L, bits_));
  }

 private:
  const BallMatrix& map_;
  std::size_t size_;
  slong bits_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;
};

/// The zero of 1 / trace X nearest to the start, by secants; nothing proved.
std::optional<Rational> zero_near(const Resolvent& resolvent, const Rational& start, int bits,
                                  const Deadline& deadline) {
  constexpr int most_steps = 60;
  const slong precision = bits_for_congruences(bits);
  const auto value = [&](const Rational& s) -> std::optional<Ball> {
    const auto x = resolvent.at(s);
    if (!x) return std::nullopt;
    const Ball result = 1 / resolvent.trace(*x);
    return result.is_finite() ? std::optional(result) : std::nullopt;
  };
  const auto middle = [&](const Ball& ball) {
    const Enclosure ends = ball.enclosure(precision);
    return Rational((*ends.lower + *ends.upper) / 2);
  };
  Rational before = start * (1 + power(Rational(2), -10)), s = start * (1 + power(Rational(2), -16));
  auto value_before = value(before);
  for (int step = 0; value_before && step < most_steps; ++step) {
    if (deadline.expired()) return std::nullopt;
    const auto here = value(s);
    if (!here) return s;  // as near as the balls tell
    const Ball slope = (*here - *value_before) / Ball(Rational(s - before), precision);
    const Ball change = *here / slope;
    if (!change.is_finite()) return s;
    const Rational next = middle(Ball(s, precision) - change);
    if (abs(next - s) <= s * power(Rational(2), -bits - 16)) return next;
    before = s;
    value_before = here;
    s = next;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Enclosure> radius_of_congruences(const std::vector<BallMatrix>& matrices, int bits,
                                               const Deadline& deadline) {
  const std::size_t size = matrices.front().size();
  if (size > most_rows) fail(ErrorKind::size, "radius_of_congruences: need at most {} rows, got {}", most_rows, size);
  const slong precision = bits_for_congruences(bits);
  const BallMatrix map = operator_on_symmetric(matrices, precision);
  if (size == 1) return map[0][0].enclosure(precision);
  const double rough = rough_radius(map, size);
  if (!(rough > 0)) return std::nullopt;
  const Resolvent resolvent(map, size, precision);
  const auto zero = zero_near(resolvent, Rational(rough), bits, deadline);
  if (!zero) return std::nullopt;
  for (int margin = bits + 2; margin > 16; margin -= 16) {
    if (deadline.expired()) return std::nullopt;
    const Rational low = *zero * (1 - power(Rational(2), -margin)), high = *zero * (1 + power(Rational(2), -margin));
    if (resolvent.is_above(high) && resolvent.is_below(low)) return Enclosure{low, high};
  }
  return std::nullopt;
}

}  // namespace subcert::radius
