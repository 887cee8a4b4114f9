#include "value_space.hpp"

#include <subcert/analysis/radii/joint/modular_meataxe.hpp>

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

/// Sequences in echelon form: each is 1 at a point, its pivot, where those after it are 0.
class SequenceSpace {
 public:
  /// x without its part in the space.
  LatticeSequence reduced(LatticeSequence x) const {
    for (const auto& [pivot, row] : rows_) {
      const auto at = x.find(pivot);
      if (at == x.end()) continue;
      const Rational factor = at->second;
      for (const auto& [point, value] : row) x[point] -= factor * value;
      std::erase_if(x, [](const auto& entry) { return entry.second == 0; });
    }
    return x;
  }
  bool holds(const LatticeSequence& x) const { return reduced(x).empty(); }
  /// Adds a sequence that is reduced and not 0.
  void add(LatticeSequence x) {
    const LatticePoint pivot = x.begin()->first;
    const Rational factor = x.begin()->second;
    for (auto& [point, value] : x) value /= factor;
    rows_.emplace_back(pivot, std::move(x));
  }
  bool is_empty() const { return rows_.empty(); }
  const std::vector<std::pair<LatticePoint, LatticeSequence>>& rows() const { return rows_; }

 private:
  std::vector<std::pair<LatticePoint, LatticeSequence>> rows_;
};

/// The span of the words modulo the prime, recognised over the rationals.
std::optional<SequenceSpace> recognised_space(const LatticeMask& mask, const std::vector<LatticeSequence>& starts,
                                              const std::vector<LatticePoint>& support, std::size_t most_points) {
  const auto closure = LatticeWindow::closure(mask, support, most_points);
  const auto family = radius::modulo_prime(transition_family(mask, closure));
  if (!family) return std::nullopt;
  std::vector<radius::ModVector> vectors;
  for (const LatticeSequence& start : starts) {
    radius::Vector entries(closure.size());
    for (const auto& [point, value] : start) entries[closure.place(point)] = value;
    vectors.push_back(radius::modulo_prime(radius::primitive(entries)));
  }
  const auto space = reached_by_long_words(*family, span_of_words(*family, vectors)).recognised();
  if (!space) return std::nullopt;
  SequenceSpace result;
  for (const radius::Vector& row : *space) {
    LatticeSequence sequence;
    for (std::size_t k = 0; k < row.size(); ++k)
      if (row[k] != 0) sequence.emplace(closure.points()[k], row[k]);
    result.add(std::move(sequence));
  }
  return result;
}

/// Whether all words of some length lead the sequences into the space, which is invariant.
bool leads_into(const LatticeMask& mask, const SequenceSpace& space, const std::vector<LatticeSequence>& starts) {
  constexpr int most_rounds = 64;
  const auto add_rest = [&space](SequenceSpace& rest, const LatticeSequence& x) {
    LatticeSequence reduced = rest.reduced(space.reduced(x));
    if (!reduced.empty()) rest.add(std::move(reduced));
  };
  SequenceSpace rest;
  for (const LatticeSequence& start : starts) add_rest(rest, start);
  for (int round = 0; !rest.is_empty() && round < most_rounds; ++round) {
    SequenceSpace next;
    for (const auto& [pivot, row] : rest.rows())
      for (const LatticeSequence& image : transitions(mask, row)) add_rest(next, image);
    rest = std::move(next);
  }
  return rest.is_empty();
}

/// That of the solutions. Domain: the first digit is 0.
std::optional<DifferenceSpace> space_of_values(const LatticeMask& mask, const std::vector<LatticeSequence>& solutions,
                                               int order, const std::vector<LatticePoint>& directions,
                                               std::size_t most_points) {
  std::vector<LatticeSequence> starts;
  for (const LatticeSequence& difference : differences_of_delta(directions, order))
    for (const LatticeSequence& values : solutions) starts.push_back(convolution(difference, values));
  auto result = space_of_long_words(mask, starts, order, most_points);
  if (result) result->values = solutions.front();
  return result;
}

}  // namespace

std::optional<DifferenceSpace> value_space(const LatticeMask& mask, int order, std::size_t most_points) {
  return value_space(mask, order, exponents_of_degree(mask.dilation().variables(), 1), most_points);
}

std::optional<DifferenceSpace> value_space(const LatticeMask& original, int order,
                                           const std::vector<LatticePoint>& directions, std::size_t most_points) {
  const LatticeMask mask = original.with_dilation(with_zero_first(original.dilation()));
  LatticeSequence values;
  try {
    values = limit_values(mask, 0);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::size) throw;
    return std::nullopt;  // several fixed vectors or none
  }
  return space_of_values(mask, {std::move(values)}, order, directions, most_points);
}

std::optional<DifferenceSpace> value_space(const LatticeMask& mask, const std::vector<LatticeSequence>& solutions,
                                           int order, std::size_t most_points) {
  return space_of_values(mask.with_dilation(with_zero_first(mask.dilation())), solutions, order,
                         exponents_of_degree(mask.dilation().variables(), 1), most_points);
}

std::optional<DifferenceSpace> space_of_long_words(const LatticeMask& mask, const std::vector<LatticeSequence>& starts,
                                                   int order, std::size_t most_points) {
  std::vector<LatticePoint> support;
  for (const LatticeSequence& start : starts)
    for (const auto& [point, value] : start) support.push_back(point);
  if (support.empty()) return std::nullopt;
  const auto space = recognised_space(mask, starts, support, most_points);
  if (!space || space->is_empty() || !leads_into(mask, *space, starts)) return std::nullopt;
  std::vector<LatticeSequence> basis;
  std::vector<LatticePoint> pivots;
  for (const auto& [pivot, row] : space->rows()) {
    for (const LatticeSequence& image : transitions(mask, row))
      if (!space->holds(image)) return std::nullopt;
    pivots.push_back(pivot);
    basis.push_back(row);
  }
  MatrixFamily family = transition_family(mask, basis, pivots);
  return DifferenceSpace{order,
                         mask.dilation(),
                         LatticeWindow(mask, support, most_points),
                         std::move(basis),
                         std::move(pivots),
                         std::move(family)};
}

bool vanish_under_long_words(const LatticeMask& mask, const std::vector<LatticeSequence>& starts) {
  return leads_into(mask, {}, starts);
}

/// Digits among which 0 is the first: those of the dilation, if 0 is one of them.
Dilation with_zero_first(const Dilation& dilation) {
  const LatticePoint zero(dilation.variables(), 0);
  std::vector<LatticePoint> digits = dilation.digits();
  if (std::find(digits.begin(), digits.end(), zero) == digits.end()) digits = Dilation(dilation.rows()).digits();
  std::stable_partition(digits.begin(), digits.end(), [&zero](const LatticePoint& digit) { return digit == zero; });
  return Dilation(dilation.rows(), digits);
}

}  // namespace subcert
