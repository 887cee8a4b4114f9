#include "variance_range.hpp"

#include "variance.hpp"

#include <subcert/analysis/limit/extreme.hpp>
#include <subcert/analysis/limit/limit_cells.hpp>
#include <subcert/analysis/limit/limit_values.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace subcert {
namespace {

constexpr long exact_width = 64;  // integers in the support up to which psi is evaluated exactly on level 1
constexpr std::size_t most_cells = 1'000'000;  // of one level

}  // namespace

VarianceRange variance_range(const Mask& mask, const VarianceOptions& options) {
  if (options.relative_width <= 0)
    throw std::invalid_argument("variance_range: need relative_width > 0, got " + to_text(options.relative_width));
  if (!(options.seconds > 0))
    throw std::invalid_argument("variance_range: need seconds > 0, got " + std::to_string(options.seconds));
  const auto start = std::chrono::steady_clock::now();
  const auto expired = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > options.seconds;
  };
  const LimitCells cells(mask);
  const double tolerance = options.relative_width.convert_to<double>() * 0.9;
  const bool slopes = cells.has_slopes();
  Extreme highest(0), lowest(-std::numeric_limits<double>::infinity()), steepest(0);

  VarianceRange result;
  result.slope_reason = cells.slope_reason();
  result.complete = true;
  std::vector<CellForm> active;
  active.push_back(cells.variance_form(0, 0));
  while (!active.empty()) {
    std::vector<CellRange> ranges;
    bool stopped = active.front().level >= cells.deepest_level() || active.size() > most_cells;
    for (const CellForm& form : active) {
      stopped = stopped || expired();
      ranges.push_back(cells.range(form));
      const CellRange& range = ranges.back();
      highest.attain(std::max(range.left_lower, range.right_lower));
      lowest.attain(-std::min(range.left_upper, range.right_upper));
      if (slopes) steepest.attain(range.steepness);
    }
    result.cells += active.size();
    const LimitCells::Spare spare{highest.attained() * tolerance / 50, steepest.attained() * tolerance / 50};
    std::vector<CellForm> next;
    for (std::size_t i = 0; i < active.size(); ++i) {
      const CellRange& range = ranges[i];
      const double slope = std::max(std::abs(range.slope_lower), std::abs(range.slope_upper));
      const bool values_settled = highest.is_settled(range.value_upper, tolerance * highest.attained()) &&
                                  lowest.is_settled(-range.value_lower, tolerance * std::abs(lowest.attained()));
      const bool slope_settled = !slopes || steepest.is_settled(slope, tolerance * steepest.attained());
      const bool worthwhile = (!values_settled && range.value_rounding < 0.5) ||
                              (!slope_settled && range.slope_rounding < 0.5);
      if (stopped || !worthwhile) {
        if (!values_settled || !slope_settled) result.complete = false;
        highest.put_aside(range.value_upper);
        lowest.put_aside(-range.value_lower);
        if (slopes) steepest.put_aside(slope);
        continue;
      }
      for (int t = 0; t < cells.arity(); ++t) {
        const std::int64_t index = active[i].index * cells.arity() + t;
        if (cells.is_mirrored()) {
          std::int64_t count = cells.arity();
          for (int k = 0; k < active[i].level; ++k) count *= cells.arity();
          if (2 * index > count - 1) continue;
        }
        next.push_back(cells.variance_child(active[i], range, t, spare));
      }
    }
    active = std::move(next);
  }
  result.maximum = highest.enclosure();
  result.minimum = lowest.negated();
  if (slopes) result.slope = steepest.enclosure();

  // What is known exactly.
  if (cells.last_integer() - cells.first_integer() <= exact_width) {
    const VarianceGrid grid = variance_grid(mask, 1, false);
    result.maximum.lower = std::max(*result.maximum.lower, grid.largest());
    result.minimum.upper = std::min(*result.minimum.upper, grid.smallest());
  }
  if (const auto ceiling = variance_ceiling(mask)) result.maximum.upper = std::min(*result.maximum.upper, *ceiling);
  result.minimum.lower = std::max(*result.minimum.lower, variance_floor(mask));
  result.mean = squared_l2_norm(mask);
  return result;
}

}  // namespace subcert
