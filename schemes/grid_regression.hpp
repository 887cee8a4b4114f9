#pragma once
/// Local polynomial regression on grids of two and three variables.

#include <subcert/analysis/symbol/masks/mask.hpp>

#include <vector>

namespace subcert {

/// The weights c with p(x) = sum of c[i] y[i], where p has total degree at most `degree` and minimises the sum of
/// (p(node i) - y[i])^2 over the product of the node lists; the first variable runs fastest. Where several polynomials
/// are minimal, the one without components that vanish at all nodes is taken, in the orthogonal basis of products.
/// Domain: one to three lists of distinct nodes, one coordinate of x for each, degree >= 0. Errors: throws
/// a domain error. Cost: nodes * degree^(variables - 1) rational operations. Proof: docs/schemes.md.
std::vector<Rational> grid_regression_weights(const std::vector<std::vector<Rational>>& nodes, int degree,
                                              const std::vector<Rational>& x);

/// One fit of total degree `degree` on points[0] x points[1] (x points[2]) data, evaluated at the arity^variables
/// positions that divide the middle cell evenly; along each axis data, positions and numbering are those of ary().
struct GridRegression {
  std::vector<int> points;
  int degree = 1;
  int arity = 2;
};

/// The exact mask. Domain: two or three numbers of points >= 2, degree >= 0, arity >= 2. Errors: throws
/// a domain error. Ref: [MLZD15, App. B], [MB16, sec. 3].
LatticeMask grid_regression_mask(const GridRegression& scheme);

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
