#pragma once
/// For which values of a parameter a property holds, in one sentence.

#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <functional>
#include <optional>
#include <string>

namespace subcert::facts {

/// Exact where that is short, else rounded to so many digits.
std::string number_text(const Rational& value, Rounding rounding = Rounding::nearest, int digits = 12);

/// How formulas are printed.
using Formula = std::function<std::string(const std::string&)>;
inline std::string as_text(const std::string& formula) { return formula; }

/// `C1 exactly for 0 < w < r, of all w from -1 to 1; r is the zero of 32*w^3 + 4*w - 1 near 0.19`; nothing where more
/// is open than pieces of the width that was asked for, or little of the range. Domain: `range` is of this scheme;
/// `property` is its name as it is to be printed.
std::optional<std::string> range_summary(const PropertyRange& range, const ParametricScheme& scheme,
                                         const std::string& property, const Formula& formula = as_text);

/// The zero of a polynomial next to a number: itself where it is rational, or `the zero of 32*w^3+4*w-1 near 0.19`.
std::string zero_text(const LaurentPolynomial& of, const Rational& near, const ParametricScheme& scheme,
                      const Formula& formula = as_text);

}  // namespace subcert::facts
