#include "sample_columns.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/runtime/input.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::data {
namespace {

/// As in the column of dates of the samples, of numbers as 20240229, or else written for the same zone and unit.
std::optional<double> date_value(const std::string& field, const DateForm& form) {
  if (const auto value = parse_date(field, form)) return value;
  for (const Date& reading : readings_of_date(field))
    if (reading.form.unit() == form.unit() && reading.form.zone == form.zone) return reading.value;
  const auto number = form.unit() == DateUnit::day ? parse_number(field) : std::nullopt;
  return number ? day_of_number(nearest_double(*number)) : std::nullopt;
}

std::string kind_of(const NamedSamples& samples) { return samples.dates ? "a date as those of the data" : "a number"; }

}  // namespace

GivenPositions GivenPositions::of_list(const std::string& list) {
  GivenPositions result;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::size_t first = list.find_first_not_of(' ', begin), last = list.find_last_not_of(' ', end - 1);
    if (end == begin || first >= end)
      fail(ErrorKind::usage, "--at {}: expected grid, data, or positions as 1,2.5,7", list);
    result.listed_.push_back(list.substr(first, last - first + 1));
    begin = end + 1;
  }
  return result;
}

GivenPositions GivenPositions::of_file(const SampleOptions& options, const std::string& file) {
  GivenPositions result;
  result.options_ = options;
  result.options_.file = file;
  result.text_ = runtime::read_input(file);
  return result;
}

std::vector<double> GivenPositions::of(const NamedSamples& samples) const {
  std::vector<double> positions;
  for (const std::string& field : listed_) {
    const auto number = samples.dates ? std::nullopt : parse_number(field);
    const auto value = samples.dates ? date_value(field, *samples.dates)
                       : number      ? std::optional(nearest_double(*number))
                                     : std::nullopt;
    if (!value || !std::isfinite(*value))
      fail(ErrorKind::usage, "--at: expected grid, data, or positions, each {}; found {}", kind_of(samples),
           in_quotes(field));
    positions.push_back(*value);
  }
  if (!listed_.empty()) return positions;
  TableForm form = options_.form();
  Table table = parse_table(text_, options_.name(), form);
  const auto named = std::ranges::find(table.header, samples.x_name);
  const std::size_t column = named == table.header.end() ? 0 : static_cast<std::size_t>(named - table.header.begin());
  form.kept = {column};
  table = parse_table(text_, options_.name(), form);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& field = table.fields.front()[row];
    const auto value = samples.dates ? date_value(field, *samples.dates)
                                     : std::optional(table.values[row * table.columns + column]);
    if (!value || std::isnan(*value))
      fail(ErrorKind::data, "{}: expected {}; found {}", place(options_, table, row, column), kind_of(samples),
           is_missing(field) ? "a missing value" : in_quotes(field));
    positions.push_back(*value);
  }
  return positions;
}

}  // namespace subcert::data
