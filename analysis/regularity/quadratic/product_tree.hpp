#pragma once
/// Complete trees of products whose norms are small, in floating point. Inner header. Nothing of it is proved.

#include "ellipsoidal_coordinates.hpp"

namespace subcert::quadratic {

struct ProductTree {
  /// The leaves, least letters first; of those that the symmetry exchanges one. Every infinite word begins with exactly
  /// one leaf or image of a leaf.
  std::vector<std::vector<int>> words;
  double bound = 0;  ///< no product of a leaf, A_{w_1} ... A_{w_k}, has a norm above bound^k
};

struct TreeLimits {
  double target = 0;            ///< a bound that is small enough
  double limbs_per_letter = 1;  ///< by which the entries of exact products grow
  double work = 0;              ///< products of limbs that an exact proof of the leaves may take
  std::size_t leaves = 1;       ///< as many as there may be
  Budget budget;
};

/// Splits the leaf of the largest averaged norm until the bound is small enough or a limit is reached. Domain:
/// coordinates of a positive bound. Cost: a product and the eigenvalues of a symmetric matrix for each node. Ref:
/// [Gri96]; [MR14] for trees.
ProductTree product_tree(const EllipsoidalCoordinates& coordinates, const polytope::SymmetryGroup& symmetry,
                         const TreeLimits& limits);

}  // namespace subcert::quadratic
