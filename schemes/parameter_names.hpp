#pragma once
// Names of parameters inside specifications, for the readers of specifications alone.

#include "specification_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace subcert::specification_text {

inline constexpr const char* algebraic_usage = "mask:[1+t,3+t,3-t,1-t]/4,where=t^2-3:1.7..1.8";

/// What stands together of letters inside brackets and parentheses, or in a symbol but for z.
std::vector<Piece> names_inside(const Piece& family, const Piece& body);

/// The one name inside brackets and parentheses.
std::string read_parameter(const Piece& family, const Piece& body, const char* usage);

/// An expression with a name in place of its letter.
std::string with_name(const std::string& expression, char letter, const std::string& name);

/// A letter for each name, its first where that is free and not z.
std::string letters_for(const std::vector<std::string>& names);

/// The text with the letters in place of the names.
std::string replaced(std::string_view text, const std::vector<Piece>& pieces, const std::vector<std::string>& names,
                     std::string_view letters);

}  // namespace subcert::specification_text
