#include "letters.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

void add(LetterPolynomial& sum, const std::array<unsigned, letters>& powers, const mpq_class& factor) {
  const auto [place, is_new] = sum.try_emplace(powers, factor);
  if (!is_new) place->second += factor;
  if (place->second == 0) sum.erase(place);
}

Interval value(const LetterPolynomial& p, const Letters& at, const Intervals& intervals) {
  Interval sum{0, 0};
  for (const auto& [powers, factor] : p) {
    Interval product = intervals.number(factor);
    for (std::size_t v = 0; v < letters; ++v)
      for (unsigned k = 0; k < powers[v]; ++k) product = intervals.times(product, at[v]);
    sum = sum + product;
  }
  return sum;
}

}  // namespace

LetterPolynomial letter(Letter which, const mpq_class& factor) {
  std::array<unsigned, letters> powers{};
  powers[which] = 1;
  return {{powers, factor}};
}

LetterPolynomial operator+(const LetterPolynomial& x, const LetterPolynomial& y) {
  LetterPolynomial sum = x;
  for (const auto& [powers, factor] : y) add(sum, powers, factor);
  return sum;
}

LetterPolynomial times(const LetterPolynomial& x, const LetterPolynomial& y, Arithmetic& arithmetic) {
  LetterPolynomial product;
  for (const auto& [p, factor] : x)
    for (const auto& [q, other] : y) {
      const mpq_class value = factor * other;
      const std::size_t words = (bits(value.get_num()) + bits(value.get_den())) / 64 + 1;
      arithmetic.spend(300 + words * words);
      std::array<unsigned, letters> powers{};
      for (std::size_t v = 0; v < letters; ++v) powers[v] = p[v] + q[v];
      add(product, powers, value);
    }
  return product;
}

LetterPolynomial derivative(const LetterPolynomial& x, Letter by) {
  LetterPolynomial result;
  for (const auto& [powers, factor] : x) {
    std::array<unsigned, letters> less = powers;
    if (less[by]-- > 0) result[less] = factor * powers[by];
  }
  return result;
}

LetterTurning times(const LetterTurning& x, const LetterTurning& y, const LetterPolynomial& cosine,
                    Arithmetic& arithmetic) {
  const LetterPolynomial bb = times(x.b, y.b, arithmetic), minus{{{}, -1}}, twice{{{}, 2}};
  return {times(x.a, y.a, arithmetic) + times(minus, bb, arithmetic),
          times(x.a, y.b, arithmetic) + times(x.b, y.a, arithmetic) +
              times(twice, times(cosine, bb, arithmetic), arithmetic)};
}

LetterTurning operator+(const LetterTurning& x, const LetterTurning& y) { return {x.a + y.a, x.b + y.b}; }

LetterTurning turned(LetterTurning x, long turns, const LetterPolynomial& cosine, Arithmetic& arithmetic) {
  const LetterPolynomial twice = times({{{}, 2}}, cosine, arithmetic), minus{{{}, -1}};
  for (; turns > 0; --turns) x = {times(minus, x.b, arithmetic), x.a + times(twice, x.b, arithmetic)};
  for (; turns < 0; ++turns) x = {x.b + times(twice, x.a, arithmetic), times(minus, x.a, arithmetic)};
  return x;
}

std::vector<LetterPolynomial> characteristic_polynomial(const std::vector<std::vector<LetterTurning>>& matrix,
                                                        const LetterPolynomial& cosine, Arithmetic& arithmetic) {
  // M_1 = A, c_j = -tr(M_j)/j, M_(j+1) = A (M_j + c_j) [Faddeev and LeVerrier].
  const std::size_t n = matrix.size();
  std::vector<LetterPolynomial> result(n + 1, {{{}, 1}});
  auto product = matrix;
  for (std::size_t j = 1; j <= n; ++j) {
    LetterTurning trace;
    for (std::size_t i = 0; i < n; ++i) trace = trace + product[i][i];
    require(trace.b.empty(), "the eigenvalues of a frequency and of its opposite are not the same");
    result[n - j] = times({{{}, ratio(-1, mpz_class(j))}}, trace.a, arithmetic);
    for (std::size_t i = 0; i < n; ++i) product[i][i].a = product[i][i].a + result[n - j];
    std::vector<std::vector<LetterTurning>> next(n, std::vector<LetterTurning>(n));
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t s = 0; s < n; ++s)
        for (std::size_t k = 0; k < n; ++k)
          next[r][s] = next[r][s] + times(matrix[r][k], product[k][s], cosine, arithmetic);
    product = std::move(next);
  }
  return result;
}

IntervalPolynomial values(const std::vector<LetterPolynomial>& p, const Letters& at, const Intervals& intervals) {
  IntervalPolynomial result;
  for (const LetterPolynomial& coefficient : p) result.push_back(value(coefficient, at, intervals));
  return result;
}

IntervalPolynomial derivatives(const std::vector<LetterPolynomial>& p, Letter by, const Letters& at,
                               const Intervals& intervals) {
  IntervalPolynomial result;
  for (const LetterPolynomial& coefficient : p) result.push_back(value(derivative(coefficient, by), at, intervals));
  return result;
}

Interval value_at(const IntervalPolynomial& p, const Interval& x, const Intervals& intervals) {
  Interval value{0, 0};
  for (std::size_t i = p.size(); i-- > 0;) value = intervals.times(value, x) + p[i];
  return value;
}

Interval slope_at(const IntervalPolynomial& p, const Interval& x, const Intervals& intervals) {
  Interval value{0, 0};
  for (std::size_t i = p.size(); i-- > 1;) value = intervals.times(value, x) + Interval{p[i].low * i, p[i].high * i};
  return value;
}

std::optional<Interval> quotient(const Interval& x, const Interval& y, const Intervals& intervals) {
  if (y.low > 0) return intervals.over(x, y);
  if (y.high < 0) return intervals.over(-x, -y);
  return std::nullopt;
}

mpz_class approach_zero(const IntervalPolynomial& p, mpz_class start, const Intervals& intervals) {
  for (int step = 0; step < 40; ++step) {
    const Interval at{start, start};
    const auto change = quotient(value_at(p, at, intervals), slope_at(p, at, intervals), intervals);
    if (!change) break;
    start -= (change->low + change->high) / 2;
  }
  return start;
}

std::optional<Interval> zero_near(const IntervalPolynomial& p, const mpz_class& start, const Intervals& intervals) {
  const Interval middle{start, start}, value = value_at(p, middle, intervals);
  const auto step = quotient(value, slope_at(p, middle, intervals), intervals);
  if (!step) return std::nullopt;
  mpz_class radius = largest(*step) + 1;
  for (int attempt = 0; attempt < 4; ++attempt) {
    radius *= 2;
    const Interval around{start - radius, start + radius};
    const auto change = quotient(value, slope_at(p, around, intervals), intervals);
    if (!change) return std::nullopt;
    const Interval next = middle - *change;
    if (around.low <= next.low && next.high <= around.high) return next;
  }
  return std::nullopt;
}

IntervalPolynomial deflated(const IntervalPolynomial& p, const Interval& zero, const Intervals& intervals) {
  IntervalPolynomial result(p.size() - 1);
  Interval carry{0, 0};
  for (std::size_t i = p.size(); i-- > 1;) result[i - 1] = carry = intervals.times(carry, zero) + p[i];
  return result;
}

bool has_zeros_below(IntervalPolynomial p, const mpz_class& radius, const Intervals& intervals) {
  Interval scale{intervals.one(), intervals.one()};
  for (Interval& coefficient : p) {
    coefficient = intervals.times(coefficient, scale);
    scale = intervals.times(scale, {radius, radius});
  }
  // |p_0| < |p_d|, and the same of (p - (p_0/p_d) p*)/x, p* with the coefficients in reverse.
  while (p.size() > 1) {
    const auto share = quotient(p.front(), p.back(), intervals);
    if (!share || largest(*share) >= intervals.one()) return false;
    IntervalPolynomial next;
    for (std::size_t i = 1; i < p.size(); ++i) next.push_back(p[i] - intervals.times(*share, p[p.size() - 1 - i]));
    p = std::move(next);
  }
  return true;
}

}  // namespace subcert_check
