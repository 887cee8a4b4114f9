#pragma once
/// Integers of any size: an owner of GMP's mpz_t with operators. Boost.Multiprecision's numbers convert from and to it
/// (boost_numbers.hpp).

#include <gmp.h>

#include <compare>
#include <concepts>
#include <iosfwd>
#include <limits>
#include <string>

namespace subcert {

/// Division and remainder truncate towards zero, as those of int do; to_integer of numbers.hpp rounds as it is told.
/// Errors: division by zero throws Error. Cost: that of GMP's functions; a small operand is not copied to the heap.
class Integer {
 public:
  Integer() { mpz_init(value_); }
  template <std::integral T>
  Integer(T value) {  // NOLINT(google-explicit-constructor): an int is an Integer
    static_assert(sizeof(T) <= sizeof(long));
    if constexpr (std::signed_integral<T>)
      mpz_init_set_si(value_, value);
    else
      mpz_init_set_ui(value_, value);
  }
  /// The integer part. Domain: a finite value. Errors: throws Error.
  explicit Integer(double value);
  explicit Integer(mpz_srcptr value) { mpz_init_set(value_, value); }
  /// Decimal digits with an optional sign. Errors: throws Error for any other text.
  explicit Integer(const std::string& digits);
  Integer(const Integer& other) { mpz_init_set(value_, other.value_); }
  Integer(Integer&& other) noexcept {
    *value_ = *other.value_;
    mpz_init(other.value_);
  }
  Integer& operator=(const Integer& other) {
    mpz_set(value_, other.value_);
    return *this;
  }
  Integer& operator=(Integer&& other) noexcept {
    mpz_swap(value_, other.value_);
    return *this;
  }
  ~Integer() { mpz_clear(value_); }

  mpz_ptr get() { return value_; }
  mpz_srcptr get() const { return value_; }

  std::string str() const;
  int sign() const { return mpz_sgn(value_); }
  bool is_zero() const { return sign() == 0; }
  /// The nearest double towards zero, infinite beyond doubles; integers beyond T give its extreme values.
  template <class T>
  T convert_to() const {
    if constexpr (std::floating_point<T>) return static_cast<T>(mpz_get_d(value_));
    if constexpr (std::signed_integral<T>) {
      if (mpz_cmp_si(value_, std::numeric_limits<T>::max()) > 0) return std::numeric_limits<T>::max();
      if (mpz_cmp_si(value_, std::numeric_limits<T>::min()) < 0) return std::numeric_limits<T>::min();
      return static_cast<T>(mpz_get_si(value_));
    }
    if constexpr (std::unsigned_integral<T>) {
      if (sign() <= 0) return 0;
      if (mpz_cmp_ui(value_, std::numeric_limits<T>::max()) > 0) return std::numeric_limits<T>::max();
      return static_cast<T>(mpz_get_ui(value_));
    }
  }

  template <class T>
  requires(std::integral<T> || std::floating_point<T>) explicit operator T() const { return convert_to<T>(); }

  Integer operator-() const;
  Integer& operator+=(const Integer& other);
  Integer& operator-=(const Integer& other);
  Integer& operator*=(const Integer& other);
  Integer& operator/=(const Integer& other);
  Integer& operator%=(const Integer& other);
  Integer& operator<<=(std::size_t bits);
  /// Rounds towards minus infinity.
  Integer& operator>>=(std::size_t bits);
  Integer& operator++() { return *this += Integer(1); }
  Integer& operator--() { return *this -= Integer(1); }
  friend Integer operator+(const Integer& a, const Integer& b);
  friend Integer operator-(const Integer& a, const Integer& b);
  friend Integer operator*(const Integer& a, const Integer& b);
  friend Integer operator/(const Integer& a, const Integer& b);
  friend Integer operator%(const Integer& a, const Integer& b);
  friend Integer operator<<(Integer a, std::size_t bits) { return a <<= bits; }
  friend Integer operator>>(Integer a, std::size_t bits) { return a >>= bits; }

  friend bool operator==(const Integer& a, const Integer& b) { return mpz_cmp(a.value_, b.value_) == 0; }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    return mpz_cmp(a.value_, b.value_) <=> 0;
  }
  template <std::integral T>
  friend bool operator==(const Integer& a, T b) {
    return std::is_eq(a <=> b);
  }
  template <std::integral T>
  friend std::strong_ordering operator<=>(const Integer& a, T b) {
    if constexpr (std::signed_integral<T>)
      return mpz_cmp_si(a.value_, static_cast<long>(b)) <=> 0;
    else
      return mpz_cmp_ui(a.value_, static_cast<unsigned long>(b)) <=> 0;
  }
  friend std::ostream& operator<<(std::ostream& out, const Integer& value);

 private:
  mpz_t value_;
};

/// sum += a * b, in place.
inline void add_product(Integer& sum, const Integer& a, const Integer& b) { mpz_addmul(sum.get(), a.get(), b.get()); }

Integer abs(const Integer& value);
Integer pow(const Integer& base, unsigned long exponent);
/// Non-negative.
Integer gcd(const Integer& a, const Integer& b);
Integer lcm(const Integer& a, const Integer& b);
/// The floor of the root. Domain: value >= 0.
Integer sqrt(const Integer& value);
/// The index of the highest bit that is set. Domain: value > 0.
std::size_t msb(const Integer& value);

}  // namespace subcert
