#pragma once
/// Tables of numbers as text: comma, semicolon, tab or blank between the columns, with or without a header line.

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// What a column holds beside numbers, where text is taken.
struct ColumnContent {
  std::size_t numbers = 0;
  std::string text;             ///< the first field that is text, or a number that is not finite
  std::string why;              ///< where it stands, and what was expected there; empty: there is none
  bool is_like_number = false;  ///< the field was to be a number, as `1.2.3`, or one with another decimal mark
  /// Whether nothing in it is or was to be a number.
  bool is_text() const { return numbers == 0 && !why.empty() && !is_like_number; }
};

/// values[row * columns + column]. Canonical: columns >= 1, values.size() == rows * columns, header empty or one name
/// for each column. The separator is ',', ';', '\t' or ' ', or what the form says.
struct Table {
  std::vector<double> values;
  std::size_t columns = 1;
  std::vector<std::string> header;
  char separator = ',';
  char decimal = '.';
  std::vector<std::size_t> lines;       ///< lines[row]: where the row stands in the file, from 1
  std::vector<std::size_t> places;      ///< of rows that are one field of the file: its column, from 1; else none
  bool row_names = false;               ///< the header has no name for the first column, which has those of the rows
  std::vector<ColumnContent> contents;  ///< of each column, of all that was read
  std::vector<std::vector<std::string>> fields;  ///< fields[k][row]: as written in the column form.kept[k]

  std::size_t rows() const { return values.size() / columns; }  // NOLINT(clang-analyzer-core.DivideZero): canonical
};

/// How missing values are taken: refused, or kept as NaN where a field is empty, `nan`, `NA` or `null`.
enum class Missing { refuse, keep };

/// Whether this field is a missing value.
bool is_missing(std::string_view field);

/// How a table is read.
struct TableForm {
  TableForm(Missing how = Missing::refuse)
      : missing(how) {}  // NOLINT(google-explicit-constructor): the other rules
                         // are seldom needed
  Missing missing;
  bool text = false;                   ///< what is no finite number is kept as NaN, and the contents say where it is
  char separator = 0;                  ///< 0: found
  char decimal = '.';                  ///< or ','
  std::optional<bool> header = {};     ///< whether the first row is one; nothing: found
  std::vector<std::size_t> kept = {};  ///< columns whose fields are kept as they are written
  std::string gaps = {};               ///< ends the error for a missing value: what would help
};

/// Reads a table. The separator is the first of semicolon, tab, comma (unless that is the decimal mark) that occurs in
/// the first line, else blanks. The first line is a header where none of its fields is a number or made of a number's
/// characters; between blanks or tabs it may have one field less than the rows, which then begin with their names, as R
/// writes them. Lines that begin with # and empty lines at the beginning and the end are skipped; fields may stand in
/// double quotes. `file` is the name for errors. Errors: throws a data error for no rows, rows of different lengths,
/// text where a number belongs, values that are not finite. Cost: linear.
Table parse_table(std::string_view text, const std::string& file, const TableForm& form = {});

/// Reads a table piece by piece.
class TableReader {
 public:
  /// As parse_table().
  explicit TableReader(const std::string& file, const TableForm& form = {});
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

/// values[row * stride], row = 0, 1, ..., or texts[row].
struct TableColumn {
  const double* values;
  std::size_t stride = 1;
  const std::string* texts = nullptr;
};

/// The text between double quotes, as a field of a line.
std::string quoted(const std::string& text);

/// The text as a field of a line; between quotes where it is empty, or a separator, a quote or an end of line asks for
/// them.
std::string quoted_where_needed(const std::string& name, char separator);

/// The header line of a table, nothing for an empty header.
std::string header_text(const std::vector<std::string>& header, char separator);

/// Writes rows as to_text does, block by block: memory does not grow with their number. Domain: one column or more, of
/// `rows` values, threads >= 1. Errors: those of the stream.
void write_rows(std::ostream& stream, const std::vector<TableColumn>& columns, std::size_t rows, char separator,
                int threads, char decimal = '.');

/// The shortest decimal text that reads back as `value`.
std::string shortest_text(double value);

}  // namespace subcert::data
