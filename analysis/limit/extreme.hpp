#pragma once
/// The largest value over cells that are looked at one by one.

#include <subcert/analysis/symbol/numbers.hpp>

#include <algorithm>

namespace subcert {

/// A lower bound that some point attains, and an upper bound over the cells that were put aside.
/// Canonical: neither is below the start.
class Extreme {
 public:
  explicit Extreme(double start) : attained_(start), aside_(start) {}

  double attained() const { return attained_; }
  /// Some point has at least this value.
  void attain(double value) { attained_ = std::max(attained_, value); }
  /// A cell with values up to `upper` need not be split: it can raise the maximum by at most `margin`.
  bool is_settled(double upper, double margin) const { return upper <= attained_ + margin; }
  void put_aside(double upper) { aside_ = std::max(aside_, upper); }
  /// Encloses the maximum, once all cells are aside.
  Enclosure enclosure() const { return {Rational(attained_), Rational(std::max(attained_, aside_))}; }
  /// Encloses the minimum, where the values given were those of the function with the other sign.
  Enclosure negated() const { return {-Rational(std::max(attained_, aside_)), -Rational(attained_)}; }

 private:
  double attained_;
  double aside_;
};

}  // namespace subcert
