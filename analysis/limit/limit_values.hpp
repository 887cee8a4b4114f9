#pragma once
/// Exact values of the basic limit function and of its derivatives.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/analysis/transition/lattice_window.hpp>

#include <optional>
#include <vector>

namespace subcert {

/// Of one variable: values[i] = phi^(order)((first_index + i) / arity^level), for all grid points in the closed
/// support.
struct LimitValues {
  int arity;
  int level;
  int order;
  long first_index;
  std::vector<Rational> values;

  /// The value at index / arity^level, 0 outside the support.
  Rational at(long index) const;
  Rational point(std::size_t i) const;
};

/// The values of the basic limit function or of its derivative of this order at the arity-adic points of this level.
/// Domain: the divided difference scheme of this order converges (decide with proved_smoothness(): order <= its order);
/// at most 1,500 integers inside the support, at most 10^7 values. Errors: throws Error, of kind domain where the
/// refinement equation does not determine the values at the integers, of kind size beyond the sizes, of kind undecided
/// past the deadline. Cost: one exact solution at the integers, then one product for each level. Ref: [DHHS15,
/// sec. 2.2].
LimitValues limit_values(const Mask& mask, int level, int order = 0, const Deadline& deadline = {});

/// M^-level index.
std::vector<Rational> point_at(const Dilation& dilation, const LatticePoint& index, int level);

/// Of a vector of functions the component is one more coordinate, and the values at lattice points sum to 1, or, where
/// they sum to 0, the first is 1. i -> (D^orders phi)(M^-level i), where it is not 0; `orders` has the order of the
/// derivative in each variable, and is empty for phi itself. Domain: a scheme that converges; level >= 0. By factors,
/// whatever their arities: the divided difference scheme of the order in its variable converges for each; at most 10^6
/// values. Without factors: for derivatives an isotropic dilation, and all derivatives of that total order continuous.
/// Errors: throws Error, of kind domain where the refinement equation does not determine the values, of kind size where
/// more than 2000 lattice points lie in the support, 4*10^6 points M^-level i in its box, or more than 10^6 values are
/// asked for. Cost: as that of the factors; without these a linear system as large as the number of lattice points in
/// the support, for derivatives two more; then coefficients * values. Proof: docs/surfaces.md.
LatticeSequence limit_values(const LatticeMask& mask, int level, const LatticePoint& orders = {});

/// The same of the solution of the refinement equation that has these values at lattice points. Domain: a mask without
/// factors; values of a continuous solution.
LatticeSequence limit_values(const LatticeMask& mask, const LatticeSequence& values, int level,
                             const LatticePoint& orders = {});

/// A basis of the sequences v with v = T_0 v on the lattice points strictly inside the box of the support, for each
/// component of the smallest box that the mask allows it where the dilation is a number: a continuous solution of the
/// refinement equation is determined by its values there, as it is 0 at all others, so that there are at most so many
/// solutions, up to linear combinations. Domain: 0 is a digit. Errors: throws Error of kind size where
/// more than 2000 numbers are to be found. Cost: one elimination.
std::vector<LatticeSequence> solutions_at_lattice_points(const LatticeMask& mask);

/// The integral of the continuous solution that has these values at lattice points, in every component. With B the
/// mean_matrix() it is the part of the sum of the values in the kernel of the powers of B - 1: the sums of the values
/// at M^-n i, times |det M|^-n, are B^n times that sum, and Riemann sums (docs/vectors.md). Domain: a mask of matrices.
std::vector<Rational> integral_of_solution(const LatticeMask& mask, const LatticeSequence& values);

/// A basis of the span of the solutions whose integrals are multiples of this one: the first has this integral, the
/// others 0. None where no solution has it. Domain: `solutions` is a basis of all; the integral is not 0.
std::vector<LatticeSequence> with_integral(const LatticeMask& mask, const std::vector<LatticeSequence>& solutions,
                                           const std::vector<Rational>& integral);

/// Times a number, so that the values sum to 1, or, where they sum to 0, that the first is 1.
LatticeSequence normalised(LatticeSequence values);

/// The coefficients of the power of the scheme: `level` steps applied to the unit sequence, the datum with index i at
/// M^-level i. Errors: throws Error of kind size for more than 10^6. Cost: coefficients * values.
LatticeSequence refined_delta(const LatticeMask& mask, int level);

/// [k] = the integral of phi(x) phi(x + k), k = 0, 1, ..., up to the last that is not zero for its support: the values
/// at the integers of the autocorrelation of phi, which the mask a(z) a(1/z) / arity refines.
/// Domain: the scheme converges. Errors: as limit_values. Cost: one exact solution of half the size of that mask.
std::vector<Rational> l2_inner_products(const Mask& mask, const Deadline& deadline = {});

/// The integral of phi^2, l2_inner_products(mask)[0].
Rational squared_l2_norm(const Mask& mask, const Deadline& deadline = {});

/// values[i] = phi(x + first + i), for all integers where x + first + i lies in the closed support.
struct ShiftedValues {
  long first;
  std::vector<Rational> values;
};

/// Domain: the scheme converges; x runs into a cycle of at most 64 points under multiplication by the arity modulo 1,
/// as every rational does whose denominator is small; at most 1,500 integers in the support. Errors: throws
/// Error, of kind domain where the refinement equation does not determine the values, of kind size beyond these sizes,
/// of kind undecided past the deadline.
/// Cost: one exact elimination of the size of the support, and products of such matrices along the cycle. Proof:
/// docs/limit-values.md.
ShiftedValues limit_values_at(const Mask& mask, const Rational& x, const Deadline& deadline = {});

/// The vector x = matrix x with x_0 weights_0 + x_1 weights_1 + ... = 1; nothing where it does not exist or is not the
/// only one. Domain: square, a weight for each row. Errors: throws Error of kind undecided past the deadline. Cost: one
/// lifted solution; where the last equation does not follow from the others, an elimination without end.
std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const std::vector<Rational>& weights,
                                                  const Deadline& deadline = {});
/// With the weights 1, weight, weight, ....
std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const Rational& weight = 1,
                                                  const Deadline& deadline = {});

}  // namespace subcert
