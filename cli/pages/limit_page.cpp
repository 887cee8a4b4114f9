#include "limit_page.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/reports/facts/limit_facts.hpp>

#include <fmt/format.h>

#include <iomanip>
#include <sstream>

namespace subcert::cli {
namespace {

LimitOptions limit_options(const LimitPageOptions& options, const Deadline& deadline) {
  const auto width = parse_number(options.width);
  if (!width || *width <= 0)
    fail(ErrorKind::usage, "--width: expected a positive number, as 1e-9 or 1/1000, got '{}'", options.width);
  return {*width, {deadline}};
}

/// Points in a column of that width, then the values, rounded and exact.
void print_points(const std::string& scheme, const std::vector<std::pair<std::string, Rational>>& points, int width,
                  const LimitPageOptions& options) {
  const auto rounded = [](const Rational& value) { return to_decimal(value, 15, Rounding::nearest); };
  if (options.form.asked_for()) {
    formats::TableRows rows{{"x", "value", "rounded"}};
    for (const auto& [point, value] : points) rows.push_back({point, to_text(value), rounded(value)});
    return answer(options, options.form, TableAnswer{"% " + scheme + "\n", std::move(rows), {0, 1, 2}});
  }
  std::ostringstream text;
  for (const auto& [point, value] : points)
    text << std::setw(width) << point << "  " << std::setw(20) << rounded(value) << "  " << to_text(value) << "\n";
  options.answer(text.str());
}

/// Points, and numbers in columns.
void print_rows(const std::string& scheme, formats::TableRows rows, const LimitPageOptions& options) {
  if (options.form.asked_for()) {
    std::vector<std::size_t> formulas;
    for (std::size_t c = 0; c < rows.front().size(); ++c) formulas.push_back(c);
    return answer(options, options.form, TableAnswer{"% " + scheme + "\n", std::move(rows), std::move(formulas)});
  }
  std::string text;
  for (const auto& row : rows) {
    text += fmt::format("{:>12}", row.front());
    for (std::size_t c = 1; c < row.size(); ++c) text += fmt::format("  {:>20}", row[c]);
    text += "\n";
  }
  options.answer(text);
}

/// The coordinates of M^-level index.
std::string point_text(const Scheme& scheme, const LatticePoint& index, int level) {
  return coordinates_text(point_at(scheme.mask.dilation(), index, level));
}

void print_surface_values(const Scheme& scheme, const LatticePoint& orders, const LimitPageOptions& options) {
  const LatticeSequence values = limit_values(scheme.mask, options.level, orders);
  if (options.json) {
    Json points = Json::array(), numbers = Json::array();
    for (const auto& [point, value] : values) {
      points.push_back(point);
      numbers.push_back(to_text(value));
    }
    options.answer(Json{{"scheme", scheme.specification},
                        {"dilation", scheme.mask.dilation().rows()},
                        {"level", options.level},
                        {"derivative", orders},
                        {"indices", std::move(points)},
                        {"values", std::move(numbers)}});
    return;
  }
  std::vector<std::pair<std::string, Rational>> points;
  for (const auto& [index, value] : values) {
    points.emplace_back(point_text(scheme, index, options.level), value);
  }
  print_points(scheme.specification, points, 20, options);
}

}  // namespace

ExitCode print_limit_values(const Scheme& scheme, const LatticePoint& orders, const LimitPageOptions& options,
                            const Deadline& deadline) {
  if (scheme.mask.dimension() == 1)
    return print_limit_values(
        scheme.specification,
        limit_values(scheme.mask.curve(), options.level, static_cast<int>(orders.front()), deadline), options);
  print_surface_values(scheme, orders, options);
  return done;
}

ExitCode print_limit_values(const std::string& scheme, const LimitValues& values, const LimitPageOptions& options) {
  if (options.json) {
    options.answer(Json{{"scheme", scheme},
                        {"arity", values.arity},
                        {"level", values.level},
                        {"derivative", values.order},
                        {"first_index", values.first_index},
                        {"values", numbers_json(values.values)}});
    return done;
  }
  std::vector<std::pair<std::string, Rational>> points;
  for (std::size_t i = 0; i < values.values.size(); ++i)
    points.emplace_back(to_text(values.point(i)), values.values[i]);
  print_points(scheme, points, 12, options);
  return done;
}

ExitCode print_limit_values(const std::string& scheme, const EnclosedLimitValues& values,
                            const LimitPageOptions& options) {
  if (options.json) {
    Json numbers = Json::array();
    for (const Interval& value : values.values) numbers.push_back(enclosure_json(value.enclosure()));
    options.answer(Json{{"scheme", scheme},
                        {"arity", values.arity},
                        {"level", values.level},
                        {"derivative", 0},
                        {"first_index", values.first_index},
                        {"order", values.order},
                        {"levels", values.levels},
                        {"values", std::move(numbers)}});
    return done;
  }
  formats::TableRows rows{{"x", "at least", "at most"}};
  const Rational size = power(Rational(values.arity), values.level);
  for (std::size_t i = 0; i < values.values.size(); ++i) {
    const Enclosure value = values.values[i].enclosure();
    rows.push_back({to_text(Rational((values.first_index + static_cast<long>(i)) / size)), value.lower_text(15),
                    value.upper_text(15)});
  }
  print_rows(scheme, std::move(rows), options);
  return done;
}

ExitCode print_vector_values(const Scheme& scheme, const FieldValues& values, const LatticePoint& orders,
                             const LimitPageOptions& options) {
  constexpr long bits = 256;
  const std::size_t size = scheme.mask.components();
  if (options.json) {
    Json points = Json::array(), numbers = Json::array();
    for (const auto& [point, vector] : values) {
      points.push_back(point);
      Json& row = numbers.emplace_back(Json::array());
      for (const QuadraticNumber& value : vector) row.push_back(value.to_text());
    }
    options.answer(Json{{"scheme", scheme.specification},
                        {"dilation", scheme.mask.dilation().rows()},
                        {"level", options.level},
                        {"derivative", orders},
                        {"components", size},
                        {"indices", std::move(points)},
                        {"values", std::move(numbers)}});
    return done;
  }
  formats::TableRows rows{{"x"}};
  for (std::size_t c = 1; c <= size; ++c) rows.front().push_back(fmt::format("phi_{}", c));
  for (const auto& [index, vector] : values) {
    rows.push_back({point_text(scheme, index, options.level)});
    for (const QuadraticNumber& value : vector)
      rows.back().push_back(options.form.asked_for() ? value.to_text()
                                                     : to_decimal(rounded(value, bits), 15, Rounding::nearest));
  }
  print_rows(scheme.specification, std::move(rows), options);
  return done;
}

ExitCode print_limit_range(const Scheme& scheme, const LimitPageOptions& options, const Deadline& deadline) {
  const bool curve = scheme.mask.dimension() == 1;
  LimitRange range;
  try {
    range = limit_range(scheme.mask, limit_options(options, deadline));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::domain || !curve) throw;
    fail(ErrorKind::undecided, "{}: no bounds of the limit function; {}", scheme.specification, error.what());
  }
  return print_range(scheme, limit_facts(range), range.complete, curve ? 17 : 13, options, options.form);
}

}  // namespace subcert::cli
