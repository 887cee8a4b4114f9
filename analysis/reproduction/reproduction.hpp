#pragma once
/// Polynomial generation and reproduction.

#include <subcert/analysis/symbol/masks/parametric_mask.hpp>

#include <vector>

namespace subcert {

/// For convergent schemes; degrees are total degrees. They are exact where the symbol has no zeros that the roots of
/// unity turn into each other (so for all with stable shifts); for others they are lower bounds. Ref: [DHSS08], [CH11].
struct PolynomialReproduction {
  /// The order of the sum rules: moments of total degree below it are the same over all cosets.
  int sum_rules;
  /// The multiplicity of 1 + z_i + ... + z_i^(arity-1) in the symbol, for each variable; none where the dilation is
  /// neither a multiple of the identity nor that of a tensor product.
  std::vector<int> factors;
  /// Polynomials of this degree are reproduced, with the datum f_j attached to j + parametrization; -1 where not even
  /// constants are.
  int reproduction_degree;
  /// The shift in units of the data spacing, the only one with which linear polynomials can be reproduced: the t with
  /// M t = t + (the mean of the indices). Of curves 0 for odd symmetric masks, -1/(2 (arity-1)) for even ones centred
  /// at -1/2.
  std::vector<Rational> parametrization;

  /// Limits of polynomial data of this degree are polynomials of this degree.
  int generation_degree() const { return sum_rules - 1; }
  /// The limit from samples of a smooth function at spacing h is within O(h^order); docs/reproduction.md shows when
  /// that is sharp.
  int approximation_order() const { return reproduction_degree + 1; }
};

/// Cost: the terms of the mask times the number of moments; by factors quasi-linear in the terms for each degree.
/// Proof: docs/reproduction.md.
PolynomialReproduction polynomial_reproduction(const LatticeMask& mask);

/// What the limit from samples of a smooth function f at spacing h misses in the mean over a period of the grid:
/// limit - f = constant * h^order * f^(order) + O(h^(order + 1)), with the datum f_j attached to j + parametrization.
struct MeanBias {
  int order;
  Rational constant;  ///< not 0
};

/// Domain: coset sums 1; a statement about schemes that converge. Cost: linear in the coefficients for each order.
/// Proof: docs/reproduction.md.
MeanBias mean_bias(const Mask& mask);

/// The degrees for all values of a parameter.
struct ParametricReproduction {
  int generation_degree;  ///< for all values
  int reproduction_degree;
  RationalFunction parametrization;
  /// Vanishes where one more sum rule holds; 1 where none does.
  LaurentPolynomial more_sum_rules;
  /// Vanishes where the degree of reproduction is larger, for want of a condition that does not hold for all values; 1
  /// where only more sum rules help.
  LaurentPolynomial more_reproduction;
};

/// Domain: coset sums 1 for all values.
ParametricReproduction polynomial_reproduction(const ParametricMask& mask);

}  // namespace subcert
