#pragma once
/// The differences of the limit function itself, which tell its exponent whether its shifts are stable or not.

#include <subcert/analysis/difference/difference.hpp>

namespace subcert {

/// Lost by a power and a logarithm on the way from a radius to an exponent.
inline constexpr int bits_of_powers = 4;

/// The space of the sequences T_w nabla^mu v, v_k = phi(k), for |mu| = order and all long words w: differences of the
/// values of phi on lattices that get finer. The exponent of phi is -log JSR(family) to the base |det M|^(1/s) where
/// that is below `order`, and at least `order` otherwise. Nothing where the numbers of the space are not recognised
/// modulo a prime, or where the refinement equation has no unique solution on lattice points. Its first digit is 0.
/// Domain: coset sums 1, isotropic dilation, order >= 1. Errors: throws Error where more than `most_points` of them are
/// needed.
/// Cost: eliminations modulo a prime, and exact ones of what differs from the space. Proof: docs/surfaces.md.
std::optional<DifferenceSpace> value_space(const LatticeMask& mask, int order, std::size_t most_points = 1024);

/// The same for differences along the vectors of a basis of an isotropic subspace: how smooth phi is along it.
std::optional<DifferenceSpace> value_space(const LatticeMask& mask, int order,
                                           const std::vector<LatticePoint>& directions, std::size_t most_points = 1024);

/// The same for fixed sequences T_0 v = v of a mask of numbers or matrices, of which there is at least one: the space
/// is that of all of them together, and holds the first as its values. No sums are asked for. Proof: docs/vectors.md.
std::optional<DifferenceSpace> value_space(const LatticeMask& mask, const std::vector<LatticeSequence>& solutions,
                                           int order, std::size_t most_points = 1024);

/// The space of T_w x for all x of `starts` and all long words w; `order` is noted in it alone. Nothing where its
/// numbers are not recognised modulo a prime, or where it is 0. Errors and cost: as above.
std::optional<DifferenceSpace> space_of_long_words(const LatticeMask& mask, const std::vector<LatticeSequence>& starts,
                                                   int order, std::size_t most_points = 1024);

/// Whether T_w x = 0 for all x of `starts` and all words w of some length up to 64.
bool vanish_under_long_words(const LatticeMask& mask, const std::vector<LatticeSequence>& starts);

/// Digits among which 0 is the first: those of the dilation, if 0 is one of them.
Dilation with_zero_first(const Dilation& dilation);

}  // namespace subcert
