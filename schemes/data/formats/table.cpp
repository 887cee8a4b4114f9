#include "table.hpp"

#include "other_formats.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <ostream>

namespace subcert::data {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

enum class Kind { number, missing, infinite, text };

struct Field {
  Kind kind;
  double value;
};

/// Whether `text` is this word in capital or small letters.
bool is_word(std::string_view text, std::string_view word) {
  if (text.size() != word.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if ((text[i] | 0x20) != word[i]) return false;
  return true;
}

Field read_field(std::string_view text, char decimal) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::string with_point;
  if (decimal != '.' && text.find_first_of(".,") != std::string_view::npos) {
    if (text.find('.') != std::string_view::npos) return {Kind::text, nan};
    with_point = text;
    std::ranges::replace(with_point, decimal, '.');
    text = with_point;
  }
  if (!text.empty() && text.front() == '+' && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = end == text.data() + text.size() && !text.empty();
  if (whole && error == std::errc::result_out_of_range) {
    value = std::strtod(std::string(text).c_str(),
                        nullptr);  // too small becomes a tiny number or 0, too large infinite
    return {std::isfinite(value) ? Kind::number : Kind::infinite, value};
  }
  if (whole && error == std::errc()) {
    if (std::isnan(value)) return {Kind::missing, nan};
    return {std::isfinite(value) ? Kind::number : Kind::infinite, value};
  }
  if (text.empty() || is_word(text, "na") || is_word(text, "null")) return {Kind::missing, nan};
  return {Kind::text, nan};
}

/// A number, finite or not, or what was to be one, as `1.2.3` and `1e`.
bool is_like_number(std::string_view field, char decimal) {
  const Kind kind = read_field(field, decimal).kind;
  if (kind == Kind::number || kind == Kind::infinite) return true;
  const std::size_t first = field.find_first_not_of("+-.,");
  return first != std::string_view::npos && field[first] >= '0' && field[first] <= '9' &&
         field.find_first_not_of("0123456789+-.,eE") == std::string_view::npos;
}

/// Of names: letters of any language.
bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

}  // namespace

bool is_missing(std::string_view field) { return read_field(field, '.').kind == Kind::missing; }

/// The state of a reader between lines.
class TableReader::Lines {
 public:
  Lines(std::string file, TableForm form) : file_(std::move(file)), form_(std::move(form)) {
    table_.decimal = form_.decimal;
    table_.fields.resize(form_.kept.size());
  }

  void read(std::string_view text) {
    text_ = text;
    line_feed_ = nullptr;
    if (number_ == 0 && text_.substr(0, 3) == "\xef\xbb\xbf") text_.remove_prefix(3);
    if (number_ == 0)
      if (const std::string other = other_format(text_); !other.empty())
        subcert::fail(ErrorKind::data, "{}: expected text in UTF-8; found {}", file_, other);
    while (next_line()) {
      if (line_.find('\0') != std::string_view::npos) fail(0, "a text file; found a zero byte");
      if (trimmed(line_).empty()) {
        if (empty_line_ == 0 && rows_ > 0) empty_line_ = number_;
        continue;
      }
      if (line_.front() == '#') continue;
      if (empty_line_ != 0) {
        number_ = empty_line_;
        fail(0, "a row; found an empty line between rows");
      }
      if (!started_ && takes_separator()) continue;
      if (!started_) find_separator();
      split();
      if (!started_ && is_header()) {
        set_header();
        start();
        continue;
      }
      add_row();
    }
  }

  Table& table() { return table_; }
  void require_rows() const {
    if (rows_ == 0)
      subcert::fail(ErrorKind::data, "{}: expected rows of numbers; found {}", file_,
                    started_ ? "a header alone" : "none");
  }

 private:
  /// Names between single quotes lose these where all have them.
  void set_header() {
    const bool single = std::ranges::all_of(fields_, [](std::string_view field) {
      return field.size() > 1 && field.starts_with('\'') && field.ends_with('\'');
    });
    for (const std::string_view field : fields_)
      table_.header.emplace_back(single ? field.substr(1, field.size() - 2) : field);
  }

  /// Of a message about this line.
  std::string place(std::size_t column) const {
    return file_ + ", line " + std::to_string(number_) + (column == 0 ? "" : ", column " + std::to_string(column)) +
           ": expected ";
  }
  [[noreturn]] void fail(std::size_t column, const std::string& expected) const {
    subcert::fail(ErrorKind::data, "{}{}", place(column), expected);
  }

  bool next_line() {
    if (text_.empty()) return false;
    // Where lines end with a carriage return alone, the next line feed is far away: it is looked for once.
    if (line_feed_ < text_.data()) line_feed_ = text_.data() + std::min(text_.find('\n'), text_.size());
    line_ = text_.substr(0, static_cast<std::size_t>(line_feed_ - text_.data()));
    line_ = line_.substr(0, line_.find('\r'));
    std::size_t end = line_.size() == text_.size() ? std::string_view::npos : line_.size();
    if (end == std::string_view::npos) {
      text_ = {};
    } else {
      if (text_[end] == '\r' && end + 1 < text_.size() && text_[end + 1] == '\n') ++end;
      text_.remove_prefix(end + 1);
    }
    ++number_;
    return true;
  }

  /// `sep=;`, which Excel reads in the first line.
  bool takes_separator() {
    const std::string_view line = trimmed(line_);
    if (number_ != 1 || line.size() != 5 || !line.starts_with("sep=")) return false;
    if (form_.separator == 0) form_.separator = line.back();
    return true;
  }

  void find_separator() {
    table_.separator = ' ';
    if (form_.separator != 0) {
      table_.separator = form_.separator;
      return;
    }
    for (const char candidate : {';', '\t', ','})
      if (candidate != form_.decimal && line_.find(candidate) != std::string_view::npos) {
        table_.separator = candidate;
        return;
      }
  }

  /// The fields of the line, without quotes and without blanks around them.
  void split() {
    fields_.clear();
    in_quotes_.clear();
    unquoted_.clear();
    if (unquoted_.capacity() < line_.size()) unquoted_.reserve(line_.size());  // views into it stay valid
    const bool blanks = table_.separator == ' ';
    std::string_view rest = blanks ? trimmed(line_) : line_;
    for (bool more = true; more;) {
      while (!rest.empty() && rest.front() != table_.separator && is_blank(rest.front())) rest.remove_prefix(1);
      std::size_t end = 0;
      in_quotes_.push_back(!rest.empty() && rest.front() == '"');
      if (in_quotes_.back()) {
        const std::size_t begin = unquoted_.size();
        for (end = 1; end < rest.size(); ++end) {
          if (rest[end] == '"' && (end + 1 == rest.size() || rest[end + 1] != '"')) break;
          if (rest[end] == '"') ++end;
          unquoted_ += rest[end];
        }
        if (end >= rest.size()) fail(fields_.size() + 1, "a closing quote on the same line");
        fields_.push_back(std::string_view(unquoted_).substr(begin));
        rest.remove_prefix(end + 1);
        while (!rest.empty() && rest.front() != table_.separator && is_blank(rest.front())) rest.remove_prefix(1);
        if (!rest.empty() && rest.front() != table_.separator && !blanks)
          fail(fields_.size(), "a separator after the closing quote");
        end = 0;
      } else {
        end = blanks ? rest.find_first_of(" \t") : rest.find(table_.separator);
        if (end == std::string_view::npos) end = rest.size();
        fields_.push_back(trimmed(rest.substr(0, end)));
      }
      more = end < rest.size();
      if (more) rest.remove_prefix(end + 1);
      if (blanks)
        while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
    }
  }

  /// Whether the first row is a header: docs/data.md. Refuses what may be one as well as a row of missing values.
  bool is_header() const {
    if (form_.header) return *form_.header;
    bool name = false, missing = true;
    for (std::size_t c = 0; c < fields_.size(); ++c) {
      if (is_like_number(fields_[c], form_.decimal)) return false;
      const bool text = in_quotes_[c] ? !fields_[c].empty() : read_field(fields_[c], form_.decimal).kind == Kind::text;
      name = name || (text && std::any_of(fields_[c].begin(), fields_[c].end(), is_letter));
      missing = missing && !text;
    }
    const auto word = std::find_if(fields_.begin(), fields_.end(),
                                   [](std::string_view field) { return !field.empty(); });
    if (missing && word != fields_.end())
      fail(static_cast<std::size_t>(word - fields_.begin()) + 1,
           "a header or numbers; found " + in_quotes(*word) +
               ", a name or a missing value: a name stands in quotes, and missing values below a header" +
               (form_.text ? " (--header says which)" : ""));
    return name;
  }

  /// Where this field of the first row is text: what keeps the row from being a header.
  std::string why_no_header(std::string_view field) const {
    const auto is_number = [this](std::string_view other) { return is_like_number(other, form_.decimal); };
    const auto number = std::find_if(fields_.begin(), fields_.end(), is_number);
    if (rows_ > 0 || !table_.header.empty() || number == fields_.end() || is_number(field)) return "";
    return "; a header has no number, as column " + std::to_string(number - fields_.begin() + 1) + " has with " +
           in_quotes(*number) + (form_.text ? " (--header yes takes it as one)" : "");
  }

  /// For a number with another decimal mark.
  std::string other_mark(std::string_view field) const {
    if (form_.decimal != '.' || std::count(field.begin(), field.end(), ',') != 1) return "";
    if (read_field(field, ',').kind != Kind::number) return "";
    return std::string(", a number with a comma for the decimal point") + (form_.text ? " (--decimal , takes it)" : "");
  }

  /// For a date between slashes.
  static std::string other_date(std::string_view field) {
    const bool date = std::ranges::count(field, '/') == 2 && field.find_first_not_of("0123456789/") == field.npos;
    return date ? ", a date that does not say which number is the month (2024-02-29 and 29.2.2024 do)" : "";
  }

  void start() {
    started_ = true;
    table_.columns = fields_.size();
    table_.contents.resize(table_.columns);
  }

  /// For text, and numbers that are not finite.
  std::string expected_of(const Field& field, std::string_view text) const {
    if (field.kind == Kind::infinite) return "a finite number; found " + in_quotes(text);
    return "a number; found " + in_quotes(text) + other_mark(text) + other_date(text) + why_no_header(text);
  }

  void add_row() {
    if (!started_) start();
    if (rows_ == 0 && !table_.header.empty() && fields_.size() == table_.columns + 1 && is_blank(table_.separator)) {
      table_.header.insert(table_.header.begin(), "");
      table_.row_names = true;
      start();
    }
    if (fields_.size() != table_.columns)
      fail(std::min(fields_.size(), table_.columns) + 1,
           std::to_string(table_.columns) + (table_.columns == 1 ? " column" : " columns") +
               " as in the first row; found " + std::to_string(fields_.size()));
    for (std::size_t c = 0; c < fields_.size(); ++c) {
      const Field field = read_field(fields_[c], form_.decimal);
      ColumnContent& content = table_.contents[c];
      if (field.kind == Kind::number) ++content.numbers;
      if (field.kind == Kind::text || field.kind == Kind::infinite) {
        const bool taken = form_.text || (c == 0 && table_.row_names);
        if (!taken) fail(c + 1, expected_of(field, fields_[c]));
        if (content.why.empty())
          content = {content.numbers, std::string(fields_[c]), place(c + 1) + expected_of(field, fields_[c]),
                     is_like_number(fields_[c], form_.decimal) || !other_mark(fields_[c]).empty()};
      }
      if (field.kind == Kind::missing && form_.missing == Missing::refuse)
        fail(c + 1, "a finite number; found " + (fields_[c].empty() ? "nothing" : in_quotes(fields_[c])) + form_.gaps);
      table_.values.push_back(field.kind == Kind::number ? field.value : std::numeric_limits<double>::quiet_NaN());
    }
    for (std::size_t k = 0; k < form_.kept.size(); ++k) table_.fields[k].emplace_back(fields_[form_.kept[k]]);
    table_.lines.push_back(number_);
    ++rows_;
  }

  std::string_view text_;
  std::string file_;
  TableForm form_;
  Table table_;
  std::string_view line_;
  const char* line_feed_ = nullptr;  // the next one, or the end
  std::size_t number_ = 0;
  std::size_t rows_ = 0;
  std::size_t empty_line_ = 0;
  bool started_ = false;
  std::vector<std::string_view> fields_;
  std::vector<bool> in_quotes_;  // for each field
  std::string unquoted_;
};

TableReader::TableReader(const std::string& file, const TableForm& form)
    : lines_(std::make_unique<Lines>(file, form)) {}

TableReader::~TableReader() = default;

Table& TableReader::read(std::string_view lines) {
  lines_->table().values.clear();
  lines_->table().lines.clear();
  for (auto& fields : lines_->table().fields) fields.clear();
  lines_->read(lines);
  return lines_->table();
}

void TableReader::finish() const { lines_->require_rows(); }

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::string quoted_where_needed(const std::string& name, char separator) {
  const bool plain = name.find_first_of(std::string("\"\n\r") + separator) == std::string::npos && !name.empty();
  return plain ? name : quoted(name);
}

namespace {

/// Appends rows to a text. Numbers that come again soon, as standard deviations do, are converted once.
class RowText {
 public:
  RowText(const std::vector<TableColumn>& columns, char separator, char decimal)
      : columns_(columns), separator_(separator), decimal_(decimal) {}

  void append(std::size_t begin, std::size_t end, std::string& text) {
    if (std::ranges::any_of(columns_, [](const TableColumn& column) { return column.texts != nullptr; })) {
      append_with_texts(begin, end, text);
      return;
    }
    const std::size_t old = text.size();
    text.resize(old + (end - begin) * columns_.size() * most_characters);
    char* to = text.data() + old;
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        to = write(columns_[c].values[row * columns_[c].stride], to);
        *to++ = c + 1 == columns_.size() ? '\n' : separator_;
      }
    text.resize(static_cast<std::size_t>(to - text.data()));
  }

 private:
  static constexpr std::size_t most_characters = 32;  // of a number and its separator
  struct Known {
    std::uint64_t bits = 0;
    std::uint8_t length = 0;  // 0: none
    char text[most_characters - 1];
  };

  void append_with_texts(std::size_t begin, std::size_t end, std::string& text) {
    char number[most_characters];
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        if (const std::string* texts = columns_[c].texts)
          text += quoted_where_needed(texts[row], separator_);
        else
          text.append(number, write(columns_[c].values[row * columns_[c].stride], number));
        text += c + 1 == columns_.size() ? '\n' : separator_;
      }
  }

  char* write(double value, char* to) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    Known& known = known_[(bits * 0x9e3779b97f4a7c15U) >> 58U];
    if (known.length == 0 || known.bits != bits) {
      known.bits = bits;
      char* const end = std::to_chars(known.text, known.text + sizeof known.text, value).ptr;
      if (decimal_ != '.') std::replace(known.text, end, '.', decimal_);
      known.length = static_cast<std::uint8_t>(end - known.text);
    }
    std::memcpy(to, known.text, sizeof known.text);
    return to + known.length;
  }

  const std::vector<TableColumn>& columns_;
  char separator_;
  char decimal_;
  std::array<Known, 64> known_ = {};
};

std::vector<TableColumn> columns_of(const Table& table) {
  std::vector<TableColumn> columns;
  for (std::size_t c = 0; c < table.columns; ++c) columns.push_back({table.values.data() + c, table.columns});
  return columns;
}

}  // namespace

Table parse_table(std::string_view text, const std::string& file, const TableForm& form) {
  TableReader reader(file, form);
  Table& table = reader.read(text);
  reader.finish();
  return std::move(table);
}

std::string shortest_text(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, error == std::errc() ? end : buffer);
}

std::string header_text(const std::vector<std::string>& header, char separator) {
  std::string text;
  for (std::size_t c = 0; c < header.size(); ++c)
    text += (c ? std::string(1, separator) : "") + quoted_where_needed(header[c], separator);
  if (!header.empty()) text += '\n';
  return text;
}

std::string to_text(const Table& table) {
  std::string text = header_text(table.header, table.separator);
  const std::vector<TableColumn> columns = columns_of(table);
  RowText(columns, table.separator, table.decimal).append(0, table.rows(), text);
  return text;
}

void write_rows(std::ostream& stream, const std::vector<TableColumn>& columns, std::size_t rows, char separator,
                int threads, char decimal) {
  constexpr std::size_t block = 8192;
  std::vector<std::string> blocks(static_cast<std::size_t>(threads) * 4);
  for (std::size_t begin = 0; begin < rows && stream; begin += blocks.size() * block) {
    const std::size_t used = std::min(blocks.size(), (rows - begin + block - 1) / block);
    parallel_for_each(used, threads, [&](std::size_t b) {
      const std::size_t first = begin + b * block;
      blocks[b].clear();
      RowText(columns, separator, decimal).append(first, std::min(first + block, rows), blocks[b]);
    });
    for (std::size_t b = 0; b < used; ++b)
      stream.write(blocks[b].data(), static_cast<std::streamsize>(blocks[b].size()));
  }
}

}  // namespace subcert::data
