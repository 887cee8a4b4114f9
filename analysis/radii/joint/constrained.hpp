#pragma once
/// Products of which a graph says what may follow what.

#include <subcert/analysis/symbol/matrices/matrix_family.hpp>

namespace subcert {

/// From one node to another, by the matrix of this number.
struct Succession {
  std::size_t from, to, matrix;
};

/// Matrices that act on one copy of the space for each node, so that all their products are those along paths.
struct LiftedFamily {
  MatrixFamily family;
  std::vector<int> letters;  ///< of each of its matrices, the number of that which it applies
};

/// The growth rate of the products A_{w_k} ... A_{w_1} along the paths of a graph (the constrained joint spectral
/// radius) is the joint spectral radius of the lifted family. Each of its matrices is a sum of E_{to,from} (x) A_matrix
/// over successions with one matrix that leave different nodes: a column of blocks of a product has at most one that is
/// not zero, and that is a product along a path. Domain: at least one succession, nodes numbered from 0, matrices of
/// the family. Errors: throws Error. Ref: [PEDJ16].
LiftedFamily lifted(const MatrixFamily& family, const std::vector<Succession>& graph);

}  // namespace subcert
