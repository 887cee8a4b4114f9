#pragma once
/// Bounded enclosures with arithmetic.

#include "numbers.hpp"

namespace subcert {

/// The enclosure times a factor; absent ends stay absent. Domain: factor > 0. Errors: throws Error.
Enclosure scaled(const Enclosure& enclosure, const Rational& factor);

/// lower <= x <= upper. Canonical: lower <= upper. Every operation gives the smallest interval that holds all results
/// for points of its arguments: its ends are exact, nothing is rounded.
struct Interval {
  Rational lower;
  Rational upper;

  static Interval exactly(const Rational& value) { return {value, value}; }
  /// Domain: both ends are present. Errors: throws Error.
  static Interval of(const Enclosure& enclosure);
  Enclosure enclosure() const { return {lower, upper}; }

  Rational width() const { return upper - lower; }
  bool contains(const Rational& value) const { return lower <= value && value <= upper; }
  bool operator==(const Interval& other) const { return lower == other.lower && upper == other.upper; }
};

Interval operator-(const Interval& a);
Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Rational& b);
/// Domain: b does not contain 0. Errors: throws Error.
Interval operator/(const Interval& a, const Interval& b);

}  // namespace subcert
