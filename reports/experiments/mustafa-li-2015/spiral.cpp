// [MLZD15, sec. 2.5, Experiment 3, Figure 6]: a logarithmic spiral with three outliers.

#include "damped_sine.hpp"

#include <cmath>
#include <numbers>

namespace subcert::experiments::mustafa_li_2015 {
namespace {

constexpr std::size_t spiral_points = 101;
constexpr double step = std::numbers::pi / 20;

NoisyData spiral_data() {
  return {.axes = {data::Axis::of(spiral_points)},
          .dimension = 2,
          .levels = 4,
          .truth =
              [](double u, double) {
                const double t = step * u, r = std::exp(t / 10);
                return std::array{r * std::cos(t), r * std::sin(t), 0.0};
              },
          .outliers = 3,
          .displace =
              [](std::mt19937_64& engine, double* point) {
                const double length = 2 + 2 * uniform(engine), angle = 2 * std::numbers::pi * uniform(engine);
                point[0] += length * std::cos(angle);
                point[1] += length * std::sin(angle);
              }};
}

formats::Figure spiral_figure(const OutlierSample& sample) {
  formats::Figure figure{"l1-exp3",
                         "Logarithmic spiral with three outliers",
                         "One sample. Above least squares, below l1 regression.",
                         3,
                         {}};
  for (const Method& method : curve_methods()) figure.panels.push_back(outlier_panel(spiral_data(), sample, method, 8));
  return figure;
}

}  // namespace

Experiment spiral() {
  const std::string place = "Sec. 2.5, Experiment 3, Fig. 6";
  const std::string moved = "largest distance by which the outliers move the curve", distance = "the largest distance";
  const std::string less_response =
      "Experiment 3 supports Experiment 1: schemes of large complexity respond less to outliers: ";
  const double tenth_of_radius = std::exp(step * (spiral_points - 1) / 10) / 10;
  return with_curve_study(
      {.id = "l1-exp3",
       .title = "Experiment 3 and Figure 6: a spiral with three outliers",
       .setup = {"x = cos t e^(t/10), y = sin t e^(t/10) at t = i pi/20, i = 0, ..., 100; the paper names no range. "
                 "Three random points are moved by a length uniform in [2, 4] in a random direction; no noise. Each "
                 "coordinate is fitted by itself, as in the paper. Curves after 4 refinements, 6 reweighted fits "
                 "with delta = 1e-8, rules at the ends by regression. Error: mean squared distance from the spiral "
                 "at the same parameter; response: the largest distance by which the outliers move a point of the "
                 "curve."},
       .claims = {{.sentence = "The curves of S_6, S_7 and S_8 compromise with the outliers (read as: they move by "
                               "more than a tenth of the largest radius).",
                   .place = place,
                   .relation = above(moved, tenth_of_radius, means("response", least_squares))},
                  {.sentence = "The curves of D_6, D_7 and D_8 do not notice the outliers (read as: they move by "
                               "less than a tenth of the largest radius).",
                   .place = place,
                   .relation = below(moved, tenth_of_radius, means("response", l1_schemes))},
                  {.sentence = less_response + "least squares.",
                   .place = place,
                   .relation = smaller(more_least_squares_points, "response", distance)},
                  {.sentence = less_response + "l1.",
                   .place = place,
                   .relation = smaller(more_l1_points, "response", distance),
                   .recorded = Verdict::not_confirmed},
                  {.sentence = "Experiment 3 supports Experiment 2: the l1 schemes have smaller errors.",
                   .place = place,
                   .relation = smaller(l1_over_least_squares)},
                  {.sentence = "D_6 fits better than the other schemes, in the other experiments too.",
                   .place = "Sec. 2.5, Experiment 2",
                   .relation = smaller(six_over_others)}}},
      "Spiral with three outliers", spiral_data(), curve_methods(), spiral_figure);
}

}  // namespace subcert::experiments::mustafa_li_2015
