#include "limit_range.hpp"

#include "cell_walk.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>

namespace subcert {
namespace {

bool has_negative(const Mask& mask) {
  const auto coefficients = mask.symbol().coefficients();
  return std::any_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c < 0; });
}

double cell_width(const LimitCells& cells, const CellForm& form) {
  return std::pow(static_cast<double>(cells.arity()), -form.level);
}

struct Integral {
  double lower = 0, upper = 0;
};

/// Encloses the integral of |f| over the cell.
Integral integral_of_modulus(const WalkedCell& cell, double width) {
  const CellForm& form = cell.form;
  const CellRange& range = cell.range;
  if (!cell.own || (range.value_lower < 0 && range.value_upper > 0)) {
    const double most = std::max(-range.value_lower, range.value_upper) * width * (1 + 0x1p-50);
    return {0, most};
  }
  // Of one sign. What is not the polynomial differs from 0 by at most half of the widths that both ends share.
  double sum = 0, size = 0, error = 0;
  for (std::size_t j = 0; j < form.middle.size(); ++j) {
    const double scale = std::ldexp(1.0, -static_cast<int>(j));
    error += form.radius[j] * scale;
    size += std::abs(form.middle[j]) * scale;
    if (j % 2 == 0) sum += form.middle[j] * scale / static_cast<double>(j + 1);
  }
  const double rest = (range.remainder + error + size * 0x1p-45) * (1 + 0x1p-40);
  return {std::max(0.0, (std::abs(sum) - rest) * width * (1 - 0x1p-50)),
          (std::abs(sum) + rest) * width * (1 + 0x1p-50)};
}

Decision is_nonnegative(const Enclosure& minimum) {
  if (*minimum.lower >= 0) return {Truth::yes, "the minimum is 0"};
  if (*minimum.upper < 0) return {Truth::no, "the minimum is negative"};
  return {Truth::unknown, "the minimum may be 0"};
}

}  // namespace

LimitRange limit_range(const Mask& mask, const LimitOptions& options) {
  require(options.relative_width > 0, "limit_range: need relative_width > 0, got {}", to_text(options.relative_width));
  const LimitCells cells(mask, exact_deadline(options.budget));
  const bool signs = has_negative(mask);
  const auto support = static_cast<double>(cells.last_integer() - cells.first_integer());
  const double tolerance = options.relative_width.convert_to<double>() * 0.9;
  CellExtremes extremes{Extreme(0), Extreme(0), cells.has_slopes(), tolerance};  // phi is 0 outside its support
  Integral modulus;
  LimitRange result;
  result.slope_reason = cells.slope_reason();
  result.complete = true;
  const auto split = [&](const WalkedCell& cell, bool may_split) {
    const double width = cell_width(cells, cell.form);
    const double size = std::max(extremes.highest.attained(), extremes.lowest.attained());
    const Integral integral = signs ? integral_of_modulus(cell, width) : Integral{};
    const bool settled = extremes.values_settled(cell.range, size, size) && extremes.slope_settled(cell.range) &&
                         integral.upper - integral.lower <= tolerance * width / support;  // the integral is 1 or more
    std::vector<CellForm> parts;
    if (!settled && may_split && cell.range.value_rounding < 0.5) {
      for (int t = 0; t < cells.arity(); ++t) parts.push_back(cells.child(cell.form, t, {}));
      return parts;
    }
    if (!settled) result.complete = false;
    extremes.put_aside(cell.range);
    modulus.lower += integral.lower;
    modulus.upper += integral.upper;
    return parts;
  };
  std::vector<CellForm> first;
  for (long k = cells.first_integer(); k < cells.last_integer(); ++k) first.push_back(cells.limit_form(k));
  result.cells = walk_cells(
      cells, std::move(first), options.budget, [&](const CellRange& range) { extremes.attain(range); }, split);
  result.maximum = extremes.highest.enclosure();
  result.minimum = signs ? extremes.lowest.negated() : Enclosure::exactly(0);
  result.sup_norm = {std::max(*result.maximum.lower, Rational(-*result.minimum.upper)),
                     std::max(*result.maximum.upper, Rational(-*result.minimum.lower))};
  result.nonnegative = is_nonnegative(result.minimum);
  if (extremes.slopes) result.slope = extremes.steepest.enclosure();
  result.l1_norm = Enclosure::exactly(1);
  if (signs)
    result.l1_norm = {std::max(Rational(1), Rational(modulus.lower * (1 - 0x1p-40))),
                      Rational(modulus.upper * (1 + 0x1p-40))};
  return result;
}

Decision is_positive(const Mask& mask, const Rational& from, const Rational& to, const CellLimits& limits) {
  const Interval support = limit_support(mask);
  if (has_positive_mask(mask) && from < to && support.lower < from && to < support.upper)
    return {Truth::yes, "the mask is positive and the interval lies inside the support"};
  const LimitCells cells(mask);
  require(from < to, "need from < to, got {} and {}", to_text(from), to_text(to));
  const Integer begin = numerator(from) / denominator(from) - 1, end = numerator(to) / denominator(to) + 1;
  require(begin >= cells.first_integer() - 1 && end <= cells.last_integer() + 1,
          "need an interval inside the support [{}, {}], got {} ... {}", cells.first_integer(), cells.last_integer(),
          to_text(from), to_text(to));
  std::vector<CellForm> stack;
  for (long k = end.convert_to<long>(); k >= begin.convert_to<long>(); --k) stack.push_back(cells.limit_form(k));
  while (!stack.empty()) {
    const CellForm form = std::move(stack.back());
    stack.pop_back();
    const Rational width = power(Rational(cells.arity()), -form.level), left = Rational(form.index) * width,
                   right = left + width;
    if (right <= from || left >= to) continue;
    const CellRange range = cells.range(form);
    if (range.value_lower > 0) continue;
    if (left >= from && range.left_upper < 0) return {Truth::no, "phi(" + to_text(left) + ") < 0"};
    if (right <= to && range.right_upper < 0) return {Truth::no, "phi(" + to_text(right) + ") < 0"};
    const bool late = limits.deadline.expired();
    if (late || form.level >= std::min(limits.levels, cells.deepest_level()))
      return {Truth::unknown,
              "undecided between " + to_text(left) + " and " + to_text(right) + (late ? ": the time is up" : "")};
    for (int t = cells.arity() - 1; t >= 0; --t) stack.push_back(cells.child(form, t, {}));
  }
  return {Truth::yes, "proved on every cell"};
}

}  // namespace subcert
