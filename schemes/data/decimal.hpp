#pragma once
/// Decimal numbers read exactly.

#include <subcert/analysis/symbol/numbers.hpp>

namespace subcert::data {

/// A number and the place of its last printed digit.
struct Decimal {
  Rational value;
  Rational unit;  ///< of the last printed digit: 1/1000 for 0.250 and for 25.0e-2
};

/// Reads `[sign] digits [. digits] [e [sign] digits]` with a digit before or after the point; anything else, more than
/// 1000 digits, or an exponent beyond 400 in modulus, gives nullopt.
std::optional<Decimal> parse_decimal(std::string_view text);

/// The shortest of `m`, `mek` and `p/q`: an integer mantissa without trailing zeros where the value is a decimal
/// number.
std::string to_short_text(const Rational& value);

}  // namespace subcert::data
