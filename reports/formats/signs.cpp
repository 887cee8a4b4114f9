#include "signs.hpp"

#include <subcert/analysis/symbol/support/utf8.hpp>

#include <algorithm>

namespace subcert::formats {
namespace {

bool is_one_of(char c, std::string_view signs) { return signs.find(c) != std::string_view::npos; }

bool is_of_word(char c) { return is_letter(c) || is_digit(c) || c == '_' || static_cast<unsigned char>(c) >= 0x80; }

/// Of the letters, digits and signs of words that begin here.
std::size_t word_length(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_of_word) - text.begin());
}

bool begins_number(std::string_view text) {
  return !text.empty() && (is_digit(text[0]) || (text[0] == '.' && text.size() > 1 && is_digit(text[1])));
}

/// `w`, `2w`, `psi` or `log2(`: a letter of a formula, not a word of a sentence.
bool begins_term(std::string_view text) {
  if (begins_number(text)) return true;
  if (text.empty()) return false;
  if (is_one_of(text[0], "(|")) return true;
  const std::size_t length = word_length(text);
  const std::string_view word = text.substr(0, length);
  if (length == 0 || !is_letter(text[0])) return false;
  const char next = length < text.size() ? text[length] : ' ';
  return next == '(' || ((length == 1 || word == "psi" || word == "phi" || word[1] == '_') && next != '-');
}

bool ends_term(std::string_view text) {
  if (text.empty()) return false;
  const char last = text.back();
  if (is_digit(last) || is_one_of(last, ")]|'")) return true;
  if (!is_letter(last)) return false;
  const std::string_view before = text.substr(0, text.size() - 1);
  return before.empty() || !is_of_word(before.back()) || is_digit(before.back()) || before.back() == '_' ||
         before.ends_with("ps") || before.ends_with("ph");
}

/// Whether `text` ends with a letter alone or behind digits, as `2n`, and `after` begins with a number alone, as in
/// `2n-1`.
bool is_difference(std::string_view text, std::string_view after) {
  if (text.empty() || text.back() < 'a' || text.back() > 'z') return false;
  text.remove_suffix(1);
  while (!text.empty() && is_digit(text.back())) text.remove_suffix(1);
  const std::size_t length = word_length(after);
  return (text.empty() || !(is_of_word(text.back()) || text.back() == '-')) && length > 0 &&
         std::ranges::all_of(after.substr(0, length), is_digit) && (length == after.size() || after[length] != '-');
}

/// Whether `text` ends within a specification: a name with a colon before what has no space.
bool within_specification(std::string_view text) {
  const std::string_view token = text.substr(std::min(text.find_last_of(" \n;") + 1, text.size()));
  const std::size_t colon = token.find(':');
  return colon != std::string_view::npos && colon > 0 && (is_letter(token[colon - 1]) || is_digit(token[colon - 1])) &&
         colon + 1 < token.size();
}

}  // namespace

bool is_minus(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at), after = text.substr(at + 1);
  if (within_specification(before)) return false;
  const char last = before.empty() ? '^' : before.back();
  if (last == ' ' && after.starts_with(' '))
    return ends_term(before.substr(0, before.size() - 1)) && begins_term(after.substr(1));
  if (is_one_of(last, "([{^,=@") && begins_term(after)) return true;
  for (const std::string_view opening : {", ", "; ", "= ", "< ", "> ", "... ", "from ", "to "})
    if (before.ends_with(opening) && begins_term(after)) return true;
  if (is_one_of(last, " \n<>;/*:+") || static_cast<unsigned char>(last) >= 0x80) return begins_number(after);
  if (last == 'e' && before.size() > 1 && is_digit(before[before.size() - 2])) return begins_number(after);
  return is_difference(before, after) || (is_one_of(last, ")|") && begins_term(after));
}

std::string with_minus(std::string_view text, std::string_view sign) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] == '-' && is_minus(text, at))
      result += sign;
    else
      result += text[at];
  return result;
}

}  // namespace subcert::formats
