#pragma once
/// What a joint spectral radius has to stay below for a property. Inner header.

#include "property_range.hpp"

namespace subcert::family {

/// Of the difference scheme of order m: arity^(m - order).
class Threshold {
 public:
  Threshold(const RangeProperty& property, int arity, int rules);

  double value() const;
  /// Bounds with room for the rounding of the checker, exact where the exponent is whole.
  Rational below() const { return *raised(1).lower * (1 - margin()); }
  Rational power_above(long length) const { return *raised(length).upper * (1 + margin()); }
  /// Domain: a multiple of rational_power(1).
  Rational exact_power(long length) const { return *raised(length).upper; }
  /// The power of that power which is rational.
  long rational_power(long length) const { return denominator(exponent_ * Rational(length)).convert_to<long>(); }
  /// Radii are at least 1: below that nothing can be proved.
  bool is_reachable() const { return exponent_ > 0; }

 private:
  Rational margin() const { return denominator(exponent_) == 1 ? Rational(0) : power(Rational(2), -90); }
  Enclosure raised(long length) const;

  int arity_;
  Rational exponent_;
};

}  // namespace subcert::family
