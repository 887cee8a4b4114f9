#include "mask.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

RationalMatrix inverse_of(const Dilation& dilation) {
  const std::size_t size = dilation.variables();
  RationalMatrix inverse(size, size);
  for (std::size_t j = 0; j < size; ++j) {
    std::vector<Rational> unit(size, 0);
    unit[j] = 1;
    const std::vector<Rational> column = dilation.inverse_times(unit);
    for (std::size_t i = 0; i < size; ++i) inverse(i, j) = column[i];
  }
  return inverse;
}

/// The box of the images of the exponents.
std::vector<Interval> box_of_support(const std::vector<LatticeMask::Term>& terms, const RationalMatrix& matrix) {
  std::vector<std::optional<Interval>> box(matrix.rows());
  for (const LatticeMask::Term& term : terms) {
    const std::vector<Rational> point = matrix * std::vector<Rational>(term.exponents.begin(), term.exponents.end());
    for (std::size_t v = 0; v < box.size(); ++v)
      box[v] = box[v] ? Interval{std::min(box[v]->lower, point[v]), std::max(box[v]->upper, point[v])}
                      : Interval::exactly(point[v]);
  }
  std::vector<Interval> result;
  for (const auto& side : box) result.push_back(*side);
  return result;
}

bool is_positive_diagonal(const RationalMatrix& matrix) {
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.rows(); ++j)
      if (i == j ? matrix(i, j) <= 0 : matrix(i, j) != 0) return false;
  return true;
}

/// Where x = s + y lies, with s in the box and y smaller than x by this norm: rounded outward.
std::vector<Interval> widened(std::vector<Interval> box, const Rational& norm) {
  const Rational million = 1'000'000;
  Rational reach = 0;
  for (const Interval& side : box) reach = std::max({reach, Rational(abs(side.lower)), Rational(abs(side.upper))});
  const Rational rest = reach * norm / (1 - norm);
  for (Interval& side : box)
    side = {Rational(to_integer((side.lower - rest) * million, Rounding::down)) / million,
            Rational(to_integer((side.upper + rest) * million, Rounding::up)) / million};
  return box;
}

}  // namespace

Mask::Mask(LaurentPolynomial symbol, int arity) : symbol_(std::move(symbol)), arity_(arity) {
  require(arity >= 2, "mask: need arity >= 2, got {}", arity);
  require(!symbol_.is_zero(), "mask: need at least one non-zero coefficient");
}

LatticeMask::LatticeMask(MultivariatePolynomial symbol, Dilation dilation)
    : LatticeMask(std::vector{std::move(symbol)}, std::move(dilation)) {}

LatticeMask::LatticeMask(std::vector<MultivariatePolynomial> entries, Dilation dilation)
    : entries_(std::move(entries)), components_(0), dilation_(std::move(dilation)) {
  while (components_ * components_ < entries_.size()) ++components_;
  require(components_ > 0 && components_ * components_ == entries_.size(), "mask: need square matrices, got {} entries",
          entries_.size());
  require(!std::ranges::all_of(entries_, &MultivariatePolynomial::is_zero),
          "mask: need at least one non-zero coefficient");
  for (const MultivariatePolynomial& entry : entries_)
    require(static_cast<int>(dilation_.variables()) == entry.variables(),
            "mask: need a dilation of {} rows, as many as variables, got {}", entry.variables(), dilation_.variables());
  std::vector<Term> terms;
  for (std::size_t at = 0; at < entries_.size(); ++at)
    for (Monomial& term : entries_[at].terms())
      terms.push_back({std::move(term.exponents), at / components_, at % components_, std::move(term.coefficient)});
  terms_ = std::make_shared<const std::vector<Term>>(std::move(terms));
}

const MultivariatePolynomial& LatticeMask::symbol() const {
  require(components_ == 1, "mask: need a mask of numbers, got matrices of {} rows", components_);
  return entries_.front();
}

LatticeMask::LatticeMask(const MultivariatePolynomial& symbol, int arity)
    : LatticeMask(symbol, Dilation::multiple(symbol.variables(), arity)) {}

LatticeMask::LatticeMask(const Mask& mask) : LatticeMask(tensor_product({mask})) {}

int LatticeMask::arity() const {
  const std::optional<int> factor = dilation_.factor();
  require(factor.has_value() && *factor > 0, "mask: need a dilation that is a multiple of the identity, got {}",
          dilation_.to_text());
  return *factor;
}

const Mask& LatticeMask::curve() const& {
  require(factors_.size() == 1, "mask: need a mask of one variable, got {} variables", dimension());
  return factors_.front();
}

LatticeMask tensor_product(const std::vector<Mask>& masks) {
  std::vector<LaurentPolynomial> symbols;
  std::vector<LatticePoint> rows;
  Rational scale = 1;
  for (const Mask& mask : masks) {
    rows.emplace_back(masks.size(), 0)[symbols.size()] = mask.arity();
    symbols.push_back(mask.symbol());
    const Rational sum = mask.symbol()(1) / mask.arity();
    if (symbols.size() == 1 || sum == 0 || sum == 1) continue;
    symbols.back() *= LaurentPolynomial(1 / sum);
    scale *= sum;
  }
  if (scale != 1) symbols.front() *= LaurentPolynomial(scale);
  LatticeMask product(MultivariatePolynomial::tensor_product(symbols), Dilation(std::move(rows)));
  for (std::size_t v = 0; v < masks.size(); ++v) product.factors_.emplace_back(symbols[v], masks[v].arity());
  return product;
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

std::vector<Rational> coset_sums(const LatticeMask& mask) {
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

std::vector<Interval> limit_support(const LatticeMask& mask) {
  // The support lies in the sum of M^-n supp(a) over n >= 1. After the power that is diagonal the terms are those of
  // the first round, divided by its entries, or, where there is none, smaller than a part of a box around them.
  constexpr int longest_period = 24;
  const RationalMatrix inverse = inverse_of(mask.dilation());
  const std::vector<LatticeMask::Term>& terms = mask.terms();
  std::vector<Interval> sums(inverse.rows(), Interval::exactly(0));
  RationalMatrix power = RationalMatrix::identity(inverse.rows());
  for (int n = 1;; ++n) {
    power = power * inverse;
    const std::vector<Interval> box = box_of_support(terms, power);
    for (std::size_t v = 0; v < box.size(); ++v) sums[v] = sums[v] + box[v];
    if (is_positive_diagonal(power)) {
      for (std::size_t v = 0; v < box.size(); ++v) sums[v] = sums[v] * (1 / (1 - power(v, v)));
      return sums;
    }
    if (n < longest_period) continue;
    const Rational norm = one_norm(transposed(power));
    if (norm < Rational(1, 1000)) return widened(std::move(sums), norm);
  }
}

SymmetryReport symmetry(const Mask& mask) {
  const IndexRange range = support(mask);
  const long twice_centre = range.first + range.last;
  if (!(mask.symbol().reversed().shifted(twice_centre) == mask.symbol())) return {Symmetry::none, 0};
  return {twice_centre % 2 == 0 ? Symmetry::odd : Symmetry::even, Rational(twice_centre, 2)};
}

}  // namespace subcert
