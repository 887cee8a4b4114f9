#pragma once
/// Exact values of basic limit functions of several variables and of their derivatives.

#include <subcert/analysis/transition/lattice_window.hpp>

namespace subcert {

/// i -> (D^orders phi)(M^-level i), where it is not 0; `orders` has the order of the derivative in each variable, and
/// is empty for phi itself. Domain: a scheme that converges; level >= 0; for derivatives an isotropic dilation, and all
/// derivatives of that total order continuous. Errors: throws Error, of kind domain where the refinement equation does
/// not determine the values, of kind size where more than 2000 lattice points lie in the support, 4*10^6 points
/// M^-level i in its box, or more than 10^6 values are asked for. Cost: a linear system as large as the number of
/// lattice points in the support, for derivatives two more; then coefficients * values. Proof: docs/surfaces.md.
LatticeSequence limit_values(const MultivariateMask& mask, int level, const LatticePoint& orders = {});

/// The same for a tensor product, from its factors, whatever their arities. Domain: each factor converges, and so does
/// its divided difference scheme of the order in its variable. Errors and cost: as those of the factors, and at most
/// 10^6 values.
LatticeSequence tensor_product_limit_values(const std::vector<Mask>& factors, int level,
                                            const LatticePoint& orders = {});

/// The coefficients of the power of the scheme: `level` steps applied to the unit sequence, the datum with index i at
/// M^-level i. Errors: throws Error of kind size for more than 10^6. Cost: coefficients * values.
LatticeSequence refined_delta(const MultivariateMask& mask, int level);

}  // namespace subcert
