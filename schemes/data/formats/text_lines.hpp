#pragma once
// Files of words in lines, as OBJ, PLY and VTK are.

#include "table.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// A finite number, or nothing.
std::optional<double> parse_finite(std::string_view word);

/// Goes through the lines of a file that hold words, and complains with file, line and word.
class TextLines {
 public:
  TextLines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  /// The next line with words, without those after #; false at the end.
  bool next(bool comments = true);
  const std::vector<std::string_view>& words() const { return words_; }
  std::string_view word(std::size_t i) const { return i < words_.size() ? words_[i] : std::string_view(); }
  std::size_t line() const { return number_; }
  bool is(std::size_t i, std::string_view expected) const { return word(i) == expected; }

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
  std::string_view text_;
  std::string file_;
  std::vector<std::string_view> words_;
  std::size_t number_ = 0;
};

}  // namespace subcert::data
