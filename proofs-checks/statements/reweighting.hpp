#pragma once
/// Weighted least squares on windows of data, for closed forms that hold for all positive weights.
/// docs/statements.md, section 3.

#include "identities.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>

namespace subcert::statements {

/// Data f with positive weights w at the nodes (r, s); s = 0 on a line.
struct WeightedWindow {
  std::vector<std::pair<long, long>> nodes;
  std::vector<Rational> weights;
  std::vector<Rational> data;
};

/// The nodes first, ..., last of a line (variables = 1) or of a square (variables = 2), all weights 1 and data 0.
WeightedWindow window(long first, long last, int variables);
/// The same with pseudo-random rational weights and data, which depend on the seed alone.
WeightedWindow random_window(long first, long last, int variables, unsigned seed);

/// Tries windows with random weights, 2n data on a line or, where not `even`, 2n+1, for n = first_n, ..., last_n.
Trial on_random_windows(long first_n, long last_n, bool even, unsigned seeds,
                        const std::function<Trial(long n, const WeightedWindow&, const std::string& where)>& visit);

/// NAME1, NAME2, ..., `count` of them, the k-th tried from k on.
std::vector<Variable> numbered(const std::string& name, int count);
/// The transcriptions PREFIX1, PREFIX2, ...
std::vector<Formula> numbered_formulas(const Context& context, const std::string& prefix, int count);
/// Adds the values NAME1, NAME2, ...: the sums of the terms, as sum_over gives them.
void add_sums(Values& to, const std::string& name, const std::vector<Formula>& terms, const WeightedWindow& window,
              long first, long last);

/// The value at (x, y) of the weighted fit of this total degree, by the library's own fits.
Rational library_value(const WeightedWindow& window, int degree, const Rational& x, const Rational& y = 0);

/// The sum of a term in r, s, w, f and the names given, over the nodes with first <= r, s <= last.
Rational sum_over(const WeightedWindow& window, const Formula& term, long first, long last, const Values& names = {});

/// The coefficients of the basis, functions of r and s, in the weighted fit: its normal equations solved. Domain: the
/// nodes determine the basis. Errors: throws Undefined otherwise.
std::vector<Rational> weighted_coefficients(const WeightedWindow& window, const std::vector<Formula>& basis);

/// The matrix A^T W A of the normal equations.
RationalMatrix normal_matrix(const WeightedWindow& window, const std::vector<Formula>& basis);

/// A linear function of weighted data, sum of rule(r) w f, with rule(r) = p(r) for a polynomial p of degree at most
/// `degree`, and the moments sum of rule(r) r^k w = moments[k], as identities in tau1, tau2, ..., which stand for the
/// sums of w, r w, r^2 w, ... . Domain: the rule is a function of r and the taus; `start` is where each tau is tried
/// first, so that no divisor vanishes.
Trial weighted_moments(const Formula& rule, int degree, const std::vector<Formula>& moments,
                       const std::vector<Variable>& start);

/// term = coefficient * w * f, where the coefficient is the term at w = f = 1.
Trial is_weighted_datum(const Formula& term, const std::vector<Variable>& names);
/// The term at w = f = 1.
Formula coefficient_of_datum(const Formula& term);

/// matrix * adjoint = determinant * identity, entry by entry, as identities in the variables. Domain: square.
Trial adjoint_identity(const std::vector<std::vector<Formula>>& matrix,
                       const std::vector<std::vector<Formula>>& adjoint, const Formula& determinant,
                       const std::vector<Variable>& variables);

/// A square grid fit whose weights have a closed form: `weight`, a function of n, r, s and the parameters, belongs to
/// the node (r, s), first(n) <= r, s <= last(n); the fit has this total degree and is evaluated at (x, y), functions of
/// the parameters.
struct GridFit {
  Formula weight;
  Line first;
  Line last;
  Formula x;
  Formula y;
  int degree;
  long smallest_n;
  std::vector<Variable> parameters;
};

/// Compares with the normal equations for n up to largest_n, then proves the form for all n >= smallest_n: the weights
/// are a polynomial of at most this degree in the node and reproduce the monomials.
Trial grid_fit(const GridFit& fit, long largest_n);

/// `n = 2, random weights 1`, as in witnesses.
std::string weighted_case(long n, unsigned seed);

/// The weights 1/bracket^exponent belong to the smoothed modulus h(t) = smoothed^smoothed_exponent: w = h'(t)/t for the
/// residual t, as identities in f and the other names.
Trial weights_of_modulus(const Formula& bracket, const Rational& exponent, const Formula& residual,
                         const std::vector<Variable>& names);

/// |t| <= h <= |t| + e for the residual t and h^2 the bracket with delta = e^2, as an identity in the names, e among
/// them.
Trial smoothed_above_modulus(const Formula& bracket, const Formula& residual, const std::vector<Variable>& names);
/// F_delta is strictly convex, and a reweighted fit makes it smaller: with h^2 the bracket, t^2 + delta at each
/// residual t, and k its value at the last fit, h <= (k^2 + h^2)/(2k), whose sum the fit minimises.
Trial fits_go_down(const Formula& bracket, const Formula& residual, const std::vector<Variable>& names);
/// The outputs with the weights w^(m), m = 0, 1, ..., are those of m + 1 reweighted fits. Of one outlier, at any place
/// of each of these windows (points, degree), and for delta to 0, the two advised m leave at most 1/50 and 1/100 at the
/// new points, and none smaller does so for 6 points and degree 1. Domain: as outlier_remainder.
Trial advised_fits(const std::vector<Formula>& advised, const std::vector<std::pair<int, int>>& windows);

/// term = w r^i s^j for the k-th pair (i, j), and the sums run over 2n (even) or 2n+1 consecutive indices about 1/2 or
/// 0.
Trial entries_of_normal_equations(const std::vector<Formula>& terms, const std::vector<std::string>& expected);
Trial summation_range(const Formula& first, const Formula& last, bool even);
/// The index of a datum is axis + node, so that the rule of `axis` takes the data about it.
Trial moving_index(const Formula& index, const std::string& axis, const std::string& node);

}  // namespace subcert::statements
