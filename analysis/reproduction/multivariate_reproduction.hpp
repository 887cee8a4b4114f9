#pragma once
/// Sum rules, polynomial generation and reproduction in two and three variables.

#include <subcert/analysis/symbol/mask.hpp>

#include <vector>

namespace subcert {

/// Degrees are total degrees of one step; for the meaning in one variable see PolynomialReproduction. Ref: [CH11].
struct MultivariateReproduction {
  /// The order of the sum rules: moments of total degree below it are the same over all cosets.
  int sum_rules;
  /// The multiplicity of 1 + z_i + ... + z_i^(arity-1) in the symbol, for each variable; none where the dilation is no
  /// multiple of the identity.
  std::vector<int> factors;
  /// Polynomials of this total degree are reproduced, with the datum f_j attached to j + parametrization; -1 for none.
  int reproduction_degree;
  std::vector<Rational> parametrization;

  int generation_degree() const { return sum_rules - 1; }
};

/// Cost: the terms of the mask times the number of moments. Proof: docs/reproduction.md.
MultivariateReproduction polynomial_reproduction(const MultivariateMask& mask);

/// The same for a tensor product, from its factors. Domain: two or three masks of one arity.
MultivariateReproduction tensor_product_reproduction(const std::vector<Mask>& factors);

/// A closed box that contains the support of the basic limit function: the sum of the boxes of M^-n supp(a), n = 1, 2,
/// .... Lowest and highest exponent over arity - 1 where M is the arity times the identity. Error: none where a power
/// of M up to the 24th is a positive multiple of the identity, otherwise an outer box, wider by at most a part in 1000.
std::vector<Interval> limit_support(const MultivariateMask& mask);

}  // namespace subcert
