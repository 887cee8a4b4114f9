#include "surface_schemes.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <map>
#include <numeric>

namespace subcert {
namespace {

constexpr long most_directions = 64, most_coefficients = 100'000;

/// The numbers m of the factors 1 - z^(m u) above and below the bar, for the shortest lattice point u of a line.
struct Line {
  std::vector<long> above, below;

  /// The degree of the quotient in z^u.
  long degree() const {
    return std::accumulate(above.begin(), above.end(), 0L) - std::accumulate(below.begin(), below.end(), 0L);
  }
};

std::map<LatticePoint, Line> lines_of(const std::vector<LatticePoint>& directions, const Dilation& dilation) {
  std::map<LatticePoint, Line> lines;
  const auto add = [&](LatticePoint point, std::vector<long> Line::*part) {
    long multiple = 0;
    for (const long c : point) multiple = std::gcd(multiple, c);
    require(multiple != 0, "box spline: need directions other than zero");
    const bool turned = *std::find_if(point.begin(), point.end(), [](long c) { return c != 0; }) < 0;
    for (long& c : point) c /= turned ? -multiple : multiple;
    (lines[point].*part).push_back(multiple);
  };
  for (const LatticePoint& direction : directions) {
    add(direction, &Line::below);
    add(dilation * direction, &Line::above);
  }
  return lines;
}

/// prod of (1 - z^m) over the numbers m, divided by the zeros at 1.
LaurentPolynomial product_of_ones(const std::vector<long>& numbers) {
  LaurentPolynomial product = 1;
  for (const long m : numbers) product *= LaurentPolynomial::all_ones(static_cast<int>(m));
  return product;
}

}  // namespace

LatticeMask box_spline_mask(const std::vector<LatticePoint>& directions, const Dilation& dilation) {
  const std::size_t variables = dilation.variables();
  require(directions.size() <= most_directions, "box spline: need at most {} directions, got {}", most_directions,
          directions.size());
  RationalMatrix columns(variables, directions.size());
  for (std::size_t j = 0; j < directions.size(); ++j) {
    require(directions[j].size() == variables, "box spline: need directions of {} numbers, got one of {}", variables,
            directions[j].size());
    for (std::size_t i = 0; i < variables; ++i) columns(i, j) = directions[j][i];
  }
  require(pivot_columns(columns).size() == variables, "box spline: need directions that span all {} dimensions",
          variables);
  const auto lines = lines_of(directions, dilation);
  long coefficients = 1;
  for (std::size_t v = 0; v < variables; ++v) {
    long length = 1;
    for (const auto& [unit, line] : lines) length += line.degree() * std::abs(unit[v]);
    coefficients *= std::clamp(length, 1L, most_coefficients + 1);
    require(coefficients <= most_coefficients, "box spline: need directions with at most {} coefficients",
            most_coefficients);
  }
  MultivariatePolynomial symbol(static_cast<int>(variables), Rational(dilation.classes()));
  for (const auto& [unit, line] : lines) {
    const auto quotient = line.above.size() != line.below.size()
                              ? std::nullopt
                              : product_of_ones(line.above).exact_quotient(product_of_ones(line.below));
    require(quotient.has_value(), "box spline: need directions that the dilation {} maps to multiples of directions",
            dilation.to_text());
    std::vector<Monomial> terms;
    LatticePoint exponents(variables, 0);
    for (const Rational& c : quotient->coefficients()) {
      terms.push_back({c / (*quotient)(1), exponents});
      exponents = exponents + unit;
    }
    symbol *= MultivariatePolynomial(static_cast<int>(variables), terms);
  }
  LatticePoint shift = symbol.lowest();
  const LatticePoint highest = symbol.highest();
  for (std::size_t v = 0; v < variables; ++v) shift[v] = -shift[v] - (highest[v] - shift[v] + 1) / 2;
  return {symbol.shifted(shift), dilation};
}

LatticeMask butterfly_mask(const Rational& w) {
  // The new point on the edge from (0,0) to (1,0): its ends, the far corners of the triangles on both sides, and those
  // of their other neighbours. Rotation by 60 degrees gives the other edges.
  const Rational half(1, 2);
  const std::vector<Monomial> rule{{half, {0, 0}}, {half, {1, 0}}, {2 * w, {1, 1}}, {2 * w, {0, -1}},
                                   {-w, {0, 1}},   {-w, {2, 1}},   {-w, {-1, -1}},  {-w, {1, -1}}};
  std::vector<Monomial> terms{{1, {0, 0}}};
  for (const Monomial& datum : rule) {
    LatticePoint at{1 - 2 * datum.exponents[0], -2 * datum.exponents[1]};
    for (int turn = 0; turn < 3; ++turn, at = {at[0] - at[1], at[0]}) terms.push_back({datum.coefficient, at});
  }
  return {MultivariatePolynomial(2, terms), 2};
}

}  // namespace subcert
