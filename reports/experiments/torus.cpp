// [DHHS15, sec. 5.2, Figures 18 and 19]: a torus from noisy points.

#include "decided.hpp"
#include "families.hpp"
#include "tensor_limit.hpp"

#include <cmath>
#include <numbers>

namespace subcert::experiments::torus {
namespace {

PointGrid torus(std::size_t count) {
  PointGrid result{count, count, {}};
  const double step = 2 * std::numbers::pi / static_cast<double>(count);
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t i = 0; i < count; ++i) {
      const double u = step * static_cast<double>(i), v = step * static_cast<double>(j);
      result.points[0].push_back(std::cos(u) * (10 + 5 * std::cos(v)));
      result.points[1].push_back(std::sin(u) * (10 + 5 * std::cos(v)));
      result.points[2].push_back(5 * std::sin(v));
    }
  return result;
}

ExperimentResult run(const ExperimentOptions& options) {
  constexpr std::size_t count = 24;
  const SurfaceTrial trial{"fig19", "Torus", torus(count), torus(2 * count),
                           true,    1,       {15, 6},      {"primal:n=3", "primal:n=5"}};
  const auto [error, shape_error, normal_error] = measure(trial, options);
  ExperimentResult result{
      {"The torus at u, v = i pi/12, i = 0, ..., 23, closed in both directions, as printed; limits at the multiples "
       "of 1/2. The signal-to-noise ratio counts all three coordinates. The error up to size is that of the limit "
       "after it is scaled about its centre by the best factor; the error of the normals is the root mean square "
       "angle, in degrees.",
       "In the figure each surface fills its panel; the limits of S_5 x S_5 are much smaller than the torus."}};
  const auto interval = [](const Measured& measured, std::size_t scheme, std::size_t noise) {
    return mean_interval(measured[scheme][noise]);
  };
  const MeanInterval low3 = interval(error, 0, 0), low5 = interval(error, 1, 0);
  result.claims.push_back(decided(
      {"With low noise both limits are fairly good (read as: relative error below 1/10).", "Sec. 5.2, Fig. 19(a,b)"},
      "means below 1/10 with their intervals", low3.mean + low3.half_width < 0.1 && low5.mean + low5.half_width < 0.1,
      "S_3: " + low3.text() + ", S_5: " + low5.text(), Verdict::not_confirmed));
  const std::string sentence = "With high noise S_5 x S_5 provides a better approximation than S_3 x S_3";
  const Dominance whole = dominance(error, 1, trial.schemes, {1}, {0}),
                  shape = dominance(shape_error, 1, trial.schemes, {1}, {0}),
                  normals = dominance(normal_error, 1, trial.schemes, {1}, {0});
  result.claims.push_back(decided({sentence + ".", "Sec. 5.2, Fig. 19(c,d)"},
                                  "mean of the paired difference of relative errors, negative with its whole interval",
                                  whole.shown, whole.numbers, Verdict::not_confirmed));
  result.claims.push_back(decided({sentence + " (read as: of the shape, whatever its size).", "Sec. 5.2, Fig. 19(c,d)"},
                                  "the same with the errors up to size", shape.shown, shape.numbers,
                                  Verdict::not_confirmed));
  result.claims.push_back(
      decided({sentence + " (read as: of the normals, which a shaded picture shows).", "Sec. 5.2, Fig. 19(c,d)"},
              "the same with the errors of the normals", normals.shown, normals.numbers));
  result.tables.push_back(measures_table(
      "fig19-measures", "Torus", trial.schemes, trial.decibels,
      {{"relative error", &error}, {"error up to size", &shape_error}, {"normals (degrees)", &normal_error}}));
  result.surface_figures = {samples_figure(trial, "fig18", options.seed), limits_figure(trial, options.seed)};
  return result;
}

}  // namespace

std::vector<Experiment> all() { return {{"fig19", "dyn-2015", "Figures 18 and 19: the torus", run}}; }

}  // namespace subcert::experiments::torus
