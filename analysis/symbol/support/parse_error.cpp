#include "parse_error.hpp"

#include "utf8.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace subcert {
namespace {

constexpr std::size_t most_characters = 40;  // of a token
constexpr std::size_t longest_word = 40;     // that is compared with others

/// Blanks other than the plain one, marks without width or of direction, surrogates for private use.
bool is_invisible(std::uint32_t code) {
  struct Range {
    std::uint32_t first, last;
  };
  constexpr Range ranges[] = {{0, 0x1F},        {0x7F, 0xA0},     {0xAD, 0xAD},     {0x300, 0x36F},
                              {0x61C, 0x61C},   {0x1680, 0x1680}, {0x180E, 0x180E}, {0x2000, 0x200F},
                              {0x2028, 0x202F}, {0x205F, 0x206F}, {0x3000, 0x3000}, {0xE000, 0xF8FF},
                              {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF}, {0xFFF0, 0xFFFF}, {0xE0000, 0x10FFFF}};
  return std::ranges::any_of(ranges, [=](const Range& range) { return range.first <= code && code <= range.last; });
}

std::string visible(std::string_view text, std::size_t most) {
  std::string result;
  for (std::size_t shown = 0; !text.empty(); ++shown) {
    if (shown == most) return result + "...";
    const auto [code, length] = first_character(text);
    if (length == 0)
      result += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(text.front())));
    else if (is_invisible(code))
      result += fmt::format("\\u{:04x}", code);
    else
      result += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Insertions, deletions, changes and swaps of neighbours that make one word of the other, case aside.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> steps(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& here = steps[i][j];
      if (i == 0 || j == 0) {
        here = i + j;
        continue;
      }
      const auto same = [&](std::size_t k, std::size_t l) { return small(a[k - 1]) == small(b[l - 1]); };
      here = std::min({steps[i - 1][j] + 1, steps[i][j - 1] + 1, steps[i - 1][j - 1] + (same(i, j) ? 0U : 1U)});
      if (i > 1 && j > 1 && same(i, j - 1) && same(i - 1, j)) here = std::min(here, steps[i - 2][j - 2] + 1);
    }
  return steps.back().back();
}

/// How masks with roots are written, where the text has a root.
std::string root_hint(std::string_view text) {
  const bool has_root = text.find("sqrt") != std::string_view::npos || text.find("\u221A") != std::string_view::npos;
  return has_root ? "; a root is a letter with its polynomial and place, as in "
                    "mask:[1+t,3+t,3-t,1-t]/4@0,where=t^2-3:1.7..1.8"
                  : "";
}

/// Without what joins words, `four_point` as `four-point`.
std::string joined(std::string_view words) {
  std::string letters(words);
  std::erase_if(letters, [](char c) { return c == '-' || c == '_' || c == ' '; });
  return letters;
}

/// The one that begins so, where there is no other.
std::string only_longer_word(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t shortest = 3;  // letters, behind the signs of an option
  const auto begins_so = [&](const std::string& candidate) { return candidate.starts_with(word); };
  const std::size_t signs = std::min(word.find_first_not_of('-'), word.size());
  if (word.size() < signs + shortest || std::ranges::count_if(known, begins_so) != 1) return "";
  return *std::ranges::find_if(known, begins_so);
}

}  // namespace

std::string visible(std::string_view text) { return visible(text, std::string_view::npos); }

std::string printable(std::string_view text) { return visible(text, most_characters); }

std::string in_quotes(std::string_view token) {
  std::string between = "'" + printable(token) + "'";
  for (; !token.empty(); token.remove_prefix(1))
    if (const auto [code, length] = first_character(token); length > 1)
      return between + fmt::format(" (with U+{:04X})", code);
  return between;
}

ParseError::ParseError(const std::string& subject, std::string_view token, std::size_t position, std::string expected)
    : Error(ErrorKind::usage, fmt::format("{}, position {}: {}; expected {}{}", subject, position, in_quotes(token),
                                          expected, root_hint(token))),
      token_(printable(token)),
      position_(position),
      expected_(std::move(expected)) {}

// Of several that are as near, the one that differs least without hyphens.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string nearest;
  if (word.size() > longest_word) return nearest;
  std::pair<std::size_t, std::size_t> least{word.size() / 3 + 1, 0};
  for (const std::string& candidate : known)
    if (const std::pair steps{distance(word, candidate), distance(joined(word), joined(candidate))}; steps < least) {
      least = steps;
      nearest = candidate;
    }
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t most = 6;
  std::vector<std::string> kinds;  // as conjecture-8-n of conjecture-8
  for (const std::string& candidate : known)
    if (!word.empty() && candidate.starts_with(std::string(word) + "-")) kinds.push_back(candidate);
  if (kinds.size() > 1 && kinds.size() <= most) return fmt::format("; did you mean one of {}?", fmt::join(kinds, ", "));
  std::string nearest = nearest_word(word, known);
  if (nearest.empty()) nearest = only_longer_word(word, known);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

std::string expected_one_of(const std::vector<std::string>& known, std::string_view word) {
  return fmt::format("{}; expected {}{}", in_quotes(word), fmt::join(known, ", "), did_you_mean(word, known));
}

}  // namespace subcert
