#pragma once
/// Decimal numbers read exactly, and what it means that a computed value agrees with a printed one.

#include "numbers.hpp"

namespace subcert {

/// A number and the place of its last printed digit.
struct Decimal {
  Rational value;
  Rational unit;  ///< of the last printed digit: 1/1000 for 0.250 and for 25.0e-2

  /// Digits after the point: 3 for 0.250 and for 25.0e-2, 0 for 12 and 1e3.
  int places() const { return static_cast<int>(denominator(unit).str().size()) - 1; }
};

/// Reads `[sign] digits [. digits] [e [sign] digits]` with a digit before or after the point; anything else, more than
/// 1000 digits, or an exponent beyond 400 in modulus, gives nullopt.
std::optional<Decimal> parse_decimal(std::string_view text);

/// The same without an exponent, as papers print numbers.
std::optional<Decimal> parse_plain_decimal(std::string_view text);
/// The same. Errors: throws Error for any other text.
Decimal read_decimal(std::string_view text);

/// A rational as parse_rational reads it, or a decimal, with an exponent or without; nothing for another text.
std::optional<Rational> parse_number(std::string_view text);

/// yes: the enclosure is narrower than one unit of the last printed digit and lies within one unit of the printed
/// value. no: the two cannot be that near. Otherwise unknown. See docs/comparison.md.
Truth agrees(const Decimal& printed, const Enclosure& computed);

/// The shortest of `m`, `mek` and `p/q`: an integer mantissa without trailing zeros where the value is a decimal
/// number.
std::string to_short_text(const Rational& value);

}  // namespace subcert
