#include "difference.hpp"

#include <algorithm>
#include <stdexcept>

namespace subcert {

int sum_rules(const Mask& mask) { return mask.symbol().multiplicity(LaurentPolynomial::all_ones(mask.arity())); }

Mask divided_difference_scheme(const Mask& mask, int order) {
  if (order < 0)
    throw std::invalid_argument("divided_difference_scheme: need order >= 0, got " + std::to_string(order));
  const LaurentPolynomial factor = LaurentPolynomial::all_ones(mask.arity()).pow(order);
  const auto quotient = mask.symbol().exact_quotient(factor);
  if (!quotient)
    throw std::invalid_argument("divided_difference_scheme: need order <= number of sum rules (" +
                                std::to_string(sum_rules(mask)) + "), got " + std::to_string(order));
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

}  // namespace subcert
