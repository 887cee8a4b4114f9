#include "multivariate_reproduction.hpp"

#include "reproduction.hpp"

#include <subcert/analysis/symbol/index_arithmetic.hpp>

#include <algorithm>
#include <limits>

namespace subcert {
namespace {

using Exponents = MultivariatePolynomial::Exponents;

/// All exponents of this total degree.
std::vector<Exponents> exponents_of(std::size_t variables, long degree) {
  if (variables == 1) return {{degree}};
  std::vector<Exponents> result;
  for (long first = 0; first <= degree; ++first)
    for (Exponents rest : exponents_of(variables - 1, degree - first)) {
      rest.insert(rest.begin(), first);
      result.push_back(std::move(rest));
    }
  return result;
}

/// The sums of a_n n^exponents over the cosets of n modulo the arity, the first variable running fastest.
std::vector<Rational> moments_over_cosets(const std::vector<MultivariatePolynomial::Monomial>& terms, long arity,
                                          const Exponents& exponents) {
  std::size_t classes = 1;
  for (std::size_t v = 0; v < exponents.size(); ++v) classes *= static_cast<std::size_t>(arity);
  std::vector<Rational> sums(classes, 0);
  for (const auto& term : terms) {
    Rational product = term.coefficient;
    std::size_t at = 0;
    for (std::size_t v = exponents.size(); v-- > 0;) {
      const long n = term.exponents[v];
      at = at * static_cast<std::size_t>(arity) + static_cast<std::size_t>(modulo(n, arity));
      if (exponents[v] > 0 && n != 0) product *= power(Rational(n), exponents[v]);
      if (exponents[v] > 0 && n == 0) product = 0;
    }
    sums[at] += product;
  }
  return sums;
}

}  // namespace

MultivariateReproduction polynomial_reproduction(const MultivariateMask& mask) {
  const MultivariatePolynomial& symbol = mask.symbol();
  const auto variables = static_cast<std::size_t>(mask.dimension());
  const long arity = mask.arity();
  const std::vector<Rational> ones(variables, 1);
  const Rational volume = power(Rational(arity), static_cast<long>(variables));
  MultivariateReproduction result{0, {}, -1, {}};
  std::vector<Rational> centre;
  for (std::size_t v = 0; v < variables; ++v) {
    const auto index = static_cast<int>(v);
    result.factors.push_back(symbol.multiplicity(
        MultivariatePolynomial::in_variable(mask.dimension(), index, LaurentPolynomial::all_ones(mask.arity()))));
    centre.push_back(symbol.derivative(index)(ones) / volume);
    result.parametrization.push_back(centre.back() / (arity - 1));
  }
  const auto terms = symbol.terms();
  bool reproduces = true;
  for (int degree = 0;; ++degree) {
    for (const Exponents& exponents : exponents_of(variables, degree)) {
      const std::vector<Rational> moments = moments_over_cosets(terms, arity, exponents);
      if (std::any_of(moments.begin(), moments.end(), [&](const Rational& m) { return m != moments.front(); }))
        return result;
      Rational expected = 1;
      for (std::size_t v = 0; v < variables; ++v)
        if (exponents[v] > 0) expected *= centre[v] == 0 ? Rational(0) : power(centre[v], exponents[v]);
      reproduces = reproduces && moments.front() == expected;
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
  const auto lowest = mask.symbol().lowest(), highest = mask.symbol().highest();
  std::vector<Interval> result;
  for (std::size_t v = 0; v < lowest.size(); ++v)
    result.push_back({Rational(lowest[v], mask.arity() - 1), Rational(highest[v], mask.arity() - 1)});
  return result;
}

}  // namespace subcert
