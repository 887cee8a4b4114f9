#pragma once
/// What a mask does on the unit squares of the regular part, as it is needed to enclose surfaces and their derivatives
/// there. Inner header.

#include <subcert/analysis/symbol/masks/mask.hpp>

#include <optional>
#include <vector>

namespace subcert::vertex {

/// The points k for which phi(x - k) may differ from 0 in the unit square, relative to its corner.
std::vector<LatticePoint> window_of(const LatticeMask& mask);

/// The mask of the derivative by x or y: D phi(x) = phi_e(x) - phi_e(x - e), phi_e by m a(z) / (1 + z^e + ... +
/// z^((m-1)e)). Nothing where the quotient is none, or has coset sums other than 1.
std::optional<LatticeMask> derivative_mask(const LatticeMask& mask, std::size_t axis);

/// Whether the second derivatives of the limits are proved bounded: the schemes of m^2 times second divided differences
/// along pairs of the directions (1,0), (0,1), (1,1), (1,-1), pairs that span the quadratic forms, have norms of at
/// most
/// 1. So first derivatives are Lipschitz. Domain: numbers, m times the identity; phi continuous.
bool has_bounded_second_derivatives(const LatticeMask& mask);

/// No coefficient is negative.
bool is_positive(const LatticeMask& mask);

/// Bounds of the sum over k of |phi(x - k)|, and of |D phi(x - k)| along x or y; nothing where no products of
/// reasonable length show one. Domain: phi differentiable, sum rules of order 2, its window. Cost: products of matrices
/// of the size of the window, in whole numbers. Proof: docs/vertices.md.
std::optional<Rational> sum_bound(const LatticeMask& mask, const std::vector<LatticePoint>& window);
std::optional<Rational> derivative_bound(const LatticeMask& mask, const std::vector<LatticePoint>& window,
                                         std::size_t axis);

}  // namespace subcert::vertex
