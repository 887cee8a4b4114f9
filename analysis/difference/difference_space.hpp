#pragma once
/// The differences of a scheme of several variables as vectors of a finite-dimensional space.

#include <subcert/analysis/transition/lattice_window.hpp>

namespace subcert {

/// A space of sequences on a window, invariant under all T_d, that tells how differences of order `order` shrink.
struct DifferenceSpace {
  int order;
  Dilation dilation;
  LatticeWindow window;
  /// A basis: basis[c] is 1 at pivots[c], where all others are 0.
  std::vector<LatticeSequence> basis;
  std::vector<LatticePoint> pivots;
  MatrixFamily family;  ///< T_d on the basis, digit by digit
  /// The values phi(k), where the differences are those of phi; empty where they are those of the scheme.
  LatticeSequence values = {};
  bool is_of_values() const { return !values.empty(); }
};

/// The differences of the scheme: sequences that annihilate all polynomials of degree below `order`, T_w nabla^mu delta
/// for |mu| = order and all words w of window.steps() letters or more among them. The largest modulus of the
/// differences of order `order` of the n-th power of the scheme grows as JSR(family)^n. Proof: docs/surfaces.md.
/// Domain: sum rules of this order >= 1; at most `most_points` lattice points. Errors: throws Error. Cost: one
/// elimination, and the dimension times the coefficients for each digit.
DifferenceSpace difference_space(const LatticeMask& mask, int order, std::size_t most_points = 4096);

}  // namespace subcert
