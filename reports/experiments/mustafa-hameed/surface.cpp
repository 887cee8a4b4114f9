// [MH, sec. 1.1]: surfaces by linear and quadratic bivariate polynomials.

#include "parts.hpp"

#include <subcert/reports/experiments/figures.hpp>

#include <cmath>

namespace subcert::experiments::mustafa_hameed {
namespace {

/// Two hills and a hollow.
NoisyData hills() {
  NoisyData data{.axes = {data::Axis::of(21), data::Axis::of(21)}, .levels = 2, .truth = [](double x, double y) {
                   const double u = (x - 10) / 4, v = (y - 10) / 4;
                   return std::array{3 * std::exp(-(u - 1) * (u - 1) - v * v) +
                                         2 * std::exp(-(u + 1.2) * (u + 1.2) - (v - 0.8) * (v - 0.8)) -
                                         2 * std::exp(-u * u - (v + 1.3) * (v + 1.3)),
                                     0.0, 0.0};
                 }};
  const auto samples = data.true_points().values;
  const double range = diameter(samples, 1);
  data.sigma = noise_deviation(mean_square(samples), 20);
  data.outliers = 12;
  data.displace = [range](std::mt19937_64& engine, double* height) {
    *height += (0.5 + uniform(engine) / 2) * (uniform(engine) < 0.5 ? range : -range);
  };
  return data;
}

}  // namespace

Measured noisy_surface(const Run& run) {
  const std::string id = run.experiment.id;
  const NoisyData data = hills();
  const std::vector<Method> methods{l1_method(5, 1, true), l1_method(5, 2, true), l1_method(6, 1, true),
                                    l1_method(6, 2, true)};
  Measured result;
  study(result, data, methods, {error_measure, error_without_measure, roughness_measure}, run);
  result.numbers = {{"noise", *data.sigma * *data.sigma}};
  const data::GridData<double> sample = data.first_data(run.seed);
  formats::SurfaceFigure figure{id,
                                "Noisy heights with outliers",
                                "The data, linear polynomials on 6 x 6 data, quadratic ones, and the true surface.",
                                {drawn_surface("data", sample)},
                                2};
  std::vector<data::Axis> fine;
  for (const Method& method : {methods[2], methods[3]}) {
    const data::GridData<double> surface = refined(method.specification, sample, data.levels);
    figure.surfaces.push_back(drawn_surface(method.name, surface));
    fine = surface.axes;
  }
  figure.surfaces.push_back(drawn_surface("true", data.true_points(fine)));
  result.surface_figures = {figure};
  result.tables = {
      MeansTable{id + "-errors",
                 "Surfaces with outliers",
                 {"scheme"},
                 rows_of(methods),
                 {{"mean squared error", "error"}, {"without outliers", "error without"}, {"roughness", "roughness"}}}
          .filled(result)};
  return result;
}

}  // namespace subcert::experiments::mustafa_hameed
