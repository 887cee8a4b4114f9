#pragma once
/// Real and complex balls as values with operators, for sources (never for public headers). Every operation contains
/// the exact results for all points of its arguments; it rounds to the larger precision of its arguments.

#include "flint.hpp"
#include "rational_complex.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace subcert {

class Ball {
 public:
  explicit Ball(slong bits = 2) : bits_(bits) { arb_init(value_); }
  Ball(long value, slong bits) : Ball(bits) { arb_set_si(value_, value); }
  Ball(const Rational& value, slong bits) : Ball(bits) {
    flint::Quotient exact(value);
    arb_set_fmpq(value_, exact.get(), bits);
  }
  Ball(const Ball& other) : Ball(other.bits_) { arb_set(value_, other.value_); }
  Ball(Ball&& other) noexcept : Ball(other.bits_) { arb_swap(value_, other.value_); }
  Ball& operator=(Ball other) noexcept {
    std::swap(bits_, other.bits_);
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  /// A ball that contains a bounded enclosure.
  static Ball containing(const Enclosure& enclosure, slong bits) {
    const Ball half(Rational((*enclosure.upper - *enclosure.lower) / 2), bits);
    return Ball(Rational((*enclosure.upper + *enclosure.lower) / 2), bits).widened(half);
  }

  static Ball pi(slong bits) {
    Ball result(bits);
    arb_const_pi(result.value_, bits);
    return result;
  }

  slong bits() const { return bits_; }
  arb_ptr get() { return value_; }
  arb_srcptr get() const { return value_; }

  /// The same ball; later operations on it round to this precision.
  Ball with_bits(slong bits) const {
    Ball result(*this);
    result.bits_ = bits;
    return result;
  }

  /// Ends with at most `bits` bits, and none where the ball is not finite.
  Enclosure enclosure(slong bits) const;
  Enclosure enclosure() const { return enclosure(bits_ + 30); }

  /// The ball whose every point is at most `error` away from a point of this one. Domain: error >= 0.
  Ball widened(const Ball& error) const {
    Ball result(*this);
    arb_add_error(result.value_, error.value_);
    return result;
  }

  /// The largest point, exact.
  Ball upper_end() const {
    arf_t end;
    arf_init(end);
    arb_get_ubound_arf(end, value_, bits_);
    Ball result(bits_);
    arb_set_arf(result.value_, end);
    arf_clear(end);
    return result;
  }

  /// No point of this ball equals or exceeds any point of the other.
  bool is_less(const Ball& other) const { return arb_lt(value_, other.value_); }
  bool is_at_most(const Ball& other) const { return arb_le(value_, other.value_); }
  bool is_finite() const { return arb_is_finite(value_); }

  /// The double nearest to the middle, and one that is not below the radius.
  double middle() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }
  double radius() const { return mag_get_d(arb_radref(value_)); }
  /// Not below the modulus of any point.
  double magnitude() const {
    mag_t bound;
    mag_init(bound);
    arb_get_mag(bound, value_);
    const double result = mag_get_d(bound);
    mag_clear(bound);
    return result;
  }
  /// The whole line.
  static Ball indeterminate(slong bits) {
    Ball result(bits);
    arb_indeterminate(result.value_);
    return result;
  }

  Ball operator-() const { return map(arb_neg_plain); }
  friend Ball operator+(const Ball& a, const Ball& b) { return combine(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return combine(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return combine(arb_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return combine(arb_div, a, b); }
  friend Ball operator+(const Ball& a, long b) { return a + Ball(b, a.bits_); }
  friend Ball operator-(const Ball& a, long b) { return a - Ball(b, a.bits_); }
  friend Ball operator*(const Ball& a, long b) { return a * Ball(b, a.bits_); }
  friend Ball operator/(const Ball& a, long b) { return a / Ball(b, a.bits_); }
  friend Ball operator-(long a, const Ball& b) { return Ball(a, b.bits_) - b; }
  friend Ball operator/(long a, const Ball& b) { return Ball(a, b.bits_) / b; }
  Ball& operator+=(const Ball& b) { return *this = *this + b; }
  Ball& operator*=(const Ball& b) { return *this = *this * b; }
  /// Adds a * b, rounded once.
  void add_product(const Ball& a, const Ball& b) { arb_addmul(value_, a.value_, b.value_, bits_); }

  /// Contains both balls and all between them.
  friend Ball join(const Ball& a, const Ball& b) { return combine(arb_union, a, b); }
  friend Ball min(const Ball& a, const Ball& b) { return combine(arb_min, a, b); }
  friend Ball max(const Ball& a, const Ball& b) { return combine(arb_max, a, b); }
  friend Ball sin(const Ball& a) { return a.map(arb_sin); }
  friend Ball cos(const Ball& a) { return a.map(arb_cos); }
  friend Ball sinc(const Ball& a) { return a.map(arb_sinc); }
  friend Ball exp(const Ball& a) { return a.map(arb_exp); }
  friend Ball log(const Ball& a) { return a.map(arb_log); }
  friend Ball log2(const Ball& a) {
    Ball result(a.bits_);
    arb_log_base_ui(result.value_, a.value_, 2, a.bits_);
    return result;
  }
  friend Ball sqrt(const Ball& a) { return a.map(arb_sqrt); }
  friend Ball abs(const Ball& a) { return a.map(arb_abs_plain); }

  /// this * 2^exponent, exact.
  Ball scaled(slong exponent) const {
    Ball result(bits_);
    arb_mul_2exp_si(result.value_, value_, exponent);
    return result;
  }
  /// this^(1/degree). Domain: degree >= 1.
  Ball root(ulong degree) const {
    Ball result(bits_);
    arb_root_ui(result.value_, value_, degree, bits_);
    return result;
  }
  /// this^exponent for any integer exponent.
  Ball pow(long exponent) const {
    Ball result(bits_);
    arb_pow_fmpz(result.value_, value_, flint::Whole(Integer(exponent)).get(), bits_);
    return result;
  }

 private:
  static void arb_neg_plain(arb_t y, const arb_t x, slong) { arb_neg(y, x); }
  static void arb_abs_plain(arb_t y, const arb_t x, slong) { arb_abs(y, x); }

  Ball map(void (*function)(arb_t, const arb_t, slong)) const {
    Ball result(bits_);
    function(result.value_, value_, bits_);
    return result;
  }
  static Ball combine(void (*function)(arb_t, const arb_t, const arb_t, slong), const Ball& a, const Ball& b) {
    Ball result(std::max(a.bits_, b.bits_));
    function(result.value_, a.value_, b.value_, result.bits_);
    return result;
  }

  arb_t value_;
  slong bits_;
};

/// A vector of real balls.
class BallVector {
 public:
  explicit BallVector(std::size_t size) : size_(static_cast<slong>(size)), entries_(_arb_vec_init(size_)) {}
  BallVector(const BallVector&) = delete;
  BallVector(BallVector&& other) noexcept
      : size_(std::exchange(other.size_, 0)), entries_(std::exchange(other.entries_, nullptr)) {}
  BallVector& operator=(BallVector other) noexcept {
    std::swap(size_, other.size_);
    std::swap(entries_, other.entries_);
    return *this;
  }
  ~BallVector() {
    if (entries_) _arb_vec_clear(entries_, size_);
  }
  std::size_t size() const { return static_cast<std::size_t>(size_); }
  arb_ptr operator[](std::size_t i) { return entries_ + i; }
  arb_srcptr operator[](std::size_t i) const { return entries_ + i; }

  Ball at(std::size_t i, slong bits) const {
    Ball result(bits);
    arb_set(result.get(), entries_ + i);
    return result;
  }
  void set(std::size_t i, const Ball& value) { arb_set(entries_ + i, value.get()); }
  /// The entry i becomes sum of a[first_a + k] b[first_b + k], 0 <= k < count.
  void set_dot(std::size_t i, const BallVector& a, std::size_t first_a, const BallVector& b, std::size_t first_b,
               std::size_t count, slong bits) {
    arb_dot(entries_ + i, nullptr, 0, a[first_a], 1, b[first_b], 1, static_cast<slong>(count), bits);
  }
  /// Adds factor * x. Domain: x.size() <= size().
  void add_multiple(const Ball& factor, const BallVector& x) {
    _arb_vec_scalar_addmul(entries_, x.entries_, x.size_, factor.get(), factor.bits());
  }
  /// x_k becomes x_0 + ... + x_k.
  void sum_up(slong bits) {
    for (slong k = 1; k < size_; ++k) arb_add(entries_ + k, entries_ + k, entries_ + k - 1, bits);
  }
  /// x_k becomes x_k - x_{k+1} for all k but the last.
  void take_differences(slong bits) {
    for (slong k = 0; k + 1 < size_; ++k) arb_sub(entries_ + k, entries_ + k, entries_ + k + 1, bits);
  }
  friend Ball dot(const BallVector& a, const BallVector& b, slong bits) {
    Ball result(bits);
    arb_dot(result.get(), nullptr, 0, a.entries_, 1, b.entries_, 1, std::min(a.size_, b.size_), bits);
    return result;
  }

 private:
  slong size_;
  arb_ptr entries_;
};

class ComplexBall {
 public:
  explicit ComplexBall(slong bits = 2) : bits_(bits) { acb_init(value_); }
  explicit ComplexBall(const Ball& value) : ComplexBall(value.bits()) { acb_set_arb(value_, value.get()); }
  ComplexBall(const acb_t value, slong bits) : ComplexBall(bits) { acb_set(value_, value); }
  ComplexBall(const ComplexBall& other) : ComplexBall(other.bits_) { acb_set(value_, other.value_); }
  ComplexBall(ComplexBall&& other) noexcept : ComplexBall(other.bits_) { acb_swap(value_, other.value_); }
  ComplexBall& operator=(ComplexBall other) noexcept {
    std::swap(bits_, other.bits_);
    acb_swap(value_, other.value_);
    return *this;
  }
  ~ComplexBall() { acb_clear(value_); }

  slong bits() const { return bits_; }
  acb_ptr get() { return value_; }
  acb_srcptr get() const { return value_; }
  Ball real() const {
    Ball result(bits_);
    acb_get_real(result.get(), value_);
    return result;
  }
  /// Not below the modulus of any point.
  double magnitude() const {
    mag_t bound;
    mag_init(bound);
    acb_get_mag(bound, value_);
    const double result = mag_get_d(bound);
    mag_clear(bound);
    return result;
  }
  /// The whole plane.
  static ComplexBall indeterminate(slong bits) {
    ComplexBall result(bits);
    acb_indeterminate(result.value_);
    return result;
  }
  bool is_finite() const { return acb_is_finite(value_); }

  ComplexBall widened(const Ball& error) const {
    ComplexBall result(*this);
    arb_add_error(acb_realref(result.value_), error.get());
    arb_add_error(acb_imagref(result.value_), error.get());
    return result;
  }

  friend ComplexBall operator+(const ComplexBall& a, const ComplexBall& b) { return combine(acb_add, a, b); }
  friend ComplexBall operator-(const ComplexBall& a, const ComplexBall& b) { return combine(acb_sub, a, b); }
  friend ComplexBall operator*(const ComplexBall& a, const ComplexBall& b) { return combine(acb_mul, a, b); }
  friend ComplexBall operator/(const ComplexBall& a, const ComplexBall& b) { return combine(acb_div, a, b); }
  friend ComplexBall operator+(const ComplexBall& a, const Ball& b) { return a + ComplexBall(b); }
  friend ComplexBall operator*(const ComplexBall& a, const Ball& b) {
    ComplexBall result(std::max(a.bits_, b.bits()));
    acb_mul_arb(result.value_, a.value_, b.get(), result.bits_);
    return result;
  }
  ComplexBall& operator+=(const ComplexBall& b) { return *this = *this + b; }
  ComplexBall& operator*=(const ComplexBall& b) { return *this = *this * b; }

  friend ComplexBall sin(const ComplexBall& a) { return a.map(acb_sin); }
  friend ComplexBall cos(const ComplexBall& a) { return a.map(acb_cos); }
  friend Ball abs(const ComplexBall& a) {
    Ball result(a.bits_);
    acb_abs(result.get(), a.value_, a.bits_);
    return result;
  }
  ComplexBall scaled(slong exponent) const {
    ComplexBall result(bits_);
    acb_mul_2exp_si(result.value_, value_, exponent);
    return result;
  }

 private:
  ComplexBall map(void (*function)(acb_t, const acb_t, slong)) const {
    ComplexBall result(bits_);
    function(result.value_, value_, bits_);
    return result;
  }
  static ComplexBall combine(void (*function)(acb_t, const acb_t, const acb_t, slong), const ComplexBall& a,
                             const ComplexBall& b) {
    ComplexBall result(std::max(a.bits_, b.bits_));
    function(result.value_, a.value_, b.value_, result.bits_);
    return result;
  }

  acb_t value_;
  slong bits_;
};

/// Whether two balls have a point in common; whether a ball holds 0.
inline bool overlap(const ComplexBall& a, const ComplexBall& b) { return acb_overlaps(a.get(), b.get()); }
inline bool contains_zero(const ComplexBall& a) { return acb_contains_zero(a.get()); }

inline ComplexBall conj(const ComplexBall& a) {
  ComplexBall result(a.bits());
  acb_conj(result.get(), a.get());
  return result;
}

inline Ball imaginary_part(const ComplexBall& a) {
  Ball result(a.bits());
  acb_get_imag(result.get(), a.get());
  return result;
}

/// The centre of a ball, as a ball and as an exact number. Domain: finite.
inline ComplexBall middle(const ComplexBall& a) {
  ComplexBall result(a.bits());
  acb_get_mid(result.get(), a.get());
  return result;
}
RationalComplex exact_middle(const ComplexBall& a);

/// A ball around an exact number.
ComplexBall ball_around(const RationalComplex& value, slong bits);

}  // namespace subcert
