
#include "difference.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
int sum_rules(const Mask& mask) { return mask.symbol().multiplicity(LaurentPolynomial::all_ones(mask.arity())); }

Mask divided_difference_scheme(const Mask& mask, int order) {
  require(order >= 0, "divided_difference_scheme: need order >= 0, got {}", order);
  const LaurentPolynomial factor = LaurentPolynomial::all_ones(mask.arity()).pow(order);
  const auto quotient = mask.symbol().exact_quotient(factor);
  if (!quotient)
    fail(ErrorKind::domain, "divided_difference_scheme: need order <= number of sum rules ({}), got {}",
         sum_rules(mask), order);
  return {*quotient * LaurentPolynomial(power(Rational(mask.arity()), order)), mask.arity()};
}

Rational operator_norm(const Mask& mask) {
  std::vector<Rational> sums(static_cast<std::size_t>(mask.arity()), 0);
  std::size_t residue = 0;
  for (const Rational& c : mask.symbol().coefficients()) {
    sums[residue] += abs(c);
    residue = (residue + 1) % sums.size();
  }
  return *std::max_element(sums.begin(), sums.end());
}

Rational operator_norm(const LatticeMask& mask) {
  std::vector<Rational> sums(mask.dilation().digits().size(), 0);
  for (const Monomial& term : mask.symbol().terms())
    sums[mask.dilation().divide(term.exponents).digit] += abs(term.coefficient);
  return *std::max_element(sums.begin(), sums.end());
}

namespace {

/// binomial(x, k) for any integer x.
Rational binomial(long x, long k) {
  Rational result = 1;
  for (long i = 0; i < k; ++i) result *= Rational(x - i, i + 1);
  return result;
}

/// One row for each monomial of degree below `order`, as products of binomials: integers, and small ones.
RationalMatrix moments(const std::vector<LatticePoint>& points, int order) {
  const std::size_t variables = points.front().size();
  const std::vector<LatticePoint> monomials = exponents_up_to(variables, order - 1);
  RationalMatrix result(monomials.size(), points.size());
  for (std::size_t i = 0; i < monomials.size(); ++i)
    for (std::size_t k = 0; k < points.size(); ++k) {
      Rational product = 1;
      for (std::size_t v = 0; v < variables; ++v) product *= binomial(points[k][v], monomials[i][v]);
      result(i, k) = product;
    }
  return result;
}

}  // namespace

DifferenceSpace difference_space(const LatticeMask& mask, int order, std::size_t largest, std::size_t most_points) {
  require(order >= 1, "difference space: need sum rules of order 1 or more, got {}", order);
  LatticeWindow window(mask, exponents_up_to(mask.dilation().variables(), order), most_points);
  const RationalMatrix conditions = moments(window.points(), order);
  if (window.size() > largest + conditions.rows())
    fail(ErrorKind::size,
         "difference space: need a dimension of at most {}, got {} or more for differences of order {}", largest,
         window.size() - conditions.rows(), order);
  const std::vector<std::vector<Rational>> vectors = kernel(conditions);
  require(!vectors.empty(), "difference space: no sequence on the {} points of the window annihilates polynomials",
          window.size());
  std::vector<LatticeSequence> basis(vectors.size());
  for (std::size_t c = 0; c < vectors.size(); ++c)
    for (std::size_t k = 0; k < window.size(); ++k)
      if (vectors[c][k] != 0) basis[c].emplace(window.points()[k], vectors[c][k]);
  std::vector<LatticePoint> pivots;
  for (const std::size_t column : free_columns(vectors)) pivots.push_back(window.points()[column]);
  MatrixFamily family = transition_family(mask, basis, pivots);
  return {order, mask.dilation(), std::move(window), std::move(basis), std::move(pivots), std::move(family)};
}

}  // namespace subcert
