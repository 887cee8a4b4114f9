#pragma once
/// Rational numbers: an owner of GMP's mpq_t with operators.

#include "integer.hpp"

#include <fmt/core.h>

namespace subcert {

/// Canonical: lowest terms, positive denominator, after every operation. Errors: division by zero throws Error.
class Rational {
 public:
  Rational() { mpq_init(value_); }
  template <std::integral T>
  Rational(T value) : Rational(Integer(value)) {}  // NOLINT(google-explicit-constructor): an int is a Rational
  Rational(const Integer& value);                  // NOLINT(google-explicit-constructor): an Integer is a Rational
  /// Domain: denominator != 0. Errors: throws Error.
  Rational(const Integer& numerator, const Integer& denominator);
  /// Exact. Domain: a finite value. Errors: throws Error.
  explicit Rational(double value);
  explicit Rational(mpq_srcptr value) : Rational() { mpq_set(value_, value); }
  Rational(const Rational& other) : Rational() { mpq_set(value_, other.value_); }
  /// What was moved from may only be assigned to or destroyed.
  Rational(Rational&& other) noexcept {
    *value_ = *other.value_;
    mpz_init(mpq_numref(other.value_));
    mpz_init(mpq_denref(other.value_));
  }
  Rational& operator=(const Rational& other) {
    mpq_set(value_, other.value_);
    return *this;
  }
  Rational& operator=(Rational&& other) noexcept {
    mpq_swap(value_, other.value_);
    return *this;
  }
  ~Rational() { mpq_clear(value_); }

  mpq_ptr get() { return value_; }
  mpq_srcptr get() const { return value_; }

  /// `p`, or `p/q` where q > 1.
  std::string str() const;
  int sign() const { return mpq_sgn(value_); }
  bool is_zero() const { return sign() == 0; }
  /// The nearest double (ties to even; below the normal ones rounded twice), infinite beyond doubles; for integers the
  /// integer part, or the extreme value beyond their range.
  template <class T>
  T convert_to() const {
    if constexpr (std::floating_point<T>)
      return static_cast<T>(to_double());
    else
      return truncated().convert_to<T>();
  }

  template <class T>
  requires(std::integral<T> || std::floating_point<T>) explicit operator T() const { return convert_to<T>(); }

  Rational operator-() const;
  Rational& operator+=(const Rational& other);
  Rational& operator-=(const Rational& other);
  Rational& operator*=(const Rational& other);
  Rational& operator/=(const Rational& other);
  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);

  friend bool operator==(const Rational& a, const Rational& b) { return mpq_equal(a.value_, b.value_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return mpq_cmp(a.value_, b.value_) <=> 0;
  }
  template <std::integral T>
  friend bool operator==(const Rational& a, T b) {
    return std::is_eq(a <=> b);
  }
  template <std::integral T>
  friend std::strong_ordering operator<=>(const Rational& a, T b) {
    if constexpr (std::signed_integral<T>)
      return mpq_cmp_si(a.value_, static_cast<long>(b), 1) <=> 0;
    else
      return mpq_cmp_ui(a.value_, static_cast<unsigned long>(b), 1) <=> 0;
  }
  friend std::ostream& operator<<(std::ostream& out, const Rational& value);

 private:
  Integer truncated() const;
  double to_double() const;

  mpq_t value_;
};

Integer numerator(const Rational& value);
Integer denominator(const Rational& value);
Rational abs(const Rational& value);

}  // namespace subcert

/// In texts: `p` or `p/q`.
template <class Number>
requires(std::same_as<Number, subcert::Integer> ||
         std::same_as<Number, subcert::Rational>) struct fmt::formatter<Number> {
  constexpr auto parse(fmt::format_parse_context& context) { return context.begin(); }
  auto format(const Number& value, fmt::format_context& context) const {
    return fmt::format_to(context.out(), "{}", value.str());
  }
};
