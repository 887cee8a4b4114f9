// [MH, abstract and sec. 1.1, Figures 8 and 9]: noisy data with outliers.

#include "parts.hpp"

#include <subcert/reports/experiments/figures.hpp>

#include <cmath>
#include <numbers>

namespace subcert::experiments::mustafa_hameed {
namespace {

const std::vector<int> windows{6, 8, 10};
constexpr std::size_t function_points = 61, curve_points = 60;

/// With noise of this ratio and four outliers.
NoisyData with_noise(NoisyData data, double decibel) {
  data.sigma = noise_deviation(mean_square(data.true_points().values), decibel);
  data.outliers = 4;
  return data;
}

NoisyData function_data() {
  NoisyData data = with_noise({.axes = {data::Axis::of(function_points)},
                               .levels = 3,
                               .truth =
                                   [](double x, double) {
                                     return std::array{std::sin(x / 5) + std::pow(x / 30 - 1, 2), 0.0, 0.0};
                                   }},
                              20);
  data.displace = [range = diameter(data.true_points().values, 1)](std::mt19937_64& engine, double* value) {
    const double height = (0.5 + uniform(engine)) * range;
    *value += uniform(engine) < 0.5 ? height : -height;
  };
  return data;
}

/// A pear-shaped closed curve with a dent.
NoisyData curve_data() {
  NoisyData data = with_noise({.axes = {data::Axis::of(curve_points, true)},
                               .dimension = 2,
                               .levels = 3,
                               .truth =
                                   [](double x, double) {
                                     const double t = 2 * std::numbers::pi * x / curve_points,
                                                  radius = 3 + std::cos(2 * t) + 0.5 * std::sin(3 * t);
                                     return std::array{radius * std::cos(t), radius * std::sin(t), 0.0};
                                   }},
                              25);
  data.displace = [size = diameter(data.true_points().values, 2)](std::mt19937_64& engine, double* point) {
    const double angle = 2 * std::numbers::pi * uniform(engine), length = (0.2 + 0.3 * uniform(engine)) * size;
    point[0] += length * std::cos(angle);
    point[1] += length * std::sin(angle);
  };
  return data;
}

std::vector<Method> all_methods() {
  std::vector<Method> result;
  for (const int degree : {1, 2, 3})
    for (const int points : windows) {
      result.push_back(l1_method(points, degree));
      result.push_back(least_squares_method(points, degree));
    }
  for (const int degree : {1, 2, 3}) {
    const Method method = l1_method(8, degree);
    result.push_back({method.name + ", 30 iterations", method.specification + ",iterations=30"});
    result.push_back({method.name + ", delta 1", method.specification + ",delta=1"});
  }
  return result;
}

formats::Figure degrees_figure(const NoisyData& data, const Run& run) {
  const data::GridData<double> sample = data.first_data(run.seed), truth = data.true_points({finer(data.axes[0], 8)});
  formats::Figure result{run.experiment.id,
                         run.experiment.title,
                         "One sample: degrees 1, 2, 3 by l1 regression above, by least squares below, on 8 data.",
                         3,
                         {}};
  for (const auto method : {l1_method, least_squares_method})
    for (const int degree : {1, 2, 3}) {
      const auto [name, specification, levels] = method(8, degree, false);
      result.panels.push_back(plain_panel(
          name,
          {dots("data", points_of(sample), colour::dark), line("true", line_of(truth), colour::pale),
           line("limit", line_of(refined(specification, sample, 5)), method == l1_method ? colour::blue : colour::red)},
          data.dimension == 2));
    }
  return result;
}

Measured measured_noise(const NoisyData& data, const Run& run) {
  const std::string id = run.experiment.id;
  const std::vector<Method> methods = all_methods(), of_parts = l1_methods(windows, {1, 2, 3});
  Measured result;
  study(result, data, methods, {error_measure, error_without_measure, response_measure, from_data_measure}, run);
  study_error_parts(result, data, of_parts, run);
  NoisyData with_one = data;
  with_one.outliers = 1;
  study(result, with_one, {{"Chaikin", "bspline:degree=2"}}, {error_measure, error_without_measure}, run,
        "one outlier: ");
  // The expected squared norm of the noise at a point.
  const double noise = static_cast<double>(data.dimension) * *data.sigma * *data.sigma;
  result.numbers = {{"noise", noise}};
  const MeansTable parts{id + "-parts",
                         "Parts of the mean squared error with outliers",
                         {"scheme"},
                         rows_of(of_parts),
                         {{"squared bias", "squared bias"}, {"variance", "variance"}, {"from data", "from data"}}};
  result.tables = {
      outlier_table(id + "-errors", "Mean squared errors with and without outliers", methods).filled(result),
      parts.filled(result)};
  result.figures = {degrees_figure(data, run)};
  return result;
}

}  // namespace

Measured noisy_function(const Run& run) { return measured_noise(function_data(), run); }
Measured noisy_curve(const Run& run) { return measured_noise(curve_data(), run); }

}  // namespace subcert::experiments::mustafa_hameed
