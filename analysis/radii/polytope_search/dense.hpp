#pragma once
/// Dense vectors and matrices of doubles as the search and its callers pass them around. Eigen computes behind them, in
/// dense.cpp and decompositions.cpp only, as every source that names it pays seconds of compilation.

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace subcert::polytope {

using Vector = std::vector<double>;
using ComplexVector = std::vector<std::complex<double>>;

/// A matrix, column after column.
class Matrix {
 public:
  Matrix() = default;
  /// All zero.
  Matrix(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns), entries_(rows * columns, 0.0) {}
  /// Domain: rows * columns entries.
  Matrix(std::size_t rows, std::size_t columns, std::vector<double> entries)
      : rows_(rows), columns_(columns), entries_(std::move(entries)) {}
  static Matrix identity(std::size_t size);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  double operator()(std::size_t i, std::size_t j) const { return entries_[j * rows_ + i]; }
  double& operator()(std::size_t i, std::size_t j) { return entries_[j * rows_ + i]; }
  const double* column(std::size_t j) const { return entries_.data() + j * rows_; }
  const std::vector<double>& entries() const { return entries_; }

  Matrix& operator+=(const Matrix& other);
  Matrix& operator/=(double divisor);
  bool is_zero() const;
  /// The largest modulus of an entry; 0 for an empty matrix.
  double largest_modulus() const;
  Matrix transposed() const;
  /// The square block on the diagonal that begins at row `begin`.
  Matrix diagonal_block(std::size_t begin, std::size_t size) const;

 private:
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<double> entries_;
};

/// Domain of what follows: sizes that fit. Error: rounding of double precision.
Matrix operator*(const Matrix& a, const Matrix& b);
/// Whether no entry is infinite or no number.
bool is_finite(const Matrix& a);
/// The same with the widest instructions of the processor: the last bits depend on it.
Matrix fast_product(const Matrix& a, const Matrix& b);
Vector operator*(const Matrix& a, const Vector& x);
ComplexVector operator*(const Matrix& a, const ComplexVector& x);
/// out += a x; `out` holds a.rows() numbers.
void add_product(const Matrix& a, const double* x, double* out);
/// a^T x
ComplexVector multiply_transposed(const Matrix& a, const ComplexVector& x);

/// Frobenius or Euclidean.
double norm(std::span<const double> entries);
double squared_norm(const ComplexVector& x);
double inner(const Vector& x, const Vector& y);
/// conj(x) . y
std::complex<double> inner(const ComplexVector& x, const ComplexVector& y);
ComplexVector conjugate(ComplexVector x);
void scale(ComplexVector& x, double factor);
void divide(ComplexVector& x, double divisor);
void divide(ComplexVector& x, std::complex<double> divisor);
void normalise(ComplexVector& x);

}  // namespace subcert::polytope
