#include "limit_values.hpp"

#include "fixed_vector.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr long max_integers = 1500;
constexpr long max_values = 10'000'000;

/// The points of Z / scale in the closed support of phi, times scale.
IndexRange grid_in_support(const Mask& mask, long scale) {
  const Interval support = limit_support(mask);
  return {ceil_index(support.lower * scale), floor_index(support.upper * scale)};
}

/// sum over the integers k of phi(k) z^k.
LaurentPolynomial values_at_integers(const Mask& mask, const Deadline& deadline) {
  const IndexRange integers = grid_in_support(mask, 1);
  const long size = integers.last - integers.first + 1;
  if (size > max_integers)
    fail(ErrorKind::size, "limit_values: need at most {} integers in the support, got {}", max_integers, size);
  require(size >= 1, "limit_values: the support contains no integer");
  // phi(k) = sum over j of a_{arity*k - j} phi(j).
  const auto values = fixed_vector(transition_block(mask.symbol(), mask.arity(), 0, integers, integers), 1, deadline);
  require(values.has_value(),
          "limit_values: the values at the integers are not determined by the refinement equation; "
          "the divided difference scheme of this order does not converge");
  return {*values, integers.first};
}

void require_time(bool enough, int level) {
  if (!enough) fail(ErrorKind::undecided, "the exact values on level {} take more than the budget", level);
}

}  // namespace

Rational LimitValues::at(long index) const {
  const long i = index - first_index;
  return i < 0 || i >= static_cast<long>(values.size()) ? Rational(0) : values[static_cast<std::size_t>(i)];
}

Rational LimitValues::point(std::size_t i) const {
  return Rational(first_index + static_cast<long>(i)) * power(Rational(arity), -level);
}

LimitValues limit_values(const Mask& mask, int level, int order, const Deadline& deadline) {
  require(level >= 0, "limit_values: need level >= 0, got {}", level);
  require(order >= 0, "limit_values: need order >= 0, got {}", order);
  long scale = 1;
  for (int k = 0; k < level; ++k) {
    scale *= mask.arity();
    if (mask.symbol().length() * scale > max_values)
      fail(ErrorKind::size, "limit_values: need at most 10^7 values, got level {} for a mask of length {}", level,
           mask.symbol().length());
  }
  const Mask derived = divided_difference_scheme(mask, order);
  // V_{k+1}(z) = a(z^(arity^k)) V_k(z), where V_k holds the values at level k.
  LaurentPolynomial values = values_at_integers(derived, deadline);
  long factor = 1;
  double seconds = 0;  // of the level before, of which a level takes the arity as many
  for (int k = 0; k < level; ++k, factor *= mask.arity()) {
    require_time(seconds * mask.arity() < deadline.remaining(), level);
    const Stopwatch watch;
    values *= derived.symbol().dilated(factor);
    seconds = watch.seconds();
  }
  // phi^(order) is the backward difference of that order, at unit steps, of the derived basic limit function.
  const LaurentPolynomial difference = LaurentPolynomial(1) - LaurentPolynomial::monomial(1, scale);
  values *= difference.pow(order);

  const auto [first, last] = grid_in_support(mask, scale);
  LimitValues result{mask.arity(), level, order, first,
                     std::vector<Rational>(static_cast<std::size_t>(last - first + 1), 0)};
  if (values.is_zero()) return result;
  for (long index = std::max(first, values.lowest()); index <= std::min(last, values.highest()); ++index) {
    require_time(!deadline.expired(), level);
    result.values[static_cast<std::size_t>(index - first)] = values.coefficient(index);
  }
  return result;
}

std::vector<Rational> l2_inner_products(const Mask& mask, const Deadline& deadline) {
  const LaurentPolynomial c = mask.symbol() * mask.symbol().reversed() * LaurentPolynomial(Rational(1, mask.arity()));
  const long last = (c.highest() - 1) / (mask.arity() - 1);  // continuous, so zero at the ends of the support
  if (last > max_integers)
    fail(ErrorKind::size, "l2_inner_products: need at most {} integers in half the support, got {}", max_integers,
         last);
  // w_k = sum over j of c_{arity*k - j} w_j, with w_{-j} = w_j, and the sum of all w_j is 1.
  auto products = fixed_vector(central_matrix(c, mask.arity(), last), 2, deadline);
  require(products.has_value(),
          "l2_inner_products: not determined by the refinement equation; the scheme does not converge");
  return std::move(*products);
}

Rational squared_l2_norm(const Mask& mask, const Deadline& deadline) {
  return l2_inner_products(mask, deadline).front();
}

}  // namespace subcert
