#pragma once
/// That a named product attains the joint spectral radius. Inner header.

#include "leading_factor.hpp"

#include <subcert/analysis/radii/polytope_proof/polytope_proof.hpp>

#include <map>

namespace subcert::radius {

/// Whether the maximizing products of the candidate attain the joint spectral radius exactly: yes, with the argument of
/// docs/joint-spectral-radius.md ('Exactly'), or unknown with the step that is missing. The true polytope has algebraic
/// vertices near the rational ones of `polytope`; each of its images is a vertex by construction, or by the mirror
/// symmetry of the product, or lies inside with a margin that exact and ball arithmetic confirm.
/// What a certificate says of it is left in `polytope`, also where it is unknown. Domain: `polytope` was made from
/// `candidate` and this family; `lower` <= radius of the first product, proved; all maximizing products have exactly
/// that radius, proved.
Decision product_attains_radius(const MatrixFamily& family, const PolytopeCandidate& candidate, PolytopeProof& polytope,
                                const Rational& lower, const Deadline& deadline);

/// Of the products of whole cycles, by the vertices that they start from.
using CycleFactors = std::map<std::size_t, LeadingFactor>;

/// Sets polytope.attained, or else polytope.not_attained: where the polytope has no cycle, leading eigenvalues of
/// cycles differ by more than their signs, or time is up. What it says of images is for the checker to accept or not.
/// Domain: `polytope` was made from `candidate` and this family; `known`: what need not be computed again; `inside`:
/// for each image whether it is known to lie inside, so that it need not be a vertex that it is near to, or empty.
/// Cost: a characteristic polynomial with its factorisation for each cycle that a symmetry makes shorter or that is not
/// known. Source: SPEC.md, section 4.10.
void find_cycles(const MatrixFamily& family, const PolytopeCandidate& candidate, PolytopeProof& polytope,
                 const CycleFactors& known, const std::vector<bool>& inside, const Deadline& deadline);

/// The same without numbers and seeds, for families of which these are only near. Cost: products along the cycles.
void find_nearby_cycles(const MatrixFamily& family, const PolytopeCandidate& candidate, PolytopeProof& polytope);

}  // namespace subcert::radius
