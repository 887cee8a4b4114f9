#include "reproduction.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>

#include <algorithm>

namespace subcert {
namespace {

/// The sums of a_n n^exponents over the classes of n, digit by digit.
std::vector<Rational> moments_over_cosets(const LatticeMask& mask, const LatticePoint& exponents) {
  std::vector<Rational> sums(mask.dilation().digits().size(), 0);
  for (const auto& term : mask.symbol().terms()) {
    sums[mask.dilation().divide(term.exponents).digit] += term.coefficient *
                                                          monomial_at({term.exponents.begin(), term.exponents.end()},
                                                                      exponents);
  }
  return sums;
}

/// The t with M t = t + centre.
std::vector<Rational> parametrization(const Dilation& dilation, const std::vector<Rational>& centre) {
  RationalMatrix matrix(centre.size(), centre.size()), right(centre.size(), 1);
  for (std::size_t i = 0; i < centre.size(); ++i) {
    for (std::size_t j = 0; j < centre.size(); ++j) matrix(i, j) = dilation.rows()[i][j] - (i == j ? 1 : 0);
    right(i, 0) = centre[i];
  }
  const RationalMatrix solution = solve(matrix, right);
  std::vector<Rational> result;
  for (std::size_t i = 0; i < centre.size(); ++i) result.push_back(solution(i, 0));
  return result;
}

/// Of degree d: d + 1 sum rules and a^(k)(1) = arity tau (tau - 1) ... (tau - k + 1) for k <= d.
void add_factor(PolynomialReproduction& result, const Mask& factor) {
  const int rules = sum_rules(factor);
  const Rational arity(factor.arity());
  LaurentPolynomial derivative = factor.symbol();
  const Rational tau = factor.symbol().derivative()(1) / arity;
  int degree = -1;
  Rational expected = arity;
  for (int k = 0; k < rules && derivative(1) == expected; degree = k++) {
    expected *= tau - k;
    derivative = derivative.derivative();
  }
  const bool first = result.factors.empty();
  result.sum_rules = first ? rules : std::min(result.sum_rules, rules);
  result.reproduction_degree = first ? degree : std::min(result.reproduction_degree, degree);
  result.factors.push_back(rules);
  result.parametrization.push_back(tau / (arity - 1));
}

/// By moments.
PolynomialReproduction of_whole(const LatticeMask& mask) {
  const MultivariatePolynomial& symbol = mask.symbol();
  const auto variables = static_cast<std::size_t>(mask.dimension());
  const std::optional<int> factor = mask.dilation().factor();
  const std::vector<Rational> ones(variables, 1);
  PolynomialReproduction result{0, {}, -1, {}};
  std::vector<Rational> centre;
  for (std::size_t v = 0; v < variables; ++v) {
    const auto index = static_cast<int>(v);
    if (factor && *factor >= 2)
      result.factors.push_back(symbol.multiplicity(
          MultivariatePolynomial::in_variable(mask.dimension(), index, LaurentPolynomial::all_ones(*factor))));
    centre.push_back(symbol.derivative(index)(ones) / mask.dilation().classes());
  }
  result.parametrization = parametrization(mask.dilation(), centre);
  bool reproduces = true;
  for (int degree = 0;; ++degree) {
    for (const LatticePoint& exponents : exponents_of_degree(variables, degree)) {
      const std::vector<Rational> moments = moments_over_cosets(mask, exponents);
      if (std::any_of(moments.begin(), moments.end(), [&](const Rational& m) { return m != moments.front(); }))
        return result;
      reproduces = reproduces && moments.front() == monomial_at(centre, exponents);
    }
    result.sum_rules = degree + 1;
    if (reproduces) result.reproduction_degree = degree;
  }
}

}  // namespace

PolynomialReproduction polynomial_reproduction(const LatticeMask& mask) {
  if (!mask.has_factors()) return of_whole(mask);
  PolynomialReproduction result{};
  for (const Mask& factor : mask.factors()) add_factor(result, factor);
  return result;
}

MeanBias mean_bias(const Mask& mask) {
  const Rational arity(mask.arity()), centre = mask.symbol().derivative()(1) / arity;
  const std::vector<Rational> coefficients = mask.symbol().coefficients();
  std::vector<Rational> terms = coefficients, places;
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    places.push_back(mask.symbol().lowest() + static_cast<long>(i) - centre);
  // The first central moment of the mask that is not 0; the one of order 1 is. They cannot all be.
  Rational factorial = 1;
  for (int order = 1;; ++order) {
    factorial *= -order;
    Rational moment = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) moment += terms[i] *= places[i];
    if (moment != 0) return {order, moment / arity / (power(arity, order) - 1) / factorial};
  }
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
