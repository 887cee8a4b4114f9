#include "text_lines.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

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

TextLines::TextLines(std::string_view text, std::string file, bool continued)
    : text_(text), file_(std::move(file)), continued_(continued) {
  if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
}

bool TextLines::add_words(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;
       at = line.find_first_not_of(blanks, at)) {
    const std::size_t stop = std::min(line.find_first_of(blanks, at), line.size());
    words_.push_back(line.substr(at, stop - at));
    at = stop;
  }
  if (!continued_ || words_.empty() || !words_.back().ends_with('\\')) return false;
  words_.back().remove_suffix(1);
  if (words_.back().empty()) words_.pop_back();
  return true;
}

bool TextLines::next(bool comments) {
  words_.clear();
  for (bool more = false; !text_.empty() && (more || words_.empty());) {
    ++number_;
    const std::size_t end = text_.find('\n');
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    if (comments) line = line.substr(0, line.find('#'));
    more = add_words(line);
  }
  return !words_.empty();
}

void TextLines::pass_paragraph() {
  while (!text_.empty()) {
    ++number_;
    const std::size_t end = std::min(text_.find('\n'), text_.size() - 1);
    const bool is_empty = text_.substr(0, end).find_first_not_of(" \t\r") == std::string_view::npos;
    text_.remove_prefix(end + 1);
    if (is_empty) return;
  }
}

void TextLines::pass_line(std::string_view capitals) {
  TextLines ahead = *this;
  if (ahead.next(false) && ahead.is_keyword(0, capitals)) *this = std::move(ahead);
}

bool TextLines::is_keyword(std::size_t i, std::string_view capitals) const {
  return std::ranges::equal(word(i), capitals, {}, [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
}

const char* TextLines::take_bytes(std::size_t count, const std::string& use) {
  if (text_.size() < count)
    fail_file(std::to_string(count) + " bytes of " + use + " after line " + std::to_string(number_) + "; found " +
              std::to_string(text_.size()));
  const char* const bytes = text_.data();
  text_.remove_prefix(count);
  return bytes;
}

std::vector<double> TextLines::take_numbers(std::size_t count, const NumberType& type, Encoding encoding, bool gaps) {
  std::vector<double> values;
  if (encoding != Encoding::text) {
    const char* const bytes = take_bytes(count * type.size, "numbers");
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      values.push_back(read_number(bytes + i * type.size, type, encoding));
      if (!std::isfinite(values.back()) && !(gaps && std::isnan(values.back())))
        fail_file("finite numbers after line " + std::to_string(number_) + "; found " + shortest_text(values.back()) +
                  " as number " + std::to_string(i + 1));
    }
    return values;
  }
  while (values.size() < count) {
    if (!next(false)) fail_file(std::to_string(count) + " values; found " + std::to_string(values.size()));
    for (std::size_t i = 0; i < words_.size(); ++i) {
      need(values.size() < count, i, "the end of the line after " + std::to_string(count) + " values");
      values.push_back(gaps && is_keyword(i, "NAN") ? std::numeric_limits<double>::quiet_NaN() : number(i));
    }
  }
  return values;
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
