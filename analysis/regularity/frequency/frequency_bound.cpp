#include "frequency_bound.hpp"

#include "cell_recursion.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <bit>
#include <cmath>

namespace subcert {
namespace {

using namespace frequency;

/// The least excess with a spectral radius below 1, by bisection of its logarithm; nothing beyond 2^k - 1, where
/// the exponent would not be positive.
std::optional<double> least_excess(const CellBounds& shells) {
  const Recursion recursion(shells, {false, shells.sum_rules, 1});
  double low = -290, high = shells.sum_rules * std::log10(2.0);
  const auto excess = [](double power) { return std::pow(10.0, power); };
  const std::vector<double> first(shells.cells, 1);
  const auto is_enough = [&](double power) { return fixed_point(recursion.matrix(excess(power)), first).has_value(); };
  if (!is_enough(high)) return std::nullopt;
  while (high - low > 1e-4) {
    const double middle = (low + high) / 2;
    (is_enough(middle) ? high : low) = middle;
  }
  return excess(high);
}

/// A little more, to three digits, so that the supersolution has room.
Rational rounded_up(double excess) {
  return parse_decimal(to_decimal(Rational(excess * 1.003), 3, Rounding::up))->value;
}

}  // namespace

bool has_frequency_bound(const Mask& mask) {
  return mask.arity() == 2 && is_affine(mask) && symmetry(mask).kind != Symmetry::none && sum_rules(mask) >= 2;
}

std::optional<FrequencyBound> frequency_bound(const Mask& mask, int cells) {
  require(cells >= 1 && std::has_single_bit(static_cast<unsigned>(cells)),
          "frequency_bound: need a power of two for cells, got {}", cells);
  const HalfSymbol symbol(mask, cell_bits);
  const CellBounds shells = bounds_on_cells(symbol, static_cast<std::size_t>(cells), NearPi::relative);
  const std::optional<double> least = least_excess(shells);
  if (!least) return std::nullopt;
  const Rational excess = rounded_up(*least);
  const std::vector<Ball> one(shells.cells, Ball(1, cell_bits));
  if (!supersolution(one, Recursion(shells, {false, shells.sum_rules, excess}))) return std::nullopt;
  const Ball exponent = shells.sum_rules - log2(Ball(Rational(1 + excess), cell_bits));
  return FrequencyBound{shells.sum_rules, excess, *exponent.enclosure().lower, cells};
}

}  // namespace subcert
