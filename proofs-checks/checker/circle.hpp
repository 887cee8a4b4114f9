// Points of the unit circle: section 4.17 of ../certificates/SPEC.md, which bounds what they are off.
#pragma once

#include "arithmetic.hpp"

namespace subcert_check {

/// A complex number times W.
struct CirclePoint {
  mpz_class re, im;
};

/// Points of the unit circle times W = 2^bits.
class Circle {
 public:
  explicit Circle(std::size_t bits);

  const mpz_class& one() const { return one_; }
  /// pi x W/2, rounded down but for 3.
  mpz_class half_angle(const mpq_class& x) const;
  /// Near exp(i pi k y), k = 0, ..., count - 1: not further away than 2^19 k. Domain: 0 <= y < 2, bits >= 64.
  std::vector<CirclePoint> powers(const mpq_class& y, std::size_t count, Arithmetic& arithmetic) const;

 private:
  CirclePoint at(const mpq_class& y) const;

  mpz_class one_, pi_;
};

/// The sum of the points times the factors, as many of both.
CirclePoint combined(std::span<const mpz_class> factors, const std::vector<CirclePoint>& points,
                     Arithmetic& arithmetic);

}  // namespace subcert_check
