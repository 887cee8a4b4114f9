#pragma once
/// Another mask whose basic limit function has the same smoothness, and stable shifts.

#include <subcert/analysis/symbol/mask.hpp>

#include <optional>

namespace subcert {

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
