#pragma once
/// Convergence and continuous differentiability, proved or refuted.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

namespace subcert {

/// How much work a proof may take: levels of the contractivity test, and when it ends with what is proved; by default
/// 20 seconds after this was made.
struct ProofLimits {
  int levels = 16;
  Deadline deadline = Deadline::in(20);
};

/// Whether the scheme converges uniformly for every bounded data; else `unknown` with the reason.
/// By factors, of which all have to converge: `yes` by the positive mask theorem or by a contractive power of the
/// difference scheme, `no` by a coset sum other than 1 or by an eigenvalue of modulus >= 1 of a transition matrix of
/// the difference scheme, `unknown` with the smallest norm seen. Ref: [DL02, thm 3.2], [CDM91, thm 3.3], [Mel97].
/// Without factors: `yes` where the symbol has the factor 1 + z_i + ... + z_i^(arity-1) for every variable and powers
/// of all difference schemes contract; `no` by a coset whose sum is not 1, or where the scheme for data that depend on
/// one variable alone does not converge. Domain: a dilation that is a multiple of the identity (otherwise `unknown`
/// unless a class does not sum to 1; a positive exponent decides, multivariate_regularity.hpp). Ref: [CDM91], [DL02,
/// sec. 4]. Cost: limits.levels products of the symbol, without factors as far as they have less than some 10^6 terms.
/// Proofs: docs/convergence.md.
Decision converges(const LatticeMask& mask, const ProofLimits& limits = {});

/// The hypotheses of the positive mask theorem: all coset sums 1, and first..last all positive with
/// last - first >= arity.
bool has_positive_mask(const Mask& mask);

/// The largest k such that C^k limits are proved: the divided difference schemes of orders 0, ..., k converge.
/// order is -1 where not even convergence is proved. `evidence` names the argument for that k, `obstacle` what stops
/// k+1. This is one-sided: the limits may be smoother than proved. Of a tensor product that of the roughest factor.
struct SmoothnessProof {
  int order = -1;
  std::string evidence;
  std::string obstacle;
};

/// Domain: a mask with factors. Errors: throws Error otherwise.
SmoothnessProof proved_smoothness(const LatticeMask& mask, const ProofLimits& limits = {});

}  // namespace subcert
