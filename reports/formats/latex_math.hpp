#pragma once
/// The part of LaTeX's mathematics that the catalogues of the papers use, as a tree.

#include <string>
#include <string_view>
#include <vector>

namespace subcert::formats {

/// TeX's classes of atoms, which decide about the spaces between neighbours. A function is an upright name as \sin.
enum class Atom { ordinary, large, function, binary, relation, open, close, punctuation };

struct MathNode {
  enum class Kind {
    identifier,   ///< a letter or a name
    number,       ///< digits, perhaps with decimals
    symbol,       ///< operators, relations, brackets, dots
    word,         ///< of a \text, with the blanks around it
    space,        ///< `text` is its width in em
    row,          ///< parts one after the other
    fenced,       ///< a bracket, a row, a bracket; an empty symbol stands for `\left.`
    subscript,    ///< base, index
    superscript,  ///< base, exponent
    scripts,      ///< base, index, exponent
    fraction,     ///< numerator, denominator
    small,        ///< a fraction in the style of running text
    binomial,     ///< top, bottom
    root,         ///< radicand, perhaps a degree
    accent,       ///< base, symbol above
  };
  Kind kind;
  std::string text = {};       ///< of a leaf, in UTF-8; `upright` concerns letters, `stretches` brackets and accents
  Atom atom = Atom::ordinary;  ///< of a node with scripts: that of its base
  bool upright = false;
  bool stretches = false;
  std::vector<MathNode> parts = {};  ///< none for a leaf
  std::size_t begin = 0, end = 0;    ///< its place in the text that was read
  int height = 0;                    ///< of the tree below it
  bool changed = false;              ///< of a leaf: the mark of a difference
};

/// `|` or a double bar.
bool is_bar(const MathNode& node);
/// It is seen, and has no parts.
bool is_leaf(const MathNode& node);
/// The base with an index, an exponent or both.
bool has_scripts(const MathNode& node);

struct Leaves {
  int all = 0, changed = 0;
};
Leaves leaves(const MathNode& node);
/// It has leaves, and all are.
bool all_changed(const MathNode& node);

/// The formula as a row. Brackets and bars that match are one node with what is between them. Domain: at most 5000
/// characters, 50 levels; \text holds plain UTF-8 without formulas, everything else is ASCII. Errors: throws a domain
/// error that names the command and its 1-based position for what is not known or not closed.
MathNode read_latex(std::string_view text);

}  // namespace subcert::formats
