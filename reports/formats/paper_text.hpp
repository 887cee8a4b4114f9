#pragma once
/// What goes into papers: formulas and tables in LaTeX, tables in Markdown.

#include <subcert/analysis/symbol/masks/dilation.hpp>
#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace subcert::formats {

using TableRows = std::vector<std::vector<std::string>>;

/// What LaTeX prints as this text, outside of formulas; `>=` and `<=` are relations, and minus signs (signs.hpp) none
/// of words.
std::string latex_text(std::string_view text);

/// A tabular with the rules of booktabs; the first row is the head, and the first column is set to the left, the others
/// as `column` says: `r`, `p{5cm}`. Cells are LaTeX. Domain: rows of one length, at least one.
std::string latex_tabular(const TableRows& rows, std::string_view column);

/// The same in Markdown. Cells are texts.
std::string markdown_table(const TableRows& rows);

/// A polynomial, an inequality or a product as this program prints it, for a formula: `32*w^3 - 1/4 <= mu` as
/// `32 w^{3} - \frac{1}{4} \le \mu`.
std::string latex_formula(std::string_view text);

/// `(a_{-2}, \ldots, a_{1}) = \frac{1}{4}(1,\, 3,\, 3,\, 1)` in one variable, a matrix in two. Domain: one or two
/// variables. Errors: throws Error for three.
std::string mask_latex(const LatticeMask& mask);

/// `a(z) = \frac{(1 + z)^{3}}{4 z^{2}}` with all factors 1 + z + ... + z^(arity-1) taken out. Domain: one variable,
/// not zero.
std::string symbol_latex(const Mask& mask);

/// A relation: `= 2`, `= 1.99\ldots`, `\in [1.5,\, 1.6]`, `\ge 1`; empty for no ends. Domain: digits >= 1.
std::string relation_latex(const Enclosure& value, int digits);

}  // namespace subcert::formats
