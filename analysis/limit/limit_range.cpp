#include "limit_range.hpp"

#include "extreme.hpp"
#include "limit_cells.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace subcert {
namespace {

constexpr std::size_t most_cells = 1'000'000;  // of one level

bool has_negative(const Mask& mask) {
  const auto coefficients = mask.symbol().coefficients();
  return std::any_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c < 0; });
}

double cell_width(const LimitCells& cells, const CellForm& form) {
  return std::pow(static_cast<double>(cells.arity()), -form.level);
}

/// Encloses the integral of |f| over the cell of the form.
struct Integral {
  double lower, upper;
};

Integral integral_of_modulus(const CellForm& form, const CellRange& range, double width) {
  if (range.value_lower < 0 && range.value_upper > 0) {
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

CellForm form_at(const LimitCells& cells, std::int64_t index, int level) {
  std::vector<int> digits;
  for (int l = 0; l < level; ++l) {
    const std::int64_t digit = ((index % cells.arity()) + cells.arity()) % cells.arity();
    digits.push_back(static_cast<int>(digit));
    index = (index - digit) / cells.arity();
  }
  CellForm form = cells.limit_form(static_cast<long>(index));
  for (; !digits.empty(); digits.pop_back()) form = cells.child(form, digits.back(), {});
  return form;
}

Rational left_end(const LimitCells& cells, const CellForm& form) {
  return Rational(form.index) * power(Rational(cells.arity()), -form.level);
}

Rational width_of(const LimitCells& cells, const CellForm& form) { return power(Rational(cells.arity()), -form.level); }

/// Visits cells that meet (from, to) inside; `judge` says yes, no, or unknown for split; the rest is `no` or unknown at
/// the deepest level.
Decision for_all_cells(const LimitCells& cells, const Rational& from, const Rational& to, int levels,
                       const std::function<Decision(const CellForm&, bool inside)>& judge) {
  if (from >= to) throw std::invalid_argument("need from < to, got " + to_text(from) + " and " + to_text(to));
  const Integer begin = numerator(from) / denominator(from) - 1, end = numerator(to) / denominator(to) + 1;
  if (begin < cells.first_integer() - 1 || end > cells.last_integer() + 1)
    throw std::invalid_argument("need an interval inside the support [" + std::to_string(cells.first_integer()) + ", " +
                                std::to_string(cells.last_integer()) + "], got " + to_text(from) + " ... " +
                                to_text(to));
  std::vector<CellForm> stack;
  for (long k = end.convert_to<long>(); k >= begin.convert_to<long>(); --k) stack.push_back(cells.limit_form(k));
  while (!stack.empty()) {
    const CellForm form = std::move(stack.back());
    stack.pop_back();
    const Rational left = left_end(cells, form), right = left + width_of(cells, form);
    if (right <= from || left >= to) continue;
    const Decision decision = judge(form, left >= from && right <= to);
    if (decision.is_no()) return decision;
    if (decision.is_yes()) continue;
    if (form.level >= std::min(levels, cells.deepest_level()))
      return {Truth::unknown, "undecided between " + to_text(left) + " and " + to_text(right)};
    for (int t = cells.arity() - 1; t >= 0; --t) stack.push_back(cells.child(form, t, {}));
  }
  return {Truth::yes, "proved on every cell"};
}

}  // namespace

LimitCell limit_cell(const Mask& mask, std::int64_t index, int level) {
  const LimitCells cells(mask);
  if (level < 0 || level > cells.deepest_level())
    throw std::invalid_argument("limit_cell: need 0 <= level <= " + std::to_string(cells.deepest_level()) + ", got " +
                                std::to_string(level));
  const CellRange range = cells.range(form_at(cells, index, level));
  LimitCell cell{{Rational(range.value_lower), Rational(range.value_upper)}, std::nullopt};
  if (cells.has_slopes()) cell.slope = Enclosure{Rational(range.slope_lower), Rational(range.slope_upper)};
  return cell;
}

LimitRange limit_range(const Mask& mask, const LimitOptions& options) {
  if (options.relative_width <= 0)
    throw std::invalid_argument("limit_range: need relative_width > 0, got " + to_text(options.relative_width));
  if (!(options.seconds > 0))
    throw std::invalid_argument("limit_range: need seconds > 0, got " + std::to_string(options.seconds));
  const auto start = std::chrono::steady_clock::now();
  const LimitCells cells(mask);
  const double tolerance = options.relative_width.convert_to<double>() * 0.9;
  const bool slopes = cells.has_slopes(), signs = has_negative(mask);
  const auto support = static_cast<double>(cells.last_integer() - cells.first_integer());
  Extreme highest(0), lowest(0), steepest(0);  // phi is 0 outside its support
  double lower_integral = 0, upper_integral = 0;
  LimitRange result;
  result.slope_reason = cells.slope_reason();
  result.complete = true;
  std::vector<CellForm> active;
  for (long k = cells.first_integer(); k < cells.last_integer(); ++k) active.push_back(cells.limit_form(k));
  while (!active.empty()) {
    std::vector<CellRange> ranges;
    bool stopped = active.front().level >= cells.deepest_level() || active.size() > most_cells;
    for (const CellForm& form : active) {
      stopped = stopped ||
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > options.seconds;
      ranges.push_back(cells.range(form));
      highest.attain(std::max(ranges.back().left_lower, ranges.back().right_lower));
      lowest.attain(-std::min(ranges.back().left_upper, ranges.back().right_upper));
      if (slopes) steepest.attain(ranges.back().steepness);
    }
    result.cells += active.size();
    const double size = std::max(highest.attained(), lowest.attained());
    std::vector<CellForm> next;
    for (std::size_t i = 0; i < active.size(); ++i) {
      const CellRange& range = ranges[i];
      const double width = cell_width(cells, active[i]);
      const double slope = std::max(std::abs(range.slope_lower), std::abs(range.slope_upper));
      const Integral integral = signs ? integral_of_modulus(active[i], range, width) : Integral{0, 0};
      const bool settled = highest.is_settled(range.value_upper, tolerance * size) &&
                           lowest.is_settled(-range.value_lower, tolerance * size) &&
                           (!slopes || steepest.is_settled(slope, tolerance * steepest.attained())) &&
                           integral.upper - integral.lower <= tolerance * width / support;  // the integral is 1 or more
      if (!settled && !stopped && range.value_rounding < 0.5) {
        for (int t = 0; t < cells.arity(); ++t) next.push_back(cells.child(active[i], t, {}));
        continue;
      }
      if (!settled) result.complete = false;
      highest.put_aside(range.value_upper);
      lowest.put_aside(-range.value_lower);
      if (slopes) steepest.put_aside(slope);
      lower_integral += integral.lower;
      upper_integral += integral.upper;
    }
    active = std::move(next);
  }
  result.maximum = highest.enclosure();
  result.minimum = lowest.negated();
  if (!signs) result.minimum = Enclosure::exactly(0);
  result.sup_norm = {std::max(*result.maximum.lower, Rational(-*result.minimum.upper)),
                     std::max(*result.maximum.upper, Rational(-*result.minimum.lower))};
  if (slopes) result.slope = steepest.enclosure();
  if (signs)
    result.l1_norm = {std::max(Rational(1), Rational(lower_integral * (1 - 0x1p-40))),
                      Rational(upper_integral * (1 + 0x1p-40))};
  else
    result.l1_norm = Enclosure::exactly(1);
  return result;
}

Decision is_positive(const Mask& mask, const Rational& from, const Rational& to, int levels) {
  const Interval support = limit_support(mask);
  if (has_positive_mask(mask) && from < to && support.lower < from && to < support.upper)
    return {Truth::yes, "the mask is positive and the interval lies inside the support"};
  const LimitCells cells(mask);
  return for_all_cells(cells, from, to, levels, [&](const CellForm& form, bool) {
    const CellRange range = cells.range(form);
    const Rational left = left_end(cells, form), right = left + width_of(cells, form);
    if (range.value_lower > 0) return Decision{Truth::yes, ""};
    if (left >= from && range.left_upper < 0) return Decision{Truth::no, "phi(" + to_text(left) + ") < 0"};
    if (right <= to && range.right_upper < 0) return Decision{Truth::no, "phi(" + to_text(right) + ") < 0"};
    return Decision{Truth::unknown, ""};
  });
}

Decision is_increasing(const Mask& mask, const Rational& from, const Rational& to, int levels) {
  const LimitCells cells(mask);
  if (!cells.has_slopes()) return {Truth::unknown, cells.slope_reason()};
  // With a derived scheme without negative coefficients, phi' >= 0 wherever no difference of the control data that
  // matters is negative.
  constexpr int data_levels = 8;
  std::vector<LaurentPolynomial> differences;
  if (sum_rules(mask) > 0 && !has_negative(divided_difference_scheme(mask, 1))) {
    LaurentPolynomial data(1);
    for (int l = 0; l <= data_levels; ++l) {
      differences.push_back(data * (LaurentPolynomial(1) - LaurentPolynomial::monomial(1, 1)));
      if (data.length() > 20'000) break;
      data = data.dilated(mask.arity()) * mask.symbol();
    }
  }
  const Interval support = limit_support(mask);
  return for_all_cells(cells, from, to, levels, [&](const CellForm& form, bool inside) {
    const CellRange range = cells.range(form);
    if (range.slope_lower >= 0) return Decision{Truth::yes, ""};
    const Rational left = left_end(cells, form), right = left + width_of(cells, form);
    if (inside && range.right_upper < range.left_lower)
      return Decision{Truth::no, "phi(" + to_text(left) + ") > phi(" + to_text(right) + ")"};
    if (static_cast<std::size_t>(form.level) < differences.size()) {
      // phi' = arity^level sum of d_l phi_1(arity^level x - l), phi_1 with the same lower and a smaller upper end of
      // support.
      const auto low = Rational(form.index) - support.upper, high = Rational(form.index + 1) - support.lower;
      const long first = Integer(numerator(low) / denominator(low)).convert_to<long>() - 1,
                 last = Integer(numerator(high) / denominator(high)).convert_to<long>() + 1;
      bool none_negative = true;
      for (long l = first; l <= last && none_negative; ++l)
        none_negative = differences[static_cast<std::size_t>(form.level)].coefficient(l) >= 0;
      if (none_negative) return Decision{Truth::yes, ""};
    }
    return Decision{Truth::unknown, ""};
  });
}

}  // namespace subcert
