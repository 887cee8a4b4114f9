#pragma once
/// That one product attains the joint spectral radius of every family near one. Inner header.

#include <subcert/analysis/radii/polytope_proof/polytope_proof.hpp>

namespace subcert::radius {

/// Whether the product of the polytope's first cycle attains the radius of all families whose matrices differ from
/// these by at most `error` in the 1-norm: yes, or unknown with the step that is missing. The polytope of each of them
/// has true vertices near those of `polytope`; each image is a vertex by construction or lies inside with a margin.
/// What a certificate says of it is left in polytope.attained, where it is yes. Domain: `polytope` was made from
/// `candidate` and this family, with residuals and a bound that hold for all families near by; error > 0; where
/// the family is its own mirror image, all others are. `is_transition`: all are the
/// transition matrices of masks of one variable. `bits`: of the radius. Cost: an inverse of the size of a matrix.
/// Source: SPEC.md, 7.1.
Decision product_attains_nearby(const MatrixFamily& family, const Rational& error, const PolytopeCandidate& candidate,
                                PolytopeProof& polytope, bool is_transition, int bits);

}  // namespace subcert::radius
