#pragma once
/// Complete trees of products whose norms are small, in floating point. Inner header. Nothing of it is proved.

#include "context_forms.hpp"

namespace subcert::quadratic {

/// A word that leads from one state to another one, which an element of the group moves.
struct TreeWord {
  std::size_t from = 0, to = 0;
  int element = 0;
  std::vector<int> letters;
};

struct ProductTree {
  /// The leaves of each state, least letters first; of a single state one of those that the symmetry exchanges. Every
  /// infinite word begins with exactly one leaf of a state, or image of a leaf.
  std::vector<TreeWord> words;
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
/// forms of a positive bound; a single one is invariant under the symmetry. Cost: a product and the eigenvalues of a
/// symmetric matrix for each node. Ref: [Gri96]; [MR14] for trees.
ProductTree product_tree(const StateForms& forms, const polytope::SymmetryGroup& symmetry, const TreeLimits& limits);

}  // namespace subcert::quadratic
