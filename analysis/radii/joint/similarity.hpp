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

/// The e such that 2^-e times the family has its largest entry near 1; 0 where it is near enough already.
long scaling_exponent(const MatrixFamily& family);

/// What to divide by before all else: a power of two that brings the largest entry near 1, times the largest number of
/// which all entries are integer multiples where that makes numbers shorter; 1 where they are short and near enough.
Rational unit_of(const MatrixFamily& family);

/// The same in the basis times a regular matrix that leaves it triangular.
BlockTriangular in_basis(BlockTriangular triangular, const RationalMatrix& change);

/// The basis and the triangular form after a change of the basis of each block whose entries differ too much in size,
/// by powers of two, or are much larger than products let expect, by a reduced basis of a lattice. Cost: a few passes
/// over such blocks; for the latter a shape of orbits in long numbers, and one reduction.
BlockTriangular balanced(BlockTriangular triangular, const Deadline& deadline);

}  // namespace subcert::radius
