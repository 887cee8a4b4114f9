#include "coordinates.hpp"

namespace subcert::polytope {

namespace {

constexpr double flattest = 1e-12;  // directions in which orbits are flatter than that are stretched no further

}  // namespace

Coordinates working_coordinates(const SearchFamily& family, PolytopeKind kind, const Deadline& deadline) {
  const std::size_t d = family.matrices.front().rows();
  if (kind == PolytopeKind::nonnegative)
    return {Matrix::identity(d), Matrix::identity(d), family.symmetry.action(d), {d}};
  const Matrix q = family.symmetry.adapted_coordinates(d);
  const Matrix shape = q * orbit_shape(family.matrices, deadline).shape * q.transposed();
  Coordinates result{Matrix(d, d), Matrix(d, d), family.symmetry.adapted_action(d), family.symmetry.blocks(d)};
  std::size_t begin = 0;
  for (const std::size_t size : result.blocks) {
    if (size == 0) continue;
    const Whitening block = whitening(shape.diagonal_block(begin, size), flattest);
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t i = 0; i < size; ++i) {
        result.to(begin + i, begin + j) = block.to(i, j);
        result.from(begin + i, begin + j) = block.from(i, j);
      }
    }
    begin += size;
  }
  result.to = result.to * q;
  result.from = q.transposed() * result.from;
  return result;
}

}  // namespace subcert::polytope
