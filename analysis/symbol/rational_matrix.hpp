#pragma once
/// Dense matrices over the rationals and the exact algebra that the analysis asks of them.

#include "laurent_polynomial.hpp"

#include <cstddef>
#include <vector>

namespace subcert {

/// Row-major, rows() x columns(). Canonical: entries.size() == rows * columns.
class RationalMatrix {
 public:
  /// The zero matrix.
  RationalMatrix(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns), entries_(rows * columns, 0) {}
  static RationalMatrix identity(std::size_t size);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  Rational& operator()(std::size_t row, std::size_t column) { return entries_[row * columns_ + column]; }
  const Rational& operator()(std::size_t row, std::size_t column) const { return entries_[row * columns_ + column]; }
  bool operator==(const RationalMatrix& other) const {
    return rows_ == other.rows_ && columns_ == other.columns_ && entries_ == other.entries_;
  }

 private:
  std::size_t rows_;
  std::size_t columns_;
  std::vector<Rational> entries_;
};

/// Domain: a.columns() == b.rows(). Errors: throws std::invalid_argument.
RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b);
/// Domain: matrix.columns() == vector.size(). Errors: throws std::invalid_argument.
std::vector<Rational> operator*(const RationalMatrix& matrix, const std::vector<Rational>& vector);

RationalMatrix transposed(const RationalMatrix& matrix);

/// det(x - matrix), with lowest exponent 0 or more. Domain: square. Cost: modular, cubic per prime.
LaurentPolynomial characteristic_polynomial(const RationalMatrix& matrix);

/// A basis of { x : matrix x = 0 }, one vector per free column. Cost: one fraction-free elimination.
std::vector<std::vector<Rational>> kernel(const RationalMatrix& matrix);

/// The columns that are not combinations of columns before them. Cost: one elimination.
std::vector<std::size_t> pivot_columns(const RationalMatrix& matrix);

/// X with a X = b. Domain: a square and non-singular, a.rows() == b.rows(). Errors: throws std::invalid_argument for
/// other shapes, std::domain_error for a singular a. Cost: p-adic lifting or one elimination.
RationalMatrix solve(const RationalMatrix& a, const RationalMatrix& b);

/// Encloses the largest modulus of the roots. Domain: p not zero; 0 for a constant or monomial. Error: relative width
/// below 2^-bits, as the roots of the squarefree part are isolated by balls. Whether 1 or -1 is a root is
/// decided exactly.
struct RootModulus {
  Enclosure largest;
  bool has_root_plus_or_minus_one = false;
};
RootModulus largest_root_modulus(const LaurentPolynomial& p, int bits = 64);

}  // namespace subcert
