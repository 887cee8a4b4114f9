#pragma once
/// Stability of the integer shifts of the basic limit function.

#include <subcert/analysis/symbol/masks/mask.hpp>

#include <optional>
#include <vector>

namespace subcert {

/// Whether the integer shifts of the basic limit function are a Riesz basis of their span (stable). Domain: the scheme
/// converges. Decided exactly for every arity: no zero z on the unit circle that all arity-th roots of unity turn into
/// zeros, and no cyclic zeros. Only with stability is the exponent that the joint spectral radius gives the true one.
/// Proof: proofs-checks/certificates/SPEC.md, theorem 4. Ref: [JW93].
Decision has_stable_shifts(const Mask& mask);

/// Whether that is so for all masks with so many sum rules whose coefficients differ from these by at most `distance`,
/// on the same support: yes or unknown. Domain: distance > 0. Cost: a determinant, and arity^((zeros of the mask where
/// sum rules have none) / (2 arity - 2)) values. Ref: SPEC.md, section 7.
Decision has_stable_shifts(const Mask& mask, const Rational& distance, int sum_rules);

/// The same with an error for each coefficient, from the first to the last. Domain: errors >= 0, as many as
/// coefficients.
Decision has_stable_shifts(const Mask& mask, const std::vector<Rational>& errors, int sum_rules);

/// a(z) p(z) = p(z^arity) b(z) z^k for the symbol a of a mask, b of `mask` and p = `factor`, p(0) and p(1) not 0: phi_a
/// is a combination of shifts of phi_b with the coefficients of p, and phi_b one of phi_a with those of 1/p, locally of
/// finitely many. So both have the same smoothness. Canonical: lowest exponent of p 0; p = 1 where the mask is reduced.
struct ReducedMask {
  LaurentPolynomial factor;
  Mask mask;

  bool changes() const { return factor.length() > 1; }
};

/// The sub-symbols of the mask have no common zero but 0, and it has no cyclic zeros: where its scheme converges the
/// shifts are stable. Domain: not zero. Cost: greatest common divisors and divisions. Ref: [JW93], SPEC.md, theorem 24.
ReducedMask reduced(const Mask& mask);

/// The least m > 1 such that the symbol vanishes wherever z^arity is a primitive root of unity of order m and z is not.
/// Domain: not zero.
std::optional<long> cyclic_order(const Mask& mask);

}  // namespace subcert
