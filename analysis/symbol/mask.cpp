#include "mask.hpp"

#include "error.hpp"
#include "index_arithmetic.hpp"

#include <algorithm>

namespace subcert {

Mask::Mask(LaurentPolynomial symbol, int arity) : symbol_(std::move(symbol)), arity_(arity) {
  require(arity >= 2, "mask: need arity >= 2, got {}", arity);
  require(!symbol_.is_zero(), "mask: need at least one non-zero coefficient");
}

MultivariateMask::MultivariateMask(MultivariatePolynomial symbol, Dilation dilation)
    : symbol_(std::move(symbol)), dilation_(std::move(dilation)) {
  require(!symbol_.is_zero(), "mask: need at least one non-zero coefficient");
  require(static_cast<int>(dilation_.variables()) == symbol_.variables(),
          "mask: need a dilation of {} rows, as many as variables, got {}", symbol_.variables(), dilation_.variables());
}

MultivariateMask::MultivariateMask(const MultivariatePolynomial& symbol, int arity)
    : MultivariateMask(symbol, Dilation::multiple(symbol.variables(), arity)) {}

int MultivariateMask::arity() const {
  const std::optional<int> factor = dilation_.factor();
  require(factor.has_value() && *factor > 0, "mask: need a dilation that is a multiple of the identity, got {}",
          dilation_.to_text());
  return *factor;
}

MultivariateMask tensor_product(const std::vector<Mask>& masks) {
  std::vector<LaurentPolynomial> symbols;
  std::vector<LatticePoint> rows;
  for (const Mask& mask : masks) {
    rows.emplace_back(masks.size(), 0)[symbols.size()] = mask.arity();
    symbols.push_back(mask.symbol());
  }
  return {MultivariatePolynomial::tensor_product(symbols), Dilation(std::move(rows))};
}

std::vector<Rational> coset_sums(const Mask& mask) {
  std::vector<Rational> sums(static_cast<std::size_t>(mask.arity()), 0);
  long index = mask.symbol().lowest();
  for (const Rational& c : mask.symbol().coefficients()) {
    const long residue = modulo(index++, mask.arity());
    sums[static_cast<std::size_t>(residue)] += c;
  }
  return sums;
}

std::vector<Rational> coset_sums(const MultivariateMask& mask) {
  std::vector<Rational> sums(mask.dilation().digits().size(), 0);
  for (const auto& term : mask.symbol().terms()) sums[mask.dilation().divide(term.exponents).digit] += term.coefficient;
  return sums;
}

bool is_affine(const Mask& mask) {
  const auto sums = coset_sums(mask);
  return std::all_of(sums.begin(), sums.end(), [](const Rational& sum) { return sum == 1; });
}

LaurentPolynomial common_factor_of_cosets(const Mask& mask) {
  LaurentPolynomial common = mask.symbol().coset(mask.arity(), 0);
  for (int residue = 1; residue < mask.arity(); ++residue)
    common = gcd(common, mask.symbol().coset(mask.arity(), residue));
  return common;
}

IndexRange support(const Mask& mask) { return {mask.symbol().lowest(), mask.symbol().highest()}; }

Interval limit_support(const Mask& mask) {
  const IndexRange range = support(mask);
  return {Rational(range.first, mask.arity() - 1), Rational(range.last, mask.arity() - 1)};
}

SymmetryReport symmetry(const Mask& mask) {
  const IndexRange range = support(mask);
  const long twice_centre = range.first + range.last;
  if (!(mask.symbol().reversed().shifted(twice_centre) == mask.symbol())) return {Symmetry::none, 0};
  return {twice_centre % 2 == 0 ? Symmetry::odd : Symmetry::even, Rational(twice_centre, 2)};
}

}  // namespace subcert
