#include "json_file.hpp"

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace subcert {
namespace {

constexpr int most_json_depth = 100;

void append_utf8(std::uint32_t code, std::string& text) {
  const auto byte = [&](std::uint32_t value) { text += static_cast<char>(static_cast<unsigned char>(value)); };
  if (code < 0x80) return byte(code);
  const int rest = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  byte((rest == 1 ? 0xC0U : rest == 2 ? 0xE0U : 0xF0U) | code >> (6U * static_cast<unsigned>(rest)));
  for (int k = rest; k-- > 0;) byte(0x80U | (code >> (6U * static_cast<unsigned>(k)) & 0x3FU));
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";  // of the order of bytes
    if (text_.starts_with(mark)) at_ = line_begin_ = mark.size();
  }

  JsonNode whole() {
    JsonNode result = value(0);
    skip_blanks();
    if (at_ < text_.size()) refuse("nothing after the value");
    return result;
  }

 private:
  Place place() const { return {line_, static_cast<unsigned>(at_ - line_begin_ + 1)}; }

  /// What stands here: a run of letters and digits, or one character.
  [[noreturn]] void refuse(const std::string& expected) const {
    std::size_t end = at_;
    const auto is_word = [&](char c) {
      return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' || c == '-';
    };
    while (end < text_.size() && is_word(text_[end])) ++end;
    if (end == at_ && at_ < text_.size()) end += std::max<std::size_t>(1, first_character(text_.substr(at_)).length);
    throw FileError(place(), fmt::format("not JSON: expected {}, got {}", expected,
                                         at_ < text_.size() ? in_quotes(text_.substr(at_, end - at_)) : "the end"));
  }

  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) {
    if (here() != c || at_ >= text_.size()) return false;
    ++at_;
    return true;
  }
  void skip_blanks() {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c != ' ' && c != '\t' && c != '\r' && c != '\n') return;
      if (c != '\n') continue;
      ++line_;
      line_begin_ = at_ + 1;
    }
  }

  JsonNode value(int level) {
    skip_blanks();
    JsonNode result;
    result.place = place();
    if (level > most_json_depth) refuse(fmt::format("at most {} levels of brackets", most_json_depth));
    const char c = here();
    if (c == '{') {
      result.kind = JsonNode::Kind::object;
      members(result, level);
    } else if (c == '[') {
      result.kind = JsonNode::Kind::array;
      elements(result, level);
    } else if (c == '"') {
      result.kind = JsonNode::Kind::string;
      result.text = string();
    } else if (c == '-' || is_digit(c)) {
      result.kind = JsonNode::Kind::number;
      result.text = number();
    } else {
      result.text = literal();
    }
    return result;
  }

  void members(JsonNode& object, int level) {
    ++at_;
    std::set<std::string> keys;
    skip_blanks();
    if (take('}')) return;
    do {
      skip_blanks();
      const Place key_place = place();
      if (here() != '"') refuse("a key in quotes");
      std::string key = string();
      if (!keys.insert(key).second)
        throw FileError(key_place, fmt::format("the key {} is there twice", in_quotes(key)));
      skip_blanks();
      if (!take(':')) refuse("':' after a key");
      JsonNode& member = object.items.emplace_back(value(level + 1));
      member.key = std::move(key);
      member.key_place = key_place;
      skip_blanks();
    } while (take(','));
    if (!take('}')) refuse("',' or '}'");
  }

  void elements(JsonNode& array, int level) {
    ++at_;
    skip_blanks();
    if (take(']')) return;
    do {
      array.items.push_back(value(level + 1));
      skip_blanks();
    } while (take(','));
    if (!take(']')) refuse("',' or ']'");
  }

  void digits(std::string& to) {
    if (!is_digit(here())) refuse("a digit");
    while (is_digit(here())) to += text_[at_++];
  }

  std::string number() {
    std::string result;
    if (take('-')) result += '-';
    if (here() == '0' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1])) refuse("a number without leading zeros");
    digits(result);
    if (take('.')) {
      result += '.';
      digits(result);
    }
    if (here() == 'e' || here() == 'E') {
      result += text_[at_++];
      if (here() == '+' || here() == '-') result += text_[at_++];
      digits(result);
    }
    if (here() == '.' || here() == '+' || here() == '-' || here() == '/') refuse("the end of a number");
    return result;
  }

  std::string literal() {
    for (const std::string_view word : {"true", "false", "null"})
      if (text_.substr(at_).starts_with(word)) {
        at_ += word.size();
        return std::string(word);
      }
    refuse("a value");
  }

  /// Four hexadecimal digits.
  std::uint32_t code_unit() {
    std::uint32_t code = 0;
    for (int k = 0; k < 4; ++k) {
      const auto digit = std::string_view("0123456789abcdef")
                             .find(static_cast<char>(here() | (is_digit(here()) ? 0 : 0x20)));
      if (at_ >= text_.size() || digit == std::string_view::npos) refuse("four hexadecimal digits");
      code = code << 4U | static_cast<std::uint32_t>(digit);
      ++at_;
    }
    return code;
  }

  void escape(std::string& to) {
    constexpr std::string_view names = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
    if (take('u')) {
      std::uint32_t code = code_unit();
      if (code >= 0xD800 && code < 0xDC00) {
        const bool pair = take('\\') && take('u');
        const std::uint32_t low = pair ? code_unit() : 0;
        if (low < 0xDC00 || low > 0xDFFF) refuse("the second half of a pair of surrogates");
        code = 0x10000 + ((code - 0xD800) << 10U) + (low - 0xDC00);
      } else if (code >= 0xDC00 && code <= 0xDFFF) {
        refuse("the first half of a pair of surrogates");
      }
      return append_utf8(code, to);
    }
    const std::size_t which = at_ < text_.size() ? names.find(text_[at_]) : std::string_view::npos;
    if (which == std::string_view::npos) refuse("an escape, as \\n");
    to += meanings[which];
    ++at_;
  }

  std::string string() {
    ++at_;
    std::string result;
    for (;;) {
      if (at_ >= text_.size() || text_[at_] == '\n') refuse("a closing quote on the same line");
      if (take('"')) return result;
      if (take('\\')) {
        escape(result);
        continue;
      }
      const std::size_t length = first_character(text_.substr(at_)).length;
      if (length == 0 || static_cast<unsigned char>(text_[at_]) < 0x20) refuse("a character in UTF-8, no control");
      result += text_.substr(at_, length);
      at_ += length;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0, line_begin_ = 0;
  unsigned line_ = 1;
};

}  // namespace

const JsonNode* JsonNode::find(std::string_view name) const {
  const auto found = std::find_if(items.begin(), items.end(), [&](const JsonNode& item) { return item.key == name; });
  return kind == Kind::object && found != items.end() ? &*found : nullptr;
}

JsonNode parse_json(std::string_view text) { return Reader(text).whole(); }

void only_keys(const JsonNode& object, const std::vector<std::string>& known, const std::string& of) {
  if (object.kind != JsonNode::Kind::object) return;
  for (const JsonNode& item : object.items)
    if (std::find(known.begin(), known.end(), item.key) == known.end())
      throw FileError(item.key_place, fmt::format("unknown key {}; the keys of {} are {}", in_quotes(item.key), of,
                                                  fmt::join(known, ", ")));
}

}  // namespace subcert
