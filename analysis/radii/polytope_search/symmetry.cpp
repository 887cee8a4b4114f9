#include "symmetry.hpp"

#include "product_search.hpp"

#include <cmath>

namespace subcert::polytope {

SymmetryGroup SymmetryGroup::transposed() const {
  SymmetryGroup result = *this;
  for (Element& element : result.elements_)
    element = {element.inverse.transposed(), element.map.transposed(), element.letters};
  return result;
}

GroupAction SymmetryGroup::action(std::size_t dimension) const {
  if (order_ == 1) return GroupAction(dimension);
  if (!is_dense()) return GroupAction::reversal(dimension);
  std::vector<Matrix> matrices;
  for (const Element& element : elements_) matrices.push_back(element.map);
  return GroupAction::dense(std::move(matrices));
}

double SymmetryGroup::condition(int element) const {
  if (!is_dense()) return 1;
  return norm(at(element).map.entries()) * norm(at(element).inverse.entries());
}

Matrix SymmetryGroup::conjugated(int element, const Matrix& matrix) const {
  if (is_dense()) return at(element).map * matrix * at(element).inverse;
  const GroupAction acting = action(matrix.rows());
  Matrix result = matrix;
  for (int side = 0; side < 2; ++side) {
    for (std::size_t j = 0; j < result.columns(); ++j) acting.apply(element, &result(0, j));
    result = result.transposed();
  }
  return result;
}

CoordinateChange SymmetryGroup::adapted_coordinates(std::size_t dimension) const {
  if (order_ == 1) return {Matrix::identity(dimension), Matrix::identity(dimension)};
  if (is_dense()) {
    Matrix shape(dimension, dimension);  // in the coordinates in which it is the identity, every element is orthogonal
    for (const Element& element : elements_) shape += element.map * element.map.transposed();
    auto [to, from] = whitening(shape, 0);
    return {std::move(to), std::move(from)};
  }
  // Sums of mirrored coordinates, the middle one, then differences.
  const std::size_t odd = dimension / 2, even = dimension - odd;
  Matrix q(dimension, dimension);
  for (std::size_t k = 0; k < odd; ++k) {
    q(k, k) = q(k, dimension - 1 - k) = q(even + k, k) = std::sqrt(0.5);
    q(even + k, dimension - 1 - k) = -std::sqrt(0.5);
  }
  if (even > odd) q(odd, odd) = 1;
  Matrix back = q.transposed();
  return {std::move(q), std::move(back)};
}

std::vector<std::size_t> SymmetryGroup::blocks(std::size_t dimension) const {
  if (order_ == 1 || is_dense()) return {dimension};
  return {dimension - dimension / 2, dimension / 2};
}

Matrix SymmetryGroup::mean(const Matrix& matrix, const CoordinateChange& adapted) const {
  if (order_ == 1) return matrix;
  if (!is_dense()) {  // the flip exchanges the signs between its blocks
    const std::size_t even = blocks(matrix.rows()).front();
    Matrix result = matrix;
    for (std::size_t j = 0; j < result.columns(); ++j)
      for (std::size_t i = 0; i < result.rows(); ++i)
        if ((i < even) != (j < even)) result(i, j) = 0;
    return result;
  }
  Matrix sum(matrix.rows(), matrix.columns());
  for (const Element& element : elements_) {
    const Matrix g = adapted.to * element.map * adapted.from;
    sum += g * matrix * g.transposed();
  }
  sum /= order_;
  return sum;
}

GroupAction SymmetryGroup::action_in(const CoordinateChange& coordinates) const {
  const std::size_t dimension = coordinates.to.rows();
  if (order_ == 1) return GroupAction(dimension);
  if (!is_dense()) return GroupAction::sign_change(dimension, dimension / 2);
  std::vector<Matrix> matrices;
  for (const Element& element : elements_) matrices.push_back(coordinates.to * element.map * coordinates.from);
  return GroupAction::dense(std::move(matrices));
}

}  // namespace subcert::polytope
