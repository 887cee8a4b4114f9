#pragma once
/// Families of matrices that depend linearly on a mask with letters.

#include <subcert/analysis/symbol/masks/polynomial_data.hpp>
#include <subcert/analysis/symbol/matrices/matrix_family.hpp>
#include <subcert/analysis/transition/lattice_window.hpp>

#include <functional>
#include <optional>

namespace subcert {

/// T_t(w): the matrices of the symbol of a mask, or of its entries, for each w. Canonical: as many for all, square and
/// of one size.
struct ParametricFamily {
  ParametricMask mask;
  std::function<std::vector<RationalMatrix>(const LaurentPolynomial&)> matrices_of;  ///< linear

  std::size_t size() const { return matrices_of(mask.powers().front()).front().rows(); }
  /// T_t(w) times the denominator of the mask.
  MatrixFamily numerators_at(const Values& w) const { return matrices_of(mask.numerator_at(w)); }
  /// Domain: the denominator is not zero there.
  MatrixFamily at(const Values& w) const { return matrices_of(mask.entries_at(w)); }
  /// The matrices C_{t,i} of the controls of the mask on a box: T_t(w) is in the convex hull of the C_{t,i} for each w
  /// in it, so that the joint spectral radius is at most that of the family of all C_{t,i}. Nothing where there are no
  /// controls.
  std::optional<MatrixFamily> controls(const Box& box) const;
};

/// Those of transition_matrices(mask.at(w)), on a window that holds all coefficients for all w.
ParametricFamily transition_matrices(const ParametricMask& mask);

/// Those of the differences that the sum rules of all w allow, times arity^m for m of them: of numbers the transition
/// matrices of the scheme for divided differences of order m. Of matrices T_t on the finite sequences u that annihilate
/// the data of kept_polynomials, sum over k of u_k . e_l(-k) = 0, on a window into which long words lead all of them.
/// With a root they are the rational ones of the doubled mask of a QuadraticMask, and the data are over the field.
/// Domain: m >= 1. Errors: throws Error where the window needs more than 256 numbers. Proof: docs/vectors.md.
ParametricFamily difference_matrices(const ParametricMask& mask, long root = 0);
/// Those of several masks of matrices on one space: the sequences that annihilate these data, which all masks keep. So
/// many data, times arity^m. Domain: masks of one arity and one size; m >= 1. Errors: as above.
std::vector<ParametricFamily> difference_matrices(const std::vector<ParametricMask>& masks,
                                                  const PolynomialData& polynomials);

/// What of a mask of matrices annihilates the data of its polynomials.
struct AnnihilatingSpace {
  PolynomialData polynomials;
  std::vector<LatticeSequence> basis;  ///< that of difference_matrices, on one window
  std::vector<LatticePoint> pivots;    ///< where one of them is 1 and the others 0
  /// Component by component but for the first one, b, of which y_0 is not 0: a sequence that is 1 at 0 in that
  /// component, and 0 but in b elsewhere. Their shifts and those of the differences of b of order m + 1 span all.
  std::vector<LatticeSequence> readings;
};

/// Domain, errors and cost: as above, of matrices.
AnnihilatingSpace annihilating_space(const ParametricMask& mask, long root = 0);
/// Of several masks, as above.
AnnihilatingSpace annihilating_space(const std::vector<ParametricMask>& masks, long root = 0);

/// The one matrix central_matrix(b(z) b(1/z)) for b = mask.at(w), which gives the Sobolev exponent. Domain: one letter.
ParametricFamily central_matrices(const ParametricMask& mask);

}  // namespace subcert
