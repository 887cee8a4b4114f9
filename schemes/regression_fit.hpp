#pragma once
// Local regression over any field of numbers: exact numbers, quotients of polynomials in a parameter, doubles.

#include "local_regression.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace subcert::regression_fit {

/// The sum of term(i) over i < count; of doubles in four parts side by side, which processors add at once.
template <class Number, class Term>
Number sum_of(std::size_t count, const Term& term) {
  if constexpr (std::is_same_v<Number, double>) {
    constexpr std::size_t lanes = 4;
    double parts[lanes] = {};
    const std::size_t whole = count - count % lanes;
    for (std::size_t i = 0; i < whole; i += lanes)
      for (std::size_t k = 0; k < lanes; ++k) parts[k] += term(i + k);
    for (std::size_t i = whole; i < count; ++i) parts[i - whole] += term(i);
    return (parts[0] + parts[1]) + (parts[2] + parts[3]);
  } else {
    Number sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += term(i);
    return sum;
  }
}

/// Calls take(scale, values) for each polynomial P_k of regression_terms() in local_regression.hpp, whose term is scale
/// times its values at the nodes. Domain: distinct nodes, norms that are not zero.
template <class Node, class Number, class Take>
void for_terms(const std::vector<Node>& nodes, const std::vector<Number>& weights, int degree, const Number& x,
               int derivative, const Take& take) {
  const std::size_t m = nodes.size();
  const auto order = static_cast<std::size_t>(derivative);
  const int last = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(degree), m - 1));
  // Monic orthogonal polynomials by Stieltjes' recurrence P_{k+1} = (t - alpha) P_k - beta P_{k-1}, carried as their
  // values at the nodes, and at x with their derivatives up to `order`.
  std::vector<Number> previous(m, Number(0)), current(m, Number(1)), squares(m, Number(1));
  std::vector<Number> previous_x(order + 1, Number(0)), current_x = previous_x;
  current_x[0] = 1;
  Number previous_norm = 1;
  for (int k = 0;; ++k) {
    for (std::size_t i = 0; i < m; ++i) squares[i] = current[i] * current[i];
    if (!weights.empty())
      for (std::size_t i = 0; i < m; ++i) squares[i] *= weights[i];
    const auto norm = sum_of<Number>(m, [&](std::size_t i) -> const Number& { return squares[i]; });
    take(Number(current_x[order] / norm), current);
    if (k == last) return;
    const Number alpha = sum_of<Number>(m, [&](std::size_t i) { return Number(squares[i] * Number(nodes[i])); }) / norm;
    const Number beta = k == 0 ? Number(0) : Number(norm / previous_norm);
    for (std::size_t i = 0; i < m; ++i) previous[i] = (Number(nodes[i]) - alpha) * current[i] - beta * previous[i];
    std::swap(previous, current);
    for (std::size_t r = order + 1; r-- > 0;) {
      previous_x[r] = (x - alpha) * current_x[r] - beta * previous_x[r];
      if (r > 0) previous_x[r] += Number(static_cast<int>(r)) * current_x[r - 1];
    }
    std::swap(previous_x, current_x);
    previous_norm = norm;
  }
}

/// The same where the datum i is one of the derivative orders[i]: polynomials are orthogonal for <g, h> = sum of
/// weights[i] g^(orders[i])(nodes[i]) h^(orders[i])(nodes[i]), and their values are those of these derivatives. No
/// recurrence of three terms holds, as t is not symmetric for this product: each polynomial is made orthogonal to all
/// before it. Domain: as many weights and orders as nodes; no polynomial of the degree but 0 has all these values 0.
/// Cost: nodes * degree^2 operations.
template <class Number, class Take>
void for_hermite_terms(const std::vector<Number>& nodes, const std::vector<int>& orders,
                       const std::vector<Number>& weights, int degree, const Number& x, int derivative,
                       const Take& take) {
  const std::size_t m = nodes.size();
  const auto highest = static_cast<std::size_t>(*std::max_element(orders.begin(), orders.end()));
  // Derivatives [r][i] at the nodes, and [r] at x.
  struct Polynomial {
    std::vector<std::vector<Number>> at_nodes;
    std::vector<Number> at_x;
    std::vector<Number> values = {};  // of the data
    Number norm = 0;
  };
  std::vector<Polynomial> made;
  Polynomial next{{highest + 1, std::vector<Number>(m, Number(0))},
                  std::vector<Number>(static_cast<std::size_t>(derivative) + 1, Number(0))};
  next.at_nodes[0].assign(m, Number(1));
  next.at_x[0] = 1;
  const auto product = [&](const std::vector<Number>& one, const std::vector<Number>& other) {
    return sum_of<Number>(m, [&](std::size_t i) { return Number(weights[i] * one[i] * other[i]); });
  };
  const auto set_values = [&](Polynomial& polynomial) {
    polynomial.values.resize(m);
    for (std::size_t i = 0; i < m; ++i)
      polynomial.values[i] = polynomial.at_nodes[static_cast<std::size_t>(orders[i])][i];
  };
  const auto subtract = [](std::vector<Number>& from, const std::vector<Number>& what, const Number& factor) {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] -= factor * what[i];
  };
  for (int k = 0;; ++k) {
    set_values(next);
    // Of doubles twice, so that what is left is orthogonal to rounding.
    for (int pass = 0; pass < (std::is_same_v<Number, double> ? 2 : 1); ++pass)
      for (const Polynomial& before : made) {
        const Number factor = product(next.values, before.values) / before.norm;
        for (std::size_t r = 0; r <= highest; ++r) subtract(next.at_nodes[r], before.at_nodes[r], factor);
        subtract(next.at_x, before.at_x, factor);
        subtract(next.values, before.values, factor);
      }
    next.norm = product(next.values, next.values);
    take(Number(next.at_x.back() / next.norm), next.values);
    if (k == degree) return;
    made.push_back(next);
    // The derivative r of t P is t P^(r) + r P^(r-1).
    for (std::size_t r = highest + 1; r-- > 0;)
      for (std::size_t i = 0; i < m; ++i) {
        next.at_nodes[r][i] *= nodes[i];
        if (r > 0) next.at_nodes[r][i] += Number(static_cast<int>(r)) * next.at_nodes[r - 1][i];
      }
    for (std::size_t r = next.at_x.size(); r-- > 0;) {
      next.at_x[r] *= x;
      if (r > 0) next.at_x[r] += Number(static_cast<int>(r)) * next.at_x[r - 1];
    }
  }
}

/// Lagrange's formula. Domain: distinct nodes.
template <class Node, class Number>
std::vector<Number> interpolation(const std::vector<Node>& nodes, const Number& x) {
  std::vector<Number> result(nodes.size(), Number(1));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (j != i) result[i] *= Number(x - Number(nodes[j])) / Number(nodes[i] - nodes[j]);
  return result;
}

/// As regression_weights() in local_regression.hpp.
template <class Node, class Number>
std::vector<Number> weights(const std::vector<Node>& nodes, const std::vector<Number>& prior, int degree,
                            const Number& x, int derivative = 0) {
  if (static_cast<std::size_t>(degree) + 1 >= nodes.size() && derivative == 0) return interpolation(nodes, x);
  std::vector<Number> result(nodes.size(), Number(0));
  for_terms(nodes, prior, degree, x, derivative, [&](const Number& scale, const std::vector<Number>& values) {
    if (scale == Number(0)) return;
    for (std::size_t i = 0; i < nodes.size(); ++i) result[i] += scale * values[i];
  });
  if (!prior.empty())
    for (std::size_t i = 0; i < nodes.size(); ++i) result[i] *= prior[i];
  return result;
}

/// The coefficients of a mask and the index of the first.
template <class Number>
struct Coefficients {
  std::vector<Number> values;
  long first = 0;
};

/// `fit(nodes, weights, degree, x)` gives the weights of a rule. Errors: throws Error for fewer than two rules, or
/// first > last.
template <class Number, class Fit>
Coefficients<Number> coefficients(const LocalRegressionOf<Number>& scheme, Fit fit) {
  const auto arity = static_cast<long>(scheme.rules.size());
  require(arity >= 2, "regression_mask: need at least two rules, got {}", arity);
  // f'_{arity*i + s} uses f_{i+l} with weight a_{s - arity*l}.
  long lowest = 0, highest = 0;
  for (long k = 0; k < arity; ++k) {
    const RegressionRuleOf<Number>& rule = scheme.rules[static_cast<std::size_t>(k)];
    require(rule.first <= rule.last, "regression_mask: need first <= last, got {} and {}", rule.first, rule.last);
    const long output = scheme.first_output + k;
    lowest = k == 0 ? output - arity * rule.last : std::min(lowest, output - arity * rule.last);
    highest = k == 0 ? output - arity * rule.first : std::max(highest, output - arity * rule.first);
  }
  Coefficients<Number> result{std::vector<Number>(static_cast<std::size_t>(highest - lowest + 1), Number(0)), lowest};
  for (long k = 0; k < arity; ++k) {
    const RegressionRuleOf<Number>& rule = scheme.rules[static_cast<std::size_t>(k)];
    std::vector<Rational> nodes;
    for (long l = rule.first; l <= rule.last; ++l) nodes.emplace_back(l);
    const std::vector<Number> values = fit(nodes, rule.weights, scheme.degree, rule.position);
    for (long l = rule.first; l <= rule.last; ++l)
      result.values[static_cast<std::size_t>(scheme.first_output + k - arity * l - lowest)] =
          values[static_cast<std::size_t>(l - rule.first)];
  }
  return result;
}

}  // namespace subcert::regression_fit
