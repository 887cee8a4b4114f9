#include "decompositions.hpp"

#include "kernels.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace subcert::polytope {

namespace {

constexpr double least_pivot = 1e-18;

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }
Eigen::MatrixXd copy(const Matrix& a) {
  return Eigen::Map<const Eigen::MatrixXd>(a.entries().data(), index(a.rows()), index(a.columns()));
}

}  // namespace

SymmetricDecomposition symmetric_decomposition(const Matrix& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(copy(matrix));
  const auto& values = solver.eigenvalues();
  SymmetricDecomposition result{Vector(values.begin(), values.end()), Matrix(matrix.rows(), matrix.rows())};
  for (std::size_t j = 0; j < matrix.rows(); ++j)
    for (std::size_t i = 0; i < matrix.rows(); ++i) result.vectors(i, j) = solver.eigenvectors()(index(i), index(j));
  return result;
}

Matrix composed(const Matrix& vectors, const Vector& values) {
  Matrix weighted = vectors;
  for (std::size_t j = 0; j < weighted.columns(); ++j)
    for (std::size_t i = 0; i < weighted.rows(); ++i) weighted(i, j) *= values[j];
  return weighted * vectors.transposed();
}

Vector symmetric_eigenvalues(const Matrix& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(copy(matrix), Eigen::EigenvaluesOnly);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

std::optional<PositiveInverse> positive_inverse(const Matrix& matrix) {
  // Sweeps [Goo79]: after each pivot one more row of what is left is solved for, with the sign changed.
  const std::size_t n = matrix.rows();
  PositiveInverse result{matrix};
  Matrix& swept = result.inverse;
  Vector column(n), multiple(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double pivot = swept(k, k);
    if (!(pivot > least_pivot)) return std::nullopt;
    result.log_determinant += std::log(pivot);
    for (std::size_t i = 0; i < n; ++i) multiple[i] = (column[i] = swept(i, k)) / pivot;
    kernels::rank_one(&swept(0, 0), n, n, column.data(), multiple.data());
    for (std::size_t i = 0; i < n; ++i) swept(i, k) = swept(k, i) = multiple[i];
    swept(k, k) = -1 / pivot;
  }
  swept /= -1;
  return result;
}

EigenDecomposition eigen_decomposition(const Matrix& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(copy(matrix));
  const Eigen::MatrixXcd vectors = solver.eigenvectors();
  EigenDecomposition result;
  result.values.assign(solver.eigenvalues().begin(), solver.eigenvalues().end());
  for (Eigen::Index k = 0; k < vectors.cols(); ++k)
    result.vectors.emplace_back(vectors.col(k).begin(), vectors.col(k).end());
  return result;
}

ComplexVector eigenvalues(const Matrix& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(copy(matrix), false);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

double spectral_norm(const Matrix& matrix) {
  return std::sqrt(symmetric_eigenvalues(matrix.transposed() * matrix).back());
}

double spectral_radius(const Matrix& matrix) {
  double largest = 0;
  if (matrix.is_zero()) return largest;
  for (const auto& value : eigenvalues(matrix)) largest = std::max(largest, std::abs(value));
  return largest;
}

bool invert(const double* matrix, std::size_t size, std::size_t stride, double* inverse) {
  const Eigen::OuterStride<> columns(index(stride));
  const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> given(matrix, index(size), index(size), columns);
  const Eigen::MatrixXd result = Eigen::PartialPivLU<Eigen::MatrixXd>(given).inverse();
  Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>(inverse, index(size), index(size), columns) = result;
  return result.allFinite() && result.cwiseAbs().maxCoeff() < 1e13;
}

template <class Scalar>
struct PivotedQr<Scalar>::Factors {
  using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Eigen::ColPivHouseholderQR<Dense> qr;
};

template <class Scalar>
PivotedQr<Scalar>::PivotedQr(const std::vector<Scalar>& entries, std::size_t rows, std::size_t columns)
    : factors_(new Factors{Eigen::ColPivHouseholderQR<typename Factors::Dense>(
          Eigen::Map<const typename Factors::Dense>(entries.data(), index(rows), index(columns)))}) {}

template <class Scalar>
PivotedQr<Scalar>::PivotedQr(PivotedQr&&) noexcept = default;
template <class Scalar>
PivotedQr<Scalar>::~PivotedQr() = default;

template <class Scalar>
std::size_t PivotedQr<Scalar>::rank() const {
  return static_cast<std::size_t>(factors_->qr.rank());
}

template <class Scalar>
std::vector<std::size_t> PivotedQr<Scalar>::pivots() const {
  const auto& order = factors_->qr.colsPermutation().indices();
  return {order.begin(), order.end()};
}

// Eigen's own solve() reflects blocks of right sides, which takes five seconds to compile for one that is never used.
template <class Scalar>
std::vector<Scalar> PivotedQr<Scalar>::solve(const std::vector<Scalar>& right) const {
  const auto& [qr] = *factors_;
  typename Factors::Dense c = Eigen::Map<const typename Factors::Dense>(right.data(), index(right.size()), 1);
  const Eigen::Index rank = qr.nonzeroPivots();
  Scalar workspace{};
  for (Eigen::Index k = 0; k < rank; ++k) {
    const Eigen::Index below = qr.rows() - k - 1;
    c.bottomRightCorner(below + 1, 1)
        .applyHouseholderOnTheLeft(qr.matrixQR().col(k).tail(below), qr.hCoeffs()[k], &workspace);
  }
  auto head = c.col(0).head(rank);
  qr.matrixQR().topLeftCorner(rank, rank).template triangularView<Eigen::Upper>().solveInPlace(head);
  std::vector<Scalar> solution(static_cast<std::size_t>(qr.cols()), Scalar{});
  const std::vector<std::size_t> order = pivots();
  for (Eigen::Index k = 0; k < rank; ++k) solution[order[static_cast<std::size_t>(k)]] = head[k];
  return solution;
}

template class PivotedQr<double>;
template class PivotedQr<std::complex<double>>;

}  // namespace subcert::polytope
