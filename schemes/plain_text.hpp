#pragma once
/// Pasted characters and LaTeX in the signs that the readers know.

#include <cstddef>
#include <string>
#include <string_view>

namespace subcert {

/// `−½z²` as `-(1/2)z^2`, `\frac{1}{16}\cdot` as `(1/16)*`, braces as brackets, Greek letters as their names. Signs
/// that are not known stay, for a reader to refuse. Domain: at most 30,000 characters. Errors: throws
/// SpecificationError for what could mean two things, as 3½ or z²3, and for LaTeX that is not known; its position is
/// that of a character.
std::string plain_text(std::string_view text);

/// Where the bracket at `begin` is closed by one of its kind, or npos.
std::size_t closing_bracket(std::string_view text, std::size_t begin);

/// Whether the word is the name of a Greek letter.
bool is_greek(std::string_view word);

}  // namespace subcert
