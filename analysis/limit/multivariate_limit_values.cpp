#include "multivariate_limit_values.hpp"

#include "fixed_vector.hpp"

#include <subcert/analysis/reproduction/multivariate_reproduction.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>

namespace subcert {
namespace {

constexpr std::size_t most_points = 2000, most_values = 1'000'000;

/// The lattice points of the box that holds the support.
std::vector<LatticePoint> points_of_support(const MultivariateMask& mask) {
  const std::vector<Interval> box = limit_support(mask);
  double count = 1;
  LatticePoint low, high;
  for (const Interval& side : box) {
    low.push_back(ceil_index(side.lower));
    high.push_back(floor_index(side.upper));
    count *= static_cast<double>(high.back() - low.back() + 1);
  }
  if (count > static_cast<double>(most_points))
    fail(ErrorKind::size, "limit_values: need at most {} lattice points in the support, got {}", most_points, count);
  return points_of_box(low, high);
}

}  // namespace

LatticeSequence limit_values(const MultivariateMask& mask, int level) {
  const Dilation dilation(mask.dilation().rows());
  const std::size_t zero = dilation.divide(LatticePoint(dilation.variables(), 0)).digit;
  const LatticeWindow window(mask.symbol(), dilation, points_of_support(mask), most_points, zero);
  // phi(k) = sum over j of a_{Mk - j} phi(j).
  RationalMatrix matrix(window.size(), window.size());
  for (std::size_t column = 0; column < window.size(); ++column) {
    const auto images = transitions(mask.symbol(), dilation, {{window.points()[column], 1}});
    for (const auto& [point, value] : images[zero]) matrix(window.place(point), column) = value;
  }
  const auto fixed = fixed_vector(matrix);
  require(fixed.has_value(), "limit_values: need a scheme that converges, got several fixed vectors or none");
  LatticeSequence values;
  for (std::size_t k = 0; k < window.size(); ++k)
    if ((*fixed)[k] != 0) values.emplace(window.points()[k], (*fixed)[k]);

  // phi(M^-(n+1) i) = sum over k of a_k phi(M^-n i - k).
  std::vector<MultivariatePolynomial::Monomial> terms = mask.symbol().terms();
  for (int n = 0; n < level; ++n) {
    LatticeSequence finer;
    for (const auto& term : terms)
      for (const auto& [point, value] : values) finer[point + term.exponents] += term.coefficient * value;
    if (finer.size() > most_values)
      fail(ErrorKind::size, "limit_values: need at most {} values, got more at level {}", most_values, n + 1);
    std::erase_if(finer, [](const auto& entry) { return entry.second == 0; });
    values = std::move(finer);
    for (auto& term : terms) term.exponents = dilation * term.exponents;
  }
  return values;
}

}  // namespace subcert
