#pragma once
/// Characters of texts in UTF-8, digits and letters among them, and the blanks about a text.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace subcert {

/// A character and the bytes that it takes; none where the text does not begin with UTF-8.
struct Character {
  std::uint32_t code;
  std::size_t length;
};

/// The first one of a text. Domain: not empty.
Character first_character(std::string_view text);

/// Those that begin before the byte at `end`.
std::size_t characters_before(std::string_view text, std::size_t end);

/// Of ASCII.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// Without the blanks at its ends, which are spaces and tabs.
std::string trimmed(std::string_view text);

}  // namespace subcert
