#include "lattice_solutions.hpp"

#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>

namespace subcert {
namespace {

/// phi_row(x) has a part phi_column(a x - index) along one axis.
struct Link {
  long index;
  std::size_t row, column;
};

/// Functions that are not linked to themselves in any number of steps are 0: the links of others.
std::vector<Link> links_between(std::vector<Link> links, std::size_t components) {
  for (std::size_t before = 0; before != links.size();) {
    before = links.size();
    std::vector<bool> linked(components, false);
    for (const Link& link : links) linked[link.row] = true;
    std::erase_if(links, [&](const Link& link) { return !linked[link.column]; });
  }
  return links;
}

/// The numbers x with x_c = min over the links of c of (index + x_column)/a, which are unique as the right side is a
/// contraction; 0 where there is no link. Method: links that are chosen give a linear system, whose solution becomes
/// smaller with each better choice.
std::vector<Rational> first_ends(const std::vector<Link>& links, std::size_t components, const Rational& arity) {
  std::vector<const Link*> chosen(components, nullptr);
  for (const Link& link : links)
    if (!chosen[link.row]) chosen[link.row] = &link;
  for (;;) {
    RationalMatrix matrix = RationalMatrix::identity(components), right(components, 1);
    for (const Link* link : chosen) {
      if (!link) continue;
      matrix(link->row, link->column) -= 1 / arity;
      right(link->row, 0) = link->index / arity;
    }
    const RationalMatrix ends = solve(matrix, right);
    std::vector<const Link*> better = chosen;
    for (const Link& link : links) {
      const Link& best = *better[link.row];
      if (link.index + ends(link.column, 0) < best.index + ends(best.column, 0)) better[link.row] = &link;
    }
    if (better == chosen) {
      std::vector<Rational> result;
      for (std::size_t c = 0; c < components; ++c) result.push_back(ends(c, 0));
      return result;
    }
    chosen = std::move(better);
  }
}

/// A box for each component, outside of which it is 0: by its own links where the dilation is a number; side by side.
/// Empty for what is 0 everywhere.
std::vector<std::vector<Interval>> boxes_of_components(const LatticeMask& mask) {
  const std::size_t components = mask.components();
  const auto arity = mask.dilation().factor();
  if (!arity || *arity < 2) return std::vector(components, limit_support(mask));
  std::vector<std::vector<Interval>> result(components);
  for (std::size_t v = 0; v < mask.dilation().variables(); ++v) {
    std::vector<Link> links;
    for (const LatticeMask::Term& term : mask.terms()) links.push_back({term.exponents[v], term.row, term.column});
    links = links_between(std::move(links), components);
    const std::vector<Rational> lower = first_ends(links, components, *arity);
    for (Link& link : links) link.index = -link.index;
    const std::vector<Rational> upper = first_ends(links, components, *arity);
    std::vector<bool> linked(components, false);
    for (const Link& link : links) linked[link.row] = true;
    for (std::size_t c = 0; c < components; ++c)
      if (linked[c]) result[c].push_back({lower[c], -upper[c]});
  }
  return result;
}

LatticePoint with_component(LatticePoint point, const LatticeMask& mask, std::size_t component) {
  if (mask.components() > 1) point.push_back(static_cast<long>(component));
  return point;
}

/// Strictly inside the box of their component.
std::vector<LatticePoint> inner_points(const LatticeMask& mask) {
  std::vector<LatticePoint> result;
  double count = 0;
  std::size_t c = 0;
  for (const std::vector<Interval>& box : boxes_of_components(mask)) {
    LatticePoint low, high;
    double inside = box.empty() ? 0 : 1;
    for (const Interval& side : box) {
      low.push_back(floor_index(side.lower) + 1);
      high.push_back(ceil_index(side.upper) - 1);
      inside *= static_cast<double>(std::max(0L, high.back() - low.back() + 1));
    }
    count += inside;
    if (count > static_cast<double>(limits::most_points))
      fail(ErrorKind::size, "limit_values: need at most {} values at lattice points in the support, got {} and more",
           limits::most_points, count);
    if (inside > 0)
      for (const LatticePoint& point : points_of_box(low, high)) result.push_back(with_component(point, mask, c));
    ++c;
  }
  return result;
}

}  // namespace

std::size_t limits::digit_zero(const Dilation& dilation) {
  return dilation.divide(LatticePoint(dilation.variables(), 0)).digit;
}

std::optional<std::vector<Rational>> limits::component_in_kernel(const RationalMatrix& matrix,
                                                                 const std::vector<Rational>& x) {
  const auto right = kernel(matrix), left = kernel(transposed(matrix));
  if (right.empty()) return std::nullopt;
  const RationalMatrix basis = from_columns(right, matrix.columns()),
                       dual = transposed(from_columns(left, matrix.rows())), pairing = dual * basis;
  if (!kernel(pairing).empty()) return std::nullopt;
  const RationalMatrix combination = solve(pairing, from_columns({dual * x}, dual.rows()));
  std::vector<Rational> weights;
  for (std::size_t r = 0; r < combination.rows(); ++r) weights.push_back(combination(r, 0));
  return basis * weights;
}

LatticeSequence normalised(LatticeSequence values) {
  Rational sum = 0;
  for (const auto& [point, value] : values) sum += value;
  const Rational scale = sum == 0 ? values.begin()->second : sum;
  for (auto& [point, value] : values) value /= scale;
  return values;
}

std::vector<LatticeSequence> solutions_at_lattice_points(const LatticeMask& mask) {
  const std::vector<LatticePoint> points = inner_points(mask);
  if (points.empty()) return {};
  const std::size_t zero = limits::digit_zero(mask.dilation());
  std::map<LatticePoint, std::size_t> rows;  // those inside, and others to which T_0 leads from there
  std::vector<LatticeSequence> images;
  for (const LatticePoint& point : points) rows.emplace(point, rows.size());
  for (const LatticePoint& point : points) {
    images.push_back(transitions(mask, {{point, 1}})[zero]);
    for (const auto& [image, value] : images.back()) rows.emplace(image, rows.size());
  }
  RationalMatrix equations(rows.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (const auto& [image, value] : images[k]) equations(rows.at(image), k) = value;
    equations(rows.at(points[k]), k) -= 1;
  }
  std::vector<LatticeSequence> result;
  for (const std::vector<Rational>& solution : kernel(equations)) {
    LatticeSequence& values = result.emplace_back();
    for (std::size_t k = 0; k < points.size(); ++k)
      if (solution[k] != 0) values.emplace(points[k], solution[k]);
  }
  return result;
}

std::vector<Rational> integral_of_solution(const LatticeMask& mask, const LatticeSequence& values) {
  const std::size_t size = mask.components();
  RationalMatrix rest = mean_matrix(mask);  // B - 1
  for (std::size_t c = 0; c < size; ++c) rest(c, c) -= 1;
  std::vector<Rational> sum(size, 0);
  for (const auto& [point, value] : values) sum[static_cast<std::size_t>(point.back())] += value;
  const auto result = limits::component_in_kernel(power(rest, static_cast<long>(size)), sum);
  return result.value_or(std::vector<Rational>(size, 0));  // nothing: the kernel is 0
}

std::vector<LatticeSequence> with_integral(const LatticeMask& mask, const std::vector<LatticeSequence>& solutions,
                                           const std::vector<Rational>& integral) {
  RationalMatrix equations(integral.size(), solutions.size() + 1);  // a combination less a multiple of the integral
  for (std::size_t k = 0; k < solutions.size(); ++k) {
    const std::vector<Rational> one = integral_of_solution(mask, solutions[k]);
    for (std::size_t c = 0; c < one.size(); ++c) equations(c, k) = one[c];
  }
  for (std::size_t c = 0; c < integral.size(); ++c) equations(c, solutions.size()) = -integral[c];
  std::vector<LatticeSequence> result;
  // The kernel has a vector for each free column, with 1 there: one with 1 in the last, if the integral is one.
  for (const std::vector<Rational>& combination : kernel(equations)) {
    LatticeSequence values;
    for (std::size_t k = 0; k < solutions.size(); ++k)
      if (combination[k] != 0)
        for (const auto& [point, value] : solutions[k]) values[point] += combination[k] * value;
    std::erase_if(values, [](const auto& entry) { return entry.second == 0; });
    const Rational& multiple = combination.back();
    if (multiple == 0) {
      result.push_back(std::move(values));
      continue;
    }
    for (auto& [point, value] : values) value /= multiple;
    result.insert(result.begin(), std::move(values));
  }
  const bool has_it = !result.empty() && integral_of_solution(mask, result.front()) == integral;
  return has_it ? result : std::vector<LatticeSequence>{};
}

}  // namespace subcert
