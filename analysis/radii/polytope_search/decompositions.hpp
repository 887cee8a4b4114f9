#pragma once
/// Eigen's decompositions, compiled once: each source that used them directly would compile them again.

#include "dense.hpp"

#include <memory>
#include <optional>

namespace subcert::polytope {

/// matrix = vectors * diag(values) * vectors^T, the values increasing. Domain: symmetric.
struct SymmetricDecomposition {
  Vector values;
  Matrix vectors;
};
SymmetricDecomposition symmetric_decomposition(const Matrix& matrix);
/// vectors diag(values) vectors^T: a function of a symmetric matrix from those of its eigenvalues.
Matrix composed(const Matrix& vectors, const Vector& values);
/// Increasing. Domain: symmetric.
Vector symmetric_eigenvalues(const Matrix& matrix);

/// Nothing where the matrix is not positive definite, or hardly. Domain: symmetric, of entries about 1.
struct PositiveInverse {
  Matrix inverse;
  double log_determinant = 0;  ///< of the matrix
};
std::optional<PositiveInverse> positive_inverse(const Matrix& matrix);

/// matrix * vectors[k] = values[k] * vectors[k], in no particular order; the vectors have norm 1.
struct EigenDecomposition {
  ComplexVector values;
  std::vector<ComplexVector> vectors;
};
EigenDecomposition eigen_decomposition(const Matrix& matrix);

ComplexVector eigenvalues(const Matrix& matrix);
/// The largest modulus of an eigenvalue.
double spectral_radius(const Matrix& matrix);
/// The largest singular value.
double spectral_norm(const Matrix& matrix);

/// The inverse of the leading size x size block of a column major array whose columns stand `stride` apart, into an
/// array of the same layout, by partial pivoting. False where an entry is not finite or at least 1e13.
bool invert(const double* matrix, std::size_t size, std::size_t stride, double* inverse);

/// Least squares solutions by a QR decomposition with column pivoting. Scalar: double or std::complex<double>.
template <class Scalar>
class PivotedQr {
 public:
  /// The entries of a matrix column after column. Domain: rows * columns entries.
  PivotedQr(const std::vector<Scalar>& entries, std::size_t rows, std::size_t columns);
  PivotedQr(PivotedQr&&) noexcept;
  ~PivotedQr();

  std::size_t rank() const;
  /// The columns in the order of the pivots: the first rank() of them are a basis.
  std::vector<std::size_t> pivots() const;
  /// Of smallest residual; zero in the columns behind the rank.
  std::vector<Scalar> solve(const std::vector<Scalar>& right) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace subcert::polytope
