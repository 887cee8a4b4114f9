// [MH, abstract and sec. 1.1, Figures 8 and 9]: noisy data with outliers.

#include "degree_study.hpp"
#include "families.hpp"

#include <cmath>
#include <numbers>

namespace subcert::experiments::nonlinear_noise {
namespace {

const std::vector<int> windows{6, 8, 10};
constexpr std::size_t outliers = 4;

struct NoisyExperiment {
  std::string id;
  std::string title;
  std::string setup;
  OutlierCase data;
  double noise;  ///< expected squared norm of the noise at a point
  Verdict cubic_without_outliers;
};

constexpr std::size_t function_points = 61, curve_points = 60;
double function(double x) { return std::sin(x / 5) + std::pow(x / 30 - 1, 2); }

NoisyExperiment function_experiment() {
  std::vector<double> samples;
  for (std::size_t i = 0; i < function_points; ++i) samples.push_back(function(static_cast<double>(i)));
  const double sigma = noise_deviation(mean_square(samples), 20), range = diameter(samples, 1);
  const auto draw = [samples, sigma, range](std::mt19937_64& engine) {
    OutlierSample sample{samples, {}};
    const auto noise = normal_noise(engine, samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) sample.without[i] += sigma * noise[i];
    sample.with = sample.without;
    for (const std::size_t i : chosen_indices(engine, outliers, samples.size())) {
      const double height = (0.5 + uniform(engine)) * range;
      sample.with[i] += uniform(engine) < 0.5 ? height : -height;
    }
    return sample;
  };
  return {"nonlinear-fig8",
          "Figure 8: a function with noise and outliers",
          "f(x) = sin(x/5) + (x/30 - 1)^2 at x = 0, ..., 60; normal noise of 20 dB; 4 outliers at random places, up or "
          "down by 1/2 to 3/2 of the range of f.",
          {{data::Axis::of(function_points)},
           1,
           3,
           draw,
           [](double x, double) {
             return std::array<double, 3>{function(x), 0, 0};
           }},
          sigma * sigma,
          Verdict::not_confirmed};
}

/// A pear-shaped closed curve with a dent.
std::array<double, 3> closed_curve(double x, double) {
  const double t = 2 * std::numbers::pi * x / curve_points, radius = 3 + std::cos(2 * t) + 0.5 * std::sin(3 * t);
  return {radius * std::cos(t), radius * std::sin(t), 0};
}

NoisyExperiment curve_experiment() {
  std::vector<double> samples;
  for (std::size_t i = 0; i < curve_points; ++i) {
    const auto point = closed_curve(static_cast<double>(i), 0);
    samples.insert(samples.end(), {point[0], point[1]});
  }
  const double sigma = noise_deviation(mean_square(samples), 25), size = diameter(samples, 2);
  const auto draw = [samples, sigma, size](std::mt19937_64& engine) {
    OutlierSample sample{samples, {}};
    const auto noise = normal_noise(engine, samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) sample.without[i] += sigma * noise[i];
    sample.with = sample.without;
    for (const std::size_t i : chosen_indices(engine, outliers, curve_points)) {
      const double angle = 2 * std::numbers::pi * uniform(engine), length = (0.2 + 0.3 * uniform(engine)) * size;
      sample.with[2 * i] += length * std::cos(angle);
      sample.with[2 * i + 1] += length * std::sin(angle);
    }
    return sample;
  };
  return {"nonlinear-fig9",
          "Figure 9: a closed curve with noise and outliers",
          "r = 3 + cos 2t + (1/2) sin 3t, 60 points at equal steps of t, closed; normal noise of 25 dB in both "
          "coordinates; 4 outliers at random places, moved in any direction by 0.2 to 0.5 of the diameter.",
          {{data::Axis::of(curve_points, true)}, 2, 3, draw, closed_curve},
          2 * sigma * sigma,
          Verdict::confirmed};
}

std::vector<Method> all_methods() {
  std::vector<Method> result;
  for (const int degree : {1, 2, 3})
    for (const int points : windows) {
      result.push_back(robust_method(points, degree));
      result.push_back(least_squares_method(points, degree));
    }
  for (const int degree : {1, 2, 3}) {
    const Method method = robust_method(8, degree);
    result.push_back({method.name + ", 30 iterations", method.specification + ",iterations=30"});
  }
  return result;
}

/// D_p^d and D_p^e, or S_p^e.
NamePairs pairs(int degree, int other, bool robust = true) {
  NamePairs result;
  for (const int points : windows)
    result.emplace_back(robust_method(points, degree).name,
                        (robust ? robust_method(points, other) : least_squares_method(points, other)).name);
  return result;
}

formats::Figure figure(const NoisyExperiment& experiment, std::uint64_t seed) {
  const OutlierCase& data = experiment.data;
  auto engine = generator(seed, 0);
  const data::GridData<double> sample{data.draw(engine).with, data.dimension, data.axes};
  data::Axis fine = data.axes[0];
  fine.count = (fine.closed ? fine.count : fine.count - 1) * 8 + !fine.closed;
  fine.step = Rational(1, 8);
  const data::GridData<double> truth{true_points(data, {fine}), data.dimension, {fine}};
  formats::Figure result{experiment.id,
                         experiment.title,
                         "One sample: degrees 1, 2, 3 by l1 regression above, by least squares below, on 8 data.",
                         3,
                         {}};
  for (const bool robust : {true, false})
    for (const int degree : {1, 2, 3}) {
      const Method method = robust ? robust_method(8, degree) : least_squares_method(8, degree);
      result.panels.push_back(
          {method.name,
           "",
           "",
           {drawn_points("data", sample, "#5a6773"), drawn_line("true", truth, pale),
            drawn_line("limit", refined(method.specification, sample, 5), robust ? "#0b559f" : "#c0392b")},
           false,
           "below",
           data.dimension == 2});
    }
  return result;
}

/// The claims of one degree about over- and underfitting.
void add_fit_claims(ExperimentResult& result, const NoisyExperiment& experiment, int degree, formats::PlainTable& table,
                    const ExperimentOptions& options) {
  std::vector<NamedMean> overfit, underfit, approximating;
  for (const int points : windows) {
    const Method method = robust_method(points, degree);
    const ErrorParts parts = error_parts(experiment.data, method, options);
    overfit.push_back({method.name, mean_interval(parts.variance)});
    underfit.push_back(paired(method.name, parts.squared_bias, parts.variance));
    approximating.push_back({method.name, mean_interval(parts.from_data)});
    table.rows.push_back({method.name, mean_interval(parts.squared_bias).text(), mean_interval(parts.variance).text(),
                          mean_interval(parts.from_data).text()});
  }
  if (degree == 1) return;
  const std::string which = degree == 2 ? "quadratic" : "cubic", place = "Sec. 1.1, Fig. 8-9";
  result.claims.push_back(all_below({"Schemes of " + which +
                                         " polynomials do not overfit (read as: the variance of the limit is below "
                                         "that of the noise, outliers apart).",
                                     place},
                                    "variance", experiment.noise, overfit, Verdict::not_confirmed));
  result.claims.push_back(all_below(
      {"Schemes of " + which + " polynomials do not underfit (read as: the squared bias is below the variance).",
       place},
      "squared bias minus variance", 0, underfit));
  result.claims.push_back(
      all_above({"Schemes of " + which +
                     " polynomials are approximating on noisy data (read as: from the data that are no outliers they "
                     "keep a mean square distance of more than half the variance of the noise).",
                 place},
                "mean square distance from the data that are no outliers", experiment.noise / 2, approximating));
}

ExperimentResult run(const NoisyExperiment& experiment, const ExperimentOptions& options) {
  ExperimentResult result{{experiment.setup +
                           " Schemes on 6, 8 and 10 data, 3 levels (5 in the picture); D: l1 regression with 6 "
                           "iterations and delta = 1e-8; S: least squares. The noise has the variance " +
                           short_number(experiment.noise) + "."}};
  const auto outcomes = study(experiment.data, all_methods(), options);
  formats::PlainTable parts{experiment.id + "-parts",
                            "Parts of the mean squared error with outliers",
                            {"scheme", "squared bias", "variance", "from data"},
                            {}};
  for (const int degree : {1, 2, 3}) {
    add_fit_claims(result, experiment, degree, parts, options);
    if (degree == 1) continue;
    const std::string which = degree == 2 ? "quadratic" : "cubic";
    result.claims.push_back(all_below(
        {"On noisy data with outliers, schemes of " + which + " polynomials perform better than those of linear ones.",
         "Abstract"},
        "paired difference of the mean squared errors", 0, differences(outcomes, pairs(degree, 1), &Outcome::error),
        Verdict::not_confirmed));
    result.claims.push_back(all_below({"On noisy data without outliers, schemes of " + which +
                                           " polynomials perform better than those of linear ones.",
                                       "Abstract"},
                                      "paired difference of the mean squared errors", 0,
                                      differences(outcomes, pairs(degree, 1), &Outcome::error_without),
                                      degree == 3 ? experiment.cubic_without_outliers : Verdict::confirmed));
    result.claims.push_back(all_below(
        {"Schemes of " + which +
             " polynomials remove noise and outliers without prior information (read as: the mean squared error is "
             "below the variance of the noise alone).",
         "Sec. 1.1"},
        "mean squared error", experiment.noise,
        means(outcomes, {robust_method(6, degree).name, robust_method(8, degree).name, robust_method(10, degree).name},
              &Outcome::error),
        Verdict::not_confirmed));
    result.claims.push_back(
        all_below({"Least squares are sensitive to outliers, l1 schemes of " + which + " polynomials suit them.",
                   "Sec. 1, abstract"},
                  "paired difference of the mean squared errors, l1 minus least squares of the same degree", 0,
                  differences(outcomes, pairs(degree, degree, false), &Outcome::error)));
  }
  result.tables = {outcome_table(experiment.id + "-errors", "Mean squared errors with and without outliers", outcomes),
                   parts};
  result.figures.push_back(figure(experiment, options.seed));
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  std::vector<Experiment> result;
  for (const NoisyExperiment& experiment : {function_experiment(), curve_experiment()})
    result.push_back({experiment.id, "mustafa-hameed", experiment.title,
                      [experiment](const ExperimentOptions& options) { return run(experiment, options); }});
  return result;
}

}  // namespace subcert::experiments::nonlinear_noise
