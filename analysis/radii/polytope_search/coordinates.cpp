#include "coordinates.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::polytope {

namespace {

constexpr double flattest = 1e-12;  // directions in which orbits are flatter than that are stretched no further
constexpr int longest_word = 40;    // of the products whose sum tells how large coordinates are

/// Of non-negative matrices: coordinates in which the points of orbits have entries of like size. Powers of two, so
/// that nothing is rounded.
CoordinateChange balanced_coordinates(const SearchFamily& family, const GroupAction& action) {
  const std::size_t d = family.matrices.front().rows();
  Vector size(d, 1.0);
  for (int k = 0; k < longest_word; ++k) {
    Vector sum(d, 0.0);
    for (const Matrix& a : family.matrices) add_product(a, size.data(), sum.data());
    const double largest = *std::max_element(sum.begin(), sum.end());
    if (!(largest > 0)) break;
    for (std::size_t i = 0; i < d; ++i) size[i] = std::max(sum[i] / largest, flattest);
  }
  for (int g = 1; g < action.order(); ++g) {
    Vector image = size;
    action.apply(g, image.data());
    for (std::size_t i = 0; i < d; ++i) size[i] = std::max(size[i], image[i]);
  }
  CoordinateChange change{Matrix(d, d), Matrix(d, d)};
  for (std::size_t i = 0; i < d; ++i) {
    change.from(i, i) = std::exp2(std::round(std::log2(size[i])));
    change.to(i, i) = 1 / change.from(i, i);
  }
  return change;
}

}  // namespace

Coordinates working_coordinates(const SearchFamily& family, PolytopeKind kind, const Deadline& deadline) {
  const std::size_t d = family.matrices.front().rows();
  const SymmetryGroup& symmetry = family.symmetry;
  if (kind == PolytopeKind::nonnegative) {
    GroupAction action = symmetry.action(d);
    return {balanced_coordinates(family, action), std::move(action), {d}};
  }
  const CoordinateChange adapted = symmetry.adapted_coordinates(d);
  std::vector<Matrix> matrices;
  for (const Matrix& a : family.matrices) matrices.push_back(adapted.to * a * adapted.from);
  const Matrix shape = symmetry.mean(orbit_shape(matrices, deadline).shape, adapted);
  CoordinateChange change{Matrix(d, d), Matrix(d, d)};
  std::vector<std::size_t> blocks = symmetry.blocks(d);
  std::size_t begin = 0;
  for (const std::size_t size : blocks) {
    if (size == 0) continue;
    const Whitening block = whitening(shape.diagonal_block(begin, size), flattest);
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t i = 0; i < size; ++i) {
        change.to(begin + i, begin + j) = block.to(i, j);
        change.from(begin + i, begin + j) = block.from(i, j);
      }
    }
    begin += size;
  }
  change = {change.to * adapted.to, adapted.from * change.from};
  GroupAction action = symmetry.action_in(change);
  return {std::move(change), std::move(action), std::move(blocks)};
}

}  // namespace subcert::polytope
