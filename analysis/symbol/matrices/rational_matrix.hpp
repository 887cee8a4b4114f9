#pragma once
/// Dense matrices over the rationals and the exact algebra that the analysis asks of them.

#include <subcert/analysis/symbol/numbers/rational_complex.hpp>
#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstddef>
#include <functional>
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

/// Domain: a.columns() == b.rows(). Errors: throws Error.
RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b);
RationalMatrix operator*(const Rational& factor, RationalMatrix matrix);
/// Domain: matrix.columns() == vector.size(). Errors: throws Error.
std::vector<Rational> operator*(const RationalMatrix& matrix, const std::vector<Rational>& vector);
ComplexVector operator*(const RationalMatrix& matrix, const ComplexVector& vector);

/// The matrix with these columns. Domain: each with `rows` entries.
RationalMatrix from_columns(const std::vector<std::vector<Rational>>& columns, std::size_t rows);

RationalMatrix transposed(const RationalMatrix& matrix);

/// Domain: square, exponent >= 0. Cost: a logarithmic number of products.
RationalMatrix power(const RationalMatrix& matrix, long exponent);

/// The minors of order 2, rows and columns in lexicographic order: its eigenvalues are the products of two eigenvalues.
/// Domain: square.
RationalMatrix second_compound(const RationalMatrix& matrix);

/// The largest sum of absolute values in a column.
Rational one_norm(const RationalMatrix& matrix);

/// The size of the largest entry as a power of 2; nothing for the zero matrix.
std::optional<long> binary_exponent(const RationalMatrix& matrix);

/// p(matrix); nothing once the deadline passes. Domain: square; lowest exponent 0 or more. Cost: a product per degree.
RationalMatrix value_at(const LaurentPolynomial& p, const RationalMatrix& matrix);
std::optional<RationalMatrix> value_at(const LaurentPolynomial& p, const RationalMatrix& matrix,
                                       const Deadline& deadline);

/// The size of the largest Jordan block whose eigenvalue is a zero of p, and 0 where none is. Domain: square; p
/// irreducible over the rationals. Cost: as many kernels of products.
int largest_jordan_block(const RationalMatrix& matrix, const LaurentPolynomial& p);

/// Domain: square. Cost: modular.
Rational determinant(const RationalMatrix& matrix);

/// det(matrix_at(w)) as a polynomial in w; nothing past the deadline. Domain: square matrices, of which the determinant
/// is a polynomial in w of at most this degree. Cost: degree + 1 determinants and an interpolation.
std::optional<LaurentPolynomial> determinant(const std::function<RationalMatrix(const Rational&)>& matrix_at,
                                             long degree, const Deadline& deadline);

/// det(x - matrix), with lowest exponent 0 or more; nothing once the deadline passes. Domain: square. Cost: modular,
/// cubic per prime, as many primes as the entries ask for.
LaurentPolynomial characteristic_polynomial(const RationalMatrix& matrix);
std::optional<LaurentPolynomial> characteristic_polynomial(const RationalMatrix& matrix, const Deadline& deadline);

/// A basis of { x : matrix x = 0 }, one vector per free column: it is 1 there, 0 behind, and all others are 0 there.
/// Cost: one fraction-free elimination.
std::vector<std::vector<Rational>> kernel(const RationalMatrix& matrix);
/// The free columns of such a basis, vector by vector.
std::vector<std::size_t> free_columns(const std::vector<std::vector<Rational>>& kernel);

/// The columns that are not combinations of columns before them. Cost: one elimination.
std::vector<std::size_t> pivot_columns(const RationalMatrix& matrix);

/// The least positive integer that makes every entry an integer by multiplication.
Integer common_denominator(const RationalMatrix& matrix);
/// factor * matrix, row by row. Domain: a multiple of the common denominator.
std::vector<Integer> integer_multiple(const RationalMatrix& matrix, const Integer& factor);

/// X with a X = b. Domain: a square and non-singular, a.rows() == b.rows(). Errors: throws Error. Cost: p-adic
/// lifting or one elimination.
RationalMatrix solve(const RationalMatrix& a, const RationalMatrix& b);

/// Short vectors that span the same lattice. Domain: independent rows of one length >= 1. Cost: one reduction. Ref:
/// [LLL82].
std::vector<std::vector<Integer>> reduced_lattice(const std::vector<std::vector<Integer>>& rows);

/// A basis of the lattice that integer rows span. Domain: at least one row, all of one length. Cost: one Hermite normal
/// form.
std::vector<std::vector<Integer>> lattice_basis(const std::vector<std::vector<Integer>>& rows);

}  // namespace subcert
