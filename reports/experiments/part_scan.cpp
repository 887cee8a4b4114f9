// [DHHS15, sec. 5.2, Figures 20 and 21]: the scan of a mechanical element.

#include "decided.hpp"
#include "families.hpp"
#include "mechanical_part.hpp"

namespace subcert::experiments::part_scan {
namespace {

ExperimentResult run(const ExperimentOptions& options) {
  const SurfaceTrial trial{"fig21",
                           "Mechanical part",
                           mechanical_part(1),
                           mechanical_part(2),
                           false,
                           1,
                           {24, 18},
                           {"primal:n=3", "primal:n=5", "primal:n=4,d=3", "primal:n=6,d=3"}};
  const auto [error, shape_error, normal_error] = measure(trial, options);
  ExperimentResult result{
      {"The paper's scan is not published. Here a surface of the same size, 49 x 81 points: a plate with a step, a "
       "groove, a boss with fillet and bore, and a rib, one unit between neighbours, centred at the origin. Noise in "
       "all three coordinates, which the signal-to-noise ratio counts together; ends continued by the scheme's own "
       "fit (interp); limits compared at the multiples of 1/2, drawn at the data. The error of the normals is the "
       "root mean square angle, in degrees."}};
  const std::string low = "With low noise S_3 x S_3 and S_6^3 x S_6^3 outperform the other two schemes";
  const std::string high = "With high noise S_5 x S_5 is superior to the other three";
  const auto add = [&](const std::string& sentence, const std::string& row, const Dominance& found,
                       const std::string& of, Verdict recorded) {
    result.claims.push_back(
        decided({sentence, "Sec. 5.2, Fig. 21, " + row},
                "the mean paired differences of the errors of the " + of + " are negative with their whole intervals",
                found.shown, found.numbers, recorded));
  };
  add(low + ".", "upper row", dominance(error, 0, trial.schemes, {0, 3}, {1, 2}), "points", Verdict::not_confirmed);
  add(low + " (read as: in the normals, which a shaded picture shows).", "upper row",
      dominance(normal_error, 0, trial.schemes, {0, 3}, {1, 2}), "normals", Verdict::confirmed);
  add(high + ".", "lower row", dominance(error, 1, trial.schemes, {1}, {0, 2, 3}), "points", Verdict::not_confirmed);
  add(high + " (read as: in the normals).", "lower row", dominance(normal_error, 1, trial.schemes, {1}, {0, 2, 3}),
      "normals", Verdict::not_confirmed);
  result.tables.push_back(measures_table("fig21-measures", "Mechanical part", trial.schemes, trial.decibels,
                                         {{"relative error", &error}, {"normals (degrees)", &normal_error}}));
  result.surface_figures = {samples_figure(trial, "fig20", options.seed), limits_figure(trial, options.seed)};
  return result;
}

}  // namespace

std::vector<Experiment> all() { return {{"fig21", "dyn-2015", "Figures 20 and 21: a mechanical part", run}}; }

}  // namespace subcert::experiments::part_scan
