// [DHHS15, sec. 5.1, Figures 14 to 17]: curves in the plane from noisy points.

#include "limit_trial.hpp"
#include "parts.hpp"

#include <cmath>
#include <numbers>

namespace subcert::experiments::dyn_2015 {
namespace {

constexpr std::size_t alpha_points = 30, star_points = 50;

PointGrid alpha_shape(std::size_t refinement) {
  const std::size_t count = (alpha_points - 1) * refinement + 1;
  return sampled_grid(count, 1, 2, [count](double i, double) {
    const double t = -1.4 + 2.8 * i / static_cast<double>(count - 1);
    return std::array{3 * std::pow(t, 4) + t * t + 1, std::pow(t, 5) - 2 * t, 0.0};
  });
}

PointGrid star_shape(std::size_t refinement) {
  const std::size_t count = star_points * refinement;
  return sampled_grid(count, 1, 2, [count](double i, double) {
    const double t = 2 * std::numbers::pi * i / static_cast<double>(count);
    return std::array{4 * std::cos(t) + std::cos(4 * t), 4 * std::sin(t) - std::sin(4 * t), 0.0};
  });
}

/// Twice the area of the triangle of three points of a curve, with its sign.
double orientation(const PointGrid& c, std::size_t i, std::size_t j, std::size_t k) {
  const Coordinate &x = c.points[0], &y = c.points[1];
  return (x[j] - x[i]) * (y[k] - y[i]) - (y[j] - y[i]) * (x[k] - x[i]);
}

/// Pairs of edges of the open polygon that cross properly.
std::size_t crossings(const PointGrid& c) {
  std::size_t result = 0;
  for (std::size_t i = 0; i + 1 < c.columns; ++i)
    for (std::size_t j = i + 2; j + 1 < c.columns; ++j)
      result += orientation(c, i, i + 1, j) * orientation(c, i, i + 1, j + 1) < 0 &&
                orientation(c, j, j + 1, i) * orientation(c, j, j + 1, i + 1) < 0;
  return result;
}

double crossings_kept(const PointGrid& limit, const PointGrid& truth) { return crossings(limit) == crossings(truth); }

/// The sum of the moduli of the angles between edges of the open polygon.
double total_turning(const PointGrid& limit, const PointGrid&) {
  const Coordinate &x = limit.points[0], &y = limit.points[1];
  double result = 0;
  for (std::size_t i = 0; i + 2 < limit.columns; ++i) {
    const double ux = x[i + 1] - x[i], uy = y[i + 1] - y[i], vx = x[i + 2] - x[i + 1], vy = y[i + 2] - y[i + 1];
    result += std::abs(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy));
  }
  return result;
}

/// The smallest distance from the origin over the largest.
double roundness(const PointGrid& limit, const PointGrid&) {
  double least = INFINITY, largest = 0;
  for (std::size_t i = 0; i < limit.columns; ++i) {
    const double radius = std::hypot(limit.points[0][i], limit.points[1][i]);
    least = std::min(least, radius);
    largest = std::max(largest, radius);
  }
  return least / largest;
}

const std::string error = "relative error", turning = "total turning", kept = "crossings kept",
                  radii = "smallest / largest radius";

/// The total turning of the first scheme exceeds that of the second.
Relation turns_more(double decibel, const std::string& first, const std::string& second) {
  Means difference = with_noise(decibel, differences(turning, {{first, second}}));
  difference[0].name.clear();
  return whole_intervals(
      "total turning of " + first + " minus that of " + second + ", positive with its whole interval",
      all_above(0, difference));
}

}  // namespace

Experiment alpha_curve() {
  const LimitTrial trial{.id = "fig15",
                         .title = "Alpha curve",
                         .shape = alpha_shape,
                         .closed = false,
                         .level = 3,
                         .decibels = {17, 4},
                         .schemes = {"primal:n=3", "primal:n=5"},
                         .measures = {{error, point_error}, {turning, total_turning}, {kept, crossings_kept}}};
  const auto [low, high] = trial.decibels;
  const PointGrid truth = alpha_shape(std::size_t{1} << trial.level);
  Means topology = with_noise(high, means(kept, {"S_5", "S_3"}));
  topology[0].lower = 0.5;  // the other one is shown
  return {.id = "fig15",
          .title = "Figures 14 and 15: the alpha curve",
          .setup =
              {"x = 3t^4 + t^2 + 1, y = t^5 - 2t at t = -7/5 + i 14/145, i = 0, ..., 29, as printed; ends continued by "
               "the scheme's own fit (interp), limits at the multiples of 1/8. The signal-to-noise ratio counts both "
               "coordinates. The curve crosses itself " +
               std::to_string(crossings(truth)) + " time(s); its total turning is " +
               short_number(total_turning(truth, truth)) + "."},
          .claims = {{.sentence = "With low noise the limits of S_3 and S_5 retain the general shape.",
                      .place = "Sec. 5.1, Fig. 15(a,b)",
                      .relation = whole_intervals("both keep the number of crossings in more than half of the samples",
                                                  with_noise(low, all_above(0.5, means(kept, {"S_3", "S_5"}))))},
                     {.sentence = "With low noise S_3 fits the noise and has an artifact.",
                      .place = "Sec. 5.1, Fig. 15(a)",
                      .relation = turns_more(low, "S_3", "S_5")},
                     {.sentence = "With high noise S_3 overfits.",
                      .place = "Sec. 5.1, Fig. 15(c)",
                      .relation = turns_more(high, "S_3", "S_5")},
                     {.sentence = "With high noise S_5 preserves the topology.",
                      .place = "Sec. 5.1, Fig. 15(d)",
                      .relation = whole_intervals("the number of crossings is kept in more than half of the samples",
                                                  topology)}},
          .tables = {trial.table()},
          .measure = [trial](const ExperimentOptions& options) {
            Measured result = trial.measured(options);
            result.figures = {trial.curves_figure(options.seed)};
            return result;
          }};
}

Experiment star() {
  const LimitTrial trial{.id = "fig17",
                         .title = "Star",
                         .shape = star_shape,
                         .closed = true,
                         .level = 3,
                         .decibels = {19, 10},
                         .schemes = {"primal:n=3", "primal:n=5", "primal:n=4,d=3", "primal:n=6,d=3"},
                         .measures = {{error, point_error}, {radii, roundness}, {turning, total_turning}}};
  const auto [low, high] = trial.decibels;
  const double between = (0.6 + std::cos(std::numbers::pi / 5)) / 2;
  Means shapes = with_noise(low, all_below(between, means(radii, {"S_3", "S_5", "S_4^3", "S_6^3"})));
  shapes[1].lower = between;
  shapes[1].upper = INFINITY;
  return {
      .id = "fig17",
      .title = "Figures 16 and 17: the star",
      .setup = {"x = 4 cos t + cos 4t, y = 4 sin t - sin 4t. The printed parameters t_i = i/(100 pi), i = 0, ..., 49, "
                "cover only a small arc; here t_i = 2 pi i/50, and the data are closed. Limits at the multiples of "
                "1/8."},
      .claims = {{.sentence = "The samples at t_i = i/(100 pi), i = 0, ..., 49, are those of the star.",
                  .place = "Sec. 5.1, after (26)",
                  .relation = all_facts("period", "50 steps make a period, 2 pi"),
                  .recorded = Verdict::not_confirmed},
                 {.sentence = "With low noise all limits are stars but that of S_5, which is more like a pentagon.",
                  .place = "Sec. 5.1, Fig. 17",
                  .relation = whole_intervals(
                      "smallest over largest radius, 0.6 for the star and cos 36° for a pentagon: above the middle, " +
                          short_number(between) + ", for S_5 and below it for the others",
                      shapes)},
                 {.sentence = "With low noise S_4^3 has a minor artifact, as it fits the noise.",
                  .place = "Sec. 5.1, Fig. 17",
                  .relation = turns_more(low, "S_4^3", "S_6^3")},
                 {.sentence = "With high noise S_3 and S_6^3 are reasonable, S_5 oversmooths and S_4^3 overfits.",
                  .place = "Sec. 5.1, Fig. 17",
                  .relation = whole_intervals(
                      "the errors of S_3 and S_6^3 minus those of S_5 and S_4^3 are negative with their intervals",
                      with_noise(high,
                                 all_below(0, differences(error, all_pairs({"S_3", "S_6^3"}, {"S_5", "S_4^3"})))))}},
      .tables = {trial.table()},
      .measure = [trial](const ExperimentOptions& options) {
        Measured result = trial.measured(options);
        const double covered = star_points / (100 * std::numbers::pi), period = 2 * std::numbers::pi;
        result.add_fact("period", "", std::abs(covered - period) < 0.01,
                        "50 steps cover " + short_number(covered) + " of " + short_number(period));
        result.figures = {trial.curves_figure(options.seed)};
        return result;
      }};
}

}  // namespace subcert::experiments::dyn_2015
