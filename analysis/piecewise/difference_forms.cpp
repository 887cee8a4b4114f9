#include "difference_forms.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>

#include <algorithm>

namespace subcert::piecewise {
namespace {

/// sum += factor * row.
void add_multiple(Row& sum, const Rational& factor, const Row& row) {
  if (factor == 0) return;
  if (sum.size() < row.size()) sum.resize(row.size(), 0);
  for (std::size_t j = 0; j < row.size(); ++j)
    if (row[j] != 0) sum[j] += factor * row[j];
}

/// (-1)^(order - s) binom(order, s) for s = 0, ..., order.
Row difference_form(int order) {
  Row form{order % 2 == 0 ? 1 : -1};
  for (int s = 0; s < order; ++s) form.push_back(form.back() * Rational(s - order, s + 1));
  return form;
}

/// Data by their differences of this order, the first `order` data being zero: row j has the coefficients of datum j.
std::vector<Row> data_by_differences(std::size_t count, std::size_t order) {
  std::vector<Row> rows(count);
  for (std::size_t j = order; j < count; ++j) {
    rows[j].assign(j - order + 1, 0);
    rows[j].back() = 1;
  }
  for (std::size_t k = 0; k < order; ++k)
    for (std::size_t j = order; j + 1 < count; ++j) add_multiple(rows[j + 1], 1, rows[j]);
  return rows;
}

/// p(x): coefficient k belongs to (2 x / (points - 1))^k.
Row fit_value(const Rule& rule, std::size_t begin, const Rational& twice_x) {
  Row row(begin, 0);
  const Rational x = twice_x / static_cast<long>(rule.points - 1);
  row.push_back(1);
  for (int k = 0; k < rule.degree; ++k) row.push_back(row.back() * x);
  return row;
}

Forms forms_of(const Rule& rule, const Dependence& plan, int order) {
  Forms result;
  const auto differences = static_cast<std::size_t>(order), own = static_cast<std::size_t>(rule.degree) + 1;
  result.data = data_by_differences(plan.levels[0].count, differences);
  result.boxed = plan.levels[0].count - std::min(differences, plan.levels[0].count);
  result.dimension = result.boxed + own * plan.windows.size();
  std::vector<std::vector<Row>> values{result.data};  // [level][index]
  for (std::size_t level = 1; level < plan.levels.size(); ++level) values.emplace_back(plan.levels[level].count);
  for (std::size_t w = 0; w < plan.windows.size(); ++w) {
    const auto [level_number, window] = plan.windows[w];
    const auto level = static_cast<std::size_t>(level_number);
    const std::size_t begin = result.boxed + own * w;
    for (std::size_t r = 0; r < rule.points; ++r) {
      Row residual = values[level][static_cast<std::size_t>(window - plan.levels[level].first) + r];
      add_multiple(residual, -1, fit_value(rule, begin, 2 * static_cast<long>(r) - static_cast<long>(rule.points - 1)));
      result.residuals.push_back(std::move(residual));
    }
    for (long phase = 0; phase < rule.arity(); ++phase) {
      const long index = rule.arity() * window + phase - plan.levels[level + 1].first;
      if (index >= 0 && index < static_cast<long>(plan.levels[level + 1].count))
        values[level + 1][static_cast<std::size_t>(index)] = fit_value(
            rule, begin, 2 * rule.places[static_cast<std::size_t>(phase)]);
    }
  }
  const Row difference = difference_form(order);
  for (std::size_t s = 0; s < difference.size(); ++s) add_multiple(result.objective, difference[s], values.back()[s]);
  return result;
}

}  // namespace

Dependence dependence(const Rule& rule, int steps, int order, long start) {
  Dependence result;
  result.levels.resize(static_cast<std::size_t>(steps) + 1);
  long low = start, high = start + order;
  result.levels.back() = {low, static_cast<std::size_t>(order) + 1};
  for (int level = steps - 1; level >= 0; --level) {
    const long first = floor_divide(low, rule.arity()), last = floor_divide(high, rule.arity());
    std::vector<WindowPlace> windows;
    for (long window = first; window <= last; ++window) windows.push_back({level, window});
    result.windows.insert(result.windows.begin(), windows.begin(), windows.end());
    low = first;
    high = last + static_cast<long>(rule.points) - 1;
    result.levels[static_cast<std::size_t>(level)] = {low, static_cast<std::size_t>(high - low + 1)};
  }
  return result;
}

Forms forms_for(Aim aim, const Rule& rule, const Dependence& plan, int order) {
  Forms forms = forms_of(rule, plan, order);
  if (aim == Aim::modulus) return forms;
  for (Rational& entry : forms.objective) entry = -entry;
  for (std::size_t j = 0; j < forms.boxed; ++j) {
    forms.residuals.emplace_back(j + 1, 0);
    forms.residuals.back().back() = 1;
  }
  return forms;
}

}  // namespace subcert::piecewise
