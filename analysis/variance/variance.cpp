#include "variance.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/numbers/scaled_numbers.hpp>

#include <algorithm>

namespace subcert {
namespace {

/// sum over j of f(x - j) g(x - j) on the grid of one period, ends included, times `factor`.
std::vector<Rational> periodised_product(const LimitValues& f, const ScaledNumbers& values_f,
                                         const ScaledNumbers& values_g, long scale, int factor) {
  std::vector<Integer> sums(static_cast<std::size_t>(scale) + 1, 0);
  for (std::size_t i = 0; i < values_f.numerators.size(); ++i) {
    const long index = f.first_index + static_cast<long>(i);
    add_product(sums[static_cast<std::size_t>(modulo(index, scale))], values_f.numerators[i], values_g.numerators[i]);
  }
  sums.back() = sums.front();
  const Integer denominator = values_f.denominator * values_g.denominator;
  std::vector<Rational> result;
  for (const Integer& sum : sums) result.emplace_back(sum * factor, denominator);
  return result;
}

}  // namespace

const Rational& VarianceGrid::largest() const { return *std::max_element(values.begin(), values.end()); }

const Rational& VarianceGrid::smallest() const { return *std::min_element(values.begin(), values.end()); }

Rational VarianceGrid::steepest() const {
  Rational result = 0;
  for (const Rational& slope : slopes) result = std::max(result, Rational(abs(slope)));
  for (std::size_t i = 1; i < values.size(); ++i)
    result = std::max(result, Rational(abs(values[i] - values[i - 1]) / step()));
  return result;
}

VarianceGrid variance_grid(const Mask& mask, int level, bool differentiable, const Deadline& deadline) {
  const LimitValues phi = limit_values(mask, level, 0, deadline);
  const long scale = numerator(power(Rational(mask.arity()), level)).convert_to<long>();
  const ScaledNumbers values(phi.values);
  VarianceGrid grid{mask.arity(), level, periodised_product(phi, values, values, scale, 1), {}};
  if (differentiable)
    grid.slopes = periodised_product(phi, values, ScaledNumbers(limit_values(mask, level, 1, deadline).values), scale,
                                     2);
  return grid;
}

Rational variance_floor(const Mask& mask) {
  const Interval range = limit_support(mask);
  // The open interval of this length meets at most ceil(length) shifted copies of a point.
  return 1 / Rational(std::max(Integer(1), to_integer(range.upper - range.lower, Rounding::up)));
}

std::optional<Rational> variance_ceiling(const Mask& mask) {
  const auto coefficients = mask.symbol().coefficients();
  if (std::any_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c < 0; }))
    return std::nullopt;
  return Rational(1);
}

}  // namespace subcert
