#include "text_lines.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace subcert::data {

std::optional<double> parse_finite(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

bool TextLines::next(bool comments) {
  while (!text_.empty()) {
    ++number_;
    const std::size_t end = text_.find('\n');
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    if (comments) line = line.substr(0, line.find('#'));
    words_.clear();
    constexpr std::string_view blanks = " \t\r\v\f";
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;
         at = line.find_first_not_of(blanks, at)) {
      const std::size_t stop = std::min(line.find_first_of(blanks, at), line.size());
      words_.push_back(line.substr(at, stop - at));
      at = stop;
    }
    if (!words_.empty()) return true;
  }
  return false;
}

double TextLines::number(std::size_t i) const {
  const auto value = parse_finite(word(i));
  if (!value) fail(i, "a finite number");
  return *value;
}

std::size_t TextLines::count(std::size_t i, std::size_t lowest, std::size_t highest, const std::string& what) const {
  const std::string_view text = word(i);
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end != text.data() + text.size() || error != std::errc() || value < lowest || value > highest)
    fail(i, what + " from " + std::to_string(lowest) + " to " + std::to_string(highest));
  return value;
}

void TextLines::fail(std::size_t i, const std::string& expected) const {
  std::string shown;
  for (char c : word(i).substr(0, 40)) shown += c >= 32 && c < 127 ? c : '?';
  subcert::fail(ErrorKind::data, "{}, line {}, word {}: expected {}; found {}", file_, number_, i + 1, expected,
                (shown.empty() ? "nothing" : "'" + shown + "'"));
}

void TextLines::fail_file(const std::string& expected) const {
  subcert::fail(ErrorKind::data, "{}: expected {}", file_, expected);
}

}  // namespace subcert::data
