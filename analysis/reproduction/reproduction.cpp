#include "reproduction.hpp"

#include <subcert/analysis/difference/difference.hpp>

namespace subcert {

PolynomialReproduction polynomial_reproduction(const Mask& mask) {
  const int rules = sum_rules(mask);
  const Rational arity(mask.arity());
  LaurentPolynomial derivative = mask.symbol();
  const Rational tau = mask.symbol().derivative()(1) / arity;
  PolynomialReproduction result{rules - 1, -1, tau / (arity - 1)};
  // Reproduction of degree d: d+1 sum rules and a^(k)(1) = arity tau (tau - 1) ... (tau - k + 1) for k <= d.
  Rational expected = arity;
  for (int k = 0; k < rules; ++k) {
    if (derivative(1) != expected) break;
    result.reproduction_degree = k;
    expected *= tau - k;
    derivative = derivative.derivative();
  }
  return result;
}

}  // namespace subcert
