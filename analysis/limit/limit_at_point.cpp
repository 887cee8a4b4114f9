#include "limit_at_point.hpp"

#include "fixed_vector.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>
#include <utility>

namespace subcert {
namespace {

constexpr std::size_t longest_orbit = 64;
constexpr long most_integers = 1500;

Integer floor_of(const Rational& x) { return to_integer(x, Rounding::down); }

/// The integers k with x + k in the closed support.
IndexRange shifts(const Interval& support, const Rational& x) {
  return {-floor_of(x - support.lower).convert_to<long>(), floor_of(support.upper - x).convert_to<long>()};
}

/// phi(x + k) = sum over l of matrix(k, l) phi(y + l), where arity * x = m + y.
RationalMatrix step(const Mask& mask, const Interval& support, const Rational& x, const Rational& y) {
  const long m = numerator(Rational(mask.arity() * x - y)).convert_to<long>();
  return transition_block(mask.symbol(), mask.arity(), m, shifts(support, x), shifts(support, y));
}

}  // namespace

ShiftedValues limit_values_at(const Mask& mask, const Rational& x, const Deadline& deadline) {
  const Interval support = limit_support(mask);
  const IndexRange integers = shifts(support, 0);
  if (integers.last - integers.first >= most_integers)
    fail(ErrorKind::size, "limit_values: need at most {} integers in the support, got {}", most_integers,
         integers.last - integers.first + 1);
  std::vector<Rational> orbit{x - Rational(floor_of(x))};
  std::size_t cycle = 0;  // orbit[cycle], ... repeat
  for (;;) {
    const Rational scaled = mask.arity() * orbit.back();
    const Rational next = scaled - Rational(floor_of(scaled));
    const auto seen = std::find(orbit.begin(), orbit.end(), next);
    if (seen != orbit.end()) {
      cycle = static_cast<std::size_t>(seen - orbit.begin());
      break;
    }
    if (orbit.size() == longest_orbit)
      fail(ErrorKind::size, "limit_values: need a point with a cycle of at most {} points, got {}", longest_orbit,
           to_text(x));
    orbit.push_back(next);
  }
  const auto following = [&](std::size_t i) { return i + 1 < orbit.size() ? orbit[i + 1] : orbit[cycle]; };
  RationalMatrix product = step(mask, support, orbit[cycle], following(cycle));
  for (std::size_t i = cycle + 1; i < orbit.size(); ++i)
    product = product * step(mask, support, orbit[i], following(i));
  auto values = fixed_vector(std::move(product), 1, deadline);
  require(
      values.has_value(),
      "limit_values: the values are not determined by the refinement equation; the scheme, or the divided difference "
      "scheme of this order, does not converge");
  for (std::size_t i = cycle; i-- > 0;) *values = step(mask, support, orbit[i], orbit[i + 1]) * *values;
  return {shifts(support, orbit[0]).first - floor_of(x).convert_to<long>(), std::move(*values)};
}

}  // namespace subcert
