#include "samples.hpp"

#include "command.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/schemes/data/smooth/uniform_grid.hpp>

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
  return options.name() + ", line " + std::to_string(table.lines[row]) + ", column " + std::to_string(column + 1);
}

/// Sets origin and spacing, or names the spacing that is farthest from the mean.
void set_grid(const SampleOptions& options, const data::Table& table, std::size_t column, data::Samples& samples) {
  std::vector<double> x;
  x.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    x.push_back(table.values[i * table.columns + column]);
    if (std::isnan(x.back()))
      fail(ErrorKind::data, "{}: expected a position; found a missing value", place(options, table, i, column));
  }
  const auto shown = [](const Rational& value) { return to_decimal(value, 9, Rounding::nearest); };
  const auto decimal = [&](std::size_t i) { return data::decimal_value(x[i]); };
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    if (x[i + 1] <= x[i])
      fail(ErrorKind::data, "{}: expected increasing positions; found {} after {}",
           place(options, table, i + 1, column), shown(decimal(i + 1)), shown(decimal(i)));
  const data::UniformGrid grid = data::uniform_grid(x);
  if (const std::size_t worst = grid.worst; !grid.uniform)
    fail(ErrorKind::data,
         "{}, lines {} and {}: expected a uniform grid, the mean spacing is {}; found the spacing {} between {} and {}",
         options.name(), table.lines[worst], table.lines[worst + 1], shown(grid.spacing),
         shown(decimal(worst + 1) - decimal(worst)), shown(decimal(worst)), shown(decimal(worst + 1)));
  samples.origin = grid.origin;
  samples.spacing = grid.spacing;
}

/// Prior weights, with 0 for rows that lack a value.
void set_weights(const SampleOptions& options, const data::Table& table, const std::vector<std::size_t>& values,
                 std::optional<std::size_t> weights, data::Samples& samples) {
  std::vector<Rational> result;  // none as long as all are 1
  if (weights) result.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (weights) {
      const double value = table.values[i * table.columns + *weights];
      if (!(value >= 0))
        fail(ErrorKind::data, "{}: expected a weight >= 0; found {}", place(options, table, i, *weights),
             (std::isnan(value) ? "a missing value" : data::shortest_text(value)));
      result.push_back(data::decimal_value(value));
    }
    for (const std::size_t column : values) {
      if (!std::isnan(table.values[i * table.columns + column])) continue;
      if (options.missing != "drop")
        fail(ErrorKind::data, "{}: expected a number; found a missing value (--missing drop leaves it out)",
             place(options, table, i, column));
      if (result.empty()) result.assign(table.rows(), 1);
      result[i] = 0;
    }
  }
  if (!result.empty() && std::all_of(result.begin(), result.end(), [](const Rational& weight) { return weight == 0; }))
    fail(ErrorKind::data, "{}: expected a row that is neither missing nor of weight 0; found none", options.name());
  samples.weights = std::move(result);
}

}  // namespace

std::string SampleOptions::name() const { return input_name(file); }

NamedSamples read_samples(const SampleOptions& options) {
  const data::Table table = data::parse_table(read_input(options.file), options.name(), data::Missing::keep);
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
  if (values.empty()) fail(ErrorKind::data, "{}: expected a column of values; found none", options.name());
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
    column.reserve(table.rows());
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
