#include "variance_order.hpp"

#include <subcert/analysis/limit/limit_cells.hpp>
#include <subcert/analysis/limit/limit_values.hpp>

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>

namespace subcert {
namespace {

long floor_div(long a, long b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

Rational variance_at(const Mask& mask, std::int64_t index, int level) {
  if (level < 0 || index < 0 || Rational(index) > power(Rational(mask.arity()), level))
    throw std::invalid_argument("variance_at: need level >= 0 and 0 <= index <= arity^level, got " +
                                std::to_string(index) + " on level " + std::to_string(level));
  // values[k] = phi(first + k + x) for the x reached so far; a digit t leads from x to (t + x) / arity.
  const int arity = mask.arity();
  const IndexRange range = support(mask);
  const long first = floor_div(range.first, arity - 1), last = -floor_div(-range.last, arity - 1);
  const LimitValues integers = limit_values(mask, 0);
  const bool at_end = Rational(index) == power(Rational(arity), level);
  std::vector<Rational> values;
  for (long k = first; k <= last; ++k) values.push_back(integers.at(at_end ? k + 1 : k));
  for (int l = 0; l < level && !at_end; ++l, index /= arity) {
    const long digit = static_cast<long>(index % arity);
    std::vector<Rational> finer;
    for (long k = first; k <= last; ++k) {
      Rational sum = 0;  // phi(k + (t + x) / a) = sum over i of a_i phi(a k + t - i + x)
      for (long j = first; j <= last; ++j) {
        const Rational c = mask.symbol().coefficient(arity * k + digit - j);
        if (c != 0) sum += c * values[static_cast<std::size_t>(j - first)];
      }
      finer.push_back(std::move(sum));
    }
    values = std::move(finer);
  }
  Rational sum = 0;
  for (const Rational& value : values) sum += value * value;
  return sum;
}

VarianceOrder is_below(const Mask& first, const Mask& second, const VarianceOrderOptions& options) {
  if (first.arity() != second.arity())
    throw std::invalid_argument("is_below: need masks of one arity, got " + std::to_string(first.arity()) + " and " +
                                std::to_string(second.arity()));
  if (!(options.seconds > 0))
    throw std::invalid_argument("is_below: need seconds > 0, got " + std::to_string(options.seconds));
  const auto start = std::chrono::steady_clock::now();
  const LimitCells lower(first), upper(second);
  const int arity = first.arity();
  const bool mirrored = lower.is_mirrored() && upper.is_mirrored();
  const int deepest = std::min({options.levels, lower.deepest_level(), upper.deepest_level()});

  struct Pair {
    CellForm lower, upper;
  };
  VarianceOrder result;
  result.below = Truth::yes;
  double least = std::numeric_limits<double>::infinity(), attained = least;
  std::vector<Pair> stack;
  stack.push_back({lower.variance_form(0, 0), upper.variance_form(0, 0)});
  while (!stack.empty()) {
    const Pair pair = std::move(stack.back());
    stack.pop_back();
    ++result.cells;
    const CellRange range = LimitCells::difference(upper, pair.upper, lower, pair.lower);
    attained = std::min({attained, range.left_upper, range.right_upper});
    if (range.value_lower > 0) {
      least = std::min(least, range.value_lower);
      continue;
    }
    // An end where the difference may vanish or be negative: exact values decide there.
    for (const bool right : {false, true}) {
      if ((right ? range.right_lower : range.left_lower) > 0) continue;
      const std::int64_t index = pair.lower.index + (right ? 1 : 0);
      const int level = pair.lower.level;
      const Rational difference = variance_at(second, index, level) - variance_at(first, index, level);
      if (difference > 0) continue;
      result.below = Truth::no;
      result.witness = Rational(index) * power(Rational(arity), -level);
      result.difference = difference;
      result.reason = "at x = " + to_text(result.witness) + " the difference is " +
                      (difference == 0 ? "0" : "about " + to_decimal(difference, 6, Rounding::nearest));
      result.smallest_difference = {std::nullopt, difference};
      return result;
    }
    const bool late = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > options.seconds;
    if (late || pair.lower.level >= deepest) {
      least = std::min(least, range.value_lower);
      result.below = Truth::unknown;
      result.reason = "undecided around x = " +
                      to_text(Rational(2 * pair.lower.index + 1) / 2 * power(Rational(arity), -pair.lower.level)) +
                      (late ? ": the seconds ran out" : ": the cells cannot be split further");
      break;
    }
    const CellRange one = lower.range(pair.lower), two = upper.range(pair.upper);
    const double spare = std::max(0.0, (range.value_upper - range.value_lower) * 0x1p-20);
    const double spare_slope = lower.has_slopes() && upper.has_slopes()
                                   ? (range.slope_upper - range.slope_lower) * 0x1p-20
                                   : 0;
    std::int64_t count = arity;
    for (int l = 0; l < pair.lower.level; ++l) count *= arity;
    for (int t = arity - 1; t >= 0; --t) {
      if (mirrored && 2 * (pair.lower.index * arity + t) > count - 1) continue;
      stack.push_back({lower.variance_child(pair.lower, one, t, {spare, spare_slope}),
                       upper.variance_child(pair.upper, two, t, {spare, spare_slope})});
    }
  }
  if (!stack.empty()) {
    result.smallest_difference = {std::nullopt, Rational(attained)};
    return result;
  }
  result.smallest_difference = {Rational(least), Rational(attained)};
  if (result.below == Truth::yes)
    result.reason = "the difference is at least " + to_decimal(Rational(least), 6, Rounding::down) + " at all points";
  return result;
}

}  // namespace subcert
