// [DHHS15, sec. 5.2, Figures 18 to 21]: surfaces from noisy points.

#include "mechanical_part.hpp"
#include "parts.hpp"

#include <cmath>
#include <numbers>

namespace subcert::experiments::dyn_2015 {
namespace {

PointGrid torus_shape(std::size_t refinement) {
  const std::size_t count = 24 * refinement;
  const double step = 2 * std::numbers::pi / static_cast<double>(count);
  return sampled_grid(count, count, 3, [step](double i, double j) {
    const double u = step * i, v = step * j;
    return std::array{std::cos(u) * (10 + 5 * std::cos(v)), std::sin(u) * (10 + 5 * std::cos(v)), 5 * std::sin(v)};
  });
}

const std::string points = "relative error", size_free = "error up to size", normals = "normals (degrees)";

/// The errors of the first of each pair are smaller.
Relation smaller_errors(const std::string& statistic, const std::string& measure, double decibel,
                        const NamePairs& pairs) {
  return whole_intervals(statistic, with_noise(decibel, all_below(0, differences(measure, pairs))));
}

/// With pictures of samples and limits.
std::function<Measured(const ExperimentOptions&)> measured_and_drawn(const LimitTrial& trial,
                                                                     const std::string& samples_id) {
  return [trial, samples_id](const ExperimentOptions& options) {
    Measured result = trial.measured(options);
    result.surface_figures = {trial.samples_figure(samples_id, options.seed), trial.surfaces_figure(options.seed)};
    return result;
  };
}

}  // namespace

Experiment torus() {
  const LimitTrial trial{.id = "fig19",
                         .title = "Torus",
                         .shape = torus_shape,
                         .closed = true,
                         .level = 1,
                         .decibels = {15, 6},
                         .schemes = {"primal:n=3", "primal:n=5"},
                         .measures = {{points, point_error}, {size_free, shape_error}, {normals, normal_error}}};
  const auto [low, high] = trial.decibels;
  const std::string sentence = "With high noise S_5 x S_5 provides a better approximation than S_3 x S_3";
  const std::string place = "Sec. 5.2, Fig. 19(c,d)";
  const NamePairs pair{{"S_5", "S_3"}};
  return {.id = "fig19",
          .title = "Figures 18 and 19: the torus",
          .setup =
              {"The torus at u, v = i pi/12, i = 0, ..., 23, closed in both directions, as printed; limits at the "
               "multiples of 1/2. The signal-to-noise ratio counts all three coordinates. The error up to size is that "
               "of the limit after it is scaled about its centre by the best factor; the error of the normals is the "
               "root mean square angle, in degrees.",
               "In the figure each surface fills its panel; the limits of S_5 x S_5 are much smaller than the torus."},
          .claims = {{.sentence = "With low noise both limits are fairly good (read as: relative error below 1/10).",
                      .place = "Sec. 5.2, Fig. 19(a,b)",
                      .relation = whole_intervals("means below 1/10 with their intervals",
                                                  with_noise(low, all_below(0.1, means(points, {"S_3", "S_5"})))),
                      .recorded = Verdict::not_confirmed},
                     {.sentence = sentence + ".",
                      .place = place,
                      .relation = smaller_errors(
                          "mean of the paired difference of relative errors, negative with its whole interval", points,
                          high, pair),
                      .recorded = Verdict::not_confirmed},
                     {.sentence = sentence + " (read as: of the shape, whatever its size).",
                      .place = place,
                      .relation = smaller_errors("the same with the errors up to size", size_free, high, pair),
                      .recorded = Verdict::not_confirmed},
                     {.sentence = sentence + " (read as: of the normals, which a shaded picture shows).",
                      .place = place,
                      .relation = smaller_errors("the same with the errors of the normals", normals, high, pair)}},
          .tables = {trial.table()},
          .measure = measured_and_drawn(trial, "fig18")};
}

Experiment mechanical_part_scan() {
  const LimitTrial trial{.id = "fig21",
                         .title = "Mechanical part",
                         .shape = mechanical_part,
                         .closed = false,
                         .level = 1,
                         .decibels = {24, 18},
                         .schemes = {"primal:n=3", "primal:n=5", "primal:n=4,d=3", "primal:n=6,d=3"},
                         .measures = {{points, point_error}, {normals, normal_error}}};
  const auto [low, high] = trial.decibels;
  const std::string with_low = "With low noise S_3 x S_3 and S_6^3 x S_6^3 outperform the other two schemes";
  const std::string with_high = "With high noise S_5 x S_5 is superior to the other three";
  const std::string upper = "Sec. 5.2, Fig. 21, upper row", lower = "Sec. 5.2, Fig. 21, lower row";
  const NamePairs two_over_two = all_pairs({"S_3", "S_6^3"}, {"S_5", "S_4^3"}),
                  one_over_three = all_pairs({"S_5"}, {"S_3", "S_4^3", "S_6^3"});
  const auto negative = [](const std::string& of) {
    return "the mean paired differences of the errors of the " + of + " are negative with their whole intervals";
  };
  return {
      .id = "fig21",
      .title = "Figures 20 and 21: a mechanical part",
      .setup = {"The paper's scan is not published. Here a surface of the same size, 49 x 81 points: a plate with a "
                "step, a groove, a boss with fillet and bore, and a rib, one unit between neighbours, centred at the "
                "origin. Noise in all three coordinates, which the signal-to-noise ratio counts together; ends "
                "continued by the scheme's own fit (interp); limits compared at the multiples of 1/2, drawn at the "
                "data. The error of the normals is the root mean square angle, in degrees."},
      .claims = {{.sentence = with_low + ".",
                  .place = upper,
                  .relation = smaller_errors(negative("points"), points, low, two_over_two),
                  .recorded = Verdict::not_confirmed},
                 {.sentence = with_low + " (read as: in the normals, which a shaded picture shows).",
                  .place = upper,
                  .relation = smaller_errors(negative("normals"), normals, low, two_over_two)},
                 {.sentence = with_high + ".",
                  .place = lower,
                  .relation = smaller_errors(negative("points"), points, high, one_over_three),
                  .recorded = Verdict::not_confirmed},
                 {.sentence = with_high + " (read as: in the normals).",
                  .place = lower,
                  .relation = smaller_errors(negative("normals"), normals, high, one_over_three),
                  .recorded = Verdict::not_confirmed}},
      .tables = {trial.table()},
      .measure = measured_and_drawn(trial, "fig20")};
}

}  // namespace subcert::experiments::dyn_2015
