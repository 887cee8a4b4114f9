#pragma once
/// Finite families of rational matrices and the symmetries that permute them.

#include "rational_matrix.hpp"

#include <initializer_list>
#include <optional>
#include <utility>

namespace subcert {

/// A linear map with integer entries, few to a row.
class SparseMap {
 public:
  /// Domain: square, integer entries that fit in a long. Errors: throws Error.
  explicit SparseMap(const RationalMatrix& matrix);
  static SparseMap identity(std::size_t size);
  static SparseMap reversal(std::size_t size);

  std::size_t size() const { return rows_.size(); }
  template <class Number>
  std::vector<Number> operator()(const std::vector<Number>& x) const {
    std::vector<Number> result(rows_.size(), Number(0));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (const auto& [j, entry] : rows_[i]) result[i] += x[j] * Number(entry);
    return result;
  }
  RationalMatrix matrix() const;
  /// Domain: integer entries in the inverse. Errors: throws Error.
  SparseMap inverse() const;
  SparseMap transposed() const;
  bool operator==(const SparseMap& other) const { return rows_ == other.rows_; }

 private:
  explicit SparseMap(std::size_t size) : rows_(size) {}
  std::vector<std::vector<std::pair<std::size_t, long>>> rows_;  // column and entry
};

/// An invertible map J of the coordinates that permutes the matrices: J A_t J^-1 = A_letters[t] for all t. Of equal
/// matrices any may be named.
struct FamilySymmetry {
  SparseMap map;
  std::vector<std::size_t> letters;
};

/// One or more square matrices of one size >= 1. Nothing says where they come from.
class MatrixFamily {
 public:
  /// Looks for the flip, the reversal of the coordinates and of the order of the matrices. Errors: throws Error unless
  /// the matrices are square and of one size.
  MatrixFamily(std::vector<RationalMatrix> matrices);
  MatrixFamily(std::initializer_list<RationalMatrix> matrices) : MatrixFamily(std::vector(matrices)) {}
  /// Domain: `group` holds symmetries of the family, the identity first, and with two of them their product or its
  /// negative.
  MatrixFamily(std::vector<RationalMatrix> matrices, std::vector<FamilySymmetry> group);

  std::size_t count() const { return matrices_.size(); }
  std::size_t size() const { return matrices_.front().rows(); }
  const RationalMatrix& operator[](std::size_t t) const { return matrices_[t]; }
  const std::vector<RationalMatrix>& matrices() const { return matrices_; }
  auto begin() const { return matrices_.begin(); }
  auto end() const { return matrices_.end(); }

  /// The symmetries that are known: a finite group up to signs, the identity first.
  const std::vector<FamilySymmetry>& group() const { return group_; }
  /// Whether it consists of the identity and the flip.
  bool is_flip_symmetric() const;

  /// A_{word[0]} A_{word[1]} ... Domain: at least one letter, all below count(). Cost: its halves first, so that long
  /// numbers meet long ones.
  RationalMatrix product(const std::vector<int>& word) const;
  /// The same, or nothing past the deadline, which is looked at before each multiplication of two matrices.
  std::optional<RationalMatrix> product(const std::vector<int>& word, const Deadline& deadline) const;

 private:
  std::vector<RationalMatrix> matrices_;
  std::vector<FamilySymmetry> group_;
};

/// The least positive integer that makes every entry of every matrix an integer by multiplication.
Integer common_denominator(const MatrixFamily& family);

/// No entry is negative.
bool is_nonnegative(const MatrixFamily& family);

/// The transposed matrices, with the maps J^-T; factor times the matrices.
MatrixFamily transposed(const MatrixFamily& family);
MatrixFamily operator*(const Rational& factor, const MatrixFamily& family);

}  // namespace subcert
