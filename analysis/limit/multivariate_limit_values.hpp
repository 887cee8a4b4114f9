#pragma once
/// Exact values of basic limit functions of several variables.

#include <subcert/analysis/transition/lattice_window.hpp>

namespace subcert {

/// i -> phi(M^-level i), where it is not 0. Domain: a scheme that converges; level >= 0. Errors: throws Error for a
/// mask whose fixed vector is not unique, which says that the scheme does not converge, or where more than 10^6 values
/// are asked for. Cost: a linear system as large as the number of lattice points in the support, then coefficients *
/// values. Proof: docs/surfaces.md.
LatticeSequence limit_values(const MultivariateMask& mask, int level);

}  // namespace subcert
