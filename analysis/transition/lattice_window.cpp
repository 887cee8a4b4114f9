#include "lattice_window.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <unordered_set>

namespace subcert {
namespace {

/// A point of up to three coordinates, without memory of its own.
using FixedPoint = std::array<long, 3>;

FixedPoint fixed(const LatticePoint& point) {
  FixedPoint result{};
  std::copy(point.begin(), point.end(), result.begin());
  return result;
}

struct Hash {
  std::size_t operator()(const FixedPoint& point) const {
    std::size_t hash = 0;
    for (const long x : point) hash = (hash ^ static_cast<std::size_t>(x)) * 0x9e3779b97f4a7c15U;
    return hash ^ hash >> 32;
  }
};

/// Where T_d v has its support, over all digits d or for one, for v supported on `points`. Cost: a look at a table for
/// each pair, and a division for each different sum.
std::set<LatticePoint> images(const std::vector<LatticePoint>& support, const Dilation& dilation,
                              const std::set<LatticePoint>& points, std::optional<std::size_t> digit) {
  std::unordered_set<FixedPoint, Hash> sums;
  std::vector<FixedPoint> steps;
  for (const LatticePoint& i : support) steps.push_back(fixed(i));
  for (const LatticePoint& k : points) {
    const FixedPoint from = fixed(k);
    for (const FixedPoint& i : steps) sums.insert({from[0] + i[0], from[1] + i[1], from[2] + i[2]});
  }
  std::set<LatticePoint> result;
  for (const FixedPoint& sum : sums) {
    Dilation::Division at = dilation.divide({sum.begin(), sum.begin() + static_cast<long>(dilation.variables())});
    if (!digit || at.digit == *digit) result.insert(std::move(at.quotient));
  }
  return result;
}

std::vector<LatticePoint> support_of(const LatticeMask& mask) {
  std::vector<LatticePoint> support;
  for (const auto& term : mask.symbol().terms()) support.push_back(term.exponents);
  return support;
}

std::set<LatticePoint> reached_from(const std::vector<LatticePoint>& support, const Dilation& dilation,
                                    const std::vector<LatticePoint>& start, std::size_t most_points,
                                    std::optional<std::size_t> digit) {
  std::set<LatticePoint> reached(start.begin(), start.end()), fresh = reached;
  while (!fresh.empty()) {
    std::set<LatticePoint> next;
    for (const LatticePoint& point : images(support, dilation, fresh, digit))
      if (reached.insert(point).second) next.insert(point);
    if (reached.size() > most_points)
      fail(ErrorKind::size, "transition operators: need at most {} lattice points, got more for {} coefficients",
           most_points, support.size());
    fresh = std::move(next);
  }
  return reached;
}

}  // namespace

LatticeWindow::LatticeWindow(const LatticeMask& mask, const std::vector<LatticePoint>& start, std::size_t most_points,
                             std::optional<std::size_t> digit) {
  const std::vector<LatticePoint> support = support_of(mask);
  std::set<LatticePoint> reached = reached_from(support, mask.dilation(), start, most_points, digit);
  // A point without predecessor is left behind after one step.
  for (;; ++steps_) {
    std::set<LatticePoint> kept = images(support, mask.dilation(), reached, digit);
    if (kept.size() == reached.size()) break;
    reached = std::move(kept);
  }
  points_.assign(reached.begin(), reached.end());
}

LatticeWindow LatticeWindow::closure(const LatticeMask& mask, const std::vector<LatticePoint>& start,
                                     std::size_t most_points) {
  const std::set<LatticePoint> reached = reached_from(support_of(mask), mask.dilation(), start, most_points,
                                                      std::nullopt);
  LatticeWindow result;
  result.points_.assign(reached.begin(), reached.end());
  return result;
}

std::size_t LatticeWindow::place(const LatticePoint& point) const {
  const auto at = std::lower_bound(points_.begin(), points_.end(), point);
  return at != points_.end() && *at == point ? static_cast<std::size_t>(at - points_.begin()) : size();
}

std::vector<LatticeSequence> transitions(const LatticeMask& mask, const LatticeSequence& v) {
  const Dilation& dilation = mask.dilation();
  std::vector<LatticeSequence> result(dilation.digits().size());
  for (const auto& term : mask.symbol().terms())
    for (const auto& [k, value] : v) {
      const Dilation::Division at = dilation.divide(term.exponents + k);
      result[at.digit][at.quotient] += term.coefficient * value;
    }
  for (LatticeSequence& sequence : result) std::erase_if(sequence, [](const auto& entry) { return entry.second == 0; });
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

}  // namespace subcert
