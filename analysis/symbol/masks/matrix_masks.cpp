#include "matrix_masks.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert {

LatticeMask matrix_mask(const std::vector<LatticeMask::Term>& terms, std::size_t size, const Dilation& dilation) {
  std::vector<std::vector<Monomial>> entries(size * size);
  for (const LatticeMask::Term& term : terms)
    if (term.coefficient != 0) entries[term.row * size + term.column].push_back({term.coefficient, term.exponents});
  std::vector<MultivariatePolynomial> result;
  for (const auto& entry : entries) result.emplace_back(static_cast<int>(dilation.variables()), entry);
  return {std::move(result), dilation};
}

RationalMatrix mean_matrix(const LatticeMask& mask) {
  RationalMatrix result(mask.components(), mask.components());
  for (const LatticeMask::Term& term : mask.terms())
    result(term.row, term.column) += term.coefficient / mask.dilation().classes();
  return result;
}

bool keeps_data(const std::vector<LatticeMask::Term>& terms, std::size_t size, const Dilation& dilation,
                bool derivatives, const Rational& one) {
  const LatticePoint zero(dilation.variables(), 0);
  const std::size_t digit = dilation.divide(zero).digit;
  std::vector<Rational> diagonal(size, 0), expected(size, one);
  for (std::size_t i = 1; derivatives && i < size; ++i) expected[i] = expected[i - 1] / dilation.factor().value();
  for (const LatticeMask::Term& term : terms) {
    if (term.coefficient == 0 || dilation.divide(term.exponents).digit != digit) continue;
    if (term.exponents != zero || term.row != term.column) return false;
    diagonal[term.row] = term.coefficient;
  }
  return diagonal == expected;
}

LatticeMask QuadraticMask::at(const Rational& number) const {
  std::vector<LatticeMask::Term> terms;
  const std::size_t size = components();
  for (const LatticeMask::Term& term : doubled.terms())
    if (term.column < size)
      terms.push_back({term.exponents, term.row % size, term.column,
                       term.row < size ? term.coefficient : number * term.coefficient});
  return matrix_mask(terms, size, doubled.dilation());
}

QuadraticMask quadratic_mask(const std::vector<QuadraticTerm>& terms, std::size_t size, long root,
                             const Dilation& dilation) {
  const Integer floor = sqrt(Integer(root < 0 ? 0 : root));
  require(root > 0 && floor * floor != root,
          "quadratic mask: need the root of a positive number that is no square, got {}", root);
  std::vector<LatticeMask::Term> doubled;
  for (const QuadraticTerm& term : terms) {
    require(term.row < size && term.column < size, "quadratic mask: need rows and columns below {}", size);
    for (const std::size_t half : {std::size_t{0}, size})
      doubled.push_back({term.exponents, half + term.row, half + term.column, term.rational});
    doubled.push_back({term.exponents, term.row, size + term.column, root * term.root});
    doubled.push_back({term.exponents, size + term.row, term.column, term.root});
  }
  return {root, matrix_mask(doubled, 2 * size, dilation)};
}

Rational rounded_root(long root, long bits) {
  const Rational unit = power(Rational(2), -bits);
  return unit * Rational(sqrt(numerator(Rational(root * power(Rational(4), bits)))));
}

}  // namespace subcert
