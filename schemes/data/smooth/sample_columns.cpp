#include "sample_columns.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace subcert::data {
namespace {

constexpr double largest_value = 1e150;  // squares stay finite

/// Prior weights, with 0 for rows that lack a value.
void set_weights(const SampleOptions& options, const Table& table, const std::vector<std::size_t>& values,
                 std::optional<std::size_t> weights, Samples& samples) {
  std::vector<Rational> result;  // none as long as all are 1
  if (weights) result.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (weights) {
      const double value = table.values[i * table.columns + *weights];
      const bool is_error = !options.errors.empty();
      if (is_error ? !(value >= 1e-75 && value <= 1e75) : !(value >= 0))
        fail(ErrorKind::data, "{}: expected {}; found {}", place(options, table, i, *weights),
             is_error ? "a standard deviation from 1e-75 to 1e75" : "a weight >= 0",
             (std::isnan(value) ? "a missing value" : shortest_text(value)));
      result.push_back(is_error ? Rational(1 / power(decimal_value(value), 2)) : decimal_value(value));
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
  samples.weights = std::move(result);
}

}  // namespace

std::string shown(const Rational& value) { return to_decimal(value, 9, Rounding::nearest); }

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
  return options.name() + ", line " + std::to_string(table.lines[row]) + ", column " +
         std::to_string(table.places.empty() ? column + 1 : table.places[row]);
}

std::optional<Rational> given_spacing(const SampleOptions& options) {
  if (options.spacing.empty()) return std::nullopt;
  auto spacing = parse_number(options.spacing);
  if (!spacing || *spacing <= 0) fail(ErrorKind::usage, "--spacing {}: expected a number > 0", options.spacing);
  return spacing;
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

/// Whether a text may be a date or a time of day in a form that is not read: numbers with marks between them, and
/// perhaps the name of a month.
bool may_be_date(std::string_view text) {
  int numbers = 0, words = 0;
  bool colon = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto is_digit = [&](std::size_t k) { return k < text.size() && text[k] >= '0' && text[k] <= '9'; };
    const auto is_letter = [&](std::size_t k) {
      return k < text.size() && ((text[k] | 32) >= 'a') && ((text[k] | 32) <= 'z');
    };
    if (is_digit(i)) {
      ++numbers;
      while (is_digit(i + 1)) ++i;
    } else if (is_letter(i)) {
      std::string word;
      for (word += text[i]; is_letter(i + 1);) word += text[++i];
      if (word.size() >= 3 && !readings_of_date(word.substr(0, 3) + " 2000").empty())
        ++words;
      else if (word != "T" && word != "Z" && word != "AM" && word != "PM" && word != "am" && word != "pm")
        return false;
    } else if (std::string_view("/.-: ,+").find(text[i]) == std::string_view::npos) {
      return false;
    }
    colon = colon || text[i] == ':';
  }
  return numbers >= 3 || (colon && numbers == 2) || (words == 1 && numbers == 2);
}

/// Refuses a first column of dates that cannot be read: the answer without it is one to another question.
void require_readable_dates(const SampleOptions& options, const Table& table, const ColumnUse& use) {
  if (!options.x.empty() || std::ranges::count(use.left_out, std::size_t{0}) == 0) return;
  const std::string& text = table.contents[0].text;
  if (may_be_date(text))
    fail(ErrorKind::data,
         "{}, column 1: expected numbers, or dates as 2023-01-31, 2023-01-31T10:00, Jan-31-2023, 2023-01 or 2023Q1; "
         "found {} (--x none counts the rows)",
         options.name(), in_quotes(text));
}

}  // namespace

ColumnUse find_columns(const SampleOptions& options, const Table& table) {
  ColumnUse use;
  if (!options.weights.empty() && !options.errors.empty())
    fail(ErrorKind::usage, "--weights and --errors: expected one of the two");
  if (!options.weights.empty()) use.weights = find_column(table, "--weights", options.weights);
  if (!options.errors.empty()) use.weights = find_column(table, "--errors", options.errors);
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
  require_readable_dates(options, table, use);
  const std::size_t fewest = use.values.empty() ? 2 : 1;  // for positions among them
  if (options.x.empty() && left.size() > fewest && left.front() == 0 && counts_rows(table)) {
    use.numbered = true;
    left.erase(left.begin());
  }
  const bool blocks = options.slopes && use.values.empty() && left.size() % 2 == 0;  // of values and slopes alone
  if (options.x.empty() && left.size() >= fewest && !blocks) {
    use.x = left.front();
    left.erase(left.begin());
  }
  const auto dates = [&](std::size_t c) { return holds_dates(table, c); };
  if (use.values.empty()) std::ranges::copy_if(left, std::back_inserter(use.left_out), dates);
  std::erase_if(left, dates);
  if (use.values.empty()) use.values = left;
  if (use.values.empty()) {
    const auto spoiled = std::ranges::find_if(use.left_out, [&](std::size_t c) { return !dates(c); });
    fail(ErrorKind::data, "{}: expected a column of values; found none{}", options.name(),
         spoiled == use.left_out.end() ? "" : " (" + table.contents[*spoiled].why + ")");
  }
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

std::vector<double> read_positions(const SampleOptions& options, const Table& table, std::size_t column) {
  std::vector<double> x;
  x.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    x.push_back(table.values[i * table.columns + column]);
    if (std::isnan(x.back()) && options.missing != "drop")
      fail(ErrorKind::data, "{}: expected a position; found a missing value (--missing drop leaves the row out)",
           place(options, table, i, column));
  }
  return x;
}

NamedSamples named_columns(const Table& table, const ColumnUse& use) {
  NamedSamples samples;
  samples.separator = table.columns > 1 ? table.separator : table.decimal == ',' ? ';' : ',';
  samples.decimal = table.decimal;
  for (const std::size_t c : use.values) samples.names.push_back(column_name(table, c));
  // Data that are counted have no column of positions, whose name must be a new one.
  samples.x_name = use.x ? column_name(table, *use.x) : std::ranges::count(samples.names, "x") > 0 ? "index" : "x";
  samples.columns.resize(use.values.size());
  return samples;
}

void set_rows(const SampleOptions& options, const Table& table, const ColumnUse& use, Samples& samples) {
  set_weights(options, table, use.values, use.weights, samples);
  for (std::size_t k = 0; k < use.values.size(); ++k) {
    auto& column = samples.columns[k];
    column.clear();
    column.reserve(table.rows());
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const double value = table.values[i * table.columns + use.values[k]];
      if (std::abs(value) > largest_value)
        fail(ErrorKind::data, "{}: expected at most 1e150 in modulus; found {}",
             place(options, table, i, use.values[k]), shortest_text(value));
      column.push_back(std::isnan(value) ? 0 : value);
    }
  }
}

}  // namespace subcert::data
