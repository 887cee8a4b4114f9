#pragma once
/// Families of numbers that doubles do not hold are brought near 1 by powers of two, exactly. Inner header.

#include "block_triangular.hpp"

namespace subcert::radius {

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
