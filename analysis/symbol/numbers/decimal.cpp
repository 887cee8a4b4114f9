#include "decimal.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <algorithm>
#include <cstdlib>

namespace subcert {
namespace {

constexpr std::size_t max_decimal_digits = 1000;
constexpr long max_exponent = 400;

/// Moves the digits at the front of `text` to `digits`.
void take_digits(std::string_view& text, std::string& digits) {
  while (!text.empty() && is_digit(text.front())) {
    digits += text.front();
    text.remove_prefix(1);
  }
}

bool take_sign(std::string_view& text) {
  if (text.empty() || (text.front() != '-' && text.front() != '+')) return false;
  const bool minus = text.front() == '-';
  text.remove_prefix(1);
  return minus;
}

}  // namespace

std::optional<Decimal> parse_decimal(std::string_view text) {
  const bool minus = take_sign(text);
  std::string digits;
  take_digits(text, digits);
  long exponent = 0;
  if (!text.empty() && text.front() == '.') {
    text.remove_prefix(1);
    const std::size_t whole = digits.size();
    take_digits(text, digits);
    exponent = -static_cast<long>(digits.size() - whole);
  }
  if (digits.empty() || digits.size() > max_decimal_digits) return std::nullopt;
  if (!text.empty() && (text.front() == 'e' || text.front() == 'E')) {
    text.remove_prefix(1);
    const bool negative = take_sign(text);
    std::string power_digits;
    take_digits(text, power_digits);
    if (power_digits.empty() || power_digits.size() > 4) return std::nullopt;
    const long shift = std::strtol(power_digits.c_str(), nullptr, 10);
    if (shift > max_exponent) return std::nullopt;
    exponent += negative ? -shift : shift;
  }
  if (!text.empty()) return std::nullopt;
  const Rational unit = power(Rational(10), exponent);
  const Rational value = Rational(Integer(digits)) * unit;
  return Decimal{minus ? Rational(-value) : value, unit};
}

std::optional<Decimal> parse_plain_decimal(std::string_view text) {
  return text.find_first_of("eE") == std::string_view::npos ? parse_decimal(text) : std::nullopt;
}

std::optional<Rational> parse_number(std::string_view text) {
  if (auto rational = parse_rational(text)) return rational;
  if (const auto decimal = parse_decimal(text)) return decimal->value;
  return std::nullopt;
}

Decimal read_decimal(std::string_view text) {
  const std::optional<Decimal> result = parse_plain_decimal(text);
  if (!result) fail(ErrorKind::usage, "need a decimal number, got '{}'", text);
  return *result;
}

Truth agrees(const Decimal& printed, const Enclosure& computed) {
  const Rational low = printed.value - printed.unit, high = printed.value + printed.unit;
  if ((computed.lower && *computed.lower > high) || (computed.upper && *computed.upper < low)) return Truth::no;
  if (computed.is_bounded() && *computed.upper - *computed.lower < printed.unit && *computed.lower >= low &&
      *computed.upper <= high)
    return Truth::yes;
  return Truth::unknown;
}

std::string to_short_text(const Rational& value) {
  if (value == 0) return "0";
  // value = m 10^k with m an integer, if the denominator has no prime factors but 2 and 5.
  Integer rest = denominator(value);
  long twos = 0, fives = 0;
  for (; rest % 2 == 0; rest /= 2) ++twos;
  for (; rest % 5 == 0; rest /= 5) ++fives;
  if (rest != 1) return to_text(value);
  long exponent = -std::max(twos, fives);
  Integer mantissa = numerator(Rational(value * power(Rational(10), -exponent)));
  for (; mantissa % 10 == 0; mantissa /= 10) ++exponent;
  const std::string scientific = mantissa.str() + (exponent == 0 ? "" : "e" + std::to_string(exponent));
  const std::string plain = to_text(value);
  return plain.size() <= scientific.size() ? plain : scientific;
}

}  // namespace subcert
