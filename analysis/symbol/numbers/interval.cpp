#include "interval.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {

Enclosure scaled(const Enclosure& enclosure, const Rational& factor) {
  require(factor > 0, "scaled: need factor > 0, got {}", factor);
  Enclosure result;
  if (enclosure.lower) result.lower = *enclosure.lower * factor;
  if (enclosure.upper) result.upper = *enclosure.upper * factor;
  return result;
}

Interval Interval::of(const Enclosure& enclosure) {
  require(enclosure.is_bounded(), "interval: need two ends, got {} ... {}", enclosure.lower_text(6),
          enclosure.upper_text(6));
  return {*enclosure.lower, *enclosure.upper};
}

Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }
Interval operator+(const Interval& a, const Interval& b) { return {a.lower + b.lower, a.upper + b.upper}; }
Interval operator-(const Interval& a, const Interval& b) { return {a.lower - b.upper, a.upper - b.lower}; }

Interval operator*(const Interval& a, const Interval& b) {
  const auto [low, high] = std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
  return {low, high};
}

Interval operator*(const Interval& a, const Rational& b) { return a * Interval::exactly(b); }

Interval operator/(const Interval& a, const Interval& b) {
  require(!b.contains(0), "interval: need a divisor without 0, got {} ... {}", b.lower, b.upper);
  return a * Interval{1 / b.upper, 1 / b.lower};
}

}  // namespace subcert
