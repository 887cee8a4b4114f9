#include "difference.hpp"

#include <subcert/analysis/symbol/error.hpp>

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

}  // namespace subcert
