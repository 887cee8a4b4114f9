#include "local_regression.hpp"

#include "regression_fit.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

void require_fit(std::vector<Rational> nodes, const std::vector<Rational>& weights, int degree) {
  require(!nodes.empty(), "regression_weights: need at least one node, got 0");
  if (!weights.empty() && weights.size() != nodes.size())
    fail(ErrorKind::domain, "regression_weights: need as many weights as nodes, got {} for {}", weights.size(),
         nodes.size());
  require(std::all_of(weights.begin(), weights.end(), [](const Rational& w) { return w > 0; }),
          "regression_weights: need weights > 0");
  require(degree >= 0, "regression_weights: need degree >= 0, got {}", degree);
  const std::size_t needed = std::min(static_cast<std::size_t>(degree) + 1, nodes.size());
  std::sort(nodes.begin(), nodes.end());
  const auto distinct = static_cast<std::size_t>(std::unique(nodes.begin(), nodes.end()) - nodes.begin());
  require(distinct >= needed, "regression_weights: need {} distinct nodes, got {}", needed, distinct);
}

}  // namespace

std::vector<std::vector<Rational>> regression_terms(const std::vector<Rational>& nodes,
                                                    const std::vector<Rational>& weights, int degree,
                                                    const Rational& x) {
  require_fit(nodes, weights, degree);
  std::vector<std::vector<Rational>> terms;
  regression_fit::for_terms(nodes, weights, degree, x, 0,
                            [&](const Rational& scale, const std::vector<Rational>& values) {
                              for (Rational& value : terms.emplace_back(values)) value *= scale;
                            });
  return terms;
}

std::vector<Rational> regression_weights(const std::vector<Rational>& nodes, const std::vector<Rational>& weights,
                                         int degree, const Rational& x, int derivative) {
  require_fit(nodes, weights, degree);
  require(derivative >= 0, "regression_weights: need derivative >= 0, got {}", derivative);
  return regression_fit::weights(nodes, weights, degree, x, derivative);
}

template <>
std::vector<double> regression_weights<double>(const std::vector<double>& nodes, const std::vector<double>& weights,
                                               int degree, double x, int derivative) {
  if (nodes.empty() || weights.size() != nodes.size() || degree < 0 || derivative < 0)
    fail(ErrorKind::domain, "regression_weights: need nodes, as many weights, degree and derivative >= 0");
  return regression_fit::weights(nodes, weights, degree, x, derivative);
}

Mask regression_mask(const LocalRegression& scheme) {
  const auto [values, first] = regression_fit::coefficients(
      scheme, [](const auto& nodes, const auto& weights, int degree, const Rational& x) {
        return regression_weights(nodes, weights, degree, x);
      });
  return {LaurentPolynomial(values, first), static_cast<int>(scheme.rules.size())};
}

ParametricMask parametric_regression_mask(const LocalRegressionOf<RationalFunction>& scheme) {
  const auto [values, first] = regression_fit::coefficients(
      scheme, [](const auto& nodes, const auto& weights, int degree, const RationalFunction& x) {
        return regression_fit::weights(nodes, weights, degree, x);
      });
  return {values, first, static_cast<int>(scheme.rules.size())};
}

LocalRegression primal(int n, int degree) { return {{{-n + 1, n - 1, 0}, {-n + 1, n, Rational(1, 2)}}, degree}; }

LocalRegression primal_odd(int n, int degree) { return {{{-n, n, 0}, {-n + 1, n, Rational(1, 2)}}, degree}; }

LocalRegression dual(int n, int degree) { return ary(2, 2 * n, degree); }

LocalRegression dual_odd(int n, int degree) { return ary(2, 2 * n + 1, degree); }

LocalRegression ary(int arity, int points, int degree) {
  require(arity >= 2, "ary: need arity >= 2, got {}", arity);
  require(points >= 2, "ary: need points >= 2, got {}", points);
  LocalRegression scheme{{}, degree};
  const int n = points / 2;
  if (points % 2 == 0) {
    // The middle cell is [0, 1] between the data -n+1, ..., n.
    for (int q = 0; q < arity; ++q) scheme.rules.push_back({-n + 1, n, Rational(2 * q + 1, 2 * arity)});
  } else {
    // The middle cell is [-1/2, 1/2] around the middle one of the data -n, ..., n.
    scheme.first_output = -(arity / 2);
    for (int q = 0; q < arity; ++q) scheme.rules.push_back({-n, n, Rational(2 * q + 1 - arity, 2 * arity)});
  }
  return scheme;
}

}  // namespace subcert
