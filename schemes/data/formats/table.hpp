#pragma once
/// Tables of numbers as text: comma, semicolon, tab or blank between the columns, with or without a header line.

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// values[row * columns + column]. Canonical: columns >= 1, values.size() == rows * columns, header empty or one name
/// for each column. The separator is ',', ';', '\t' or ' '.
struct Table {
  std::vector<double> values;
  std::size_t columns = 1;
  std::vector<std::string> header;
  char separator = ',';
  std::vector<std::size_t> lines;  ///< lines[row]: where the row stands in the file, from 1

  std::size_t rows() const { return values.size() / columns; }  // NOLINT(clang-analyzer-core.DivideZero): canonical
};

/// How missing values are taken: refused, or kept as NaN where a field is empty, `nan`, `NA` or `null`.
enum class Missing { refuse, keep };

/// Reads a table. The separator is the first of semicolon, tab, comma that occurs in the first line, else blanks. The
/// first line is a header where none of its fields is a number or made of a number's characters. Lines that begin with
/// # and empty lines at the beginning and the end are skipped; fields may stand in double quotes. `file` is the name
/// for errors. Errors: throws a data error for no rows, rows of different lengths, text where a number belongs,
/// values that are not finite. Cost: linear.
Table parse_table(std::string_view text, const std::string& file, Missing missing = Missing::refuse);

/// Reads a table piece by piece.
class TableReader {
 public:
  /// As parse_table().
  explicit TableReader(const std::string& file, Missing missing = Missing::refuse);
  ~TableReader();
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;

  /// The rows of these lines, which are whole; header and separator as soon as a line had them. It stands until the
  /// next call; rows may be moved from it. Errors: as parse_table(), but for no rows. Cost: linear.
  Table& read(std::string_view lines);
  /// Throws a data error where no row came.
  void finish() const;

 private:
  class Lines;
  std::unique_ptr<Lines> lines_;
};

/// The text of a table: shortest decimal numbers that read back as the same doubles, lines end with a line feed.
std::string to_text(const Table& table);

/// values[row * stride], row = 0, 1, ...
struct TableColumn {
  const double* values;
  std::size_t stride = 1;
};

/// The header line of a table, nothing for an empty header.
std::string header_text(const std::vector<std::string>& header, char separator);

/// Writes rows as to_text does, block by block: memory does not grow with their number. Domain: one column or more, of
/// `rows` values, threads >= 1. Errors: those of the stream.
void write_rows(std::ostream& stream, const std::vector<TableColumn>& columns, std::size_t rows, char separator,
                int threads);

/// The shortest decimal text that reads back as `value`.
std::string shortest_text(double value);

}  // namespace subcert::data
