#pragma once
/// Which columns of a table of samples hold what, and dates in the place of numbers.

#include "read_samples.hpp"

#include <optional>
#include <string>
#include <vector>

namespace subcert::data {

/// Which columns of a table hold what.
struct ColumnUse {
  std::optional<std::size_t> x;
  std::optional<std::size_t> weights;
  std::vector<std::size_t> values;
  std::optional<std::size_t> by;
  std::vector<std::size_t> kept;
  std::vector<std::size_t> left_out;  ///< text that nobody asked for
  bool numbered = false;              ///< the first column counts the rows, and is left out
  bool dates = false;                 ///< in x
};

std::string column_name(const Table& table, std::size_t column);

/// By name, or number from 1. Errors: throws a usage error.
std::size_t find_column(const Table& table, const std::string& option, const std::string& text);

/// As errors name it.
std::string place(const SampleOptions& options, const Table& table, std::size_t row, std::size_t column);

/// The fields of a column that the table keeps as they are written.
const std::vector<std::string>& fields_of(const Table& table, const std::vector<std::size_t>& kept, std::size_t column);

/// Whether the first text of a column without numbers is a date.
bool holds_dates(const Table& table, std::size_t column);

/// Errors: throws a usage error for unknown columns, a data error where there are no values.
ColumnUse find_columns(const SampleOptions& options, const Table& table);

/// Refuses text in columns that are to hold numbers.
void require_numbers(const Table& table, const ColumnUse& use);

/// Puts units of time in the place of dates. Errors: a data error for text that is none, or is written otherwise.
DateForm read_dates(const SampleOptions& options, Table& table, const std::vector<std::string>& fields,
                    std::size_t column);

/// Puts days in the place of dates that are written as numbers, as 20240229; whether all in the column are.
bool read_number_dates(Table& table, std::size_t column);

}  // namespace subcert::data
