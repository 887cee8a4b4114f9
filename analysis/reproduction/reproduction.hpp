#pragma once
/// Polynomial generation and reproduction.

#include <subcert/analysis/symbol/parametric_mask.hpp>

namespace subcert {

/// For convergent schemes. The degrees are exact where the symbol has no zeros that the roots of unity turn into each
/// other (so for all with stable shifts); for others they are lower bounds. Ref: [DHSS08], [CH11].
struct PolynomialReproduction {
  /// Limits of polynomial data of this degree are polynomials of this degree: number of sum rules minus one.
  int generation_degree;
  /// Polynomials of this degree are reproduced, with the datum f_j attached to j + parametrization; -1 where not even
  /// constants are.
  int reproduction_degree;
  /// The shift in units of the data spacing: 0 for odd symmetric masks, -1/(2 (arity-1)) for even ones centred at -1/2.
  /// It is tau / (arity - 1) with tau = a'(1) / arity, the only shift with which linear polynomials can be reproduced.
  Rational parametrization;
  /// The limit from samples of a smooth function at spacing h is within O(h^order); docs/reproduction.md shows when
  /// that is sharp.
  int approximation_order() const { return reproduction_degree + 1; }
};

PolynomialReproduction polynomial_reproduction(const Mask& mask);

/// The same for all values of a parameter.
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
