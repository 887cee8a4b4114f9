#pragma once
/// Maps between families of matrices that permute their letters: the symmetries of a family, and whether two families
/// are the same but for coordinates and the order of the letters. Inner header.

#include "block_triangular.hpp"

namespace subcert::radius {

/// The blocks in coordinates in which the symmetries found have integer entries, and their groups. Nothing is changed
/// in a block of which no symmetry is found. What is found is verified in exact arithmetic; more may exist. Domain:
/// blocks irreducible over the rationals or not. Cost: for each block a basis of words modulo a prime for each
/// permutation of the letters that keeps the traces of products of two. Ref: [HR94], the test for isomorphism.
BlockTriangular with_symmetries(BlockTriangular triangular, const Deadline& deadline);

/// Whether J A_t J^-1 = B_letters[t] for some J and some permutation: the families then have equal radii, of products
/// and of all. False where none is found.
bool are_similar(const MatrixFamily& first, const MatrixFamily& second, const Deadline& deadline);

}  // namespace subcert::radius
