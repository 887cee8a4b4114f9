#include "symmetry.hpp"

#include <cmath>

namespace subcert::polytope {

Matrix SymmetryGroup::conjugated(int element, const Matrix& matrix) const {
  const GroupAction acting = action(matrix.rows());
  Matrix result = matrix;
  for (int side = 0; side < 2; ++side) {
    for (std::size_t j = 0; j < result.columns(); ++j) acting.apply(element, &result(0, j));
    result = result.transposed();
  }
  return result;
}

Matrix SymmetryGroup::adapted_coordinates(std::size_t dimension) const {
  if (order_ == 1) return Matrix::identity(dimension);
  // Sums of mirrored coordinates, the middle one, then differences.
  const std::size_t odd = dimension / 2, even = dimension - odd;
  Matrix q(dimension, dimension);
  for (std::size_t k = 0; k < odd; ++k) {
    q(k, k) = q(k, dimension - 1 - k) = q(even + k, k) = std::sqrt(0.5);
    q(even + k, dimension - 1 - k) = -std::sqrt(0.5);
  }
  if (even > odd) q(odd, odd) = 1;
  return q;
}

std::vector<std::size_t> SymmetryGroup::blocks(std::size_t dimension) const {
  if (order_ == 1) return {dimension};
  return {dimension - dimension / 2, dimension / 2};
}

}  // namespace subcert::polytope
