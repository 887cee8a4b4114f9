#pragma once
/// Local polynomial regression: the one family that contains every linear scheme of the papers.

#include <subcert/analysis/symbol/masks/parametric_mask.hpp>

#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

namespace subcert {

/// The weights c with p(x) = sum of c[i] y[i], where p is the polynomial of degree at most `degree` that minimises
/// sum of weights[i] (p(nodes[i]) - y[i])^2. With degree >= nodes.size() - 1 it interpolates, and among the
/// interpolating polynomials the one of smallest degree is taken ([DHHS15, Rem. 9] leaves the choice open). With
/// `derivative` they give that derivative of p at x.
/// Domain: nodes not empty, at least degree + 1 of them distinct or all of them, weights positive and as many as the
/// nodes (none: all one), degree >= 0,
/// derivative >= 0.
/// Errors: throws a domain error that names the broken inequality.
/// Cost: nodes * degree rational operations (three-term recurrence of the discrete orthogonal polynomials, which for
/// equally spaced nodes are Gram's); interpolation nodes^2.
/// Ref: [DHHS15, App. A], [EF07].
std::vector<Rational> regression_weights(const std::vector<Rational>& nodes, const std::vector<Rational>& weights,
                                         int degree, const Rational& x, int derivative = 0);

/// The same in double precision; lists in braces are exact numbers. Domain: as there, as many weights as nodes, degree
/// at most 30, nodes within a few hundreds of x. Error: a small multiple of 2^-53 times the largest weight for degrees
/// up to 5, not bounded here; the tests compare with exact weights. Cost: nodes * degree operations.
template <std::same_as<double> Number>
std::vector<Number> regression_weights(const std::vector<Number>& nodes, const std::vector<Number>& weights, int degree,
                                       std::type_identity_t<Number> x, int derivative = 0);
template <>
std::vector<double> regression_weights<double>(const std::vector<double>& nodes, const std::vector<double>& weights,
                                               int degree, double x, int derivative);

/// [k][i] = P_k(x) P_k(nodes[i]) / <P_k, P_k> for k = 0, ..., min(degree, nodes.size() - 1), with the polynomials P_k
/// of degree k that are orthogonal for <g, h> = sum of weights[i] g(nodes[i]) h(nodes[i]): the sum of the first rows
/// times weights[i] are the regression weights. Domain, errors and cost as regression_weights without its
/// interpolation.
std::vector<std::vector<Rational>> regression_terms(const std::vector<Rational>& nodes,
                                                    const std::vector<Rational>& weights, int degree,
                                                    const Rational& x);

/// One refinement rule: the fit uses the data f_{i+first}, ..., f_{i+last} and is evaluated at i + position.
template <class Number>
struct RegressionRuleOf {
  long first;
  long last;
  Number position;
  std::vector<Number> weights;  ///< prior weights, positive; empty means all one

  RegressionRuleOf(long from, long to, Number at, std::vector<Number> prior = {})
      : first(from), last(to), position(std::move(at)), weights(std::move(prior)) {}
};
using RegressionRule = RegressionRuleOf<Rational>;

/// The scheme with rules[k] : f'_{arity*i + first_output + k}, arity = rules.size().
template <class Number>
struct LocalRegressionOf {
  std::vector<RegressionRuleOf<Number>> rules;
  int degree;
  long first_output = 0;
};
using LocalRegression = LocalRegressionOf<Rational>;

/// The exact mask. Domain: at least two rules, first <= last in each. Errors: as regression_weights.
Mask regression_mask(const LocalRegression& scheme);

/// The same with positions and weights that are functions of a parameter. Where a weight is not positive the mask is
/// what the formula gives, and no longer a minimum. Domain: as above; weights that are not zero.
ParametricMask parametric_regression_mask(const LocalRegressionOf<RationalFunction>& scheme);

/// [DHHS15, sec. 2, 4.3]: 2n-1 data around the old point, 2n data around the midpoint. Domain: n >= 1, degree >= 0.
LocalRegression primal(int n, int degree);
/// [DHHS15, sec. 4.2]: 2n+1 data around the old point, 2n around the midpoint. Domain: n >= 1.
LocalRegression primal_odd(int n, int degree);
/// [DHHS15, sec. 4.1, 4.3]: 2n data, evaluated at 1/4 and 3/4 between the middle two. Domain: n >= 1.
LocalRegression dual(int n, int degree);
/// [DHHS15, sec. 4.2]: 2n+1 data, evaluated at -1/4 and 1/4 about the middle one. Domain: n >= 1.
LocalRegression dual_odd(int n, int degree);
/// [MB16, sec. 2]: one fit on `points` data, evaluated at the `arity` positions that divide the middle cell evenly.
/// The outputs are numbered so that the mask is centred at 0 or -1/2. Domain: arity >= 2, points >= 2.
LocalRegression ary(int arity, int points, int degree);

}  // namespace subcert
