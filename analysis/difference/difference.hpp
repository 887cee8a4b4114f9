#pragma once
/// Sum rules and the schemes for divided differences.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/transition/lattice_window.hpp>

namespace subcert {

/// The number of sum rules: the multiplicity of 1 + z + ... + z^(arity-1) in the symbol. Ref: [CDM91], [DL02].
int sum_rules(const Mask& mask);

/// The scheme for the divided differences of this order, with symbol a(z) / ((1 + ... + z^(arity-1)) / arity)^order;
/// its limits are the derivatives of this order. Domain: 0 <= order <= sum_rules(mask). Errors: throws
/// Error. Ref: [DL02, sec. 4].
Mask divided_difference_scheme(const Mask& mask, int order);

/// The maximum norm of the subdivision operator: the largest sum of |a_i| over a coset modulo the dilation.
Rational operator_norm(const Mask& mask);
Rational operator_norm(const LatticeMask& mask);

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
/// Domain: sum rules of this order >= 1; at most `most_points` lattice points, and a dimension of at most `largest`.
/// Errors: throws Error. Cost: one elimination, and the dimension times the coefficients for each digit.
DifferenceSpace difference_space(const LatticeMask& mask, int order, std::size_t largest = 4096,
                                 std::size_t most_points = 4096);

}  // namespace subcert
