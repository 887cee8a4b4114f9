#pragma once
/// Stability of the integer shifts of the basic limit function.

#include <subcert/analysis/symbol/mask.hpp>

#include <vector>

namespace subcert {

/// Whether the integer shifts of the basic limit function are a Riesz basis of their span (stable). Domain: the scheme
/// converges. Decided exactly for every arity: no zero z on the unit circle that all arity-th roots of unity turn into
/// zeros, and no cyclic zeros. Only with stability is the exponent that the joint spectral radius gives the true one.
/// Proof: proofs-checks/certificates/SPEC.md, theorem 4. Ref: [JW93].
Decision has_stable_shifts(const Mask& mask);

/// Whether that is so for all masks whose coefficients differ from these by at most `distance`, on the same support:
/// yes or unknown. Domain: distance > 0. Cost: a determinant. Ref: SPEC.md, section 7.
Decision has_stable_shifts(const Mask& mask, const Rational& distance);

/// The same with an error for each coefficient, from the first to the last. Domain: errors >= 0, as many as
/// coefficients.
Decision has_stable_shifts(const Mask& mask, const std::vector<Rational>& errors);

}  // namespace subcert
