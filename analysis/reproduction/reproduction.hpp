#pragma once
/// Polynomial generation and reproduction.

#include <subcert/analysis/symbol/mask.hpp>

namespace subcert {

/// All answers are exact and hold for convergent schemes. Ref: [DHSS08], [CH11].
struct PolynomialReproduction {
  /// Limits of polynomial data of this degree are polynomials of this degree: number of sum rules minus one.
  int generation_degree;
  /// Polynomials of this degree are reproduced, with the datum f_j attached to j + parametrization; -1 where not even
  /// constants are.
  int reproduction_degree;
  /// The shift in units of the data spacing: 0 for primal schemes, -1/2 for centred dual ones. It is
  /// tau / (arity - 1) with tau = a'(1) / arity, the only shift with which linear polynomials can be reproduced.
  Rational parametrization;
  /// The limit from samples of a smooth function at spacing h is within O(h^order), and no better for every function.
  int approximation_order() const { return reproduction_degree + 1; }
};

PolynomialReproduction polynomial_reproduction(const Mask& mask);

}  // namespace subcert
