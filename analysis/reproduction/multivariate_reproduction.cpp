#include "multivariate_reproduction.hpp"

#include "reproduction.hpp"

#include <subcert/analysis/symbol/rational_matrix.hpp>

#include <algorithm>
#include <limits>

namespace subcert {
namespace {

using Exponents = MultivariatePolynomial::Exponents;

/// The sums of a_n n^exponents over the classes of n, digit by digit.
std::vector<Rational> moments_over_cosets(const MultivariateMask& mask, const Exponents& exponents) {
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

}  // namespace

MultivariateReproduction polynomial_reproduction(const MultivariateMask& mask) {
  const MultivariatePolynomial& symbol = mask.symbol();
  const auto variables = static_cast<std::size_t>(mask.dimension());
  const std::optional<int> factor = mask.dilation().factor();
  const std::vector<Rational> ones(variables, 1);
  MultivariateReproduction result{0, {}, -1, {}};
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
    for (const Exponents& exponents : exponents_of_degree(variables, degree)) {
      const std::vector<Rational> moments = moments_over_cosets(mask, exponents);
      if (std::any_of(moments.begin(), moments.end(), [&](const Rational& m) { return m != moments.front(); }))
        return result;
      reproduces = reproduces && moments.front() == monomial_at(centre, exponents);
    }
    result.sum_rules = degree + 1;
    if (reproduces) result.reproduction_degree = degree;
  }
}

MultivariateReproduction tensor_product_reproduction(const std::vector<Mask>& factors) {
  MultivariateReproduction result{std::numeric_limits<int>::max(), {}, std::numeric_limits<int>::max(), {}};
  for (const Mask& factor : factors) {
    const PolynomialReproduction one = polynomial_reproduction(factor);
    result.factors.push_back(one.generation_degree + 1);
    result.sum_rules = std::min(result.sum_rules, one.generation_degree + 1);
    result.reproduction_degree = std::min(result.reproduction_degree, one.reproduction_degree);
    result.parametrization.push_back(one.parametrization);
  }
  return result;
}

std::vector<Interval> limit_support(const MultivariateMask& mask) {
  // The support lies in the sum of M^-n supp(a) over n >= 1. After `period` steps the terms are those of the first
  // round, divided by `scale`, or, where no power of M is a multiple of the identity, smaller than a part of a box
  // around them.
  const Dilation& dilation = mask.dilation();
  const std::size_t variables = dilation.variables();
  RationalMatrix inverse(variables, variables);
  for (std::size_t j = 0; j < variables; ++j) {
    std::vector<Rational> unit(variables, 0);
    unit[j] = 1;
    const std::vector<Rational> column = dilation.inverse_times(unit);
    for (std::size_t i = 0; i < variables; ++i) inverse(i, j) = column[i];
  }
  std::vector<Interval> sums(variables, Interval::exactly(0));
  RationalMatrix power = RationalMatrix::identity(variables);
  constexpr int longest_period = 24;
  const Rational million = 1'000'000;
  for (int n = 1;; ++n) {
    power = power * inverse;
    std::vector<std::optional<Interval>> boxes(variables);
    for (const auto& term : mask.symbol().terms()) {
      const std::vector<Rational> point = power * std::vector<Rational>(term.exponents.begin(), term.exponents.end());
      for (std::size_t v = 0; v < variables; ++v)
        boxes[v] = boxes[v] ? Interval{std::min(boxes[v]->lower, point[v]), std::max(boxes[v]->upper, point[v])}
                            : Interval::exactly(point[v]);
    }
    for (std::size_t v = 0; v < variables; ++v) sums[v] = sums[v] + *boxes[v];
    bool returned = true;
    for (std::size_t i = 0; i < variables; ++i)
      for (std::size_t j = 0; j < variables; ++j) returned = returned && (i == j ? power(i, i) > 0 : power(i, j) == 0);
    if (!returned && n < longest_period) continue;
    if (returned) {
      for (std::size_t v = 0; v < variables; ++v) sums[v] = sums[v] * (1 / (1 - power(v, v)));
      return sums;
    }
    // x in sums + power x: by coordinates, with the norm of the power.
    Rational reach = 0, norm = one_norm(transposed(power));
    for (const Interval& sum : sums) reach = std::max({reach, Rational(abs(sum.lower)), Rational(abs(sum.upper))});
    if (norm >= Rational(1, 1000)) continue;
    const Rational rest = reach * norm / (1 - norm);
    for (Interval& sum : sums)
      sum = {Rational(to_integer((sum.lower - rest) * million, Rounding::down)) / million,
             Rational(to_integer((sum.upper + rest) * million, Rounding::up)) / million};
    return sums;
  }
}

}  // namespace subcert
