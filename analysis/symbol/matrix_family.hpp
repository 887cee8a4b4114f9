#pragma once
/// Finite families of rational matrices and the symmetries that permute them.

#include "rational_matrix.hpp"

#include <initializer_list>

namespace subcert {

/// A permutation P of the coordinates, (P x)_i = x_coordinates[i], that permutes the matrices: P A_t P^-1 is
/// A_letters[t] for all t.
struct FamilySymmetry {
  std::vector<std::size_t> coordinates;
  std::vector<std::size_t> letters;
};

/// One or more square matrices of one size >= 1. Nothing says where they come from.
class MatrixFamily {
 public:
  /// Looks for the flip, the reversal of the coordinates and of the order of the matrices. Errors: throws Error unless
  /// the matrices are square and of one size.
  MatrixFamily(std::vector<RationalMatrix> matrices);
  MatrixFamily(std::initializer_list<RationalMatrix> matrices) : MatrixFamily(std::vector(matrices)) {}

  std::size_t count() const { return matrices_.size(); }
  std::size_t size() const { return matrices_.front().rows(); }
  const RationalMatrix& operator[](std::size_t t) const { return matrices_[t]; }
  const std::vector<RationalMatrix>& matrices() const { return matrices_; }
  auto begin() const { return matrices_.begin(); }
  auto end() const { return matrices_.end(); }

  /// Generators of the group of the symmetries that are known, without the identity.
  const std::vector<FamilySymmetry>& symmetries() const { return symmetries_; }
  /// Whether the flip is one of them.
  bool is_flip_symmetric() const { return !symmetries_.empty(); }

  /// A_{word[0]} A_{word[1]} ... Domain: at least one letter, all below count().
  RationalMatrix product(const std::vector<int>& word) const;

 private:
  std::vector<RationalMatrix> matrices_;
  std::vector<FamilySymmetry> symmetries_;
};

/// The transposed matrices; factor times the matrices.
MatrixFamily transposed(const MatrixFamily& family);
MatrixFamily operator*(const Rational& factor, const MatrixFamily& family);

}  // namespace subcert
