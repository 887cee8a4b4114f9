#include "variance_range.hpp"

#include "mirror.hpp"
#include "variance.hpp"

#include <subcert/analysis/limit/cell_walk.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace subcert {
namespace {

constexpr long exact_width = 64;  // integers in the support up to which psi is evaluated exactly on level 1

/// What is known exactly.
void tighten(const Mask& mask, bool narrow, const Deadline& deadline, VarianceRange& range) {
  if (narrow) {
    const VarianceGrid grid = variance_grid(mask, 1, false, deadline);
    range.maximum.lower = std::max(*range.maximum.lower, grid.largest());
    range.minimum.upper = std::min(*range.minimum.upper, grid.smallest());
  }
  if (const auto ceiling = variance_ceiling(mask)) range.maximum.upper = std::min(*range.maximum.upper, *ceiling);
  range.minimum.lower = std::max(*range.minimum.lower, variance_floor(mask));
  range.mean = squared_l2_norm(mask, deadline);
}

}  // namespace

VarianceRange variance_range(const Mask& mask, const VarianceOptions& options) {
  require(options.relative_width > 0, "variance_range: need relative_width > 0, got {}",
          to_text(options.relative_width));
  const Deadline exact = exact_deadline(options.budget);
  const LimitCells cells(mask, exact);
  const double tolerance = options.relative_width.convert_to<double>() * 0.9;
  CellExtremes extremes{Extreme(0), Extreme(-std::numeric_limits<double>::infinity()), cells.has_slopes(), tolerance};
  VarianceRange result;
  result.slope_reason = cells.slope_reason();
  result.complete = true;
  const auto split = [&](const WalkedCell& cell, bool may_split) {
    const CellRange& range = cell.range;
    const double highest = extremes.highest.attained();
    const bool values_settled = extremes.values_settled(range, highest, std::abs(extremes.lowest.attained()));
    const bool slope_settled = extremes.slope_settled(range);
    const bool worthwhile = (!values_settled && range.value_rounding < 0.5) ||
                            (!slope_settled && range.slope_rounding < 0.5);
    std::vector<CellForm> parts;
    if (may_split && worthwhile) {
      const LimitCells::Spare spare{highest * tolerance / 50, extremes.steepest.attained() * tolerance / 50};
      for (int t = 0; t < cells.arity(); ++t)
        if (!cells.is_mirrored() || !is_mirror_image(cell.form, t, cells.arity()))
          parts.push_back(cells.variance_child(cell.form, range, t, spare));
      return parts;
    }
    if (!values_settled || !slope_settled) result.complete = false;
    extremes.put_aside(range);
    return parts;
  };
  std::vector<CellForm> first;
  first.push_back(cells.variance_form(0, 0));
  result.cells = walk_cells(
      cells, std::move(first), options.budget, [&](const CellRange& range) { extremes.attain(range); }, split);
  result.maximum = extremes.highest.enclosure();
  result.minimum = extremes.lowest.negated();
  if (extremes.slopes) result.slope = extremes.steepest.enclosure();
  tighten(mask, cells.last_integer() - cells.first_integer() <= exact_width, exact, result);
  return result;
}

}  // namespace subcert
