// What affine data say of limits on a unit square, and of their derivatives, for masks of any sign: Lemma 65 and
// Theorem 66 in ../../certificates/SPEC.md.
#pragma once

#include "hull.hpp"
#include "turning.hpp"

#include <array>
#include <vector>

namespace subcert_check {

/// Of data f at the window and r, what is left of them without the affine function through those at 0, (1,0), (0,1):
/// the derivatives along the axes differ from its slopes by at most slopes * max |r_l| / W_l, the limits from its value
/// at x + shift by at most value * that.
struct FitBounds {
  std::vector<Point> window;             // in order, with 0, (1,0), (0,1)
  Vector weights;                        // W
  std::array<std::size_t, 3> corners{};  // the places of these three
  std::vector<std::size_t> free;         // and of the others
  mpq_class value, slopes[2], shift[2];
};

/// By words w of digits, as long as it takes for g_w <= rate. Rejects a mask without sum rules of order 2.
FitBounds fit_bounds(const LatticeMask& mask, const mpq_class& rate, Arithmetic& arithmetic);

/// What real data at the window, in their order, say of limits on the square.
class AffineFit {
 public:
  AffineFit(const FitBounds& bounds, const std::vector<Interval>& data, const Intervals& intervals);

  /// Of the derivative along an axis.
  Interval slope(std::size_t axis) const;
  /// The limits are at least that.
  mpz_class least() const;

 private:
  const FitBounds& bounds_;
  const Intervals& intervals_;
  Interval at_zero_, steps_[2];
  Interval rest_;  // the largest |r_l| / W_l
};

}  // namespace subcert_check
