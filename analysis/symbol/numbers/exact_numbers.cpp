#include <subcert/analysis/symbol/support/error.hpp>
#include "rational.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace subcert {
namespace {

/// The text that GMP allocated, as a string of ours.
std::string owned(char* text) {
  std::string result(text);
  void (*release)(void*, std::size_t) = nullptr;
  mp_get_memory_functions(nullptr, nullptr, &release);
  release(text, result.size() + 1);
  return result;
}

template <class Number>
Number combined(void (*operation)(decltype(Number().get()), decltype(std::declval<const Number&>().get()),
                                  decltype(std::declval<const Number&>().get())),
                const Number& a, const Number& b) {
  Number result;
  operation(result.get(), a.get(), b.get());
  return result;
}

template <class Number>
const Number& divisor(const Number& value) {
  if (value.is_zero()) fail(ErrorKind::domain, "division by zero");
  return value;
}

/// GMP ends the program where a number is not finite. Whoever computes such a one has lost what it was about.
double finite(double value) {
  if (!std::isfinite(value)) fail(ErrorKind::undecided, "exact number: need a finite double, got {}", value);
  return value;
}

}  // namespace

Integer::Integer(double value) { mpz_init_set_d(value_, finite(value)); }

Integer::Integer(const std::string& digits) {
  if (mpz_init_set_str(value_, digits.c_str(), 10) != 0) {
    mpz_clear(value_);
    fail(ErrorKind::usage, "integer: need decimal digits, got '{}'", digits);
  }
}

std::string Integer::str() const { return owned(mpz_get_str(nullptr, 10, value_)); }

Integer Integer::operator-() const {
  Integer result;
  mpz_neg(result.value_, value_);
  return result;
}

Integer& Integer::operator+=(const Integer& other) {
  mpz_add(value_, value_, other.value_);
  return *this;
}

Integer& Integer::operator-=(const Integer& other) {
  mpz_sub(value_, value_, other.value_);
  return *this;
}

Integer& Integer::operator*=(const Integer& other) {
  mpz_mul(value_, value_, other.value_);
  return *this;
}

Integer& Integer::operator/=(const Integer& other) {
  mpz_tdiv_q(value_, value_, divisor(other).value_);
  return *this;
}

Integer& Integer::operator%=(const Integer& other) {
  mpz_tdiv_r(value_, value_, divisor(other).value_);
  return *this;
}

Integer& Integer::operator<<=(std::size_t bits) {
  mpz_mul_2exp(value_, value_, bits);
  return *this;
}

Integer& Integer::operator>>=(std::size_t bits) {
  mpz_fdiv_q_2exp(value_, value_, bits);
  return *this;
}

Integer operator+(const Integer& a, const Integer& b) { return combined(mpz_add, a, b); }
Integer operator-(const Integer& a, const Integer& b) { return combined(mpz_sub, a, b); }
Integer operator*(const Integer& a, const Integer& b) { return combined(mpz_mul, a, b); }
Integer operator/(const Integer& a, const Integer& b) { return combined(mpz_tdiv_q, a, divisor(b)); }
Integer operator%(const Integer& a, const Integer& b) { return combined(mpz_tdiv_r, a, divisor(b)); }

std::ostream& operator<<(std::ostream& out, const Integer& value) { return out << value.str(); }

Integer abs(const Integer& value) {
  Integer result;
  mpz_abs(result.get(), value.get());
  return result;
}

Integer pow(const Integer& base, unsigned long exponent) {
  Integer result;
  mpz_pow_ui(result.get(), base.get(), exponent);
  return result;
}

Integer gcd(const Integer& a, const Integer& b) { return combined(mpz_gcd, a, b); }
Integer lcm(const Integer& a, const Integer& b) { return combined(mpz_lcm, a, b); }

Integer sqrt(const Integer& value) {
  require(value.sign() >= 0, "sqrt: need value >= 0, got {}", value.str());
  Integer result;
  mpz_sqrt(result.get(), value.get());
  return result;
}

std::size_t msb(const Integer& value) {
  require(value.sign() > 0, "msb: need value > 0, got {}", value.str());
  return mpz_sizeinbase(value.get(), 2) - 1;
}

Rational::Rational(const Integer& value) {
  mpq_init(value_);
  mpz_set(mpq_numref(value_), value.get());
}

Rational::Rational(const Integer& numerator, const Integer& denominator) {
  divisor(denominator);
  mpz_init_set(mpq_numref(value_), numerator.get());
  mpz_init_set(mpq_denref(value_), denominator.get());
  mpq_canonicalize(value_);
}

Rational::Rational(double value) {
  finite(value);
  mpq_init(value_);
  mpq_set_d(value_, value);
}

std::string Rational::str() const { return owned(mpq_get_str(nullptr, 10, value_)); }

Integer Rational::truncated() const {
  Integer result;
  mpz_tdiv_q(result.get(), mpq_numref(value_), mpq_denref(value_));
  return result;
}

double Rational::to_double() const {
  const auto is_double = [](mpz_srcptr x) { return mpz_sizeinbase(x, 2) <= std::numeric_limits<double>::digits; };
  if (is_double(mpq_numref(value_)) && is_double(mpq_denref(value_)))  // one rounding
    return mpz_get_d(mpq_numref(value_)) / mpz_get_d(mpq_denref(value_));
  // A quotient of 55 or 56 bits; its last bit tells whether anything was cut off, so that one rounding remains.
  const auto bits = [](mpz_srcptr x) { return static_cast<long>(mpz_sizeinbase(x, 2)); };
  const long shift = 55 - (bits(mpq_numref(value_)) - bits(mpq_denref(value_)));
  Integer dividend(mpq_numref(value_)), divisor(mpq_denref(value_));
  mpz_abs(dividend.get(), dividend.get());
  (shift >= 0 ? dividend : divisor) <<= static_cast<std::size_t>(shift >= 0 ? shift : -shift);
  mpz_tdiv_qr(dividend.get(), divisor.get(), dividend.get(), divisor.get());
  const unsigned long quotient = mpz_get_ui(dividend.get()) | (divisor.is_zero() ? 0UL : 1UL);
  const int exponent = static_cast<int>(std::clamp(-shift, -4000L, 4000L));
  return std::ldexp(sign() * static_cast<double>(quotient), exponent);
}

Rational Rational::operator-() const {
  Rational result;
  mpq_neg(result.value_, value_);
  return result;
}

Rational& Rational::operator+=(const Rational& other) {
  mpq_add(value_, value_, other.value_);
  return *this;
}

Rational& Rational::operator-=(const Rational& other) {
  mpq_sub(value_, value_, other.value_);
  return *this;
}

Rational& Rational::operator*=(const Rational& other) {
  mpq_mul(value_, value_, other.value_);
  return *this;
}

Rational& Rational::operator/=(const Rational& other) {
  mpq_div(value_, value_, divisor(other).value_);
  return *this;
}

Rational operator+(const Rational& a, const Rational& b) { return combined(mpq_add, a, b); }
Rational operator-(const Rational& a, const Rational& b) { return combined(mpq_sub, a, b); }
Rational operator*(const Rational& a, const Rational& b) { return combined(mpq_mul, a, b); }
Rational operator/(const Rational& a, const Rational& b) { return combined(mpq_div, a, divisor(b)); }

std::ostream& operator<<(std::ostream& out, const Rational& value) { return out << value.str(); }

Integer numerator(const Rational& value) { return Integer(mpq_numref(value.get())); }
Integer denominator(const Rational& value) { return Integer(mpq_denref(value.get())); }

Rational abs(const Rational& value) {
  Rational result;
  mpq_abs(result.get(), value.get());
  return result;
}

}  // namespace subcert
