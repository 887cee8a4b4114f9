// [MLZD15, sec. 2.5, Experiment 3, Figure 6]: a logarithmic spiral with three outliers.

#include "damped_sine.hpp"

#include <cmath>
#include <numbers>

namespace subcert::experiments::mustafa_li_2015 {
namespace {

constexpr std::size_t spiral_points = 101;

/// t runs from 0 to `turns` pi, and outliers are moved by a length from `length` to twice that.
NoisyData spiral_data(double turns, double length) {
  const double step = turns * std::numbers::pi / (spiral_points - 1);
  return {.axes = {data::Axis::of(spiral_points)},
          .dimension = 2,
          .levels = 3,
          .truth =
              [step](double u, double) {
                const double t = step * u, r = std::exp(t / 10);
                return std::array{r * std::cos(t), r * std::sin(t), 0.0};
              },
          .outliers = 3,
          .displace =
              [length](std::mt19937_64& engine, double* point) {
                const double moved = length * (1 + uniform(engine)), angle = 2 * std::numbers::pi * uniform(engine);
                point[0] += moved * std::cos(angle);
                point[1] += moved * std::sin(angle);
              }};
}

}  // namespace

Measured spiral(const Run& run) {
  const NoisyData data = spiral_data(run.number("half turns"), run.number("displacement"));
  Measured result;
  add_outlier_study(result, run, "-measures", "Spiral with three outliers", data, curve_methods());
  result.numbers = {{"seen", std::pow(diameter(data.true_points().values, 2) / 100, 2)}};
  if (run.is_alternative()) return result;
  formats::Figure figure{run.experiment.id,
                         "Logarithmic spiral with three outliers",
                         "One sample. Above least squares, below l1 regression.",
                         3,
                         {}};
  for (const Method& method : curve_methods())
    figure.panels.push_back(outlier_panel(data, data.first_sample(run.seed), method, 8));
  result.figures = {figure};
  return result;
}

}  // namespace subcert::experiments::mustafa_li_2015
