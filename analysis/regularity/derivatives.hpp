#pragma once
/// Whether limits, and derivatives of them, exist: what has to be proved before their values are given.

#include "holder_regularity.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <string>

namespace subcert {

/// An answer, and of `unknown` whether it stays so however long one looks.
struct DerivativeProof {
  Decision decision;
  bool open_for_good = false;
};

/// Whether the derivative of these orders, one for each variable, of all limits exists, is continuous, and is the limit
/// of divided differences, as limit_values() needs it; of orders 0: whether the scheme converges. By factors: `yes` by
/// proved_smoothness() or by the exponent, `no` by the exponent, or by the sum rules of the mask without its factor p
/// (stability.hpp), whose shifts are stable. Without factors: by the exponent alone, which refutes no derivative.
/// Domain: orders >= 0, one for each variable. Error: none. Cost: within the limits. Ref: SPEC.md, theorems 23 and 24.
DerivativeProof has_derivative(const LatticeMask& mask, const LatticePoint& orders, const ProofLimits& limits = {});

/// Why limits are not so smooth. Domain: the scheme converges, and has_derivatives() says no.
std::string refutation(const HolderRegularity& regularity, long order);

/// Thrown where values are asked for that are not proved to exist. kind(): domain where they are proved not to, else
/// undecided.
class NoLimit : public Error {
 public:
  NoLimit(const std::string& what, const DerivativeProof& proof)
      : Error(proof.decision.is_no() ? ErrorKind::domain : ErrorKind::undecided, what), proof_(proof) {}
  const DerivativeProof& proof() const { return proof_; }

 private:
  DerivativeProof proof_;
};

/// Errors: throws NoLimit, which names the scheme, unless the decision is yes.
void require_convergence(const std::string& scheme, const Decision& convergence);

/// The same for has_derivative().
void require_derivative(const std::string& scheme, const LatticeMask& mask, const LatticePoint& orders,
                        const ProofLimits& limits = {});

}  // namespace subcert
