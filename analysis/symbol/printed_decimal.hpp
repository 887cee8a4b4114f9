#pragma once
/// Decimal numbers as papers print them.

#include "numbers.hpp"

namespace subcert {

/// The value and the count of its decimals, which sets the unit of the last printed place.
struct PrintedDecimal {
  Rational value;
  int places;

  Rational unit() const { return power(Rational(10), -places); }
};

/// Reads `12.340`, also with a minus. Errors: throws Error.
PrintedDecimal read_printed_decimal(const std::string& text);

/// yes: the enclosure is narrower than one unit of the last printed place and lies within one unit of the printed
/// value. no: the two cannot be that near. Otherwise unknown. See docs/comparison.md.
Truth agrees(const PrintedDecimal& printed, const Enclosure& computed);

}  // namespace subcert
