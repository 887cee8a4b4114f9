#include "dense.hpp"

#include "kernels.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace subcert::polytope {

namespace {

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }
Eigen::Map<const Eigen::MatrixXd> view(const Matrix& a) {
  return {a.entries().data(), index(a.rows()), index(a.columns())};
}
Eigen::Map<const Eigen::VectorXcd> view(const ComplexVector& x) { return {x.data(), index(x.size())}; }
Eigen::Map<Eigen::VectorXcd> view(ComplexVector& x) { return {x.data(), index(x.size())}; }

}  // namespace

Matrix Matrix::identity(std::size_t size) {
  Matrix result(size, size);
  for (std::size_t k = 0; k < size; ++k) result(k, k) = 1;
  return result;
}

Matrix& Matrix::operator+=(const Matrix& other) {
  for (std::size_t k = 0; k < entries_.size(); ++k) entries_[k] += other.entries_[k];
  return *this;
}

Matrix& Matrix::operator/=(double divisor) {
  for (double& entry : entries_) entry /= divisor;
  return *this;
}

bool Matrix::is_zero() const {
  return std::all_of(entries_.begin(), entries_.end(), [](double entry) { return entry == 0; });
}

double Matrix::largest_modulus() const {
  double largest = 0;
  for (const double entry : entries_) largest = std::max(largest, std::abs(entry));
  return largest;
}

Matrix Matrix::transposed() const {
  Matrix result(columns_, rows_);
  for (std::size_t j = 0; j < columns_; ++j)
    for (std::size_t i = 0; i < rows_; ++i) result(j, i) = (*this)(i, j);
  return result;
}

Matrix Matrix::diagonal_block(std::size_t begin, std::size_t size) const {
  Matrix result(size, size);
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t i = 0; i < size; ++i) result(i, j) = (*this)(begin + i, begin + j);
  return result;
}

bool is_finite(const Matrix& a) {
  return std::ranges::all_of(a.entries(), [](double entry) { return std::isfinite(entry); });
}

// New vectors and matrices are zero: what Eigen would set to zero once more, it adds to.
Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix result(a.rows(), b.columns());
  Eigen::Map<Eigen::MatrixXd>(&result(0, 0), index(a.rows()), index(b.columns())).noalias() += view(a) * view(b);
  return result;
}

Matrix fast_product(const Matrix& a, const Matrix& b) {
  Matrix result(a.rows(), b.columns());
  kernels::add_product(a.column(0), a.rows(), a.columns(), b.column(0), b.columns(), &result(0, 0));
  return result;
}

Vector operator*(const Matrix& a, const Vector& x) {
  Vector result(a.rows());
  add_product(a, x.data(), result.data());
  return result;
}

ComplexVector operator*(const Matrix& a, const ComplexVector& x) {
  ComplexVector result(a.rows());
  view(result).noalias() += view(a) * view(x);
  return result;
}

void add_product(const Matrix& a, const double* x, double* out) {
  Eigen::Map<Eigen::VectorXd>(out, index(a.rows())).noalias() += view(a) * Eigen::Map<const Eigen::VectorXd>(
                                                                               x, index(a.columns()));
}

ComplexVector multiply_transposed(const Matrix& a, const ComplexVector& x) {
  ComplexVector result(a.columns());
  view(result).noalias() += view(a).transpose() * view(x);
  return result;
}

double norm(std::span<const double> entries) {
  return Eigen::Map<const Eigen::VectorXd>(entries.data(), index(entries.size())).norm();
}

double squared_norm(const ComplexVector& x) { return view(x).squaredNorm(); }

// Two running sums, of the even and of the odd places.
double inner(const Vector& x, const Vector& y) {
  double even = 0, odd = 0;
  std::size_t k = 0;
  for (; k + 1 < x.size(); k += 2) {
    even += x[k] * y[k];
    odd += x[k + 1] * y[k + 1];
  }
  even += odd;
  return k < x.size() ? even + x[k] * y[k] : even;
}

std::complex<double> inner(const ComplexVector& x, const ComplexVector& y) { return view(x).dot(view(y)); }

ComplexVector conjugate(ComplexVector x) {
  for (auto& entry : x) entry = std::conj(entry);
  return x;
}

void scale(ComplexVector& x, double factor) {
  for (auto& entry : x) entry *= factor;
}

void divide(ComplexVector& x, double divisor) {
  for (auto& entry : x) entry /= divisor;
}

void divide(ComplexVector& x, std::complex<double> divisor) { view(x) /= divisor; }

void normalise(ComplexVector& x) { view(x).normalize(); }

}  // namespace subcert::polytope
