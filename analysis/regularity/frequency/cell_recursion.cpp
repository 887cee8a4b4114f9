#include "cell_recursion.hpp"

#include <subcert/analysis/radii/frequency/positive_fixed_point.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::frequency {
namespace {

/// The cell of shell 0 that holds xi/2 + pi, modulo 2 pi, for xi in the cell (j, i).
std::size_t image(std::size_t j, std::size_t i, std::size_t cells) {
  // floor of cells - (cells + i + 1)/2^(j+1)
  const std::size_t unit = std::size_t{1} << (j + 1);
  return cells - (cells + i + unit) / unit;
}

}  // namespace

CellBounds bounds_on_cells(const HalfSymbol& symbol, std::size_t cells) {
  const Ball pi = Ball::pi(cell_bits);
  // So many shells that the sum of 2^j b over the shells beyond is about 2^-14.
  const double least = std::log2(static_cast<double>(cells)) + 1;  // so that the shells beyond refer to the last cell
  const double count = std::max(least, std::log2(symbol.flatness().middle()) + 18);
  CellBounds result{static_cast<std::size_t>(count), cells, {}, {}, Ball(cell_bits)};
  for (std::size_t j = 0; j < result.count; ++j) {
    const Ball low = pi.scaled(-static_cast<slong>(j) - 2), high = low.scaled(1);
    std::vector<Ball> x, e;
    for (const HalfSymbol::Suprema& one : symbol.suprema(low, high, static_cast<int>(cells))) {
      x.push_back(one.plain);
      e.push_back(one.alias);
    }
    result.x.push_back(std::move(x));
    result.e.push_back(std::move(e));
  }
  result.beyond = symbol.flatness() * pi * pi.scaled(-2 * static_cast<slong>(result.count)) / 3;
  return result;
}

Cells products(const CellBounds& shells, bool squared) {
  Cells result(shells.count + 1, std::vector<Ball>(shells.cells, exp(shells.beyond.scaled(squared ? 1 : 0))));
  for (std::size_t j = shells.count; j-- > 0;)
    for (std::size_t i = 0; i < shells.cells; ++i) {
      const Ball& x = shells.x[j][i];
      result[j][i] = (squared ? x * x : x) * result[j + 1][i];
    }
  return result;
}

Recursion::Recursion(const CellBounds& shells, const Terms& terms)
    : shells_(shells), terms_(terms), x_(shells.x), e_(shells.e) {
  const auto cells = static_cast<long>(shells.cells);
  for (std::size_t j = 0; j < shells.count; ++j)
    for (std::size_t i = 0; i < shells.cells; ++i) {
      Ball &x = x_[j][i], &e = e_[j][i];
      if (terms.squared) {
        x = x * x;
        e = e * e;
      }
      if (!terms.frequencies) continue;
      // 2^(j+1) times the ratio of the ends of the cells.
      const Rational ratio(cells + static_cast<long>(image(j, i, shells.cells)) + 1, cells + static_cast<long>(i) + 1);
      e = (e * Ball(ratio, cell_bits)).scaled(static_cast<slong>(j) + 1);
    }
}

Cells Recursion::operator()(const std::vector<Ball>& w) const {
  Cells result(shells_.count + 1, std::vector<Ball>(shells_.cells, beyond() * w.back()));
  for (std::size_t j = shells_.count; j-- > 0;)
    for (std::size_t i = 0; i < shells_.cells; ++i)
      result[j][i] = e_[j][i] * w[image(j, i, shells_.cells)] + x_[j][i] * result[j + 1][i];
  return result;
}

Ball Recursion::beyond() const {
  const Ball& b = shells_.beyond;
  if (terms_.squared) return b * b * exp(b.scaled(1));
  if (!terms_.frequencies) return b * exp(b);
  return (b * exp(b)).scaled(static_cast<slong>(shells_.count) + 3);
}

polytope::Matrix Recursion::matrix() const {
  polytope::Matrix result(shells_.cells, shells_.cells);
  const double last = beyond().middle();
  for (std::size_t i = 0; i < shells_.cells; ++i) {
    double product = 1;
    for (std::size_t j = 0; j < shells_.count; ++j) {
      result(i, image(j, i, shells_.cells)) += product * e_[j][i].middle();
      product *= x_[j][i].middle();
    }
    result(i, shells_.cells - 1) += product * last;
  }
  return result;
}

std::optional<std::vector<Ball>> supersolution(const std::vector<Ball>& first, const Recursion& recursion) {
  constexpr double slack = 1.0001;
  std::vector<double> start;
  for (const Ball& one : first) start.push_back(slack * one.middle());
  const std::optional<std::vector<double>> w = positive_fixed_point(recursion.matrix(), start);
  if (!w) return std::nullopt;
  std::vector<Ball> result;
  for (const double one : *w) result.emplace_back(Rational(one), cell_bits);
  const Cells value = recursion(result);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (!(first[i] + value.front()[i]).is_at_most(result[i])) return std::nullopt;
  return result;
}

}  // namespace subcert::frequency
