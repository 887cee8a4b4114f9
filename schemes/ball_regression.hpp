#pragma once
/// Local polynomial regression on the data within a distance of the new point: least squares on triangular grids.

#include <subcert/analysis/symbol/mask.hpp>

#include <vector>

namespace subcert {

/// Where the points of Z^2 lie in the plane: equilateral, |i e + j f|^2 = i^2 + ij + j^2, or rectangular, i^2 + j^2.
enum class Lattice { equilateral, rectangular };

/// Binary schemes on a triangular grid: the new points are the old ones and the midpoints (1/2, 0), (0, 1/2), (1/2,
/// 1/2) of edges. For each a polynomial of total degree `degree` is fitted to the data at a distance less than
/// `radius`, and evaluated there. Ref: [CLY25].
struct BallRegression {
  Rational radius;
  int degree = 1;
  Lattice lattice = Lattice::equilateral;
  int power = 0;                       ///< data at distance r have the weight (1 - (r / radius)^2)^power, or
  std::vector<Rational> weights = {};  ///< those of ball_distances(), where not empty
};

/// The squares of the distances less than the radius between new points and data, in ascending order.
std::vector<Rational> ball_distances(const BallRegression& scheme);

/// The exact mask. Domain: 1/2 < radius <= 10, 0 <= degree <= 6, 0 <= power <= 8; no weights or as many as distances,
/// all positive; data that determine the polynomials. Errors: throws Error. Cost: data * degree^2, and linear systems
/// of the size of the number of monomials.
LatticeMask ball_regression_mask(const BallRegression& scheme);

}  // namespace subcert
