#pragma once
/// Local fits on grids in which data are missing.

#include "local_polynomial.hpp"

#include <array>
#include <functional>

namespace subcert::data {

/// Where data of a grid are missing, the first axis running fastest. Canonical: as many flags as points of the counts.
struct GridHoles {
  std::array<std::size_t, 3> counts{1, 1, 1};
  std::vector<bool> missing = {};  ///< none: no datum

  bool any() const { return !missing.empty(); }
  bool at(std::size_t i, std::size_t j, std::size_t k) const { return missing[(k * counts[1] + j) * counts[0] + i]; }
};

/// The coefficients of one output.
struct GridRow {
  std::size_t output = 0;
  bool known = false;                                      ///< whether the data that are left determine the fit
  std::vector<std::pair<std::size_t, double>> terms = {};  ///< numbers of points, and coefficients
  double outside = 0;                                      ///< of the constant past the ends
  double variance = 0;                                     ///< the sum of the squares of the coefficients of data
};

/// Calls take(row) for each output whose window holds a missing datum, on `threads` threads. The output (o_0, o_1, o_2)
/// is number (o_2 m_1 + o_1) m_0 + o_0, m_k the number of bases along axis k. Its fit is that of least squares, with
/// the products of the weights along the axes, to the data that are there, in the space of the products of the
/// polynomials: with the products u_p of the orthonormal values at the points p of the window and G = 1 - the sum of
/// u_p u_p^T over the missing ones, the coefficient of p is root_p u_p^T G^-1 at. It is determined unless G is
/// singular, which it counts as where a pivot is below 1e-7. Without missing data G = 1, and the coefficients are
/// products. Cost: the data of a window times the number of polynomials, and of missing ones times its square. Proof:
/// docs/smoothing.md, section 13.
void fit_around_holes(const GridHoles& holes, const std::array<std::vector<LocalBasis>, 3>& along, int threads,
                      const std::function<void(const GridRow&)>& take);

/// The basis along an axis of one datum.
LocalBasis trivial_basis();

}  // namespace subcert::data
