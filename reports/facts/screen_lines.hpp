#pragma once
/// Text in lines that a terminal shows whole.

#include <cstddef>
#include <string>

namespace subcert::facts {

constexpr std::size_t screen_width = 100;

/// The text in lines of at most `width` characters, broken at blanks; lines that go on begin at the column `indent`,
/// where the text of the first one begins. Line breaks of the text stay, and so do words that are too long, as masks.
/// Domain: indent < width.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width = screen_width);

}  // namespace subcert::facts
