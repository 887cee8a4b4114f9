#include "coordinates.hpp"

namespace subcert::polytope {

namespace {

constexpr double flattest = 1e-12;  // directions in which orbits are flatter than that are stretched no further

}  // namespace

Coordinates working_coordinates(const SearchFamily& family, PolytopeKind kind, const Deadline& deadline) {
  const std::size_t d = family.matrices.front().rows();
  const SymmetryGroup& symmetry = family.symmetry;
  if (kind == PolytopeKind::nonnegative) return {{Matrix::identity(d), Matrix::identity(d)}, symmetry.action(d), {d}};
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
