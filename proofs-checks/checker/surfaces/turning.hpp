// Intervals between integers over W = 2^bits, and numbers a + b w with w = exp(2 pi i k/n): section 5.11 of
// ../../certificates/SPEC.md. All rounding is outward.
#pragma once

#include "../arithmetic.hpp"

namespace subcert_check {

/// Between low/W and high/W.
struct Interval {
  mpz_class low, high;
};

Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator-(const Interval& a);
/// At least |x| W for all x of the interval.
mpz_class largest(const Interval& a);

/// Intervals over one W.
class Intervals {
 public:
  Intervals(std::size_t bits, Arithmetic& arithmetic) : bits_(bits), arithmetic_(arithmetic) {}

  mpz_class one() const { return mpz_class(1) << bits_; }
  Interval number(const mpq_class& x) const;
  Interval times(const Interval& a, const Interval& b) const;
  /// Domain: b above 0.
  Interval over(const Interval& a, const Interval& b) const;
  Interval cosine(std::size_t k, std::size_t n) const;
  /// Of 2 pi x. Domain: 0 < x < 1.
  Interval cosine(const mpq_class& x) const;

 private:
  std::size_t bits_;
  Arithmetic& arithmetic_;
};

/// a + b w.
struct Turning {
  Interval a, b;
};

Turning operator+(const Turning& x, const Turning& y);
Turning operator-(const Turning& x, const Turning& y);
/// At least |x| W.
mpz_class largest(const Turning& x);

/// Numbers a + b w; where w is real, b = 0.
class Frequency {
 public:
  /// Domain: 0 <= k <= n/2.
  Frequency(std::size_t k, std::size_t n, const Intervals& intervals);
  /// w = exp(i t) for all t with cosines in the interval.
  Frequency(const Interval& cosine, const Intervals& intervals);

  /// k; 1 for w of an interval.
  std::size_t number() const { return static_cast<std::size_t>(k_); }
  bool is_real() const { return k_ == 0 || 2 * k_ == n_; }

  Turning times(const Turning& x, const Turning& y) const;
  /// Twice the real part of x times the conjugate of y.
  Interval inner(const Turning& x, const Turning& y) const;
  Turning scaled(const Interval& factor, const Turning& x) const;
  /// Rejects a number that may be 0.
  Turning inverse(const Turning& x) const;
  /// w^turns x, by as few turns as may be.
  Turning turned(Turning x, long turns) const;
  /// rho and s of w^turns (1 + delta rho + s (w - 1)), delta = 2 - 2 cos; a and b of x are rho and s.
  Turning turned_near_one(Turning x, long turns, const Interval& delta) const;

 private:
  long k_, n_;
  const Intervals& intervals_;
  Interval twice_cosine_;
};

using TurningMatrix = std::vector<std::vector<Turning>>;

/// The largest sum of a row of bounds of |entries| W.
mpz_class row_norm(const TurningMatrix& matrix);
TurningMatrix product(const TurningMatrix& x, const TurningMatrix& y, const Frequency& frequency);

}  // namespace subcert_check
