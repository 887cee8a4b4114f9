#include "lattice_window.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>
#include <set>

namespace subcert {
namespace {

/// Where T_d v has its support, over all digits d or for one, for v supported on `points`.
std::set<LatticePoint> images(const std::vector<LatticePoint>& support, const Dilation& dilation,
                              const std::set<LatticePoint>& points, std::optional<std::size_t> digit) {
  std::set<LatticePoint> result;
  for (const LatticePoint& k : points)
    for (const LatticePoint& i : support) {
      Dilation::Division at = dilation.divide(i + k);
      if (!digit || at.digit == *digit) result.insert(std::move(at.quotient));
    }
  return result;
}

}  // namespace

LatticeWindow::LatticeWindow(const MultivariatePolynomial& symbol, const Dilation& dilation,
                             const std::vector<LatticePoint>& start, std::size_t most_points,
                             std::optional<std::size_t> digit) {
  std::vector<LatticePoint> support;
  for (const auto& term : symbol.terms()) support.push_back(term.exponents);
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
  // A point without predecessor is left behind after one step.
  for (;; ++steps_) {
    std::set<LatticePoint> kept = images(support, dilation, reached, digit);
    if (kept.size() == reached.size()) break;
    reached = std::move(kept);
  }
  points_.assign(reached.begin(), reached.end());
}

std::size_t LatticeWindow::place(const LatticePoint& point) const {
  const auto at = std::lower_bound(points_.begin(), points_.end(), point);
  return at != points_.end() && *at == point ? static_cast<std::size_t>(at - points_.begin()) : size();
}

std::vector<LatticeSequence> transitions(const MultivariatePolynomial& symbol, const Dilation& dilation,
                                         const LatticeSequence& v) {
  std::vector<LatticeSequence> result(dilation.digits().size());
  for (const auto& term : symbol.terms())
    for (const auto& [k, value] : v) {
      const Dilation::Division at = dilation.divide(term.exponents + k);
      result[at.digit][at.quotient] += term.coefficient * value;
    }
  for (LatticeSequence& sequence : result) std::erase_if(sequence, [](const auto& entry) { return entry.second == 0; });
  return result;
}

std::vector<LatticeSequence> differences_of_delta(std::size_t variables, int order) {
  std::vector<LatticeSequence> result;
  for (const LatticePoint& exponents : exponents_of_degree(variables, order)) {
    LatticeSequence sequence{{LatticePoint(variables, 0), 1}};
    for (std::size_t v = 0; v < variables; ++v)
      for (long round = 0; round < exponents[v]; ++round) {
        LatticeSequence next = sequence;
        for (const auto& [point, value] : sequence) {
          LatticePoint moved = point;
          ++moved[v];
          next[moved] -= value;
        }
        sequence = std::move(next);
      }
    std::erase_if(sequence, [](const auto& entry) { return entry.second == 0; });
    result.push_back(std::move(sequence));
  }
  return result;
}

}  // namespace subcert
