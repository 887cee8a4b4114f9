#pragma once
/// Upper bounds by the norms of all products of one length.

#include <subcert/analysis/symbol/matrices/matrix_family.hpp>

namespace subcert {

/// The largest 1-norm of a product of `level` matrices, of which `norm` is a proved upper bound; first columns suffice
/// where the family consists of transition matrices.
struct NormProof {
  int level = 1;
  Rational norm = 0;
  /// norm^(1/level), rounded up.
  Rational bound() const { return *root_enclosure(norm, level).upper; }
};

/// The best of the lengths whose products number at most 512, have few numbers, and fit into the memory. Cost: a
/// product of integer matrices each. It is the same in any time, up to a fifth of a second past the deadline, so that
/// more time gives no larger bound. `count`: of the matrices of which this family holds the different ones, so that the
/// lengths are those that a checker goes through.
NormProof norm_of_products(const MatrixFamily& family, const Budget& budget, std::size_t count = 0);

}  // namespace subcert
