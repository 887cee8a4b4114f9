#include "damped_sine.hpp"

#include <subcert/reports/experiments/figures.hpp>

#include <cmath>
#include <numbers>

namespace subcert::experiments::mustafa_li_2015 {

double damped_sine(double x) { return std::sin(3 * x) * std::exp(-x / 3); }

formats::Panel outlier_panel(const NoisyData& data, const OutlierSample& sample, const Method& method, int density,
                             const Rational& origin, const Rational& scale) {
  const bool in_plane = data.dimension > 1;
  const Points drawn = points_of(placed(data.as_grid(sample.with), origin, scale));
  Points kept, outliers;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    (sample.with[i * data.dimension] != sample.without[i * data.dimension] ? outliers : kept).push_back(drawn[i]);
  const data::GridData<double> truth = data.true_points({finer(data.axes[0], density)}),
                               fitted = refined(method.specification, data.as_grid(sample.with),
                                                method.levels.value_or(data.levels));
  formats::Panel panel = plain_panel(
      method.name,
      {line("original", points_of(placed(truth, origin, scale)), colour::amber), dots("data", kept, colour::grey)},
      in_plane);
  if (!outliers.empty()) panel.curves.push_back(dots("outliers", outliers, colour::violet));
  panel.curves.push_back(line("fitted", points_of(placed(fitted, origin, scale)),
                              method.specification.starts_with("l1") ? colour::blue : colour::red));
  return panel;
}

namespace damped {

Setting setting(const Run& run) {
  return {run.number("half interval"), static_cast<std::size_t>(run.number("data")), run.number("heights")};
}

NoisyData Setting::with_outliers(std::size_t outliers, double sigma) const {
  return {.axes = {data::Axis::of(count)},
          .levels = levels,
          .truth =
              [at = *this](double u, double) {
                return std::array{damped_sine(at.position(u)), 0.0, 0.0};
              },
          .sigma = sigma,
          .outliers = outliers,
          .displace = vertical_outlier(height, height)};
}

std::map<std::string, double> Setting::numbers() const {
  constexpr int steps = 10000;
  double from_zero = 0;  // the sum of squares on [0, 2 pi]
  for (int i = 0; i < steps; ++i) from_zero += std::pow(damped_sine((i + 0.5) * 2 * std::numbers::pi / steps), 2);
  const std::vector<double> heights = with_outliers(0, 0).true_points().values;
  return {{"mean square", mean_square(heights)},
          {"seen", std::pow(diameter(heights, 1) / 100, 2)},
          {"mean square from 0", from_zero / steps}};
}

formats::Panel panel(const OutlierSample& sample, const Method& method) {
  return outlier_panel(Setting().with_outliers(0, 0), sample, method, 4, -5, Rational(1, 10));
}

formats::Figure figure(const std::string& id, const std::string& title, const std::string& caption, int columns,
                       const std::vector<Method>& methods, const OutlierSample& sample) {
  formats::Figure result{id, title, caption, columns, {}};
  for (const Method& method : methods) result.panels.push_back(panel(sample, method));
  return result;
}

}  // namespace damped
}  // namespace subcert::experiments::mustafa_li_2015
