#pragma once
/// Common invariant subspaces of finite families of rational matrices.

#include <subcert/analysis/symbol/matrices/matrix_family.hpp>

namespace subcert {

/// A_t basis = basis triangular[t] for all matrices A_t of a family, `basis` non-singular, triangular[t] zero below
/// diagonal blocks of these sizes. The joint spectral radius is the largest of those of the diagonal blocks. Canonical:
/// the sizes are positive and add up.
struct BlockTriangular {
  std::vector<std::size_t> sizes;
  RationalMatrix basis;
  std::vector<RationalMatrix> triangular;
  /// Of each diagonal block over the rationals: yes where proved, otherwise only 'not reduced'.
  std::vector<Decision> irreducible;
  /// Symmetries of each block; empty, or one group for each.
  std::vector<std::vector<FamilySymmetry>> groups = {};

  /// The family of a diagonal block. Domain: index < sizes.size().
  MatrixFamily block(std::size_t index) const;
};

/// Reduces as far as invariant subspaces are found before the deadline. Error: none, the result is verified in exact
/// arithmetic; a family that is reducible only over the real numbers is not split; one block has the identity as basis.
/// Cost: a few characteristic polynomials and eliminations modulo a prime for an irreducible family; where it may be
/// reducible, rational ones. Ref: [HR94]; docs/joint-spectral-radius.md.
BlockTriangular block_triangularise(const MatrixFamily& family, const Deadline& deadline);

}  // namespace subcert
