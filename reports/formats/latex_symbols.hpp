#pragma once
/// What commands and characters of LaTeX stand for. Inner header.

#include "latex_math.hpp"

#include <string>

namespace subcert::formats {

struct Symbol {
  std::string text;
  Atom atom = Atom::ordinary;
  MathNode::Kind kind = MathNode::Kind::symbol;
  bool upright = false;
};

/// Of a command or a character; null where it stands for no symbol.
const Symbol* symbol(const std::string& token);

/// In Unicode's alphabet for \mathbf, \mathbb or \mathcal. Domain: a letter, or a digit, which \mathcal does not have.
std::string in_alphabet(const std::string& alphabet, char c);

}  // namespace subcert::formats
