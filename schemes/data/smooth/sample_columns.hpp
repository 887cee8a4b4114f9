#pragma once
/// Which columns of a table hold what, and the samples in its rows. Errors are data errors that name the line.

#include "read_samples.hpp"

namespace subcert::data {

/// Which columns of a table hold what.
struct ColumnUse {
  std::optional<std::size_t> x;
  std::optional<std::size_t> weights;
  std::vector<std::size_t> values;
  std::optional<std::size_t> by;
  std::vector<std::size_t> kept;
  std::vector<std::size_t> left_out;  ///< text that nobody asked for
  bool dates = false;                 ///< in x
  bool numbered = false;              ///< the first column counts the rows, and is left out
};

/// A table of samples, and what its columns hold.
struct SampleTable {
  Table table;
  ColumnUse use;
  std::vector<std::size_t> kept;     ///< columns whose fields the table has as they are written
  std::vector<std::string> remarks;  ///< what was done that the options do not say, a line each
};

/// Each row of the text as a series, with the names of its columns for positions: a table of names, positions and
/// values. Errors: a usage error without names, or for options of columns; a data error where fewer than two columns
/// have a position for a name.
SampleTable read_row_series(const SampleOptions& options, const std::string& text);

std::string column_name(const Table& table, std::size_t column);

/// By its name, or its number from 1. Errors: a usage error that names the option.
std::size_t find_column(const Table& table, const std::string& option, const std::string& text);

/// Where a field stands, for messages.
std::string place(const SampleOptions& options, const Table& table, std::size_t row, std::size_t column);

/// A number as messages show it.
std::string shown(const Rational& value);

/// --spacing, where it is given.
std::optional<Rational> given_spacing(const SampleOptions& options);

bool holds_dates(const Table& table, std::size_t column);

ColumnUse find_columns(const SampleOptions& options, const Table& table);

/// Refuses text in columns that are to hold numbers.
void require_numbers(const Table& table, const ColumnUse& use);

/// The positions in a column; NaN where one is missing and may be.
std::vector<double> read_positions(const SampleOptions& options, const Table& table, std::size_t column);

/// Samples without data, with the names of their columns.
NamedSamples named_columns(const Table& table, const ColumnUse& use);

/// Sets values and weights to those of the rows.
void set_rows(const SampleOptions& options, const Table& table, const ColumnUse& use, Samples& samples);

}  // namespace subcert::data
