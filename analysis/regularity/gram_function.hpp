#pragma once
/// The inner products <phi, phi(. - k)> of the integer shifts of the basic limit function of several variables, and
/// what follows: stability and the Sobolev exponent.

#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/analysis/transition/lattice_window.hpp>

namespace subcert {

/// k -> <phi, phi(. - k)>, exact. Nothing where the solution of the refinement equation is not unique, which says that
/// the scheme does not converge. Domain: coset sums 1. Errors: throws Error where the window has more than 4096 points.
/// Cost: a linear system as large as the window modulo the symmetries of the autocorrelation. Proof: docs/surfaces.md.
std::optional<LatticeSequence> gram_function(const LatticeMask& mask, const Deadline& deadline = {});

/// Whether the integer shifts of phi are stable: sum over k of <phi, phi(. - k)> e^(i k x) > 0 for all x. `no` names a
/// zero, `yes` comes from exact bounds on cells. Domain: `gram` is that of a scheme that converges. Proof:
/// docs/surfaces.md.
Decision has_stable_shifts(const LatticeSequence& gram, const Budget& budget = {});

/// The largest s such that phi lies in the Sobolev spaces of all orders below s. Ref: [Jia99].
struct MultivariateSobolev {
  Enclosure radius;  ///< of the transfer operator
  Enclosure exponent;
  std::size_t dimension;  ///< of the space on which the radius was computed
};

/// From the transfer operator on the sequences that annihilate polynomials of degree below 2 * sum_rules: the exponent
/// where the shifts are stable, otherwise a lower bound of it. Nothing where it would take longer than the deadline.
/// Domain: sum rules of this order >= 1, isotropic dilation. Errors: throws Error. Error: exponent to 1e-15. Cost: one
/// characteristic polynomial.
std::optional<MultivariateSobolev> sobolev_regularity(const LatticeMask& mask, int sum_rules,
                                                      const Deadline& deadline = {});

/// From the words of the transfer operator on the differences of `gram`: the exponent, whether the shifts are stable or
/// not. Nothing where it would take longer than the deadline. Domain: `gram` is that of the mask, phi continuous.
/// Errors, Error: as above. Cost: the minimal polynomial of a vector, for each order up to the exponent.
std::optional<MultivariateSobolev> sobolev_regularity(const LatticeMask& mask, const LatticeSequence& gram,
                                                      const Deadline& deadline = {});

}  // namespace subcert
