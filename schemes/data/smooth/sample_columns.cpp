#include "sample_columns.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace subcert::data {

std::string column_name(const Table& table, std::size_t column) {
  return table.header.empty() ? "column " + std::to_string(column + 1) : table.header[column];
}

std::size_t find_column(const Table& table, const std::string& option, const std::string& text) {
  const auto named = std::find(table.header.begin(), table.header.end(), text);
  if (named != table.header.end()) {
    const auto first = static_cast<std::size_t>(named - table.header.begin());
    if (const auto again = std::find(named + 1, table.header.end(), text); again != table.header.end())
      fail(ErrorKind::usage,
           "{} {}: expected the name of one column; columns {} and {} have it, and are known by number", option, text,
           first + 1, again - table.header.begin() + 1);
    return first;
  }
  const auto number = parse_rational(text);
  if (number && denominator(*number) == 1 && *number >= 1 && *number <= Rational(table.columns))
    return numerator(*number).convert_to<std::size_t>() - 1;
  std::string known;
  for (const std::string& name : table.header) known += (known.empty() ? " or one of " : ", ") + name;
  fail(ErrorKind::usage, "{} {}: expected a column from 1 to {}{}{}", option, text, table.columns, known,
       did_you_mean(text, table.header));
}

std::string place(const SampleOptions& options, const Table& table, std::size_t row, std::size_t column) {
  return options.name() + ", line " + std::to_string(table.lines[row]) + ", column " + std::to_string(column + 1);
}

const std::vector<std::string>& fields_of(const Table& table, const std::vector<std::size_t>& kept,
                                          std::size_t column) {
  return table.fields[static_cast<std::size_t>(std::ranges::find(kept, column) - kept.begin())];
}

DateForm read_dates(const SampleOptions& options, Table& table, const std::vector<std::string>& fields,
                    std::size_t column) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (!is_missing(fields[i])) rows.push_back(i);
  if (rows.empty()) return {};
  // The form that takes most of the column, which one text does not tell.
  std::size_t known = 0;
  DateForm form;
  for (const Date& reading : readings_of_date(fields[rows.front()])) {
    const auto other = std::ranges::find_if(rows, [&](std::size_t i) { return !parse_date(fields[i], reading.form); });
    if (const auto taken = static_cast<std::size_t>(other - rows.begin()); taken > known) {
      known = taken;
      form = reading.form;
    }
  }
  if (known < rows.size())
    fail(ErrorKind::data, "{}: expected a date{}; found {}", place(options, table, rows[known], column),
         known > 0 ? " written as those before" : "", in_quotes(fields[rows[known]]));
  if (rows.size() > 1 && std::ranges::all_of(rows, [&](std::size_t i) { return may_be_two_years(fields[i], form); }))
    fail(
        ErrorKind::data,
        "{}: expected months; found {}, which may be two years (write months with days, or take another column by --x)",
        place(options, table, rows.front(), column), in_quotes(fields[rows.front()]));
  for (const std::size_t i : rows) table.values[i * table.columns + column] = *parse_date(fields[i], form);
  return form;
}

bool read_number_dates(Table& table, std::size_t column) {
  std::vector<double> days;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double value = table.values[i * table.columns + column];
    const auto day = std::isnan(value) ? std::optional(value) : day_of_number(value);
    if (!day) return false;
    days.push_back(*day);
  }
  for (std::size_t i = 0; i < table.rows(); ++i) table.values[i * table.columns + column] = days[i];
  return true;
}

bool holds_dates(const Table& table, std::size_t column) {
  return table.contents[column].numbers == 0 && !readings_of_date(table.contents[column].text).empty();
}

namespace {

/// Whether the first column has no name and counts the rows from 0 or 1, as R and pandas write.
bool counts_rows(const Table& table) {
  if (table.header.empty() || !table.header.front().empty()) return false;
  const double first = table.values.front();
  for (std::size_t i = 0; i < table.rows(); ++i)
    if (table.values[i * table.columns] != first + static_cast<double>(i)) return false;
  return first == 0 || first == 1;
}

}  // namespace

ColumnUse find_columns(const SampleOptions& options, const Table& table) {
  ColumnUse use;
  if (!options.weights.empty()) use.weights = find_column(table, "--weights", options.weights);
  if (!options.by.empty()) use.by = find_column(table, "--by", options.by);
  const bool none = options.x == "none";
  if (!options.x.empty() && !none) use.x = find_column(table, "--x", options.x);
  for (const std::string& text : options.y) use.values.push_back(find_column(table, "--y", text));
  for (const std::string& text : options.keep) use.kept.push_back(find_column(table, "--keep", text));
  std::vector<std::size_t> left;
  for (std::size_t c = 0; c < table.columns; ++c) {
    if (c == use.weights || c == use.x || c == use.by || std::ranges::count(use.values, c) > 0) continue;
    if (std::ranges::count(use.kept, c) > 0 || (c == 0 && table.row_names)) continue;
    if (!table.contents[c].is_text() || holds_dates(table, c))
      left.push_back(c);
    else if (use.values.empty())
      use.left_out.push_back(c);
  }
  const std::size_t fewest = use.values.empty() ? 2 : 1;  // for positions among them
  if (options.x.empty() && left.size() > fewest && left.front() == 0 && counts_rows(table)) {
    use.numbered = true;
    left.erase(left.begin());
  }
  if (options.x.empty() && left.size() >= fewest) {
    use.x = left.front();
    left.erase(left.begin());
  }
  const auto dates = [&](std::size_t c) { return holds_dates(table, c); };
  if (use.values.empty()) std::ranges::copy_if(left, std::back_inserter(use.left_out), dates);
  std::erase_if(left, dates);
  if (use.values.empty()) use.values = left;
  if (use.values.empty()) fail(ErrorKind::data, "{}: expected a column of values; found none", options.name());
  for (const std::size_t c : use.values)
    if (c == use.weights || c == use.x || c == use.by) fail(ErrorKind::usage, "--y: column {} has another use", c + 1);
  use.dates = use.x && holds_dates(table, *use.x);
  return use;
}

void require_numbers(const Table& table, const ColumnUse& use) {
  std::vector<std::size_t> columns = use.values;
  if (use.weights) columns.push_back(*use.weights);
  if (use.x && !use.dates) columns.push_back(*use.x);
  std::ranges::sort(columns);
  for (const std::size_t c : columns)
    if (!table.contents[c].why.empty()) fail(ErrorKind::data, "{}", table.contents[c].why);
}

}  // namespace subcert::data
