#include "limit_values.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/rational_matrix.hpp>

#include <algorithm>
#include <stdexcept>

namespace subcert {
namespace {

constexpr long max_integers = 1500;
constexpr long max_values = 10'000'000;

long ceil_div(long a, long b) { return a >= 0 ? (a + b - 1) / b : -(-a / b); }
long floor_div(long a, long b) { return -ceil_div(-a, b); }

/// sum over the integers k of phi(k) z^k.
LaurentPolynomial values_at_integers(const Mask& mask) {
  const IndexRange range = support(mask);
  const long first = ceil_div(range.first, mask.arity() - 1), last = floor_div(range.last, mask.arity() - 1);
  const long size = last - first + 1;
  if (size > max_integers)
    throw std::length_error("limit_values: need at most " + std::to_string(max_integers) +
                            " integers in the support, got " + std::to_string(size));
  if (size < 1) throw std::domain_error("limit_values: the support contains no integer");
  // phi(k) = sum over j of a_{arity*k - j} phi(j).
  const auto n = static_cast<std::size_t>(size);
  RationalMatrix matrix(n, n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      matrix(k, j) = mask.symbol().coefficient(mask.arity() * (first + static_cast<long>(k)) - first -
                                               static_cast<long>(j)) -
                     (k == j ? 1 : 0);
  const auto basis = kernel(matrix);
  Rational sum = 0;
  if (basis.size() == 1)
    for (const Rational& x : basis.front()) sum += x;
  if (sum == 0)
    throw std::domain_error(
        "limit_values: the values at the integers are not determined by the refinement equation; "
        "the divided difference scheme of this order does not converge");
  return LaurentPolynomial(basis.front(), first) * LaurentPolynomial(1 / sum);
}

}  // namespace

Rational LimitValues::at(long index) const {
  const long i = index - first_index;
  return i < 0 || i >= static_cast<long>(values.size()) ? Rational(0) : values[static_cast<std::size_t>(i)];
}

Rational LimitValues::point(std::size_t i) const {
  return Rational(first_index + static_cast<long>(i)) * power(Rational(arity), -level);
}

LimitValues limit_values(const Mask& mask, int level, int order) {
  if (level < 0) throw std::invalid_argument("limit_values: need level >= 0, got " + std::to_string(level));
  if (order < 0) throw std::invalid_argument("limit_values: need order >= 0, got " + std::to_string(order));
  long scale = 1;
  for (int k = 0; k < level; ++k) {
    scale *= mask.arity();
    if (mask.symbol().length() * scale > max_values)
      throw std::length_error("limit_values: need at most 10^7 values, got level " + std::to_string(level) +
                              " for a mask of length " + std::to_string(mask.symbol().length()));
  }
  const Mask derived = divided_difference_scheme(mask, order);
  // V_{k+1}(z) = a(z^(arity^k)) V_k(z), where V_k holds the values at level k.
  LaurentPolynomial values = values_at_integers(derived);
  LaurentPolynomial power_of_symbol = LaurentPolynomial(1);
  long factor = 1;
  for (int k = 0; k < level; ++k, factor *= mask.arity()) power_of_symbol *= derived.symbol().dilated(factor);
  values *= power_of_symbol;
  // phi^(order) is the backward difference of that order, at unit steps, of the derived basic limit function.
  const LaurentPolynomial difference = LaurentPolynomial(1) - LaurentPolynomial::monomial(1, scale);
  values *= difference.pow(order);

  const IndexRange range = support(mask);
  const long first = ceil_div(range.first * scale, mask.arity() - 1);
  const long last = floor_div(range.last * scale, mask.arity() - 1);
  LimitValues result{mask.arity(), level, order, first,
                     std::vector<Rational>(static_cast<std::size_t>(last - first + 1), 0)};
  if (values.is_zero()) return result;
  long index = values.lowest();
  for (const Rational& value : values.coefficients()) {
    if (index >= first && index <= last) result.values[static_cast<std::size_t>(index - first)] = value;
    ++index;
  }
  return result;
}

std::vector<Rational> l2_inner_products(const Mask& mask) {
  const LaurentPolynomial c = mask.symbol() * mask.symbol().reversed() * LaurentPolynomial(Rational(1, mask.arity()));
  const long last = (c.highest() - 1) / (mask.arity() - 1);  // continuous, so zero at the ends of the support
  if (last > max_integers)
    throw std::length_error("l2_inner_products: need at most " + std::to_string(max_integers) +
                            " integers in half the support, got " + std::to_string(last));
  // w_k = sum over j of c_{arity*k - j} w_j, with w_{-j} = w_j.
  const auto n = static_cast<std::size_t>(last) + 1;
  RationalMatrix matrix(n, n);
  for (long k = 0; k <= last; ++k)
    for (long j = 0; j <= last; ++j) {
      Rational entry = c.coefficient(mask.arity() * k - j);
      if (j > 0) entry += c.coefficient(mask.arity() * k + j);
      matrix(static_cast<std::size_t>(k), static_cast<std::size_t>(j)) = entry - (k == j ? 1 : 0);
    }
  const auto basis = kernel(matrix);
  Rational sum = 0;
  if (basis.size() == 1) {
    for (const Rational& x : basis.front()) sum += 2 * x;
    sum -= basis.front().front();
  }
  if (sum == 0)
    throw std::domain_error(
        "l2_inner_products: not determined by the refinement equation; the scheme does not converge");
  std::vector<Rational> products = basis.front();
  for (Rational& x : products) x /= sum;
  return products;
}

Rational squared_l2_norm(const Mask& mask) { return l2_inner_products(mask).front(); }

}  // namespace subcert
