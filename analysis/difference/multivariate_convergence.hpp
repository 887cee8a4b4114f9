#pragma once
/// Convergence in two and three variables.

#include "convergence.hpp"

#include <vector>

namespace subcert {

/// The maximum norm of the subdivision operator: the largest sum of moduli over a class.
Rational operator_norm(const MultivariateMask& mask);

/// Whether the scheme converges uniformly for every bounded data. Domain: a dilation that is a multiple of the identity
/// (otherwise `unknown` unless a class does not sum to 1; a positive exponent decides, multivariate_regularity.hpp).
/// `yes` where the symbol has the factor 1 + z_i + ... +
/// z_i^(arity-1) for every variable and powers of all difference schemes contract; `no` by a coset whose sum is
/// not 1, or where the scheme for data that depend on one variable alone does not converge; else `unknown` with the
/// reason. Cost: limits.levels products of the symbol, as far as they have less than some 10^6 terms. Proof:
/// docs/convergence.md. Ref: [CDM91], [DL02, sec. 4].
Decision converges(const MultivariateMask& mask, const ProofLimits& limits = {});

/// The same for a tensor product, which converges if and only if its factors do.
Decision tensor_product_converges(const std::vector<Mask>& factors, const ProofLimits& limits = {});

}  // namespace subcert
