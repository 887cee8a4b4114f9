#pragma once
/// Families of numbers that doubles do not hold are brought near 1 by powers of two, exactly. Inner header.

#include "block_triangular.hpp"

namespace subcert::radius {

/// The e such that 2^-e times the family has its largest entry near 1; 0 where it is near enough already.
long scaling_exponent(const MatrixFamily& family);

/// What to divide by before all else: a power of two that brings the largest entry near 1, times the largest number of
/// which all entries are integer multiples where that makes numbers shorter; 1 where they are short and near enough.
Rational unit_of(const MatrixFamily& family);

/// The basis and the triangular form after a change of the lengths of the basis vectors by powers of two, block by
/// block, where the entries of a block differ too much in size. Cost: a few passes over each such block.
BlockTriangular balanced(BlockTriangular triangular);

}  // namespace subcert::radius
