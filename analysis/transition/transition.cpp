#include "transition.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <type_traits>

namespace subcert {
namespace {

void add_product(double& sum, double a, double b) { sum += a * b; }

void add_product(Rational& sum, const Rational& a, const Rational& b) {
  if (b != 0) sum += a * b;
}

/// Adds factor * entries[0], ..., factor * entries[count-1].
template <class Number>
void add_multiple(Number* __restrict sums, const Number& factor, const Number* __restrict entries, long count) {
  if constexpr (!std::is_same_v<Number, double>)
    if (factor == 0) return;
  for (long i = 0; i < count; ++i) add_product(sums[i], factor, entries[i]);
}

}  // namespace

TransitionWindow::TransitionWindow(long given_degree, int given_arity)
    : degree(given_degree), arity(given_arity), width(std::max(1L, (degree + arity - 2) / (arity - 1))) {}

template <class Number>
Transition<Number>::Transition(const std::vector<Number>& coefficients, int arity)
    : window_(static_cast<long>(coefficients.size()) - 1, arity),
      cosets_(static_cast<std::size_t>(arity)),
      reversed_(coefficients.rbegin(), coefficients.rend()) {
  for (std::size_t i = 0; i < coefficients.size(); ++i) cosets_[i % cosets_.size()].push_back(coefficients[i]);
}

template <class Number>
void Transition<Number>::apply(long t, const Number* in, Number* out) const {
  std::fill(out, out + window_.width, Number(0));
  long residue = t, offset = 0;  // t - k = arity * offset + residue
  for (long k = 0; k < window_.width; ++k) {
    const std::vector<Number>& coset = cosets_[static_cast<std::size_t>(residue)];
    const long first = -offset, last = std::min(window_.width, static_cast<long>(coset.size()) - offset);
    add_multiple(out + first, in[k], coset.data(), last - first);
    if (--residue < 0) {
      residue = window_.arity - 1;
      --offset;
    }
  }
}

template <class Number>
void Transition<Number>::apply_transposed(long t, const Number* in, Number* out) const {
  std::fill(out, out + window_.width, Number(0));
  for (long j = 0; j < window_.width; ++j) {
    const IndexRange columns = window_.columns(t, j);
    const Number* entries = reversed_.data() + window_.degree - window_.index(t, j, columns.first);
    add_multiple(out + columns.first, in[j], entries, columns.last + 1 - columns.first);
  }
}

template class Transition<double>;
template class Transition<Integer>;
template class Transition<Rational>;

RationalMatrix transition_block(const LaurentPolynomial& symbol, int arity, long shift, const IndexRange& rows,
                                const IndexRange& columns) {
  const auto count = [](const IndexRange& range) {
    return static_cast<std::size_t>(std::max(0L, range.last - range.first + 1));
  };
  const std::vector<Rational> coefficients = symbol.coefficients();
  const long origin = arity * rows.first + shift - columns.first - (symbol.is_zero() ? 0 : symbol.lowest());
  RationalMatrix result(count(rows), count(columns));
  for (std::size_t j = 0; j < result.rows(); ++j)
    for (std::size_t k = 0; k < result.columns(); ++k) {
      const long index = origin + arity * static_cast<long>(j) - static_cast<long>(k);
      if (index >= 0 && index < static_cast<long>(coefficients.size()))
        result(j, k) = coefficients[static_cast<std::size_t>(index)];
    }
  return result;
}

std::vector<RationalMatrix> transition_matrices(const Mask& mask) {
  return transition_matrices(mask, TransitionWindow(mask.symbol().length() - 1, mask.arity()).width);
}

std::vector<RationalMatrix> transition_matrices(const Mask& mask, long width) {
  const LaurentPolynomial& symbol = mask.symbol();
  const IndexRange all{0, width - 1};
  std::vector<RationalMatrix> result;
  for (long t = 0; t < mask.arity(); ++t)
    result.push_back(transition_block(symbol, mask.arity(), symbol.lowest() + t, all, all));
  return result;
}

RationalMatrix central_matrix(const LaurentPolynomial& symbol, int arity) {
  require(!symbol.is_zero(), "central_matrix: need a symbol that is not zero, got 0");
  return central_matrix(symbol, arity, symbol.highest() / (arity - 1));
}

RationalMatrix central_matrix(const LaurentPolynomial& symbol, int arity, long reach) {
  require(symbol.reversed() == symbol, "central_matrix: need b(z) = b(1/z), got {}", symbol.to_text());
  const RationalMatrix both = transition_block(symbol, arity, 0, {0, reach}, {-reach, reach});
  const std::size_t centre = both.rows() - 1;
  RationalMatrix result(both.rows(), both.rows());
  for (std::size_t j = 0; j < both.rows(); ++j)
    for (std::size_t k = 0; k < both.rows(); ++k)
      result(j, k) = k == 0 ? both(j, centre) : Rational(both(j, centre + k) + both(j, centre - k));
  return result;
}

RefinementWindow::RefinementWindow(const Mask& mask)
    : first(floor_index(limit_support(mask).lower)),
      coefficients(static_cast<std::size_t>(mask.symbol().lowest() - (mask.arity() - 1) * first), 0) {
  for (const Rational& c : mask.symbol().coefficients()) coefficients.push_back(c);
}

}  // namespace subcert
