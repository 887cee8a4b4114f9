#include "typeset.hpp"

#include "signs.hpp"

#include <subcert/analysis/symbol/support/utf8.hpp>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace subcert::formats {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

constexpr std::pair<std::string_view, std::string_view> words[] = {
    {"Hoelder", "Hölder"}, {"psi", "<i>ψ</i>"}, {"phi", "<i>φ</i>"}};
constexpr std::pair<std::string_view, std::string_view> signs[] = {{" ... ", " … "}, {" %", "&nbsp;%"}, {"+-", "±"}};
constexpr std::pair<std::string_view, std::string_view> relations[] = {  // with a space behind them
    {"&gt;=", "≥"}, {"&lt;=", "≤"}, {"=", "="}, {"&lt;", "&lt;"}, {"&gt;", "&gt;"}, {"-", "-"}, {"+", "+"}};
constexpr std::string_view numbered[] = {"Table",       "Figure",  "Theorem", "Section", "Corollary", "Conjecture",
                                         "Proposition", "Lemma",   "Example", "Remark",  "table",     "figure",
                                         "theorem",     "section", "degree",  "level",   "valence",   "order"};
constexpr std::string_view untouched[] = {"script", "style", "math", "svg", "pre", "option", "title", "textarea"};

/// Of what stands behind `^`, as `-2`, `0.5`, `k`, `(2)` or `(1 - log2(N)/2)`: how long it is; 0 where it is no
/// exponent.
std::size_t exponent_length(std::string_view text) {
  constexpr std::size_t longest = 24;  // in parentheses
  if (text.empty()) return 0;
  if (text[0] == '(') {
    int depth = 0;
    for (std::size_t i = 0; i < std::min(text.size(), longest); ++i) {
      depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
      if (depth == 0) return i + 1;
    }
    return 0;
  }
  const auto digit_at = [&](std::size_t i) { return i < text.size() && is_digit(text[i]); };
  std::size_t length = text[0] == '-' ? 1 : 0;
  while (digit_at(length) || (length > 0 && digit_at(length - 1) && digit_at(length + 1) && text[length] == '.'))
    ++length;
  if (length > 0 && is_digit(text[length - 1])) return length;
  const bool letter = length < text.size() && std::isalpha(static_cast<unsigned char>(text[length]));
  return letter && (length + 1 == text.size() || !is_word(text[length + 1])) ? length + 1 : 0;
}

/// Of what stands behind `_`, as `n` or `12`: how long it is; 0 where it is no index but part of a name.
std::size_t index_length(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size() && is_digit(text[length])) ++length;
  if (length == 0 && !text.empty() && is_letter(text[0])) length = 1;
  return length < text.size() && is_word(text[length]) ? 0 : length;
}

/// `S_n`, `psi_n` and `log_2`: letter or word, and how long it is without the index; 0 where nothing has an index.
std::pair<std::size_t, std::string> with_index(std::string_view rest) {
  for (const auto& [from, to] : words)
    if (rest.starts_with(from) && rest.size() > from.size() && rest[from.size()] == '_')
      return {from.size(), std::string(to)};
  if (rest.starts_with("log_")) return {3, "log"};
  if (rest.size() > 1 && is_letter(rest[0]) && rest[1] == '_') return {1, std::string(1, rest[0])};
  return {0, ""};
}

/// Whether no line ends at this space: between `all` and `n`, `Table` and `3`, and beside a sign between short terms.
bool is_tied(std::string_view text, std::size_t at) {
  constexpr std::size_t longest_term = 4, longest_word = 5;
  const std::string_view before = text.substr(0, at), after = text.substr(at + 1);
  const std::string_view word = before.substr(before.find_last_of(" \n(") + 1);
  std::string_view next = after.substr(0, after.find_first_of(" \n,)"));
  if (next.ends_with(';') && !next.starts_with('&')) next.remove_suffix(1);
  if (word.empty() || next.empty()) return false;
  const auto is_relation = [](std::string_view one) {
    return std::ranges::count(relations, one, &std::pair<std::string_view, std::string_view>::first) > 0;
  };
  if (is_relation(word) || is_relation(next)) return (is_relation(word) ? next : word).size() <= longest_term;
  if (std::ranges::count(numbered, word) > 0) return is_digit(next[0]);
  const bool is_symbol = is_letter(next[0]) && (next.size() == 1 || next.substr(1) == ".") && next[0] != 'a' &&
                         next[0] != 'A' && next[0] != 'I';
  return is_symbol && word.size() <= longest_word && std::ranges::all_of(word, is_letter);
}

void add(std::string& result, std::string_view text, bool code);

/// Whether no word goes on at this place; a factor of digits may stand before, as in `2q_n`.
bool begins_word(std::string_view text, std::size_t at) {
  while (at > 0 && is_digit(text[at - 1])) --at;
  return at == 0 || !is_word(text[at - 1]);
}

/// What stands in `text` from `at` on, as it is printed, and how long it was; length 0 where nothing is to be changed.
std::pair<std::size_t, std::string> printed(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  const char before = at > 0 ? text[at - 1] : ' ';
  for (const auto& [from, to] : signs)
    if (rest.starts_with(from)) return {from.size(), std::string(to)};
  for (const auto& [from, to] : relations)
    if (rest.starts_with(from) && from != to && rest.substr(from.size()).starts_with(' '))
      return {from.size(), std::string(to)};
  if (rest[0] == '-' && is_minus(text, at)) return {1, std::string(minus_sign)};
  if (rest[0] == ' ' && is_tied(text, at)) return {1, "&nbsp;"};
  for (const auto& [from, to] : words)
    if (!is_word(before) && rest.starts_with(from) && (rest.size() == from.size() || !is_word(rest[from.size()])))
      return {from.size(), std::string(to)};
  if (const auto [length, base] = with_index(rest); length > 0 && begins_word(text, at))
    if (const std::size_t index = index_length(rest.substr(length + 1)); index > 0)
      return {length + 1 + index, base + "<sub>" + std::string(rest.substr(length + 1, index)) + "</sub>"};
  if (!is_word(before) && rest.starts_with("log2(")) return {4, "log<sub>2</sub>"};
  if (rest[0] == '^' && (is_word(before) || before == ')' || before == '|'))
    if (const std::size_t length = exponent_length(rest.substr(1)); length > 0) {
      std::string exponent;
      add(exponent, rest.substr(1, length), false);
      return {length + 1, "<sup>" + exponent + "</sup>"};
    }
  return {0, ""};
}

/// Adds a text without tags.
void add(std::string& result, std::string_view text, bool code) {
  for (std::size_t at = 0; at < text.size();) {
    if (const auto [length, by] = printed(text, at); length > 0 && !code) {
      result += by;
      at += length;
      continue;
    }
    result += text[at++];
    if (result.back() == ',' && at < text.size() && text[at] != ' ') result += "<wbr>";
  }
}

std::string_view name_of(std::string_view tag) {
  std::size_t length = 1;
  while (length < tag.size() && std::isalnum(static_cast<unsigned char>(tag[length]))) ++length;
  return tag.substr(1, length - 1);
}

}  // namespace

std::string typeset(const std::string& html) {
  const std::string_view text = html;
  std::string result;
  int code = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t tag = std::min(text.find('<', at), text.size());
    add(result, text.substr(at, tag - at), code > 0);
    if (tag == text.size()) break;
    std::size_t end = std::min(text.find('>', tag), text.size() - 1) + 1;
    const std::string_view name = name_of(text.substr(tag, end - tag));
    for (const std::string_view one : untouched)
      if (name == one) end = std::min(text.find("</" + std::string(one), end), text.size());
    if (name == "code") ++code;
    if (text.substr(tag).starts_with("</code")) --code;
    result += text.substr(tag, end - tag);
    at = end;
  }
  return result;
}

}  // namespace subcert::formats
