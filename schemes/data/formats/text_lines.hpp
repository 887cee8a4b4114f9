#pragma once
// Files of words in lines, as OBJ, PLY and VTK are, with bytes between them where they are binary.

#include "number_type.hpp"
#include "table.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// A finite number, or nothing.
std::optional<double> parse_finite(std::string_view word);

/// Goes through the lines of a file that hold words, and complains with file, line and word. A byte order mark is
/// passed over.
class TextLines {
 public:
  /// `continued`: a backslash at the end of a line joins the next one to it.
  TextLines(std::string_view text, std::string file, bool continued = false);

  /// The next line with words, without those after #; false at the end.
  bool next(bool comments = true);
  /// Goes on behind the next line without words.
  void pass_paragraph();
  /// Passes over the next line if its first word is this keyword.
  void pass_line(std::string_view capitals);
  const std::vector<std::string_view>& words() const { return words_; }
  std::string_view word(std::size_t i) const { return i < words_.size() ? words_[i] : std::string_view(); }
  std::size_t line() const { return number_; }
  bool is(std::size_t i, std::string_view expected) const { return word(i) == expected; }
  /// The same for capital and small letters.
  bool is_keyword(std::size_t i, std::string_view capitals) const;

  /// The bytes that follow this line. Errors: throws a data error where the file ends before, with their use.
  const char* take_bytes(std::size_t count, const std::string& use);
  /// `count` numbers of the lines that follow, or of the bytes; with `gaps` NaN is one. Errors: throw a data error.
  std::vector<double> take_numbers(std::size_t count, const NumberType& type, Encoding encoding, bool gaps = false);

  /// Errors: throw a data error.
  double number(std::size_t i) const;
  std::size_t count(std::size_t i, std::size_t lowest, std::size_t highest, const std::string& what) const;
  void need(bool condition, std::size_t i, const std::string& expected) const {
    if (!condition) fail(i, expected);
  }
  /// The word i of this line is not what was expected.
  [[noreturn]] void fail(std::size_t i, const std::string& expected) const;
  /// The file as a whole is not what was expected.
  [[noreturn]] void fail_file(const std::string& expected) const;

 private:
  /// Adds the words of a line; whether it goes on in the next one.
  bool add_words(std::string_view line);

  std::string_view text_;
  std::string file_;
  bool continued_;
  std::vector<std::string_view> words_;
  std::size_t number_ = 0;
};

}  // namespace subcert::data
