#pragma once
/// The differences of a scheme of several variables as vectors of a finite-dimensional space.

#include <subcert/analysis/transition/lattice_window.hpp>

namespace subcert {

/// A space V of sequences on a window K that annihilate all polynomials of degree below `order`, invariant under all
/// T_d. It holds T_w nabla^mu delta for |mu| = order and all words w of steps() letters or more, so that the largest
/// modulus of the differences of order `order` of the n-th power of the scheme grows as JSR(family)^n.
/// Proof: docs/surfaces.md.
struct DifferenceSpace {
  int order;
  LatticeWindow window;
  /// A basis: basis[c] is 1 at window.points()[pivots[c]], where all others are 0.
  std::vector<LatticeSequence> basis;
  std::vector<std::size_t> pivots;
  MatrixFamily family;  ///< T_d on the basis, digit by digit
};

/// Domain: sum rules of this order >= 1; at most `most_points` lattice points. Errors: throws Error. Cost: one
/// elimination, and the dimension times the coefficients for each digit.
DifferenceSpace difference_space(const MultivariateMask& mask, int order, std::size_t most_points = 4096);

}  // namespace subcert
