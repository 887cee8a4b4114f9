#include "variance_order.hpp"

#include "mirror.hpp"

#include <subcert/analysis/limit/limit_cells.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace subcert {
namespace {

/// One cell, with the forms of both curves.
struct PairOfForms {
  CellForm lower, upper;
};

/// Exact values at the ends of the cell where the difference may vanish or be negative; whether it does.
bool is_refuted_at_an_end(const Mask& first, const Mask& second, const CellForm& form, const CellRange& range,
                          VarianceOrder& result) {
  for (const bool right : {false, true}) {
    if ((right ? range.right_lower : range.left_lower) > 0) continue;
    const std::int64_t index = form.index + (right ? 1 : 0);
    const Rational difference = variance_at(second, index, form.level) - variance_at(first, index, form.level);
    if (difference > 0) continue;
    result.below = Truth::no;
    result.witness = Rational(index) * power(Rational(first.arity()), -form.level);
    result.difference = difference;
    result.reason = "at x = " + to_text(result.witness) + " the difference is " +
                    (difference == 0 ? "0" : "about " + to_decimal(difference, 6, Rounding::nearest));
    result.smallest_difference = {std::nullopt, difference};
    return true;
  }
  return false;
}

/// Parts of the cell, from the last to the first.
void push_parts(const LimitCells& lower, const LimitCells& upper, const PairOfForms& pair, const CellRange& range,
                std::vector<PairOfForms>& stack) {
  const CellRange one = lower.range(pair.lower), two = upper.range(pair.upper);
  const double spare = std::max(0.0, (range.value_upper - range.value_lower) * 0x1p-20);
  const double spare_slope = lower.has_slopes() && upper.has_slopes()
                                 ? (range.slope_upper - range.slope_lower) * 0x1p-20
                                 : 0;
  const bool mirrored = lower.is_mirrored() && upper.is_mirrored();
  for (int t = lower.arity() - 1; t >= 0; --t)
    if (!mirrored || !is_mirror_image(pair.lower, t, lower.arity()))
      stack.push_back({lower.variance_child(pair.lower, one, t, {spare, spare_slope}),
                       upper.variance_child(pair.upper, two, t, {spare, spare_slope})});
}

}  // namespace

Rational variance_at(const Mask& mask, std::int64_t index, int level) {
  require(level >= 0 && index >= 0 && Rational(index) <= power(Rational(mask.arity()), level),
          "variance_at: need level >= 0 and 0 <= index <= arity^level, got {} on level {}", index, level);
  // values[k] = phi(first + k + x) for the x reached so far; a digit t leads from x to (t + x) / arity.
  const RefinementWindow window(mask);
  const Transition<Rational> refine(window.coefficients, mask.arity());
  const LimitValues integers = limit_values(mask, 0);
  const bool at_end = Rational(index) == power(Rational(mask.arity()), level);
  std::vector<Rational> values, finer(refine.width());
  for (long k = 0; k < refine.window().width; ++k) values.push_back(integers.at(window.first + (at_end ? k + 1 : k)));
  for (int l = 0; l < level && !at_end; ++l, index /= mask.arity()) {
    refine.apply(static_cast<long>(index % mask.arity()), values.data(), finer.data());
    std::swap(values, finer);
  }
  Rational sum = 0;
  for (const Rational& value : values) sum += value * value;
  return sum;
}

VarianceOrder compare_variance(const Mask& first, const Mask& second, const VarianceOrderOptions& options) {
  require(first.arity() == second.arity(), "compare_variance: need masks of one arity, got {} and {}", first.arity(),
          second.arity());
  const LimitCells lower(first), upper(second);
  const int deepest = std::min({options.levels, lower.deepest_level(), upper.deepest_level()});
  VarianceOrder result;
  result.below = Truth::yes;
  double least = std::numeric_limits<double>::infinity(), attained = least;
  std::vector<PairOfForms> stack;  // at most arity on each level
  stack.push_back({lower.variance_form(0, 0), upper.variance_form(0, 0)});
  while (!stack.empty()) {
    const PairOfForms pair = std::move(stack.back());
    stack.pop_back();
    ++result.cells;
    const CellRange range = LimitCells::difference(upper, pair.upper, lower, pair.lower);
    attained = std::min({attained, range.left_upper, range.right_upper});
    if (range.value_lower > 0) {
      least = std::min(least, range.value_lower);
      continue;
    }
    if (is_refuted_at_an_end(first, second, pair.lower, range, result)) return result;
    const bool late = options.deadline.expired();
    if (late || pair.lower.level >= deepest) {
      least = std::min(least, range.value_lower);
      result.below = Truth::unknown;
      result.reason = "undecided around x = " +
                      to_text(Rational(2 * pair.lower.index + 1) / 2 *
                              power(Rational(first.arity()), -pair.lower.level)) +
                      (late ? ": the seconds ran out" : ": the cells cannot be split further");
      break;
    }
    push_parts(lower, upper, pair, range, stack);
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
