#pragma once
/// What certificates say of the cycles of a polytope. Inner header.

#include "leading_factor.hpp"

#include <subcert/analysis/radii/polytope_proof/polytope_proof.hpp>

#include <map>

namespace subcert::radius {

/// Of the products of whole cycles, by the vertices that they start from.
using CycleFactors = std::map<std::size_t, LeadingFactor>;

/// Sets polytope.attained, or else polytope.not_attained: where the polytope has no cycle, leading eigenvalues of
/// cycles differ by more than their signs, or time is up. What it says of images is for the checker to accept or not.
/// Domain: `polytope` was made from `candidate` and this family; `known`: what need not be computed again. Cost: a
/// characteristic polynomial with its factorisation for each cycle that a symmetry makes shorter or that is not known.
/// Source: SPEC.md, section 4.10.
void find_cycles(const MatrixFamily& family, const PolytopeCandidate& candidate, PolytopeProof& polytope,
                 const CycleFactors& known, const Deadline& deadline);

}  // namespace subcert::radius
