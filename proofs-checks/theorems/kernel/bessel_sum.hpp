#pragma once
/// Linear combinations of spherical Bessel functions j_l, in which the symbols of the least squares schemes are
/// written, for the sources of this floor. Proofs: docs/theorems/variance-curves.tex, section 7.

#include <subcert/analysis/symbol/numbers/balls.hpp>

#include <vector>

namespace subcert::theorems {

/// j_0, j_1, ... at one point v >= 1, by j_{l+1} = (2l+1)/v j_l - j_{l-1}.
class BesselTable {
 public:
  BesselTable(const Ball& point, std::size_t count);
  const Ball& operator[](std::size_t l) const { return values_[l]; }

 private:
  std::vector<Ball> values_;
};

/// f = sum over l of c[l] j_l; each coefficient is a ball, and what is said holds for all numbers in them.
class BesselSum {
 public:
  explicit BesselSum(std::vector<Ball> coefficients);

  BesselSum derivative() const { return BesselSum(derivatives_[1]); }

  /// How many entries `over` reads from its table.
  std::size_t needs() const { return derivatives_.back().size(); }

  /// Contains f(x) for |x - v| <= radius, v the point of the table: Taylor, with |j_l^(k)| <= 1/(k+1).
  Ball over(const BesselTable& table, const Ball& radius) const;

  /// A with |f(v)| <= A/v for all v >= from > 0.
  Ball decay(const Ball& from) const;

  /// A bound of |f(z)| for all complex |z| <= radius. Domain: radius <= 64.
  Ball on_disc(const Ball& radius) const;

 private:
  static constexpr int order = 6;               ///< of the Taylor polynomial
  std::vector<std::vector<Ball>> derivatives_;  ///< coefficients of f, f', ..., f^(order-1)
};

}  // namespace subcert::theorems
