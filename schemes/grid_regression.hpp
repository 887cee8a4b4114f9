#pragma once
/// Local polynomial regression on grids of two and three variables.

#include <subcert/analysis/symbol/mask.hpp>

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

}  // namespace subcert
