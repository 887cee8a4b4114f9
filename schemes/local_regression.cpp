#include "local_regression.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

std::vector<Rational> interpolation_weights(const std::vector<Rational>& nodes, const Rational& x) {
  std::vector<Rational> result(nodes.size(), 0);
  const auto hit = std::find(nodes.begin(), nodes.end(), x);
  if (hit != nodes.end()) {
    result[static_cast<std::size_t>(hit - nodes.begin())] = 1;
    return result;
  }
  Rational all = 1;  // product of x - node; Lagrange's formula divides one factor out
  for (const Rational& node : nodes) all *= x - node;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Rational denominator = x - nodes[i];
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (j != i) denominator *= nodes[i] - nodes[j];
    result[i] = all / denominator;
  }
  return result;
}

void require_fit(std::vector<Rational> nodes, const std::vector<Rational>& weights, int degree) {
  require(!nodes.empty(), "regression_weights: need at least one node, got 0");
  std::sort(nodes.begin(), nodes.end());
  require(std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end(), "regression_weights: need distinct nodes");
  if (!weights.empty() && weights.size() != nodes.size())
    fail(ErrorKind::domain, "regression_weights: need as many weights as nodes, got {} for {}", weights.size(),
         nodes.size());
  require(std::all_of(weights.begin(), weights.end(), [](const Rational& w) { return w > 0; }),
          "regression_weights: need weights > 0");
  require(degree >= 0, "regression_weights: need degree >= 0, got {}", degree);
}

}  // namespace

std::vector<std::vector<Rational>> regression_terms(const std::vector<Rational>& nodes,
                                                    const std::vector<Rational>& weights, int degree,
                                                    const Rational& x) {
  require_fit(nodes, weights, degree);
  const std::size_t m = nodes.size();
  const int last = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(degree), m - 1));
  // Monic orthogonal polynomials by Stieltjes' recurrence P_{k+1} = (t - alpha) P_k - beta P_{k-1}, carried as their
  // values at the nodes and at x.
  std::vector<Rational> previous(m, 0), current(m, 1);
  std::vector<std::vector<Rational>> result;
  Rational previous_x = 0, current_x = 1, previous_norm = 1;
  for (int k = 0;; ++k) {
    Rational norm = 0, moment = 0;
    for (std::size_t i = 0; i < m; ++i) {
      Rational square = current[i] * current[i];
      if (!weights.empty()) square *= weights[i];
      norm += square;
      moment += square * nodes[i];
    }
    result.emplace_back(m, Rational(0));
    const Rational scale = current_x / norm;
    if (scale != 0)
      for (std::size_t i = 0; i < m; ++i) result.back()[i] = scale * current[i];
    if (k == last) return result;
    const Rational alpha = moment / norm;
    const Rational beta = k == 0 ? Rational(0) : norm / previous_norm;
    for (std::size_t i = 0; i < m; ++i) {
      previous[i] = (nodes[i] - alpha) * current[i] - beta * previous[i];
      std::swap(previous[i], current[i]);
    }
    previous_x = (x - alpha) * current_x - beta * previous_x;
    std::swap(previous_x, current_x);
    previous_norm = norm;
  }
}

std::vector<Rational> regression_weights(const std::vector<Rational>& nodes, const std::vector<Rational>& weights,
                                         int degree, const Rational& x) {
  require_fit(nodes, weights, degree);
  if (static_cast<std::size_t>(degree) + 1 >= nodes.size()) return interpolation_weights(nodes, x);
  std::vector<Rational> result(nodes.size(), 0);
  for (const std::vector<Rational>& term : regression_terms(nodes, weights, degree, x))
    for (std::size_t i = 0; i < nodes.size(); ++i) result[i] += term[i];
  if (!weights.empty())
    for (std::size_t i = 0; i < nodes.size(); ++i) result[i] *= weights[i];
  return result;
}

Mask regression_mask(const LocalRegression& scheme) {
  const auto arity = static_cast<long>(scheme.rules.size());
  require(arity >= 2, "regression_mask: need at least two rules, got {}", arity);
  // f'_{arity*i + s} uses f_{i+l} with weight a_{s - arity*l}.
  long lowest = 0, highest = 0;
  for (long k = 0; k < arity; ++k) {
    const RegressionRule& rule = scheme.rules[static_cast<std::size_t>(k)];
    require(rule.first <= rule.last, "regression_mask: need first <= last, got {} and {}", rule.first, rule.last);
    const long output = scheme.first_output + k;
    lowest = k == 0 ? output - arity * rule.last : std::min(lowest, output - arity * rule.last);
    highest = k == 0 ? output - arity * rule.first : std::max(highest, output - arity * rule.first);
  }
  std::vector<Rational> coefficients(static_cast<std::size_t>(highest - lowest + 1), 0);
  for (long k = 0; k < arity; ++k) {
    const RegressionRule& rule = scheme.rules[static_cast<std::size_t>(k)];
    std::vector<Rational> nodes;
    for (long l = rule.first; l <= rule.last; ++l) nodes.emplace_back(l);
    const std::vector<Rational> weights = regression_weights(nodes, rule.weights, scheme.degree, rule.position);
    for (long l = rule.first; l <= rule.last; ++l)
      coefficients[static_cast<std::size_t>(scheme.first_output + k - arity * l - lowest)] =
          weights[static_cast<std::size_t>(l - rule.first)];
  }
  return {LaurentPolynomial(coefficients, lowest), static_cast<int>(arity)};
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
