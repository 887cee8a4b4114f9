#pragma once
/// Convergence and continuous differentiability, proved or refuted.

#include <subcert/analysis/symbol/budget.hpp>
#include <subcert/analysis/symbol/mask.hpp>

namespace subcert {

/// How much work a proof may take: levels of the contractivity test, and when it ends with what is proved; by default
/// 20 seconds after this was made.
struct ProofLimits {
  int levels = 16;
  Deadline deadline = Deadline::in(20);
};

/// Whether the scheme converges uniformly for every bounded data. `yes` by the positive mask theorem or by a
/// contractive power of the difference scheme, `no` by a coset sum other than 1 or by an eigenvalue of modulus >= 1
/// of a transition matrix of the difference scheme, `unknown` with the smallest norm seen. Proofs:
/// docs/convergence.md. Ref: [DL02, thm 3.2], [CDM91, thm 3.3], [Mel97].
Decision converges(const Mask& mask, const ProofLimits& limits = {});

/// The hypotheses of the positive mask theorem: all coset sums 1, and first..last all positive with
/// last - first >= arity.
bool has_positive_mask(const Mask& mask);

/// The largest k such that C^k limits are proved: the divided difference schemes of orders 0, ..., k converge.
/// order is -1 where not even convergence is proved. `evidence` names the argument for that k, `obstacle` what stops
/// k+1. This is one-sided: the limits may be smoother than proved.
struct SmoothnessProof {
  int order = -1;
  std::string evidence;
  std::string obstacle;
};

SmoothnessProof proved_smoothness(const Mask& mask, const ProofLimits& limits = {});

}  // namespace subcert
