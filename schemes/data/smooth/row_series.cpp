#include "sample_columns.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <limits>

namespace subcert::data {
namespace {

/// The number that a name is; nothing for other names, and for numbers beyond double precision.
std::optional<double> number_of(const std::string& name, char decimal) {
  std::string text = name;
  std::ranges::replace(text, decimal, '.');
  const auto number = parse_number(text);
  if (!number || abs(*number) > Rational(std::numeric_limits<double>::max())) return std::nullopt;
  return nearest_double(*number);
}

/// The columns whose names are positions: numbers, or dates, which are read later, where more are.
struct NamedPositions {
  std::vector<std::size_t> columns = {};
  std::vector<double> numbers = {};
  bool dates = false;
};

NamedPositions positions_in_header(const SampleOptions& options, const Table& table, std::size_t by) {
  NamedPositions numbers, dates;
  dates.dates = true;
  for (std::size_t c = 0; c < table.columns; ++c) {
    if (c == by) continue;
    if (const auto number = number_of(table.header[c], table.decimal)) {
      numbers.columns.push_back(c);
      numbers.numbers.push_back(*number);
    } else if (!readings_of_date(table.header[c]).empty()) {
      dates.columns.push_back(c);
    }
  }
  dates.numbers.resize(dates.columns.size());
  const NamedPositions& more = dates.columns.size() > numbers.columns.size() ? dates : numbers;
  if (more.columns.size() < 2)
    fail(ErrorKind::data, "{}: expected two columns or more whose names are positions, numbers or dates; found {}",
         options.name(), more.columns.empty() ? "none" : in_quotes(table.header[more.columns.front()]) + " alone");
  return more;
}

/// The names of what is neither the column of names nor a position.
std::string names_left_out(const Table& table, std::size_t by, const std::vector<std::size_t>& columns) {
  std::string names;
  for (std::size_t c = 0; c < table.columns; ++c)
    if (c != by && std::ranges::count(columns, c) == 0) names += (names.empty() ? "" : ", ") + column_name(table, c);
  return names;
}

void require_rows_alone(const SampleOptions& options) {
  if (options.by.empty()) fail(ErrorKind::usage, "--series rows needs --by: the column of the names of the series");
  if (!options.x.empty() || !options.y.empty() || !options.weights.empty() || !options.errors.empty() ||
      !options.keep.empty() || options.header == "no")
    fail(ErrorKind::usage,
         "--series rows: expected none of --x, --y, --weights, --keep, --header no; the first row has the positions");
}

}  // namespace

SampleTable read_row_series(const SampleOptions& options, const std::string& text) {
  require_rows_alone(options);
  TableForm form = options.form();
  form.header = true;
  const std::size_t by = find_column(parse_table(text, options.name(), form), "--by", options.by);
  form.kept = {by};
  const Table table = parse_table(text, options.name(), form);
  const auto [columns, numbers, dates] = positions_in_header(options, table, by);
  for (const std::size_t c : columns)
    if (!table.contents[c].why.empty()) fail(ErrorKind::data, "{}", table.contents[c].why);

  SampleTable result;
  Table& series = result.table;
  series.columns = 3;
  series.header = {column_name(table, by), "x", "value"};
  series.separator = table.separator;
  series.decimal = table.decimal;
  series.contents.resize(3);
  result.kept = {0};
  series.fields.resize(dates ? 2 : 1);
  if (dates) result.kept.push_back(1);
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::size_t c = columns[k];
      series.values.insert(series.values.end(), {std::numeric_limits<double>::quiet_NaN(), numbers[k],
                                                 table.values[row * table.columns + c]});
      series.lines.push_back(table.lines[row]);
      series.places.push_back(c + 1);
      series.fields[0].push_back(table.fields[0][row]);
      if (dates) series.fields[1].push_back(table.header[c]);
    }
  series.contents[1].numbers = dates ? 0 : series.rows();
  result.use.by = 0;
  result.use.x = 1;
  result.use.values = {2};
  result.use.dates = dates;
  if (const std::string names = names_left_out(table, by, columns); !names.empty())
    result.remarks.push_back("columns whose names are no positions, left out: " + names);
  return result;
}

}  // namespace subcert::data
