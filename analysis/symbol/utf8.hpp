#pragma once
/// Characters of texts in UTF-8, and the blanks about a text.

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

/// Without the blanks at its ends, which are spaces and tabs.
std::string trimmed(std::string_view text);

}  // namespace subcert
