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

ParametricReproduction polynomial_reproduction(const ParametricMask& mask) {
  const int rules = sum_rules(mask);
  std::vector<LaurentPolynomial> derivatives = mask.powers();
  // The values of the derivatives at z = 1.
  const auto at_one = [&] {
    std::vector<Rational> values;
    for (const LaurentPolynomial& p : derivatives) values.push_back(p.is_zero() ? Rational(0) : p(1));
    return RationalFunction(LaurentPolynomial(values, 0), mask.denominator());
  };
  const auto differentiate = [&] {
    for (LaurentPolynomial& p : derivatives) p = p.derivative();
  };
  RationalFunction value = at_one();
  differentiate();
  const RationalFunction arity(mask.arity()), tau = at_one() / arity;
  ParametricReproduction result{rules - 1, -1, tau / RationalFunction(mask.arity() - 1), special_values(mask), 1};
  RationalFunction expected = arity;
  for (int k = 0; k < rules; ++k) {
    if (!(value == expected)) {
      result.more_reproduction = (value - expected).numerator();
      break;
    }
    result.reproduction_degree = k;
    expected *= tau - RationalFunction(k);
    value = at_one();
    differentiate();
  }
  return result;
}

}  // namespace subcert
