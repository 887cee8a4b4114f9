#include "curve_bounds.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/frequency/cell_recursion.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace subcert::theorems {
namespace {

using namespace frequency;

constexpr slong curve_bits = cell_bits;

/// The sum over all cells of f(j, i), each times its share of the measure of [-pi, pi].
template <class Function>
Ball mean_over_cells(const CellBounds& shells, const Function& f) {
  Ball sum(curve_bits);
  for (std::size_t j = 0; j <= shells.count; ++j)
    for (std::size_t i = 0; i < shells.cells; ++i)
      sum += f(j, i).scaled(-static_cast<slong>(j) - (j < shells.count ? 1 : 0));
  return sum / static_cast<long>(shells.cells);
}

/// The mean of psi by samples of the transform, widened by what their aliases can add; nothing if that is not bounded.
std::optional<Enclosure> sampled_mean(const HalfSymbol& symbol, const CellBounds& shells) {
  const std::optional<std::vector<Ball>> w = supersolution(products(shells, true).front(),
                                                           Recursion(shells, {.squared = true}));
  if (!w) return std::nullopt;
  const Cells squares = Recursion(shells, {.squared = true})(*w);
  const Ball pi = Ball::pi(curve_bits), near = Ball(1, curve_bits).scaled(-20);
  // The autocorrelation of phi lives on (-2r, 2r) with r the reach of the mask.
  const auto samples = static_cast<long>(std::bit_ceil(static_cast<unsigned long>(2 * symbol.reach()) + 1));
  std::vector<Ball> transform(static_cast<std::size_t>(samples / 2) + 1, Ball(1, curve_bits));
  Ball sum(1, curve_bits), aliases(curve_bits);
  for (long r = 1; r <= samples / 2; ++r) {
    Ball xi = pi * (2 * r) / samples, product(1, curve_bits);
    // Down to the sample at half the frequency, or to where the rest of the product is known well enough.
    do {
      xi = xi.scaled(-1);
      product *= symbol.value(xi);
    } while (r % 2 == 1 && !(symbol.flatness() * xi * xi).is_less(near));
    product *= r % 2 == 0 ? transform[static_cast<std::size_t>(r / 2)] : symbol.product_near_zero(xi);
    transform[static_cast<std::size_t>(r)] = product;
    const Ball share(r == samples / 2 ? 1 : 2, curve_bits);
    sum += share * product * product;
    // |xi| = pi 2^-j (1 - ...): the shell is found from r, the cell from what is left.
    std::size_t j = 0;
    while (((samples / 2) >> (j + 1)) >= r) ++j;
    // xi/(pi 2^(-j-1)) = 1 + fraction with 0 < fraction <= 1.
    const auto unit = static_cast<std::size_t>(samples / 2), scaled = static_cast<std::size_t>(r) << (j + 1);
    const std::size_t cell = ((scaled - unit) * shells.cells + unit - 1) / unit - 1;
    aliases += share * squares[std::min(j, shells.count)][cell];
  }
  // The frequencies 2 pi k, k not 0, contribute nothing.
  const Ball low = sum / samples, high = (sum + aliases) / samples;
  return Enclosure{low.enclosure().lower, high.enclosure().upper};
}

}  // namespace

CurveBounds curve_bounds(const Mask& mask, int cells) {
  require(cells >= 1 && std::has_single_bit(static_cast<unsigned>(cells)),
          "curve_bounds: need a power of two for cells, got {}", cells);
  const HalfSymbol symbol(mask, curve_bits);
  const CellBounds shells = bounds_on_cells(symbol, static_cast<std::size_t>(cells));
  CurveBounds result{Enclosure::at_least(0), Enclosure::at_least(0), Enclosure::at_least(0)};
  const Cells X = products(shells, false);
  const Recursion plain(shells, {}), frequencies(shells, {.frequencies = true});
  const std::optional<std::vector<Ball>> w = supersolution(X.front(), plain);
  if (!w) return result;
  constexpr double exact_means = 32;  // below this reach an exact solution is cheap, and the aliases are not small
  const std::optional<Enclosure> sampled = symbol.reach() > exact_means ? sampled_mean(symbol, shells) : std::nullopt;
  result.mean = sampled ? *sampled : Enclosure::exactly(squared_l2_norm(mask));
  const Cells Y = plain(*w);
  result.ripple.upper = mean_over_cells(shells,
                                        [&](std::size_t j, std::size_t i) {
                                          return (X[j][i] * Y[j][i]).scaled(1) + Y[j][i] * Y[j][i];
                                        })
                            .enclosure()
                            .upper;
  const std::optional<std::vector<Ball>> v = supersolution(X.front(), frequencies);
  if (!v) return result;
  const Cells Z = frequencies(*v);
  const Ball pi = Ball::pi(curve_bits);
  result.slope.upper = mean_over_cells(shells,
                                       [&](std::size_t j, std::size_t i) {
                                         const Ball end = (pi * static_cast<long>(shells.cells + i + 1) /
                                                           static_cast<long>(shells.cells))
                                                              .scaled(-static_cast<slong>(j));
                                         return end * (X[j][i] * Y[j][i] + Z[j][i] * X[j][i] + Z[j][i] * Y[j][i]);
                                       })
                           .enclosure()
                           .upper;
  return result;
}

}  // namespace subcert::theorems
