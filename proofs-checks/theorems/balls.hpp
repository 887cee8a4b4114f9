#pragma once
/// Real and complex balls as values with operators, for the sources of this floor. Every operation contains the exact
/// results for all points of its arguments; it rounds to the larger precision of its arguments.

#include <subcert/analysis/symbol/flint.hpp>

#include <algorithm>
#include <utility>

namespace subcert::theorems {

class Real {
 public:
  explicit Real(slong bits = 2) : bits_(bits) { arb_init(value_); }
  Real(long value, slong bits) : Real(bits) { arb_set_si(value_, value); }
  Real(const Rational& value, slong bits) : Real(bits) {
    flint::Quotient exact(value);
    arb_set_fmpq(value_, exact.get(), bits);
  }
  Real(const Real& other) : Real(other.bits_) { arb_set(value_, other.value_); }
  Real(Real&& other) noexcept : Real(other.bits_) { arb_swap(value_, other.value_); }
  Real& operator=(Real other) noexcept {
    std::swap(bits_, other.bits_);
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Real() { arb_clear(value_); }

  /// A ball that contains a bounded enclosure.
  static Real containing(const Enclosure& enclosure, slong bits) {
    const Real half(Rational((*enclosure.upper - *enclosure.lower) / 2), bits);
    return Real(Rational((*enclosure.upper + *enclosure.lower) / 2), bits).widened(half);
  }

  static Real pi(slong bits) {
    Real result(bits);
    arb_const_pi(result.value_, bits);
    return result;
  }

  slong bits() const { return bits_; }
  arb_ptr get() { return value_; }
  arb_srcptr get() const { return value_; }

  /// The same ball; later operations on it round to this precision.
  Real with_bits(slong bits) const {
    Real result(*this);
    result.bits_ = bits;
    return result;
  }

  Enclosure enclosure() const {
    flint::Ball ball;
    arb_set(ball.get(), value_);
    return ball.enclosure(bits_ + 30);
  }

  /// The ball whose every point is at most `error` away from a point of this one. Domain: error >= 0.
  Real widened(const Real& error) const {
    Real result(*this);
    arb_add_error(result.value_, error.value_);
    return result;
  }

  /// The largest point, exact.
  Real upper_end() const {
    arf_t end;
    arf_init(end);
    arb_get_ubound_arf(end, value_, bits_);
    Real result(bits_);
    arb_set_arf(result.value_, end);
    arf_clear(end);
    return result;
  }

  /// No point of this ball equals or exceeds any point of the other.
  bool is_less(const Real& other) const { return arb_lt(value_, other.value_); }
  bool is_at_most(const Real& other) const { return arb_le(value_, other.value_); }
  bool is_finite() const { return arb_is_finite(value_); }

  Real operator-() const { return map(arb_neg_plain); }
  friend Real operator+(const Real& a, const Real& b) { return combine(arb_add, a, b); }
  friend Real operator-(const Real& a, const Real& b) { return combine(arb_sub, a, b); }
  friend Real operator*(const Real& a, const Real& b) { return combine(arb_mul, a, b); }
  friend Real operator/(const Real& a, const Real& b) { return combine(arb_div, a, b); }
  friend Real operator+(const Real& a, long b) { return a + Real(b, a.bits_); }
  friend Real operator-(const Real& a, long b) { return a - Real(b, a.bits_); }
  friend Real operator*(const Real& a, long b) { return a * Real(b, a.bits_); }
  friend Real operator/(const Real& a, long b) { return a / Real(b, a.bits_); }
  friend Real operator-(long a, const Real& b) { return Real(a, b.bits_) - b; }
  friend Real operator/(long a, const Real& b) { return Real(a, b.bits_) / b; }
  Real& operator+=(const Real& b) { return *this = *this + b; }
  Real& operator*=(const Real& b) { return *this = *this * b; }

  /// Contains both balls and all between them.
  friend Real join(const Real& a, const Real& b) { return combine(arb_union, a, b); }
  friend Real min(const Real& a, const Real& b) { return combine(arb_min, a, b); }
  friend Real max(const Real& a, const Real& b) { return combine(arb_max, a, b); }
  friend Real sin(const Real& a) { return a.map(arb_sin); }
  friend Real cos(const Real& a) { return a.map(arb_cos); }
  friend Real exp(const Real& a) { return a.map(arb_exp); }
  friend Real sqrt(const Real& a) { return a.map(arb_sqrt); }
  friend Real abs(const Real& a) { return a.map(arb_abs_plain); }

  /// this * 2^exponent, exact.
  Real scaled(slong exponent) const {
    Real result(bits_);
    arb_mul_2exp_si(result.value_, value_, exponent);
    return result;
  }
  /// this^exponent for any integer exponent.
  Real pow(long exponent) const {
    Real result(bits_);
    const flint::Whole power{Integer(exponent)};
    arb_pow_fmpz(result.value_, value_, const_cast<flint::Whole&>(power).get(), bits_);
    return result;
  }

 private:
  static void arb_neg_plain(arb_t y, const arb_t x, slong) { arb_neg(y, x); }
  static void arb_abs_plain(arb_t y, const arb_t x, slong) { arb_abs(y, x); }

  Real map(void (*function)(arb_t, const arb_t, slong)) const {
    Real result(bits_);
    function(result.value_, value_, bits_);
    return result;
  }
  static Real combine(void (*function)(arb_t, const arb_t, const arb_t, slong), const Real& a, const Real& b) {
    Real result(std::max(a.bits_, b.bits_));
    function(result.value_, a.value_, b.value_, result.bits_);
    return result;
  }

  arb_t value_;
  slong bits_;
};

class Complex {
 public:
  explicit Complex(slong bits = 2) : bits_(bits) { acb_init(value_); }
  explicit Complex(const Real& value) : Complex(value.bits()) { acb_set_arb(value_, value.get()); }
  Complex(const acb_t value, slong bits) : Complex(bits) { acb_set(value_, value); }
  Complex(const Complex& other) : Complex(other.bits_) { acb_set(value_, other.value_); }
  Complex(Complex&& other) noexcept : Complex(other.bits_) { acb_swap(value_, other.value_); }
  Complex& operator=(Complex other) noexcept {
    std::swap(bits_, other.bits_);
    acb_swap(value_, other.value_);
    return *this;
  }
  ~Complex() { acb_clear(value_); }

  slong bits() const { return bits_; }
  acb_ptr get() { return value_; }
  acb_srcptr get() const { return value_; }
  Real real() const {
    Real result(bits_);
    acb_get_real(result.get(), value_);
    return result;
  }
  bool is_finite() const { return acb_is_finite(value_); }

  Complex widened(const Real& error) const {
    Complex result(*this);
    arb_add_error(acb_realref(result.value_), error.get());
    arb_add_error(acb_imagref(result.value_), error.get());
    return result;
  }

  friend Complex operator+(const Complex& a, const Complex& b) { return combine(acb_add, a, b); }
  friend Complex operator-(const Complex& a, const Complex& b) { return combine(acb_sub, a, b); }
  friend Complex operator*(const Complex& a, const Complex& b) { return combine(acb_mul, a, b); }
  friend Complex operator/(const Complex& a, const Complex& b) { return combine(acb_div, a, b); }
  friend Complex operator+(const Complex& a, const Real& b) { return a + Complex(b); }
  friend Complex operator*(const Complex& a, const Real& b) {
    Complex result(std::max(a.bits_, b.bits()));
    acb_mul_arb(result.value_, a.value_, b.get(), result.bits_);
    return result;
  }
  Complex& operator+=(const Complex& b) { return *this = *this + b; }
  Complex& operator*=(const Complex& b) { return *this = *this * b; }

  friend Complex sin(const Complex& a) { return a.map(acb_sin); }
  friend Complex cos(const Complex& a) { return a.map(acb_cos); }
  friend Real abs(const Complex& a) {
    Real result(a.bits_);
    acb_abs(result.get(), a.value_, a.bits_);
    return result;
  }
  Complex scaled(slong exponent) const {
    Complex result(bits_);
    acb_mul_2exp_si(result.value_, value_, exponent);
    return result;
  }

 private:
  Complex map(void (*function)(acb_t, const acb_t, slong)) const {
    Complex result(bits_);
    function(result.value_, value_, bits_);
    return result;
  }
  static Complex combine(void (*function)(acb_t, const acb_t, const acb_t, slong), const Complex& a, const Complex& b) {
    Complex result(std::max(a.bits_, b.bits_));
    function(result.value_, a.value_, b.value_, result.bits_);
    return result;
  }

  acb_t value_;
  slong bits_;
};

}  // namespace subcert::theorems
