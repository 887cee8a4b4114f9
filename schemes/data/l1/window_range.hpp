#pragma once
/// Ranges of what one window of reweighted fits gives, over boxes of data. Not for users.

#include "reweighted_contraction.hpp"

#include <memory>

namespace subcert::data {

/// Two numbers that the first window, or the second one, of points + 1 data adds to the two second differences of the
/// four outputs. They are homogeneous of degree 1 in the data and the root of delta.
class WindowRange {
 public:
  using Parts = std::array<Ends, 2>;

  virtual ~WindowRange() = default;
  /// Contain those of all numbers of fits up to `fits`, for all data and delta of the box. Domain: points - 1
  /// differences of moduli up to `largest_datum`, of which one, of the other window, has no part in it; root >= 0.
  virtual Parts parts(const DifferenceBox& box, int fits) = 0;

  static constexpr double largest_datum = 8;
};

/// Domain: 3 <= points <= 8; which = 0 or 1.
std::unique_ptr<WindowRange> window_range(int points, std::size_t which);

}  // namespace subcert::data
