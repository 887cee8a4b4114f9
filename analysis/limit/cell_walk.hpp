#pragma once
/// Branch and bound over cells, level by level.

#include "limit_cells.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace subcert {

/// Of what is solved exactly before and after a walk, without which there is no answer: half a second more.
inline Deadline exact_deadline(const Budget& budget) { return budget.deadline.later(0.5); }

/// A lower bound that some point attains, and an upper bound over the cells that were put aside.
/// Canonical: neither is below the start.
class Extreme {
 public:
  explicit Extreme(double start) : attained_(start), aside_(start) {}

  double attained() const { return attained_; }
  /// Some point has at least this value.
  void attain(double value) { attained_ = std::max(attained_, value); }
  /// A cell with values up to `upper` need not be split: it can raise the maximum by at most `margin`.
  bool is_settled(double upper, double margin) const { return upper <= attained_ + margin; }
  void put_aside(double upper) { aside_ = std::max(aside_, upper); }
  /// Encloses the maximum, once all cells are aside.
  Enclosure enclosure() const { return {Rational(attained_), Rational(std::max(attained_, aside_))}; }
  /// Encloses the minimum, where the values given were those of the function with the other sign.
  Enclosure negated() const { return {-Rational(std::max(attained_, aside_)), -Rational(attained_)}; }

 private:
  double attained_;
  double aside_;
};

/// The largest and the smallest value and the largest |slope| of a function. Relative to the size that the caller
/// names, a cell is settled where it can raise none of them by more than the tolerance.
struct CellExtremes {
  Extreme highest, lowest;  // lowest: of the function with the other sign
  bool slopes;
  double tolerance;
  Extreme steepest{0};

  static double slope(const CellRange& range) {
    return std::max(std::abs(range.slope_lower), std::abs(range.slope_upper));
  }
  void attain(const CellRange& range) {
    highest.attain(std::max(range.left_lower, range.right_lower));
    lowest.attain(-std::min(range.left_upper, range.right_upper));
    if (slopes) steepest.attain(range.steepness);
  }
  bool values_settled(const CellRange& range, double high, double low) const {
    return highest.is_settled(range.value_upper, tolerance * high) &&
           lowest.is_settled(-range.value_lower, tolerance * low);
  }
  bool slope_settled(const CellRange& range) const {
    return !slopes || steepest.is_settled(slope(range), tolerance * steepest.attained());
  }
  void put_aside(const CellRange& range) {
    highest.put_aside(range.value_upper);
    lowest.put_aside(-range.value_lower);
    if (slopes) steepest.put_aside(slope(range));
  }
};

/// `own`: the range is that of the form, else that of the larger cell it was cut from, whose values and slopes hold all
/// of those here.
struct WalkedCell {
  CellForm form;
  CellRange range{};
  bool own = false;
};

/// Calls attain(range) for the cells of a level, then split(cell, may_split), which gives the parts that are to be
/// looked at on the next level, none where it puts the cell aside; it must where !may_split. Returns the number of
/// cells. Past the deadline, and once the cells of a level and their parts hold the memory of the budget, no cell may
/// be split; past the deadline the cells that are left keep the range of a larger one, so that the walk ends at once.
template <class Attain, class Split>
std::uint64_t walk_cells(const LimitCells& cells, std::vector<CellForm> first, const Budget& budget,
                         const Attain& attain, const Split& split) {
  std::uint64_t visited = 0;
  std::vector<WalkedCell> active;
  for (CellForm& form : first) active.push_back({std::move(form)});
  bool late = false;
  for (bool first_level = true; !active.empty(); first_level = false) {
    for (WalkedCell& cell : active) {
      late = late || budget.deadline.expired();
      if (late && !first_level) break;
      cell.range = cells.range(cell.form);
      cell.own = true;
      attain(cell.range);
    }
    visited += active.size();
    const bool deepest = active.front().form.level >= cells.deepest_level();
    std::size_t held = 0;
    for (const WalkedCell& cell : active) held += cell.form.memory();
    std::vector<WalkedCell> next;
    for (const WalkedCell& cell : active) {
      late = late || budget.deadline.expired();
      for (CellForm& part : split(cell, !late && !deepest && held <= budget.memory)) {
        held += part.memory();
        next.push_back({std::move(part), cell.range});
      }
    }
    active = std::move(next);
  }
  return visited;
}

}  // namespace subcert
