#pragma once
/// Numbers with one square root.

#include <subcert/analysis/symbol/numbers/rational.hpp>

#include <string>
#include <string_view>

namespace subcert {

/// rational + multiple * sqrt(root). Canonical: the root is 0, and then the multiple as well, or above 1 without a
/// square factor but 1.
struct QuadraticNumber {
  Rational rational = 0, multiple = 0;
  long root = 0;

  bool is_zero() const { return rational == 0 && multiple == 0; }
  /// Domain: one root, or 0, for both; b is not 0.
  friend QuadraticNumber operator/(const QuadraticNumber& a, const QuadraticNumber& b);
  bool operator==(const QuadraticNumber& other) const = default;

  /// Reads sums, products, quotients and powers of exact numbers and of `sqrt(N)`, N a whole number up to 10^9. A root
  /// of 0 is taken to be whatever stands in the text; otherwise no other one may. Errors: throws ParseError.
  static QuadraticNumber parse(std::string_view text, long root = 0);
  /// What parse reads: `1/2-3/4*sqrt(7)`.
  std::string to_text() const;
};

}  // namespace subcert
