#pragma once
/// Subspaces over the rationals, by short integer vectors. Inner header.

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>

namespace subcert::radius {

using Vector = std::vector<Rational>;

/// The vectors of a subspace, as independent rows.
using Subspace = std::vector<Vector>;

/// The multiple with integer entries that have no factor in common.
std::vector<Integer> primitive(const Vector& vector);

/// The orthogonal complement. Domain: at least one row.
Subspace annihilator(const Subspace& rows);

/// Short vectors that span the same subspace. Domain: at least one row.
Subspace with_short_vectors(const Subspace& rows);

}  // namespace subcert::radius
