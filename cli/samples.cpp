#include "samples.hpp"

#include "command.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::cli {
namespace {

constexpr double largest_value = 1e150;  // squares stay finite

std::string column_name(const data::Table& table, std::size_t column) {
  return table.header.empty() ? "column " + std::to_string(column + 1) : table.header[column];
}

std::size_t find_column(const data::Table& table, const std::string& option, const std::string& text) {
  const auto named = std::find(table.header.begin(), table.header.end(), text);
  if (named != table.header.end()) return static_cast<std::size_t>(named - table.header.begin());
  const auto number = parse_rational(text);
  if (number && denominator(*number) == 1 && *number >= 1 && *number <= Rational(table.columns))
    return numerator(*number).convert_to<std::size_t>() - 1;
  std::string known;
  for (const std::string& name : table.header) known += (known.empty() ? " or one of " : ", ") + name;
  fail(ErrorKind::usage, "{} {}: expected a column from 1 to {}{}", option, text, table.columns, known);
}

std::string place(const SampleOptions& options, const data::Table& table, std::size_t row, std::size_t column) {
  return options.file + ", line " + std::to_string(table.lines[row]) + ", column " + std::to_string(column + 1);
}

/// The decimal number that was read as this double, and the place of its last digit.
Decimal decimal_of(double value) {
  if (const auto decimal = parse_decimal(data::shortest_text(value))) return *decimal;
  return {Rational(value), 0};
}

/// Sets origin and spacing, or names the spacing that is farthest from the mean.
void set_grid(const SampleOptions& options, const data::Table& table, std::size_t column, data::Samples& samples) {
  std::vector<Rational> x;
  Rational unit = -1, largest = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double value = table.values[i * table.columns + column];
    if (std::isnan(value))
      fail(ErrorKind::data, "{}: expected a position; found a missing value", place(options, table, i, column));
    const Decimal decimal = decimal_of(value);
    x.push_back(decimal.value);
    if (unit < 0 || decimal.unit < unit) unit = decimal.unit;
    largest = std::max(largest, Rational(abs(decimal.value)));
  }
  samples.origin = x.front();
  if (x.size() == 1) return;
  const Rational mean = (x.back() - x.front()) / Rational(x.size() - 1);
  const auto shown = [](const Rational& value) { return to_decimal(value, 9, Rounding::nearest); };
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    if (x[i + 1] <= x[i])
      fail(ErrorKind::data, "{}: expected increasing positions; found {} after {}",
           place(options, table, i + 1, column), shown(x[i + 1]), shown(x[i]));
  const Rational allowed = std::min(unit, Rational(mean / 20)) + largest * power(Rational(2), -48);
  bool uniform = true;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    uniform = uniform && abs(x[i] - x.front() - mean * Rational(i)) <= allowed;
    if (i > 0 && abs(x[i] - x[i - 1] - mean) > abs(x[worst + 1] - x[worst] - mean)) worst = i - 1;
  }
  if (!uniform)
    fail(ErrorKind::data,
         "{}, lines {} and {}: expected a uniform grid, the mean spacing is {}; found the spacing {} between {} and {}",
         options.file, table.lines[worst], table.lines[worst + 1], shown(mean), shown(x[worst + 1] - x[worst]),
         shown(x[worst]), shown(x[worst + 1]));
  samples.spacing = mean;
}

/// Prior weights, with 0 for rows that lack a value.
void set_weights(const SampleOptions& options, const data::Table& table, const std::vector<std::size_t>& values,
                 std::optional<std::size_t> weights, data::Samples& samples) {
  bool needed = weights.has_value();
  std::vector<Rational> result;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    Rational weight = 1;
    if (weights) {
      const double value = table.values[i * table.columns + *weights];
      if (!(value >= 0))
        fail(ErrorKind::data, "{}: expected a weight >= 0; found {}", place(options, table, i, *weights),
             (std::isnan(value) ? "a missing value" : data::shortest_text(value)));
      weight = decimal_of(value).value;
    }
    for (const std::size_t column : values) {
      if (!std::isnan(table.values[i * table.columns + column])) continue;
      if (options.missing != "drop")
        fail(ErrorKind::data, "{}: expected a number; found a missing value (--missing drop leaves it out)",
             place(options, table, i, column));
      weight = 0;
      needed = true;
    }
    result.push_back(weight);
  }
  if (std::all_of(result.begin(), result.end(), [](const Rational& weight) { return weight == 0; }))
    fail(ErrorKind::data, "{}: expected a row that is neither missing nor of weight 0; found none", options.file);
  if (needed) samples.weights = result;
}

}  // namespace

NamedSamples read_samples(const SampleOptions& options) {
  const data::Table table = data::parse_table(read_file(options.file), options.file, data::Missing::keep);
  std::optional<std::size_t> weights, x;
  if (!options.weights.empty()) weights = find_column(table, "--weights", options.weights);
  const bool none = options.x == "none";
  if (!options.x.empty() && !none) x = find_column(table, "--x", options.x);
  std::vector<std::size_t> values;
  for (const std::string& text : options.y) values.push_back(find_column(table, "--y", text));
  std::vector<std::size_t> left;
  for (std::size_t c = 0; c < table.columns; ++c)
    if (c != weights && c != x && std::find(values.begin(), values.end(), c) == values.end()) left.push_back(c);
  if (options.x.empty() && (values.empty() ? left.size() > 1 : !left.empty())) {
    x = left.front();
    left.erase(left.begin());
  }
  if (values.empty()) values = left;
  if (values.empty()) fail(ErrorKind::data, "{}: expected a column of values; found none", options.file);
  for (const std::size_t c : values)
    if (c == weights || c == x) fail(ErrorKind::usage, "--y: column {} has another use", c + 1);

  NamedSamples samples;
  samples.separator = table.columns == 1 ? ',' : table.separator;
  samples.x_name = x ? column_name(table, *x) : "x";
  if (x) set_grid(options, table, *x, samples);
  set_weights(options, table, values, weights, samples);
  for (const std::size_t c : values) {
    samples.names.push_back(column_name(table, c));
    auto& column = samples.columns.emplace_back();
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const double value = table.values[i * table.columns + c];
      if (std::abs(value) > largest_value)
        fail(ErrorKind::data, "{}: expected at most 1e150 in modulus; found {}", place(options, table, i, c),
             data::shortest_text(value));
      column.push_back(std::isnan(value) ? 0 : value);
    }
  }
  return samples;
}

}  // namespace subcert::cli
