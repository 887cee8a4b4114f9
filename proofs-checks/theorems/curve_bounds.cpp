#include "curve_bounds.hpp"

#include "symbol_cells.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace subcert::theorems {
namespace {

constexpr slong curve_bits = 128;

/// A number for each cell (j, i), and one more row for what all shells beyond the last contribute.
using Cells = std::vector<std::vector<Ball>>;

/// The cell of shell 0 that holds xi/2 + pi, modulo 2 pi, for xi in the cell (j, i).
std::size_t image(std::size_t j, std::size_t i, std::size_t cells) {
  // floor of cells - (cells + i + 1)/2^(j+1)
  const std::size_t unit = std::size_t{1} << (j + 1);
  return cells - (cells + i + unit) / unit;
}

/// x, e on the cells of the first shells; beyond them |m| <= 1 + b, |m(. + pi)| <= b with b = flatness (pi 2^(-j-1))^2.
struct CellBounds {
  std::size_t count, cells;
  Cells x, e;
  Ball beyond;  ///< the sum of b over the shells beyond
};

CellBounds bounds_on_cells(const HalfSymbol& symbol, std::size_t cells) {
  const Ball pi = Ball::pi(curve_bits);
  // So many shells that the sum of 2^j b over the shells beyond is about 2^-14.
  const double count = std::max(1.0, std::log2(symbol.flatness().middle()) + 18);
  CellBounds result{static_cast<std::size_t>(count), cells, {}, {}, Ball(curve_bits)};
  for (std::size_t j = 0; j < result.count; ++j) {
    const Ball low = pi.scaled(-static_cast<slong>(j) - 2);
    std::vector<Ball> x, e;
    for (const HalfSymbol::Suprema& one : symbol.suprema(low, low.scaled(1), static_cast<int>(cells))) {
      x.push_back(one.plain);
      e.push_back(one.alias);
    }
    result.x.push_back(std::move(x));
    result.e.push_back(std::move(e));
  }
  result.beyond = symbol.flatness() * pi * pi.scaled(-2 * static_cast<slong>(result.count)) / 3;
  return result;
}

/// X_ji.
Cells products(const CellBounds& shells, bool squared) {
  Cells result(shells.count + 1, std::vector<Ball>(shells.cells, exp(shells.beyond.scaled(squared ? 1 : 0))));
  for (std::size_t j = shells.count; j-- > 0;)
    for (std::size_t i = 0; i < shells.cells; ++i) {
      const Ball& x = shells.x[j][i];
      result[j][i] = (squared ? x * x : x) * result[j + 1][i];
    }
  return result;
}

/// The three recursions of Proposition 1: of the aliases, of their squares, of the aliases times their frequencies.
enum class Sum { plain, squares, frequencies };

/// Y_ji(w), E_ji(w) or Z_ji(w).
class Recursion {
 public:
  Recursion(const CellBounds& shells, Sum sum) : shells_(shells), sum_(sum) {}

  Cells operator()(const std::vector<Ball>& w) const {
    Ball largest = w.front();
    for (const Ball& one : w) largest = max(largest, one);
    Cells result(shells_.count + 1, std::vector<Ball>(shells_.cells, beyond() * largest));
    for (std::size_t j = shells_.count; j-- > 0;)
      for (std::size_t i = 0; i < shells_.cells; ++i)
        result[j][i] = alias(j, i) * w[image(j, i, shells_.cells)] + plain(j, i) * result[j + 1][i];
    return result;
  }

  /// What the shells beyond the last add where w = 1: their b fall by 4, and the ratios of ends are at most 2.
  Ball beyond() const {
    const Ball& b = shells_.beyond;
    if (sum_ == Sum::plain) return b * exp(b);
    if (sum_ == Sum::squares) return b * b * exp(b.scaled(1));
    return (b * exp(b)).scaled(static_cast<slong>(shells_.count) + 3);
  }
  /// The matrix of w -> value on shell 0, near enough for a search.
  std::vector<std::vector<double>> matrix() const {
    std::vector<std::vector<double>> result(shells_.cells, std::vector<double>(shells_.cells, 0));
    for (std::size_t i = 0; i < shells_.cells; ++i) {
      double product = 1;
      for (std::size_t j = 0; j < shells_.count; ++j) {
        result[i][image(j, i, shells_.cells)] += product * alias(j, i).middle();
        product *= plain(j, i).middle();
      }
    }
    return result;
  }

 private:
  Ball plain(std::size_t j, std::size_t i) const {
    const Ball& x = shells_.x[j][i];
    return sum_ == Sum::squares ? x * x : x;
  }
  Ball alias(std::size_t j, std::size_t i) const {
    const Ball& e = shells_.e[j][i];
    if (sum_ == Sum::plain) return e;
    if (sum_ == Sum::squares) return e * e;
    // 2^(j+1) times the ratio of the ends of the cells.
    const auto cells = static_cast<long>(shells_.cells), to = static_cast<long>(image(j, i, shells_.cells));
    return (e * (cells + to + 1) / (cells + static_cast<long>(i) + 1)).scaled(static_cast<slong>(j) + 1);
  }
  const CellBounds& shells_;
  Sum sum_;
};

/// w > 0 with X_0i + Y_0i(w) <= w_i for all i: floating point proposes it, balls prove it.
std::optional<std::vector<Ball>> supersolution(const std::vector<Ball>& first, const Recursion& recursion) {
  const std::size_t size = first.size();
  const auto matrix = recursion.matrix();
  const double beyond = recursion.beyond().middle();
  constexpr double slack = 1.0001;
  constexpr int rounds = 4000;
  std::vector<double> w(size, 0);
  for (int round = 0; round < rounds; ++round) {
    double change = 0;
    const double largest = *std::max_element(w.begin(), w.end());
    for (std::size_t i = 0; i < size; ++i) {
      double sum = slack * (first[i].middle() + beyond * largest);
      for (std::size_t k = 0; k < size; ++k) sum += matrix[i][k] * w[k];
      change = std::max(change, std::abs(sum - w[i]) / sum);
      w[i] = sum;
    }
    if (change < 1e-12) break;
  }
  std::vector<Ball> result;
  for (double one : w) {
    if (!std::isfinite(one)) return std::nullopt;
    result.emplace_back(Rational(one), curve_bits);
  }
  const Cells value = recursion(result);
  for (std::size_t i = 0; i < size; ++i)
    if (!(first[i] + value.front()[i]).is_at_most(result[i])) return std::nullopt;
  return result;
}

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
                                                           Recursion(shells, Sum::squares));
  if (!w) return std::nullopt;
  const Cells squares = Recursion(shells, Sum::squares)(*w);
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
  const Recursion plain(shells, Sum::plain), frequencies(shells, Sum::frequencies);
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
