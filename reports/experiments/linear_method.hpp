#pragma once
/// Linear reconstructions as matrices, and local linear regression with automatic bandwidth.

#include <subcert/schemes/data/extension.hpp>

#include <string>
#include <vector>

namespace subcert {

/// out = matrix * data, row by row.
class DenseMatrix {
 public:
  DenseMatrix(std::size_t rows, std::size_t columns) : columns_(columns), entries_(rows * columns) {}
  std::size_t rows() const { return entries_.size() / columns_; }
  std::size_t columns() const { return columns_; }
  double& at(std::size_t row, std::size_t column) { return entries_[row * columns_ + column]; }
  double at(std::size_t row, std::size_t column) const { return entries_[row * columns_ + column]; }
  std::vector<double> operator*(const std::vector<double>& data) const;

 private:
  std::size_t columns_;
  std::vector<double> entries_;
};

/// The limit of a linear scheme at the multiples of arity^-level of the spacing; `wrap` data go once around, and so do
/// the outputs. Domain and errors: as LinearSmoother. The entries are rounded.
DenseMatrix limit_matrix(const std::string& specification, std::size_t count, Extension extension, int level);

/// Local linear regression with the normal kernel on the data 0, ..., count - 1. The bandwidth is the one of the grid
/// lowest * ratio^k, in spacings, with the smallest sum of squared residuals when each datum is left out.
/// Ref: [DHHS15, sec. 3.2].
class LocalLinearRegression {
 public:
  static constexpr double lowest = 0.5, ratio = 1.15;

  /// Evaluates at `positions`. The bandwidths go up to a quarter of the data. Domain: count >= 8.
  LocalLinearRegression(std::size_t count, const std::vector<double>& positions);
  std::vector<double> operator()(const std::vector<double>& data) const;
  /// The bandwidth chosen for these data.
  double bandwidth(const std::vector<double>& data) const;

 private:
  std::size_t choice(const std::vector<double>& data) const;
  std::vector<double> bandwidths_;
  std::vector<DenseMatrix> at_data_;
  std::vector<DenseMatrix> at_positions_;
};

}  // namespace subcert
