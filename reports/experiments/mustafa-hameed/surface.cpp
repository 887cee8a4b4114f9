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

std::vector<Method> surface_methods() {
  return {l1_method(5, 1, true), l1_method(5, 2, true), l1_method(6, 1, true), l1_method(6, 2, true)};
}

Measured measured_hills(const ExperimentOptions& options) {
  const NoisyData data = hills();
  Measured result;
  study(result, data, surface_methods(), {error_measure, error_without_measure, roughness_measure}, options);
  const data::GridData<double> sample = data.first_data(options.seed);
  formats::SurfaceFigure figure{"nonlinear-surface",
                                "Noisy heights with outliers",
                                "The data, linear polynomials on 6 x 6 data, quadratic ones, and the true surface.",
                                {drawn_surface("data", sample)},
                                2};
  std::vector<data::Axis> fine;
  for (const Method& method : {l1_method(6, 1, true), l1_method(6, 2, true)}) {
    const data::GridData<double> surface = refined(method.specification, sample, data.levels);
    figure.surfaces.push_back(drawn_surface(method.name, surface));
    fine = surface.axes;
  }
  figure.surfaces.push_back(drawn_surface("true", data.true_points(fine)));
  result.surface_figures = {figure};
  return result;
}

}  // namespace

Experiment noisy_surface() {
  const double variance = *hills().sigma * *hills().sigma;
  const std::string sentence =
      "In the surface case the schemes of quadratic polynomials produce smooth models compared with those of linear "
      "ones";
  const std::string minus = ", degree 2 minus degree 1";
  const NamePairs quadratic_over_linear{{"D_5^2", "D_5^1"}, {"D_6^2", "D_6^1"}};
  MeansTable table{
      "nonlinear-surface-errors",
      "Surfaces with outliers",
      {"scheme"},
      rows_of(surface_methods()),
      {{"mean squared error", "error"}, {"without outliers", "error without"}, {"roughness", "roughness"}}};
  return {
      .id = "nonlinear-surface",
      .title = "Surfaces by linear and quadratic polynomials",
      .setup = {"The surfaces are not published. Here: two hills and a hollow, 21 x 21 heights, normal noise of 20 dB "
                "(variance " +
                short_number(variance) +
                "), 12 outliers at random places, up or down by 1/2 to 1 of the range. D_p^d: l1 regression of total "
                "degree d on p x p data, 6 iterations, delta = 1e-8, 2 levels. Roughness: mean square of the second "
                "differences along both axes on the last level."},
      .claims =
          {{.sentence = sentence + " (read literally: smoother).",
            .place = "Sec. 1.1",
            .relation = below("paired difference of the roughness" + minus, 0,
                              differences("roughness", quadratic_over_linear)),
            .recorded = Verdict::not_confirmed},
           {.sentence = sentence + " (read as: nearer to the smooth surface from which the data come).",
            .place = "Sec. 1.1",
            .relation = below("paired difference of the mean squared errors" + minus, 0,
                              differences("error", quadratic_over_linear))},
           {.sentence = "The surface schemes of quadratic polynomials remove noise and outliers (read as: the mean "
                        "squared error is below the variance of the noise).",
            .place = "Sec. 1.1",
            .relation = below("mean squared error", variance, means("error", {"D_5^2", "D_6^2"}))}},
      .tables = {table},
      .measure = measured_hills};
}

}  // namespace subcert::experiments::mustafa_hameed
