#pragma once
/// Printing of sums of monomials, shared by the polynomials in one and in several variables, and masks as text.

#include "quadratic_number.hpp"
#include "rational_function.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace subcert::text {

enum class Style { plain, latex };

/// Names of the variables: z for one, x, y for two, x, y, z for three. Domain: 1 <= variables <= 3.
std::vector<std::string> variable_names(int variables);

/// `3/4*z^-2 - z + 5`, or the same in LaTeX; `0` for no terms. The order of the terms is kept. `names`: of the
/// variables, where they have others.
std::string print_terms(const std::vector<Monomial>& terms, Style style, std::vector<std::string> names = {});

/// The parts of `[c0,c1,...]/D@first`, or of lists nested as deep as there are variables, the last variable outermost;
/// /D and @first may be absent.
template <class Number>
struct MaskTextOf {
  std::vector<Number> coefficients;        ///< the first variable runs fastest
  std::vector<std::size_t> sizes;          ///< entries along each variable, behind columns and rows of matrices
  std::optional<std::vector<long>> first;  ///< index of the first coefficient
};
using MaskText = MaskTextOf<Rational>;

enum class Entries { numbers, matrices };

/// Reads a mask with rational coefficients, or matrices of such, row by row, divided by the positive integer D. Domain:
/// 1 <= variables <= 3. Errors: throws ParseError, also for lists of one level with different lengths.
MaskText parse_mask_text(std::string_view text, int variables, Entries entries = Entries::numbers);
/// The same in one variable with coefficients that LetterFunction::parse reads, and such a D in parentheses.
MaskTextOf<LetterFunction> parse_mask_text(std::string_view text, std::string_view letters,
                                           Entries entries = Entries::numbers);

/// Matrices whose entries may have multiples of one square root, the same in all. Errors: throws ParseError.
MaskTextOf<QuadraticNumber> parse_quadratic_mask_text(std::string_view text, int variables);

/// What parse_mask_text reads, over the common denominator.
std::string print_mask_text(const MaskText& mask);
std::string print_mask_text(const MaskTextOf<QuadraticNumber>& mask);

}  // namespace subcert::text
