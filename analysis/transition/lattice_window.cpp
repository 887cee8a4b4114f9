#include "lattice_window.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <unordered_set>

namespace subcert {
namespace {

/// A point of up to three coordinates, and the component, without memory of its own.
using FixedPoint = std::array<long, 4>;

struct Hash {
  std::size_t operator()(const FixedPoint& point) const {
    std::size_t hash = 0;
    for (const long x : point) hash = (hash ^ static_cast<std::size_t>(x)) * 0x9e3779b97f4a7c15U;
    return hash ^ hash >> 32;
  }
};

/// The points of Z^s, and the components that points of sequences carry where there are several.
class Lattice {
 public:
  explicit Lattice(const LatticeMask& mask)
      : variables_(mask.dilation().variables()), has_components_(mask.components() > 1) {}

  FixedPoint fixed(const LatticePoint& point) const { return fixed(point, component(point)); }
  FixedPoint fixed(const LatticePoint& point, std::size_t component) const {
    FixedPoint result{};
    std::copy_n(point.begin(), variables_, result.begin());
    result.back() = static_cast<long>(component);
    return result;
  }
  std::size_t component(const LatticePoint& point) const {
    return has_components_ ? static_cast<std::size_t>(point.back()) : 0;
  }
  /// M^-1 of a point, digit by digit, with its component.
  Dilation::Division divide(const Dilation& dilation, const FixedPoint& point) const {
    Dilation::Division at = dilation.divide({point.begin(), point.begin() + static_cast<long>(variables_)});
    if (has_components_) at.quotient.push_back(point.back());
    return at;
  }

 private:
  std::size_t variables_;
  bool has_components_;
};

/// The least box around points. One is added at least.
struct LatticeBox {
  FixedPoint low, high;
  bool is_empty = true;

  void add(const FixedPoint& point) {
    if (is_empty) low = high = point;
    is_empty = false;
    for (std::size_t v = 0; v < point.size(); ++v) {
      low[v] = std::min(low[v], point[v]);
      high[v] = std::max(high[v], point[v]);
    }
  }
  double volume() const {
    double result = 1;
    for (std::size_t v = 0; v < low.size(); ++v)
      result *= static_cast<double>(high[v]) - static_cast<double>(low[v]) + 1;
    return result;
  }
  /// The place of low + offset in the box, row by row. Linear in the offset.
  long place(const FixedPoint& offset) const {
    long result = 0;
    for (std::size_t v = 0; v < low.size(); ++v) result = result * (high[v] - low[v] + 1) + offset[v];
    return result;
  }
  FixedPoint point(long place) const {
    FixedPoint result = low;
    for (std::size_t v = low.size(); v-- > 0;) {
      const long length = high[v] - low[v] + 1;
      result[v] += place % length;
      place /= length;
    }
    return result;
  }
};

/// The component is that of a.
FixedPoint plus(FixedPoint a, const FixedPoint& b) {
  for (std::size_t v = 0; v < 3; ++v) a[v] += b[v];
  return a;
}

FixedPoint minus(FixedPoint a, const FixedPoint& b) {
  for (std::size_t v = 0; v < a.size(); ++v) a[v] -= b[v];
  return a;
}

/// Where a component leads to: the exponents of the entries in a column, with their rows.
class Steps {
 public:
  explicit Steps(const LatticeMask& mask) : lattice(mask), dilation(mask.dilation()), columns_(mask.components()) {
    for (const LatticeMask::Term& term : mask.terms()) {
      const FixedPoint& step = columns_[term.column].emplace_back(lattice.fixed(term.exponents, term.row));
      box_.add(step);
      ++count_;
    }
  }

  /// All steps from a point of this component.
  const std::vector<FixedPoint>& from(std::size_t component) const { return columns_[component]; }
  std::size_t components() const { return columns_.size(); }
  std::size_t count() const { return count_; }
  const LatticeBox& box() const { return box_; }

  const Lattice lattice;
  const Dilation& dilation;

 private:
  std::vector<std::vector<FixedPoint>> columns_;
  LatticeBox box_;
  std::size_t count_ = 0;
};

/// The different sums of points and steps from there, with the component to which the step leads, in a box of places:
/// a mark for each place.
std::vector<FixedPoint> sums_in_box(const Steps& steps, const std::vector<FixedPoint>& points, const LatticeBox& from,
                                    const LatticeBox& box) {
  std::vector<std::vector<long>> offsets;
  for (std::size_t c = 0; c < steps.components(); ++c)
    for (std::vector<long>& column = offsets.emplace_back(); const FixedPoint& step : steps.from(c))
      column.push_back(box.place(minus(step, steps.box().low)));
  std::vector<char> marks(static_cast<std::size_t>(box.volume()), 0);
  for (const FixedPoint& point : points) {
    FixedPoint offset = minus(point, from.low);
    offset.back() = 0;  // the step has the component of the sum
    char* const base = marks.data() + box.place(offset);
    for (const long step : offsets[static_cast<std::size_t>(point.back())]) base[step] = 1;
  }
  std::vector<FixedPoint> result;
  for (std::size_t place = 0; place < marks.size(); ++place)
    if (marks[place]) result.push_back(box.point(static_cast<long>(place)));
  return result;
}

/// The different sums of points and steps from there. Cost: a mark for each pair in a box that is not much larger than
/// their number, else a look at a table for each.
std::vector<FixedPoint> sums(const Steps& steps, const std::set<LatticePoint>& points) {
  constexpr double places_of_pair = 8;
  std::vector<FixedPoint> fixed;
  LatticeBox from;
  for (const LatticePoint& point : points) from.add(fixed.emplace_back(steps.lattice.fixed(point)));
  LatticeBox box{plus(steps.box().low, from.low), plus(steps.box().high, from.high), false};
  const double pairs = static_cast<double>(points.size()) * static_cast<double>(steps.count());
  if (box.volume() <= places_of_pair * pairs) return sums_in_box(steps, fixed, from, box);
  std::unordered_set<FixedPoint, Hash> result;
  for (const FixedPoint& point : fixed)
    for (const FixedPoint& step : steps.from(static_cast<std::size_t>(point.back()))) result.insert(plus(step, point));
  return {result.begin(), result.end()};
}

/// Where T_d v has its support, over all digits d or for one, for v supported on `points`. Cost: as sums(), and a
/// division for each different sum.
std::set<LatticePoint> images(const Steps& steps, const std::set<LatticePoint>& points,
                              std::optional<std::size_t> digit) {
  if (points.empty() || steps.count() == 0) return {};
  std::set<LatticePoint> result;
  for (const FixedPoint& sum : sums(steps, points)) {
    Dilation::Division at = steps.lattice.divide(steps.dilation, sum);
    if (!digit || at.digit == *digit) result.insert(std::move(at.quotient));
  }
  return result;
}

std::set<LatticePoint> reached_from(const Steps& steps, const std::vector<LatticePoint>& start, std::size_t most_points,
                                    std::optional<std::size_t> digit) {
  std::set<LatticePoint> reached(start.begin(), start.end()), fresh = reached;
  while (!fresh.empty()) {
    std::set<LatticePoint> next;
    for (const LatticePoint& point : images(steps, fresh, digit))
      if (reached.insert(point).second) next.insert(point);
    if (reached.size() > most_points)
      fail(ErrorKind::size, "transition operators: need at most {} lattice points, got more for {} coefficients",
           most_points, steps.count());
    fresh = std::move(next);
  }
  return reached;
}

}  // namespace

LatticeWindow::LatticeWindow(const LatticeMask& mask, const std::vector<LatticePoint>& start, std::size_t most_points,
                             std::optional<std::size_t> digit) {
  const Steps steps(mask);
  std::set<LatticePoint> reached = reached_from(steps, start, most_points, digit);
  // A point without predecessor is left behind after one step.
  for (;; ++steps_) {
    std::set<LatticePoint> kept = images(steps, reached, digit);
    if (kept.size() == reached.size()) break;
    reached = std::move(kept);
  }
  points_.assign(reached.begin(), reached.end());
}

LatticeWindow LatticeWindow::closure(const LatticeMask& mask, const std::vector<LatticePoint>& start,
                                     std::size_t most_points) {
  const std::set<LatticePoint> reached = reached_from(Steps(mask), start, most_points, std::nullopt);
  LatticeWindow result;
  result.points_.assign(reached.begin(), reached.end());
  return result;
}

std::size_t LatticeWindow::place(const LatticePoint& point) const {
  const auto at = std::lower_bound(points_.begin(), points_.end(), point);
  return at != points_.end() && *at == point ? static_cast<std::size_t>(at - points_.begin()) : size();
}

LatticeSequence convolution(const std::vector<LatticeMask::Term>& terms, std::size_t components,
                            const LatticeSequence& x) {
  const bool has_components = components > 1;
  LatticeSequence result;
  for (const LatticeMask::Term& term : terms)
    for (const auto& [k, value] : x) {
      if (has_components && static_cast<std::size_t>(k.back()) != term.column) continue;
      LatticePoint sum = k;
      for (std::size_t v = 0; v < term.exponents.size(); ++v) sum[v] += term.exponents[v];
      if (has_components) sum.back() = static_cast<long>(term.row);
      result[std::move(sum)] += term.coefficient * value;
    }
  return result;
}

std::vector<LatticeSequence> transitions(const LatticeMask& mask, const LatticeSequence& v) {
  const Lattice lattice(mask);
  std::vector<LatticeSequence> result(mask.dilation().digits().size());
  for (const auto& [point, value] : convolution(mask.terms(), mask.components(), v)) {
    if (value == 0) continue;
    Dilation::Division at = lattice.divide(mask.dilation(), lattice.fixed(point));
    result[at.digit].emplace(std::move(at.quotient), value);
  }
  return result;
}

MatrixFamily transition_family(const LatticeMask& mask, const LatticeWindow& window) {
  std::vector<LatticeSequence> deltas;
  for (const LatticePoint& point : window.points()) deltas.push_back({{point, 1}});
  return transition_family(mask, deltas, window.points());
}

MatrixFamily transition_family(const LatticeMask& mask, const std::vector<LatticeSequence>& basis,
                               const std::vector<LatticePoint>& pivots) {
  std::map<LatticePoint, std::size_t> row_of;
  for (std::size_t c = 0; c < pivots.size(); ++c) row_of.emplace(pivots[c], c);
  std::vector<RationalMatrix> matrices(mask.dilation().digits().size(), RationalMatrix(basis.size(), basis.size()));
  for (std::size_t c = 0; c < basis.size(); ++c) {
    const std::vector<LatticeSequence> moved = transitions(mask, basis[c]);
    for (std::size_t d = 0; d < moved.size(); ++d)
      for (const auto& [point, value] : moved[d])
        if (const auto row = row_of.find(point); row != row_of.end()) matrices[d](row->second, c) = value;
  }
  return MatrixFamily(std::move(matrices));
}

std::vector<LatticeSequence> differences_of_delta(const std::vector<LatticePoint>& directions, int order) {
  std::vector<LatticeSequence> result;
  for (const LatticePoint& exponents : exponents_of_degree(directions.size(), order)) {
    LatticeSequence sequence{{LatticePoint(directions.front().size(), 0), 1}};
    for (std::size_t v = 0; v < directions.size(); ++v)
      for (long round = 0; round < exponents[v]; ++round) {
        LatticeSequence next = sequence;
        for (const auto& [point, value] : sequence) next[point + directions[v]] -= value;
        sequence = std::move(next);
      }
    std::erase_if(sequence, [](const auto& entry) { return entry.second == 0; });
    result.push_back(std::move(sequence));
  }
  return result;
}

std::vector<LatticeSequence> differences_of_delta(std::size_t variables, int order) {
  std::vector<LatticePoint> axes(variables, LatticePoint(variables, 0));
  for (std::size_t v = 0; v < variables; ++v) axes[v][v] = 1;
  return differences_of_delta(axes, order);
}

LatticeSequence convolution(const LatticeSequence& a, const LatticeSequence& x) {
  LatticeSequence result;
  for (const auto& [i, factor] : a)
    for (const auto& [k, value] : x) {
      LatticePoint sum = k;
      for (std::size_t v = 0; v < i.size(); ++v) sum[v] += i[v];
      result[std::move(sum)] += factor * value;
    }
  std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
  return result;
}

}  // namespace subcert
