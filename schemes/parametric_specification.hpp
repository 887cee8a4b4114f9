#pragma once
/// Specifications with a letter where a number may stand.

#include "specification.hpp"

#include <subcert/analysis/symbol/masks/parametric_mask.hpp>

namespace subcert {

/// A scheme of one variable whose coefficients, numbers or matrices, are polynomials in one parameter, or quotients of
/// them.
struct ParametricScheme {
  std::string specification;
  std::string title;
  char letter;                                    ///< for the parameter, as in certificates
  std::string name;                               ///< of the parameter, as it is written: the letter, or `mu`
  ParametricMask mask;                            ///< of matrices A_k
  std::optional<VectorForm> form = std::nullopt;  ///< of a mask of matrices, always

  /// An expression in the letter, with the name in its place.
  std::string named(const std::string& expression) const;
};

/// Reads `mask:[-w,0,1/2+w,1,1/2+w,0,-w]`, `regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1,weights=[w;1;w|w;1;1;w]`,
/// a classical family, as `four-point:w`, matrices `refinable:[[[1,0],[w,1]],...]`, `vector:` and `hermite:`, or
/// `merrien:lambda=-1/8,mu`, with any letter or a name of several, `mu`, for the parameter. Letters
/// that stand together are one name, those of one letter, `ww`, a product, and z in a symbol stands for itself.
/// Coefficients, positions and weights are what RationalFunction::parse reads. Domain: up to 100 coefficients, degree
/// up to 12 over their common denominator; else as make_scheme. Errors: throws SpecificationError, also for two
/// letters, none, or coset sums other than 1 for some value.
ParametricScheme make_parametric_scheme(std::string_view text);

/// Whether the text names a family that make_parametric_scheme may read: with a letter where a number may stand.
bool has_parameter(std::string_view text);

/// The specification with a letter for each of these names, as `wt` for {"omega", "tau"}, which are returned behind it.
/// Domain: different names of letters. Errors: throws SpecificationError where letters that stand together are products
/// of them in two ways.
std::pair<std::string, std::string> in_letters(std::string_view specification, const std::vector<std::string>& names);

/// Reads `mask:[t,0,-w-3*t,...]`, or matrices as make_parametric_scheme, with two or three letters: coefficients are
/// what LetterFunction::parse reads. Domain: the specification is from in_letters; different letters; up to 100
/// coefficients, degrees up to 12 in each; else as make_scheme. Errors: throws SpecificationError.
ParametricMask make_parametric_mask(std::string_view specification, const std::string& letters);

/// Values of a parameter between two numbers, low < high.
struct ParameterRange {
  Rational low, high;
  bool low_included = true, high_included = true;
};

/// Reads `0 < w <= 1/5` or `-0.1 <= w < 2`, blanks anywhere; nothing for another text. Domain: low < high, up to 1000
/// characters.
std::optional<ParameterRange> parse_parameter_range(std::string text, std::string_view name);

}  // namespace subcert
