#include "limit_at_point.hpp"

#include <subcert/analysis/symbol/rational_matrix.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace subcert {
namespace {

constexpr std::size_t longest_orbit = 64, most_integers = 1500;

Integer floor_of(const Rational& x) { return to_integer(x, Rounding::down); }

/// The integers k with x + k in the closed support.
struct Shifts {
  long first;
  long last;
  std::size_t count() const { return static_cast<std::size_t>(std::max(0L, last - first + 1)); }
};

Shifts shifts(const Interval& support, const Rational& x) {
  return {-floor_of(x - support.lower).convert_to<long>(), floor_of(support.upper - x).convert_to<long>()};
}

/// phi(x + k) = sum over l of matrix(k, l) phi(y + l), where arity * x = m + y.
RationalMatrix step(const Mask& mask, const Interval& support, const Rational& x, const Rational& y) {
  const Shifts rows = shifts(support, x), columns = shifts(support, y);
  const long m = numerator(Rational(mask.arity() * x - y)).convert_to<long>();
  RationalMatrix result(rows.count(), columns.count());
  for (std::size_t k = 0; k < rows.count(); ++k)
    for (std::size_t l = 0; l < columns.count(); ++l)
      result(k, l) = mask.symbol().coefficient(m + mask.arity() * (rows.first + static_cast<long>(k)) - columns.first -
                                               static_cast<long>(l));
  return result;
}

/// The vector with sum 1 that the matrix keeps.
RationalMatrix fixed_vector(RationalMatrix matrix) {
  const std::size_t size = matrix.rows();
  for (std::size_t i = 0; i < size; ++i) matrix(i, i) -= 1;
  const auto fixed = kernel(matrix);
  Rational sum = 0;
  if (fixed.size() == 1)
    for (const Rational& value : fixed[0]) sum += value;
  if (sum == 0) throw std::domain_error("limit_values_at: the refinement equation does not determine the values");
  RationalMatrix result(size, 1);
  for (std::size_t i = 0; i < size; ++i) result(i, 0) = fixed[0][i] / sum;
  return result;
}

}  // namespace

ShiftedValues limit_values_at(const Mask& mask, const Rational& x) {
  const Interval support = limit_support(mask);
  if (shifts(support, 0).count() > most_integers)
    throw std::length_error("limit_values_at: need at most " + std::to_string(most_integers) +
                            " integers in the support, got " + std::to_string(shifts(support, 0).count()));
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
      throw std::length_error("limit_values_at: need a point with a cycle of at most " + std::to_string(longest_orbit) +
                              " points, got " + to_text(x));
    orbit.push_back(next);
  }
  const auto following = [&](std::size_t i) { return i + 1 < orbit.size() ? orbit[i + 1] : orbit[cycle]; };
  RationalMatrix product = RationalMatrix::identity(shifts(support, orbit[cycle]).count());
  for (std::size_t i = cycle; i < orbit.size(); ++i) product = product * step(mask, support, orbit[i], following(i));
  RationalMatrix values = fixed_vector(product);
  for (std::size_t i = cycle; i-- > 0;) values = step(mask, support, orbit[i], orbit[i + 1]) * values;
  ShiftedValues result{shifts(support, orbit[0]).first - floor_of(x).convert_to<long>(), {}};
  for (std::size_t i = 0; i < values.rows(); ++i) result.values.push_back(values(i, 0));
  return result;
}

}  // namespace subcert
