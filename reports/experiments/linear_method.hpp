#pragma once
/// Linear reconstructions as matrices.

#include <subcert/schemes/data/smooth/extension.hpp>

#include <string>
#include <vector>

namespace subcert::experiments {

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
DenseMatrix limit_matrix(const std::string& specification, std::size_t count, data::Boundary extension, int level);

}  // namespace subcert::experiments
