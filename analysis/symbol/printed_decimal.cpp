#include "printed_decimal.hpp"

#include "error.hpp"

namespace subcert {

PrintedDecimal read_printed_decimal(const std::string& text) {
  const std::size_t point = text.find('.');
  std::string digits = text;
  int places = 0;
  if (point != std::string::npos) {
    places = static_cast<int>(text.size() - point - 1);
    digits.erase(point, 1);
  }
  const auto value = parse_rational(digits);
  if (!value || digits.find('/') != std::string::npos)
    fail(ErrorKind::domain, "printed value: need a decimal number, got '{}'", text);
  return {*value * power(Rational(10), -places), places};
}

Truth agrees(const PrintedDecimal& printed, const Enclosure& computed) {
  const Rational unit = printed.unit(), low = printed.value - unit, high = printed.value + unit;
  if ((computed.lower && *computed.lower > high) || (computed.upper && *computed.upper < low)) return Truth::no;
  if (computed.is_bounded() && *computed.upper - *computed.lower < unit && *computed.lower >= low &&
      *computed.upper <= high)
    return Truth::yes;
  return Truth::unknown;
}

}  // namespace subcert
