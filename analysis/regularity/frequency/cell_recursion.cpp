#include "cell_recursion.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>

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

/// The aliases of one shell relative to the sum rules, where that is sharper: |m(w + pi)| <= ratio high^k.
void sharpen_near_pi(const HalfSymbol& symbol, const Ball& low, std::vector<Ball>& e) {
  const auto cells = static_cast<long>(e.size());
  for (long i = 0; i < cells; ++i) {
    const Ball from = low * (cells + i) / cells, to = low * (cells + i + 1) / cells;
    Ball& one = e[static_cast<std::size_t>(i)];
    one = min(one, symbol.alias_ratio(from, to) * to.pow(symbol.sum_rules())).upper_end();
  }
}

}  // namespace

CellBounds bounds_on_cells(const HalfSymbol& symbol, std::size_t cells, NearPi near_pi) {
  const Ball pi = Ball::pi(cell_bits);
  // So many shells that the sum of 2^j b over the shells beyond is about 2^-14.
  const double least = std::log2(static_cast<double>(cells)) + 1;  // so that the shells beyond refer to the last cell
  const double count = std::max(least, std::log2(symbol.flatness().middle()) + 18);
  CellBounds result{
      static_cast<std::size_t>(count), cells, {}, {}, Ball(cell_bits), symbol.sum_rules(), Ball(cell_bits)};
  constexpr double absolute_is_enough = 64;  // of w times the reach
  constexpr int refined = 8;
  for (std::size_t j = 0; j < result.count; ++j) {
    const Ball low = pi.scaled(-static_cast<slong>(j) - 2), high = low.scaled(1);
    const double reached = 1.000001 * high.middle() * symbol.reach();
    const bool relative = near_pi == NearPi::relative && reached <= absolute_is_enough;
    std::vector<Ball> x, e;
    for (const HalfSymbol::Suprema& one : symbol.suprema(low, high, static_cast<int>(cells), relative ? refined : 1)) {
      x.push_back(one.plain);
      e.push_back(one.alias);
    }
    if (relative && reached <= HalfSymbol::near_pi) sharpen_near_pi(symbol, low, e);
    result.x.push_back(std::move(x));
    result.e.push_back(std::move(e));
  }
  result.beyond = symbol.flatness() * pi * pi.scaled(-2 * static_cast<slong>(result.count)) / 3;
  if (near_pi == NearPi::relative)
    result.alias_beyond = symbol.alias_ratio(Ball(cell_bits), pi.scaled(-static_cast<slong>(result.count) - 1));
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
    : shells_(shells), terms_(terms), step_(Rational(1 / (1 + terms.excess)), cell_bits), x_(shells.x), e_(shells.e) {
  const auto cells = static_cast<long>(shells.cells);
  for (std::size_t j = 0; j < shells.count; ++j)
    for (std::size_t i = 0; i < shells.cells; ++i) {
      Ball &x = x_[j][i], &e = e_[j][i];
      if (terms.squared) {
        x = x * x;
        e = e * e;
      }
      if (terms.order == 0) continue;
      // 2^(j+1) times the ratio of the ends of the cells.
      const Rational ratio(cells + static_cast<long>(image(j, i, shells.cells)) + 1, cells + static_cast<long>(i) + 1);
      e = (e * Ball(power(ratio, terms.order), cell_bits)).scaled(terms.order * (static_cast<slong>(j) + 1));
    }
}

Cells Recursion::operator()(const std::vector<Ball>& w) const {
  Cells result(shells_.count + 1, std::vector<Ball>(shells_.cells, beyond() * w.back()));
  for (std::size_t j = shells_.count; j-- > 0;)
    for (std::size_t i = 0; i < shells_.cells; ++i)
      result[j][i] = (e_[j][i] * w[image(j, i, shells_.cells)] + x_[j][i] * result[j + 1][i]) * step_;
  return result;
}

Ball Recursion::beyond() const {
  const Ball& b = shells_.beyond;
  if (terms_.excess > 0)
    return exp(b) * shells_.alias_beyond * Ball::pi(cell_bits).pow(terms_.order) / Ball(terms_.excess, cell_bits);
  if (terms_.squared) return b * b * exp(b.scaled(1));
  if (terms_.order == 0) return b * exp(b);
  return (b * exp(b)).scaled(static_cast<slong>(shells_.count) + 3);
}

polytope::Matrix Recursion::matrix(double excess) const {
  polytope::Matrix result(shells_.cells, shells_.cells);
  const double step = 1 / (1 + excess);
  const double last = beyond().middle() * (terms_.excess > 0 ? terms_.excess.convert_to<double>() / excess : 1);
  for (std::size_t i = 0; i < shells_.cells; ++i) {
    double product = 1;
    for (std::size_t j = 0; j < shells_.count; ++j) {
      product *= step;
      result(i, image(j, i, shells_.cells)) += product * e_[j][i].middle();
      product *= x_[j][i].middle();
    }
    result(i, shells_.cells - 1) += product * last;
  }
  return result;
}

std::optional<std::vector<double>> fixed_point(const polytope::Matrix& matrix, const std::vector<double>& first) {
  const std::size_t size = matrix.rows();
  polytope::Matrix difference = polytope::Matrix::identity(size), inverse(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) difference(i, j) -= matrix(i, j);
  if (!is_finite(difference) || !polytope::invert(difference.column(0), size, size, &inverse(0, 0)))
    return std::nullopt;
  std::vector<double> w = inverse * first;
  for (const double one : w)
    if (!(one > 0)) return std::nullopt;
  return w;
}

std::optional<std::vector<Ball>> supersolution(const std::vector<Ball>& first, const Recursion& recursion) {
  constexpr double slack = 1.0001;
  std::vector<double> start;
  for (const Ball& one : first) start.push_back(slack * one.middle());
  const std::optional<std::vector<double>> w = fixed_point(recursion.matrix(), start);
  if (!w) return std::nullopt;
  std::vector<Ball> result;
  for (const double one : *w) result.emplace_back(Rational(one), cell_bits);
  const Cells value = recursion(result);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (!(first[i] + value.front()[i]).is_at_most(result[i])) return std::nullopt;
  return result;
}

}  // namespace subcert::frequency
