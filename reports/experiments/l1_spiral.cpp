// [MLZD15, sec. 2.5, Experiment 3, Figure 6]: a logarithmic spiral with three outliers.

#include "families.hpp"
#include "outlier_study.hpp"
#include "plane_panel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace subcert::experiments::l1_spiral {
namespace {

constexpr std::size_t count = 101;
constexpr int levels = 4;
constexpr double step = std::numbers::pi / 20;

std::array<double, 3> spiral(double u) {
  const double t = step * u, r = std::exp(t / 10);
  return {r * std::cos(t), r * std::sin(t), 0};
}

OutlierCase spiral_case() {
  return {{data::Axis::of(count)},
          2,
          levels,
          [](std::mt19937_64& engine) {
            OutlierSample sample;
            for (std::size_t i = 0; i < count; ++i) {
              const auto p = spiral(static_cast<double>(i));
              sample.without.insert(sample.without.end(), {p[0], p[1]});
            }
            sample.with = sample.without;
            for (const std::size_t i : chosen_indices(engine, 3, count)) {
              const double length = 2 + 2 * uniform(engine), angle = 2 * std::numbers::pi * uniform(engine);
              sample.with[2 * i] += length * std::cos(angle);
              sample.with[2 * i + 1] += length * std::sin(angle);
            }
            return sample;
          },
          [](double u, double) { return spiral(u); }};
}

formats::Panel panel(const Method& method, const OutlierSample& sample) {
  const Batch fine = refined(method.specification, {{data::Axis::of(count)}, 2, {sample.with}}, levels);
  PanelParts parts{method.name, {}, {}, {}, {}, method.name[0] == 'D', true};
  for (std::size_t i = 0; i < count; ++i) {
    const double x = sample.with[2 * i], y = sample.with[2 * i + 1];
    (x != sample.without[2 * i] ? parts.outliers : parts.data).emplace_back(x, y);
  }
  for (std::size_t i = 0; i <= 8 * (count - 1); ++i) {
    const auto p = spiral(static_cast<double>(i) / 8);
    parts.truth.emplace_back(p[0], p[1]);
  }
  for (std::size_t i = 0; i < fine.sets[0].size(); i += 2)
    parts.curve.emplace_back(fine.sets[0][i], fine.sets[0][i + 1]);
  return plane_panel(parts);
}

ExperimentResult run(const ExperimentOptions& options) {
  const OutlierCase what = spiral_case();
  const auto outcomes = study(what, curve_methods(), options);
  const std::string place = "Sec. 2.5, Experiment 3, Fig. 6";
  const double bound = std::exp(step * (count - 1) / 10) / 10;
  ExperimentResult result{
      {"x = cos t e^(t/10), y = sin t e^(t/10) at t = i pi/20, i = 0, ..., 100; the paper names no range. Three random "
       "points are "
       "moved by a length uniform in [2, 4] in a random direction; no noise. Each coordinate is fitted by itself, as "
       "in the "
       "paper. Curves after 4 refinements, 6 reweighted fits with delta = 1e-8, rules at the ends by regression. "
       "Error: mean "
       "squared distance from the spiral at the same parameter; response: the largest distance by which the outliers "
       "move a "
       "point of the curve."}};
  result.claims = {
      all_above({"The curves of S_6, S_7 and S_8 compromise with the outliers (read as: they move by more than a tenth "
                 "of the "
                 "largest radius).",
                 place},
                "largest distance by which the outliers move the curve", bound,
                means(outcomes, least_squares, &Outcome::response)),
      all_below(
          {"The curves of D_6, D_7 and D_8 do not notice the outliers (read as: they move by less than a tenth of the "
           "largest radius).",
           place},
          "largest distance by which the outliers move the curve", bound, means(outcomes, robust, &Outcome::response)),
      all_below(
          {"Experiment 3 supports Experiment 1: schemes of large complexity respond less to outliers: least squares.",
           place},
          "paired differences of the largest distance", 0,
          differences(outcomes, more_least_squares_points, &Outcome::response)),
      all_below(
          {"Experiment 3 supports Experiment 1: schemes of large complexity respond less to outliers: l1.", place},
          "paired differences of the largest distance", 0,
          differences(outcomes, more_robust_points, &Outcome::response), Verdict::not_confirmed),
      all_below({"Experiment 3 supports Experiment 2: the l1 schemes have smaller errors.", place},
                "paired differences of the errors", 0,
                differences(outcomes, robust_over_least_squares, &Outcome::error)),
      all_below({"D_6 fits better than the other schemes, in the other experiments too.", "Sec. 2.5, Experiment 2"},
                "paired differences of the errors", 0, differences(outcomes, six_over_others, &Outcome::error))};
  result.tables.push_back(outcome_table("l1-exp3-measures", "Spiral with three outliers", outcomes));
  auto engine = generator(options.seed, 0);
  const OutlierSample sample = what.draw(engine);
  formats::Figure figure{"l1-exp3",
                         "Logarithmic spiral with three outliers",
                         "One sample. Above least squares, below l1 regression.",
                         3,
                         {}};
  for (const Method& method : curve_methods()) figure.panels.push_back(panel(method, sample));
  result.figures.push_back(figure);
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  return {{"l1-exp3", "mustafa-li-2015", "Experiment 3 and Figure 6: a spiral with three outliers", run}};
}

}  // namespace subcert::experiments::l1_spiral
