// [MH, sec. 1.1]: surfaces by linear and quadratic bivariate polynomials.

#include "degree_study.hpp"
#include "families.hpp"

#include <cmath>

namespace subcert::experiments::nonlinear_surface {
namespace {

constexpr std::size_t count = 21, outliers = 12;
constexpr int levels = 2;
const std::vector<int> windows{5, 6};

/// Two hills and a hollow.
double height(double x, double y) {
  const double u = (x - 10) / 4, v = (y - 10) / 4;
  return 3 * std::exp(-(u - 1) * (u - 1) - v * v) + 2 * std::exp(-(u + 1.2) * (u + 1.2) - (v - 0.8) * (v - 0.8)) -
         2 * std::exp(-u * u - (v + 1.3) * (v + 1.3));
}

OutlierCase hills(double& variance) {
  std::vector<double> samples;
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t i = 0; i < count; ++i) samples.push_back(height(static_cast<double>(i), static_cast<double>(j)));
  const double sigma = noise_deviation(mean_square(samples), 20), range = diameter(samples, 1);
  variance = sigma * sigma;
  return {{data::Axis::of(count), data::Axis::of(count)},
          1,
          levels,
          [samples, sigma, range](std::mt19937_64& engine) {
            OutlierSample sample{samples, {}};
            const auto noise = normal_noise(engine, samples.size());
            for (std::size_t i = 0; i < samples.size(); ++i) sample.without[i] += sigma * noise[i];
            sample.with = sample.without;
            for (const std::size_t i : chosen_indices(engine, outliers, samples.size()))
              sample.with[i] += (0.5 + uniform(engine) / 2) * (uniform(engine) < 0.5 ? range : -range);
            return sample;
          },
          [](double x, double y) {
            return std::array<double, 3>{height(x, y), 0, 0};
          }};
}

formats::SurfaceFigure figure(const OutlierCase& data, std::uint64_t seed) {
  auto engine = generator(seed, 0);
  const data::GridData<double> sample{data.draw(engine).with, 1, data.axes};
  formats::SurfaceFigure result{"nonlinear-surface",
                                "Noisy heights with outliers",
                                "The data, linear polynomials on 6 x 6 data, quadratic ones, and the true surface.",
                                {drawn_surface("data", sample)},
                                2};
  std::vector<data::Axis> fine;
  for (const int degree : {1, 2}) {
    const Method method = robust_method(6, degree, true);
    const data::GridData<double> surface = refined(method.specification, sample, levels);
    result.surfaces.push_back(drawn_surface(method.name, surface));
    fine = surface.axes;
  }
  result.surfaces.push_back(drawn_surface("true", {true_points(data, fine), 1, fine}));
  return result;
}

/// Degrees 2 and 1 on as many data.
NamePairs pairs() {
  NamePairs result;
  for (const int points : windows) result.emplace_back(robust_method(points, 2).name, robust_method(points, 1).name);
  return result;
}

ExperimentResult run(const ExperimentOptions& options) {
  double variance = 0;
  const OutlierCase data = hills(variance);
  std::vector<Method> methods;
  for (const int points : windows)
    for (const int degree : {1, 2}) methods.push_back(robust_method(points, degree, true));
  ExperimentResult result{
      {"The surfaces are not published. Here: two hills and a hollow, 21 x 21 heights, normal noise of 20 dB "
       "(variance " +
       short_number(variance) +
       "), 12 outliers at random places, up or down by 1/2 to 1 of the range. D_p^d: l1 regression of total degree d "
       "on p x p data, 6 iterations, delta = 1e-8, 2 levels. Roughness: mean square of the "
       "second differences along both axes on the last level."}};
  const auto outcomes = study(data, methods, options);
  const std::string sentence =
      "In the surface case the schemes of quadratic polynomials produce smooth models compared with those of linear "
      "ones";
  std::vector<NamedMean> rough;
  formats::PlainTable table{"nonlinear-surface-errors",
                            "Surfaces with outliers",
                            {"scheme", "mean squared error", "without outliers", "roughness"},
                            {}};
  for (const Outcome& o : outcomes)
    table.rows.push_back({o.method.name, mean_interval(o.error).text(), mean_interval(o.error_without).text(),
                          mean_interval(o.roughness).text()});
  result.claims = {
      all_below({sentence + " (read literally: smoother).", "Sec. 1.1"},
                "paired difference of the roughness, degree 2 minus degree 1", 0,
                differences(outcomes, pairs(), &Outcome::roughness), Verdict::not_confirmed),
      all_below({sentence + " (read as: nearer to the smooth surface from which the data come).", "Sec. 1.1"},
                "paired difference of the mean squared errors, degree 2 minus degree 1", 0,
                differences(outcomes, pairs(), &Outcome::error)),
      all_below({"The surface schemes of quadratic polynomials remove noise and outliers (read as: the mean squared "
                 "error is below the variance of the noise).",
                 "Sec. 1.1"},
                "mean squared error", variance, means(outcomes, {"D_5^2", "D_6^2"}, &Outcome::error))};
  result.tables.push_back(table);
  result.surface_figures.push_back(figure(data, options.seed));
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  return {{"nonlinear-surface", "mustafa-hameed", "Surfaces by linear and quadratic polynomials", run}};
}

}  // namespace subcert::experiments::nonlinear_surface
