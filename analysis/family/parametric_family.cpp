#include "parametric_family.hpp"

#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>

namespace subcert {
namespace {

/// A number for each entry that is not 0 for all masks and values of the letters.
LatticeMask pattern_of(const std::vector<ParametricMask>& masks) {
  const auto rows = static_cast<long>(masks.front().components());
  std::vector<LatticeMask::Term> terms;
  for (const ParametricMask& mask : masks)
    for (const LaurentPolynomial& power : mask.powers())
      for (long k = 0; k < power.length(); ++k) {
        const long at = power.lowest() + k, place = modulo(at, rows * rows);
        if (power.coefficient(at) != 0)
          terms.push_back({{floor_divide(at, rows * rows)},
                           static_cast<std::size_t>(place / rows),
                           static_cast<std::size_t>(place % rows),
                           1});
      }
  return matrix_mask(terms, masks.front().components(), Dilation::multiple(1, masks.front().arity()));
}

/// The conditions sum over k of u_k . e_l(-k) = 0, a row for each l, on sequences at these points with components.
RationalMatrix conditions(const PolynomialData& polynomials, const std::vector<LatticePoint>& points) {
  RationalMatrix result(polynomials.at(0).size(), points.size());
  for (std::size_t c = 0; c < points.size(); ++c) {
    const std::vector<Values> data = polynomials.at(-points[c].front());
    for (std::size_t l = 0; l < data.size(); ++l) result(l, c) = data[l][static_cast<std::size_t>(points[c].back())];
  }
  return result;
}

/// All components at so many points that shifts of what annihilates the data there are a basis of all that does: one
/// more than those at which no polynomial has the data 0. Over a field, and of several masks, also those of the
/// sequences from which a certificate starts, readings and differences of the order m + 1: points that shorter words
/// alone reach are left out of a window anyway.
std::vector<LatticePoint> generating_points(const PolynomialData& polynomials, bool of_several) {
  const auto components = static_cast<long>(polynomials.data.front().size());
  const std::size_t count = polynomials.at(0).size();
  const auto order = static_cast<long>(polynomials.data.size());
  std::vector<LatticePoint> points;
  const auto add_point = [&](long k) {
    for (long c = 0; c < components; ++c) points.push_back({k, c});
  };
  long k = 0;
  do add_point(k++);
  while (pivot_columns(conditions(polynomials, points)).size() < count ||
         ((polynomials.root > 0 || of_several) && k < order));
  add_point(k);
  return points;
}

/// A sequence that annihilates the data, by its places in the window.
struct Annihilator {
  std::size_t pivot;  ///< where it is 1, and all others are 0
  std::vector<std::pair<std::size_t, Rational>> values;
};

std::vector<Annihilator> annihilators(const PolynomialData& polynomials, const std::vector<LatticePoint>& points) {
  const auto basis = kernel(conditions(polynomials, points));
  const std::vector<std::size_t> pivots = free_columns(basis);
  std::vector<Annihilator> result;
  for (std::size_t c = 0; c < basis.size(); ++c) {
    result.push_back({pivots[c], {}});
    for (std::size_t k = 0; k < points.size(); ++k)
      if (basis[c][k] != 0) result.back().values.emplace_back(k, basis[c][k]);
  }
  return result;
}

/// The window of the sequences.
std::vector<LatticePoint> window_points(const std::vector<ParametricMask>& masks, const PolynomialData& polynomials) {
  constexpr std::size_t most_numbers = 256;
  return LatticeWindow(pattern_of(masks), generating_points(polynomials, masks.size() > 1), most_numbers).points();
}

}  // namespace

std::optional<MatrixFamily> ParametricFamily::controls(const Box& box) const {
  const auto masks = mask.controls(box);
  if (!masks) return std::nullopt;
  std::vector<std::vector<RationalMatrix>> families;
  for (const LaurentPolynomial& control : *masks) families.push_back(matrices_of(control));
  std::vector<RationalMatrix> matrices;
  for (std::size_t t = 0; t < families.front().size(); ++t)
    for (std::vector<RationalMatrix>& family : families) matrices.push_back(std::move(family[t]));
  return MatrixFamily(std::move(matrices));
}

ParametricFamily transition_matrices(const ParametricMask& mask) {
  const IndexRange support = mask.support();
  const IndexRange window{0, TransitionWindow(support.last - support.first, mask.arity()).width - 1};
  return {mask, [arity = mask.arity(), first = support.first, window](const LaurentPolynomial& symbol) {
            std::vector<RationalMatrix> matrices;
            for (long t = 0; t < arity; ++t)
              matrices.push_back(transition_block(symbol.shifted(-first), arity, t, window, window));
            return matrices;
          }};
}

std::vector<ParametricFamily> difference_matrices(const std::vector<ParametricMask>& masks,
                                                  const PolynomialData& polynomials) {
  const std::vector<LatticePoint> points = window_points(masks, polynomials);
  const auto rows = static_cast<long>(masks.front().components());
  const auto matrices = [arity = static_cast<long>(masks.front().arity()), rows, points,
                         basis = annihilators(polynomials, points),
                         scale = power(Rational(masks.front().arity()), static_cast<long>(polynomials.data.size()))](
                            const LaurentPolynomial& entries) {
    std::vector<RationalMatrix> result;
    for (long t = 0; t < arity; ++t) {
      RationalMatrix& matrix = result.emplace_back(basis.size(), basis.size());
      for (std::size_t r = 0; r < basis.size(); ++r) {
        const LatticePoint& to = points[basis[r].pivot];
        for (std::size_t c = 0; c < basis.size(); ++c)
          for (const auto& [place, value] : basis[c].values) {
            const LatticePoint& from = points[place];
            const long k = arity * to.front() + t - from.front();
            matrix(r, c) += scale * value * entries.coefficient(rows * (rows * k + to.back()) + from.back());
          }
      }
    }
    return result;
  };
  std::vector<ParametricFamily> families;
  for (const ParametricMask& mask : masks) families.push_back({mask, matrices});
  return families;
}

ParametricFamily difference_matrices(const ParametricMask& mask, long root) {
  if (mask.components() == 1) return transition_matrices(divided_difference_scheme(mask, sum_rules(mask)));
  return difference_matrices({mask}, kept_polynomials(mask, root)).front();
}

AnnihilatingSpace annihilating_space(const ParametricMask& mask, long root) {
  return annihilating_space(std::vector{mask}, root);
}

AnnihilatingSpace annihilating_space(const std::vector<ParametricMask>& masks, long root) {
  AnnihilatingSpace result{kept_polynomials(masks, root), {}, {}, {}};
  const std::vector<LatticePoint> points = window_points(masks, result.polynomials);
  for (const Annihilator& one : annihilators(result.polynomials, points)) {
    LatticeSequence& sequence = result.basis.emplace_back();
    for (const auto& [place, value] : one.values) sequence.emplace(points[place], value);
    result.pivots.push_back(points[one.pivot]);
  }
  const Values& constant = result.polynomials.data.front();
  const auto size = static_cast<long>(result.polynomials.components());
  const auto first = (std::ranges::find_if(constant, [](const Rational& y) { return y != 0; }) - constant.begin()) %
                     size;
  for (long c = 0; c < size; ++c) {
    if (c == first) continue;
    std::vector<LatticePoint> places{{0, c}};
    for (long k = 0; k < static_cast<long>(result.polynomials.data.size()); ++k)
      for (long part = first; part < static_cast<long>(constant.size()); part += size) places.push_back({k, part});
    const auto one = kernel(conditions(result.polynomials, places));
    LatticeSequence& reading = result.readings.emplace_back();
    for (std::size_t k = 0; k < places.size(); ++k)
      if (one.front()[k] != 0) reading.emplace(places[k], one.front()[k] / one.front()[0]);
  }
  return result;
}

ParametricFamily central_matrices(const ParametricMask& mask) {
  const std::vector<LaurentPolynomial>& powers = mask.powers();
  std::vector<LaurentPolynomial> autocorrelation(2 * powers.size() - 1);
  for (std::size_t j = 0; j < powers.size(); ++j)
    for (std::size_t k = 0; k < powers.size(); ++k) autocorrelation[j + k] += powers[j] * powers[k].reversed();
  const IndexRange support = mask.support();
  const long reach = (support.last - support.first) / (mask.arity() - 1);
  const LaurentPolynomial denominator = mask.denominator();
  return {ParametricMask(autocorrelation, mask.arity(), denominator * denominator),
          [arity = mask.arity(), reach](const LaurentPolynomial& symbol) {
            return std::vector{central_matrix(symbol, arity, reach)};
          }};
}

}  // namespace subcert
