#pragma once
/// Linear combinations of derivatives of sinc x = sin(x)/x, in which the symbols of the least squares schemes are
/// written, for the sources of this floor. Proofs: docs/theorems/variance-curves.tex, section 7.

#include <subcert/analysis/symbol/balls.hpp>

#include <vector>

namespace subcert::theorems {

/// sinc^(k) at one point v >= 1, k = 0, 1, ..., by v sinc^(k) = sin^(k) - k sinc^(k-1).
class SincTable {
 public:
  SincTable(const Ball& point, int count);
  const Ball& operator[](std::size_t k) const { return values_[k]; }

 private:
  std::vector<Ball> values_;
};

/// f = sum over k of c[k] sinc^(k); each coefficient is a ball, and what is said holds for all numbers in them.
class SincSum {
 public:
  explicit SincSum(std::vector<Ball> coefficients) : c_(std::move(coefficients)) {}

  SincSum derivative() const;

  /// How many derivatives `over` reads from its table.
  int needs() const { return static_cast<int>(c_.size()) + order; }

  /// Contains f(x) for |x - v| <= radius, v the point of the table: Taylor, with |sinc^(k)| <= 1/(k+1).
  Ball over(const SincTable& table, const Ball& radius) const;

  /// A with |f(v)| <= A/v for all v >= from > 0.
  Ball decay(const Ball& from) const;

  /// A bound of |f(z)| for all complex |z| <= radius. Domain: radius <= 8.
  Ball on_disc(const Ball& radius) const;

 private:
  static constexpr int order = 6;  ///< of the Taylor polynomial
  std::vector<Ball> c_;
};

}  // namespace subcert::theorems
