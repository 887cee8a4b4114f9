// [MH, abstract and sec. 1.1, Figures 8 and 9]: noisy data with outliers.

#include "parts.hpp"

#include <subcert/reports/experiments/figures.hpp>

#include <cmath>
#include <numbers>

namespace subcert::experiments::mustafa_hameed {
namespace {

const std::vector<int> windows{6, 8, 10};
constexpr std::size_t outliers = 4, function_points = 61, curve_points = 60;

struct NoisyExperiment {
  std::string id;
  std::string title;
  std::string setup;
  NoisyData data;
  double noise;  ///< expected squared norm of the noise at a point
  Verdict cubic_without_outliers;
};

NoisyExperiment function_experiment() {
  NoisyData data{.axes = {data::Axis::of(function_points)}, .levels = 3, .truth = [](double x, double) {
                   return std::array{std::sin(x / 5) + std::pow(x / 30 - 1, 2), 0.0, 0.0};
                 }};
  const auto samples = data.true_points().values;
  const double sigma = noise_deviation(mean_square(samples), 20), range = diameter(samples, 1);
  data.sigma = sigma;
  data.outliers = outliers;
  data.displace = [range](std::mt19937_64& engine, double* value) {
    const double height = (0.5 + uniform(engine)) * range;
    *value += uniform(engine) < 0.5 ? height : -height;
  };
  return {"nonlinear-fig8",
          "Figure 8: a function with noise and outliers",
          "f(x) = sin(x/5) + (x/30 - 1)^2 at x = 0, ..., 60; normal noise of 20 dB; 4 outliers at random places, up or "
          "down by 1/2 to 3/2 of the range of f.",
          data,
          sigma * sigma,
          Verdict::not_confirmed};
}

/// A pear-shaped closed curve with a dent.
NoisyExperiment curve_experiment() {
  NoisyData data{
      .axes = {data::Axis::of(curve_points, true)}, .dimension = 2, .levels = 3, .truth = [](double x, double) {
        const double t = 2 * std::numbers::pi * x / curve_points, radius = 3 + std::cos(2 * t) + 0.5 * std::sin(3 * t);
        return std::array{radius * std::cos(t), radius * std::sin(t), 0.0};
      }};
  const auto samples = data.true_points().values;
  const double sigma = noise_deviation(mean_square(samples), 25), size = diameter(samples, 2);
  data.sigma = sigma;
  data.outliers = outliers;
  data.displace = [size](std::mt19937_64& engine, double* point) {
    const double angle = 2 * std::numbers::pi * uniform(engine), length = (0.2 + 0.3 * uniform(engine)) * size;
    point[0] += length * std::cos(angle);
    point[1] += length * std::sin(angle);
  };
  return {"nonlinear-fig9",
          "Figure 9: a closed curve with noise and outliers",
          "r = 3 + cos 2t + (1/2) sin 3t, 60 points at equal steps of t, closed; normal noise of 25 dB in both "
          "coordinates; 4 outliers at random places, moved in any direction by 0.2 to 0.5 of the diameter.",
          data,
          2 * sigma * sigma,
          Verdict::confirmed};
}

std::vector<Method> least_squares_methods(int degree) {
  std::vector<Method> result;
  for (const int points : windows) result.push_back(least_squares_method(points, degree));
  return result;
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
  }
  return result;
}

formats::Figure degrees_figure(const NoisyExperiment& experiment, std::uint64_t seed) {
  const NoisyData& data = experiment.data;
  const data::GridData<double> sample = data.first_data(seed), truth = data.true_points({finer(data.axes[0], 8)});
  formats::Figure result{experiment.id,
                         experiment.title,
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

Measured measured_noise(const NoisyExperiment& experiment, const ExperimentOptions& options) {
  Measured result;
  study(result, experiment.data, all_methods(), {error_measure, error_without_measure, response_measure}, options);
  study_error_parts(result, experiment.data, l1_methods(windows, {1, 2, 3}), options);
  result.figures = {degrees_figure(experiment, options.seed)};
  return result;
}

std::vector<Claim> claims_about_degree(const NoisyExperiment& experiment, int degree) {
  const std::string which = degree == 2 ? "quadratic" : "cubic", of = " of " + which + " polynomials",
                    place = "Sec. 1.1, Fig. 8-9", difference = "paired difference of the mean squared errors";
  const std::vector<Method> methods = l1_methods(windows, {degree});
  const Names names = names_of(methods);
  const NamePairs over_linear = pairs(methods, l1_methods(windows, {1}));
  return {{.sentence = "Schemes" + of +
                       " do not overfit (read as: the variance of the limit is below that of the noise, "
                       "outliers apart).",
           .place = place,
           .relation = below("variance", experiment.noise, means("variance", names)),
           .recorded = Verdict::not_confirmed},
          {.sentence = "Schemes" + of + " do not underfit (read as: the squared bias is below the variance).",
           .place = place,
           .relation = below("squared bias minus variance", 0, excess("squared bias", "variance", names))},
          {.sentence = "Schemes" + of +
                       " are approximating on noisy data (read as: from the data that are no outliers they "
                       "keep a mean square distance of more than half the variance of the noise).",
           .place = place,
           .relation = above("mean square distance from the data that are no outliers", experiment.noise / 2,
                             means("from data", names))},
          {.sentence = "On noisy data with outliers, schemes" + of + " perform better than those of linear ones.",
           .place = "Abstract",
           .relation = below(difference, 0, differences("error", over_linear)),
           .recorded = Verdict::not_confirmed},
          {.sentence = "On noisy data without outliers, schemes" + of + " perform better than those of linear ones.",
           .place = "Abstract",
           .relation = below(difference, 0, differences("error without", over_linear)),
           .recorded = degree == 3 ? experiment.cubic_without_outliers : Verdict::confirmed},
          {.sentence = "Schemes" + of +
                       " remove noise and outliers without prior information (read as: the mean squared "
                       "error is below the variance of the noise alone).",
           .place = "Sec. 1.1",
           .relation = below("mean squared error", experiment.noise, means("error", names)),
           .recorded = Verdict::not_confirmed},
          {.sentence = "Least squares are sensitive to outliers, l1 schemes" + of + " suit them.",
           .place = "Sec. 1, abstract",
           .relation = below(difference + ", l1 minus least squares of the same degree", 0,
                             differences("error", pairs(methods, least_squares_methods(degree))))}};
}

Experiment noise_experiment(const NoisyExperiment& experiment) {
  MeansTable parts{experiment.id + "-parts",
                   "Parts of the mean squared error with outliers",
                   {"scheme"},
                   rows_of(l1_methods(windows, {1, 2, 3})),
                   {{"squared bias", "squared bias"}, {"variance", "variance"}, {"from data", "from data"}}};
  std::vector<Claim> claims = claims_about_degree(experiment, 2);
  for (Claim& claim : claims_about_degree(experiment, 3)) claims.push_back(std::move(claim));
  return {.id = experiment.id,
          .title = experiment.title,
          .setup = {experiment.setup +
                    " Schemes on 6, 8 and 10 data, 3 levels (5 in the picture); D: l1 regression with 6 iterations and "
                    "delta = 1e-8; S: least squares. The noise has the variance " +
                    short_number(experiment.noise) + "."},
          .claims = claims,
          .tables = {outlier_table(experiment.id + "-errors", "Mean squared errors with and without outliers",
                                   all_methods()),
                     parts},
          .measure = [=](const ExperimentOptions& options) { return measured_noise(experiment, options); }};
}

}  // namespace

Experiment noisy_function() { return noise_experiment(function_experiment()); }
Experiment noisy_curve() { return noise_experiment(curve_experiment()); }

}  // namespace subcert::experiments::mustafa_hameed
