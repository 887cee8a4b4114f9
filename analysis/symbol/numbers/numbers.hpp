#pragma once
/// Exact numbers, enclosures and three-valued answers: the vocabulary every floor speaks.

#include "rational.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace subcert {

/// Reads `p` or `p/q` with optional sign; anything else (blanks, decimals, q = 0, more than 10,000 digits) gives
/// nullopt. Cost: quadratic in the digits.
std::optional<Rational> parse_rational(std::string_view text);

/// Prints `p` or `p/q` in lowest terms with q > 1.
std::string to_text(const Rational& value);

/// base^exponent, exact. Domain: base != 0 when exponent < 0.
Rational power(const Rational& base, long exponent);

/// The least k >= 0 with 10^-k <= width. Domain: width > 0.
int decimal_places(const Rational& width);

/// So many significant digits, `least` or more, that a value printed with them is less than that away. Domain: distance
/// > 0. At most 10,000.
int digits_within(const Rational& value, const Rational& distance, int least);

enum class Rounding { down, up, nearest };

/// The floor, the ceiling, or the nearest integer (ties away from zero).
Integer to_integer(const Rational& value, Rounding rounding);
/// The multiple of the unit that is next below, next above or nearest. Domain: unit > 0.
Rational to_multiple(const Rational& value, const Rational& unit, Rounding rounding);

/// Decimal string with `digits` significant digits, rounded towards -infinity, +infinity or to the nearest (ties away
/// from zero). Domain: 1 <= digits <= 10,000. Error: less than one unit in the last digit. Plain notation for decimal
/// exponents from -7 to 20, scientific otherwise; exact short decimals lose their trailing zeros.
std::string to_decimal(const Rational& value, int digits, Rounding rounding);

/// For reasons and messages: exact while that takes at most 24 characters, else `about` and six significant digits.
std::string short_text(const Rational& value);

/// Decimal string with exactly `places` digits after the point. Domain: 0 <= places <= 10,000.
std::string to_fixed(const Rational& value, int places, Rounding rounding);

/// A set lower <= x <= upper that contains the true value; an absent end is unbounded. Canonical: lower <= upper when
/// both are present.
struct Enclosure {
  std::optional<Rational> lower;
  std::optional<Rational> upper;

  static Enclosure exactly(const Rational& value) { return {value, value}; }
  static Enclosure at_least(const Rational& value) { return {value, std::nullopt}; }

  bool is_canonical() const { return !lower || !upper || *lower <= *upper; }
  bool is_bounded() const { return lower && upper; }
  bool is_exact() const { return is_bounded() && *lower == *upper; }
  bool contains(const Rational& value) const { return (!lower || *lower <= value) && (!upper || value <= *upper); }

  /// Decimal ends rounded outward, so that the printed set contains this one; `-inf` and `inf` for absent ends.
  std::string lower_text(int digits = 20) const;
  std::string upper_text(int digits = 20) const;
  /// The least number of digits, from `digits` on, with which the printed ends lie between the same multiples of 1/12
  /// as the ends themselves: what is proved to lie above 1 is not printed as 1. At most 10,000.
  int telling_digits(int digits) const;
};

/// Exact decimal ends for people: `1.2345` where both ends round to it, or `1.2345 ... 1.2346`, `>= 1.2345`, `unknown`.
/// Domain: digits >= 1, more where they tell it from thresholds.
std::string enclosure_text(const Enclosure& enclosure, int digits = 12);

/// Encloses log(argument) / log(base). Domain: argument > 0, base >= 2. Error: none where it is rational, else
/// width below 2^-bits times max(1, |value|). Cost: one ball logarithm each. Ref: [Joh17].
Enclosure log_ratio(const Rational& argument, int base, int bits = 100);

/// The number with the least denominator, of these the one next to 0. Domain: low <= high.
Rational simplest_between(const Rational& low, const Rational& high);

/// value^(1/degree), where that is rational. Domain: value >= 0, degree >= 1.
std::optional<Rational> exact_root(const Rational& value, unsigned long degree);

/// Encloses value^(1/degree). Domain: value >= 0, degree >= 1. Error: relative width below 2^-bits.
Enclosure root_enclosure(const Rational& value, int degree, int bits = 180);

/// The size as a power of 2: 2^(e-1) < |value| < 2^(e+1). Domain: value != 0.
long binary_exponent(const Rational& value);

/// A proof is three-valued; `unknown` says why, `yes` and `no` say by which argument.
enum class Truth { yes, no, unknown };

struct [[nodiscard]] Decision {
  Truth truth = Truth::unknown;
  std::string reason;

  bool is_yes() const { return truth == Truth::yes; }
  bool is_no() const { return truth == Truth::no; }
};

std::string to_text(Truth truth);

}  // namespace subcert
