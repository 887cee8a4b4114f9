#include "numbers.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include "balls.hpp"

#include <algorithm>

namespace subcert {
namespace {

constexpr std::size_t max_digits = 10'000;
constexpr int thresholds_per_unit = 12;

bool all_digits(std::string_view text) {
  return !text.empty() && text.size() <= max_digits &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

Integer power_of_ten(long exponent) { return pow(Integer(10), static_cast<unsigned>(exponent)); }

/// The largest e with 10^e <= |value|. Domain: value != 0.
long decimal_exponent(const Rational& value) {
  const Rational magnitude = abs(value);
  const auto size = [](const Integer& x) { return static_cast<long>(mpz_sizeinbase(x.get(), 10)); };
  long exponent = size(numerator(magnitude)) - size(denominator(magnitude)) + 1;
  while (power(Rational(10), exponent) > magnitude) --exponent;
  return exponent;
}

/// The least integer that the base is a power of, and which power. Domain: base >= 2.
std::pair<Integer, int> primitive_root(int base) {
  const Integer power = base;
  for (int degree = 30; degree > 1; --degree) {
    Integer root;
    if (mpz_root(root.get(), power.get(), static_cast<unsigned long>(degree)) != 0) return {root, degree};
  }
  return {power, 1};
}

std::string place_point(std::string digits, long places) {
  bool negative = !digits.empty() && digits.front() == '-';
  if (negative) digits.erase(0, 1);
  if (places > 0) {
    if (static_cast<long>(digits.size()) <= places)
      digits.insert(0, static_cast<std::size_t>(places) + 1 - digits.size(), '0');
    digits.insert(digits.size() - static_cast<std::size_t>(places), ".");
  }
  return negative ? "-" + digits : digits;
}

void drop_trailing_zeros(std::string& text) {
  if (text.find('.') == std::string::npos) return;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
}

}  // namespace

Integer to_integer(const Rational& value, Rounding rounding) {
  if (rounding == Rounding::nearest) {
    const Rational half(1, 2);
    return value < 0 ? -to_integer(half - value, Rounding::down) : to_integer(value + half, Rounding::down);
  }
  const Integer num = numerator(value), den = denominator(value);
  Integer result;
  if (rounding == Rounding::down)
    mpz_fdiv_q(result.get(), num.get(), den.get());
  else
    mpz_cdiv_q(result.get(), num.get(), den.get());
  return result;
}

Rational to_multiple(const Rational& value, const Rational& unit, Rounding rounding) {
  return unit * Rational(to_integer(value / unit, rounding));
}

std::optional<Rational> parse_rational(std::string_view text) {
  bool negative = false;
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    negative = text.front() == '-';
    text.remove_prefix(1);
  }
  const std::size_t slash = text.find('/');
  const std::string_view num = text.substr(0, slash);
  const std::string_view den = slash == std::string_view::npos ? std::string_view("1") : text.substr(slash + 1);
  if (!all_digits(num) || !all_digits(den)) return std::nullopt;
  Integer numerator{std::string(num)};
  const Integer denominator{std::string(den)};
  if (denominator == 0) return std::nullopt;
  if (negative) numerator = -numerator;
  return Rational(numerator, denominator);
}

std::string to_text(const Rational& value) { return value.str(); }

Rational power(const Rational& base, long exponent) {
  if (exponent < 0) {
    if (base == 0) fail(ErrorKind::domain, "power: need base != 0 for a negative exponent, got 0");
    return 1 / power(base, -exponent);
  }
  Integer num, den;
  mpz_pow_ui(num.get(), numerator(base).get(), static_cast<unsigned long>(exponent));
  mpz_pow_ui(den.get(), denominator(base).get(), static_cast<unsigned long>(exponent));
  return Rational(num, den);
}

std::string to_fixed(const Rational& value, int places, Rounding rounding) {
  if (places < 0 || places > static_cast<int>(max_digits))
    fail(ErrorKind::domain, "to_fixed: need 0 <= places <= 10000, got {}", places);
  return place_point(to_integer(value * Rational(power_of_ten(places)), rounding).str(), places);
}

std::string short_text(const Rational& value) {
  const std::string exact = to_text(value);
  return exact.size() <= 24 ? exact : "about " + to_decimal(value, 6, Rounding::nearest);
}

std::string to_decimal(const Rational& value, int digits, Rounding rounding) {
  if (digits < 1 || digits > static_cast<int>(max_digits))
    fail(ErrorKind::domain, "to_decimal: need 1 <= digits <= 10000, got {}", digits);
  if (value == 0) return "0";
  long exponent = decimal_exponent(value);
  long shift = digits - 1 - exponent;
  Integer scaled = to_integer(value * power(Rational(10), shift), rounding);
  if (abs(scaled) == power_of_ten(digits)) {  // 9.99 was rounded to 10.0
    scaled /= 10;
    ++exponent;
    --shift;
  }
  if (exponent >= -7 && exponent <= 20) {
    std::string text = shift >= 0 ? place_point(scaled.str(), shift) : Integer(scaled * power_of_ten(-shift)).str();
    drop_trailing_zeros(text);
    return text;
  }
  std::string text = place_point(scaled.str(), digits - 1);
  drop_trailing_zeros(text);
  return text + "e" + std::to_string(exponent);
}

std::string Enclosure::lower_text(int digits) const {
  return lower ? to_decimal(*lower, digits, Rounding::down) : "-inf";
}

std::string Enclosure::upper_text(int digits) const { return upper ? to_decimal(*upper, digits, Rounding::up) : "inf"; }

int digits_within(const Rational& value, const Rational& distance, int least) {
  // A digit more brings the printed value ten times nearer.
  const Rational most = abs(value);
  for (Rational error = power(Rational(10), 1 - least) * most;
       error >= distance && least < static_cast<int>(max_digits); error /= 10)
    ++least;
  return least;
}

int Enclosure::telling_digits(int digits) const {
  const auto enough = [](const Rational& end, Rounding rounding, int least) {
    const Rational next = to_multiple(end, Rational(1, thresholds_per_unit), rounding);
    return end == next ? least : digits_within(end, abs(end - next), least);
  };
  if (lower) digits = enough(*lower, Rounding::down, digits);
  if (upper) digits = enough(*upper, Rounding::up, digits);
  return digits;
}

int decimal_places(const Rational& width) {
  require(width > 0, "decimal_places: need width > 0, got {}", width);
  int places = 0;
  for (Rational unit = 1; unit > width; unit /= 10) ++places;
  return places;
}

std::string enclosure_text(const Enclosure& enclosure, int digits) {
  if (!enclosure.lower && !enclosure.upper) return "unknown";
  digits = enclosure.telling_digits(digits);
  if (!enclosure.upper) return ">= " + enclosure.lower_text(digits);
  if (!enclosure.lower) return "<= " + enclosure.upper_text(digits);
  std::string low = to_decimal(*enclosure.lower, digits, Rounding::nearest);
  if (low == to_decimal(*enclosure.upper, digits, Rounding::nearest)) return low;
  return enclosure.lower_text(digits) + " ... " + enclosure.upper_text(digits);
}

Enclosure log_ratio(const Rational& argument, int base, int bits) {
  if (argument <= 0) fail(ErrorKind::domain, "log_ratio: need argument > 0, got {}", argument);
  require(base >= 2, "log_ratio: need base >= 2, got {}", base);
  // The logarithm is rational where both are powers of one integer.
  const auto [primitive, degree] = primitive_root(base);
  for (bool inverted : {false, true}) {
    const Rational value = inverted ? 1 / argument : argument;
    if (denominator(value) != 1) continue;
    Integer rest = numerator(value);
    const Rational exponent(Integer(mpz_remove(rest.get(), rest.get(), primitive.get())), degree);
    if (rest == 1) return Enclosure::exactly(inverted ? Rational(-exponent) : exponent);
  }
  const slong precision = bits + 92;
  return (log(Ball(argument, precision)) / log(Ball(base, precision))).enclosure(precision + 64);
}

Rational simplest_between(const Rational& low, const Rational& high) {
  flint::Quotient from(low), to(high), between;
  fmpq_simplest_between(between.get(), from.get(), to.get());
  return flint::to_rational(between.get());
}

std::optional<Rational> exact_root(const Rational& value, unsigned long degree) {
  Integer top, bottom;
  const Integer numbers[] = {numerator(value), denominator(value)};
  if (mpz_root(top.get(), numbers[0].get(), degree) == 0 || mpz_root(bottom.get(), numbers[1].get(), degree) == 0)
    return std::nullopt;
  return Rational(top, bottom);
}

Enclosure root_enclosure(const Rational& value, int degree, int bits) {
  if (value < 0 || degree < 1) fail(ErrorKind::domain, "root_enclosure: need value >= 0 and degree >= 1");
  if (degree == 1 || value == 0) return Enclosure::exactly(value);
  // An exact root where there is one.
  Integer num, den;
  if (mpz_root(num.get(), numerator(value).get(), static_cast<unsigned long>(degree)) != 0 &&
      mpz_root(den.get(), denominator(value).get(), static_cast<unsigned long>(degree)) != 0)
    return Enclosure::exactly(Rational(num, den));
  const slong precision = bits + 76;
  return Ball(value, precision).root(static_cast<ulong>(degree)).enclosure(precision);
}

long binary_exponent(const Rational& value) {
  const auto bits = [](const Integer& x) { return static_cast<long>(mpz_sizeinbase(x.get(), 2)); };
  return bits(numerator(value)) - bits(denominator(value));
}

std::string to_text(Truth truth) {
  switch (truth) {
    case Truth::yes: return "yes";
    case Truth::no: return "no";
    default: return "unknown";
  }
}

}  // namespace subcert
