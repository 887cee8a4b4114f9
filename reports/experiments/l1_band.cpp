// [MLZD15, sec. 3.1, Experiment 2, Figure 9]: a part of a Moebius band.

#include "families.hpp"
#include "outlier_study.hpp"

#include <cmath>
#include <numbers>

namespace subcert::experiments::l1_band {
namespace {

constexpr std::size_t columns = 40, rows = 50, few = 20, many = 100;
constexpr int levels = 1;
constexpr double variance = 0.1;
const std::string classical = "biquadratic B-spline";

/// The point of datum (i, j): u from -1.5 to 1.5, v from -1.25 to 1.25.
std::array<double, 3> band(double i, double j) {
  const double u = -1.5 + 3 * i / (columns - 1), v = -1.25 + 2.5 * j / (rows - 1);
  const double radius = 3 + u * std::cos(v / 2);
  return {std::cos(v) * radius, std::sin(v) * radius, u * std::sin(v / 2)};
}

std::vector<double> samples() {
  std::vector<double> result;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const auto p = band(static_cast<double>(i), static_cast<double>(j));
      result.insert(result.end(), p.begin(), p.end());
    }
  return result;
}

/// Uniform on the sphere of this radius.
std::array<double, 3> direction(std::mt19937_64& engine, double radius) {
  const double z = 2 * uniform(engine) - 1, angle = 2 * std::numbers::pi * uniform(engine), r = std::sqrt(1 - z * z);
  return {radius * r * std::cos(angle), radius * r * std::sin(angle), radius * z};
}

OutlierCase band_case(std::size_t outliers) {
  return {{data::Axis::of(columns), data::Axis::of(rows)},
          3,
          levels,
          [outliers](std::mt19937_64& engine) {
            OutlierSample sample{samples(), {}};
            const auto noise = normal_noise(engine, sample.without.size());
            for (std::size_t i = 0; i < noise.size(); ++i) sample.without[i] += std::sqrt(variance) * noise[i];
            sample.with = sample.without;
            for (const std::size_t at : chosen_indices(engine, outliers, columns * rows)) {
              const auto moved = direction(engine, 2 + 2 * uniform(engine));
              for (std::size_t c = 0; c < 3; ++c) sample.with[3 * at + c] += moved[c];
            }
            return sample;
          },
          band};
}

/// Every `keep`-th point in both directions.
formats::DrawnSurface drawn(const std::string& title, const Batch& surface, std::size_t keep) {
  const std::size_t width = surface.axes[0].count, height = surface.axes[1].count;
  formats::DrawnSurface result{title, (width + keep - 1) / keep, (height + keep - 1) / keep, false, false, {}};
  for (std::size_t j = 0; j < height; j += keep)
    for (std::size_t i = 0; i < width; i += keep) {
      const double* p = &surface.sets[0][3 * (j * width + i)];
      result.points.push_back({p[0], p[1], p[2]});
    }
  return result;
}

formats::SurfaceFigure figure(const std::vector<Method>& methods, const OutlierCase& what, std::uint64_t seed) {
  auto engine = generator(seed, 0);
  const Batch data{what.axes, 3, {what.draw(engine).with}};
  formats::SurfaceFigure result{"l1-surface2",
                                "A part of a Moebius band with normal noise of variance 0.1 and 20 outliers",
                                "One sample. Original, data, biquadratic B-spline; least squares; l1 regression.",
                                {drawn("original", {what.axes, 3, {samples()}}, 1), drawn("data", data, 1)},
                                3};
  for (const std::size_t m : {6u, 0u, 1u, 2u, 3u, 4u, 5u})
    result.surfaces.push_back(drawn(methods[m].name, refined(methods[m].specification, data, 2), 4));
  return result;
}

/// What the outliers add to the errors: error - 1.1 error without them.
std::vector<NamedMean> excess(const std::vector<Outcome>& outcomes, const Names& names) {
  std::vector<NamedMean> result;
  for (const std::string& name : names) {
    const Outcome& o = outcome(outcomes, name);
    std::vector<double> bound(o.error_without);
    for (double& value : bound) value *= 1.1;
    result.push_back({name, mean_difference(o.error, bound)});
  }
  return result;
}

ExperimentResult run(const ExperimentOptions& options) {
  std::vector<Method> methods = surface_methods();
  methods.push_back({classical, "tensor:(bspline:degree=2)x(bspline:degree=2)"});
  const OutlierCase what = band_case(few);
  const auto outcomes = study(what, methods, options);
  const std::string place = "Sec. 3.1, Experiment 2, Fig. 9";
  NamePairs over_classical;
  for (const std::string& name : robust) over_classical.emplace_back(name, classical);
  ExperimentResult result{
      {"40 values of u in [-1.5, 1.5] and 50 of v in [-1.25, 1.25], as printed: some 0.4 of the Moebius band. Normal "
       "noise of "
       "variance 0.1 in every coordinate; the paper does not say how many outliers, here 20 random points are moved by "
       "a length "
       "uniform in [2, 4] in a random direction. Surfaces after one refinement, every coordinate fitted by itself, 6 "
       "reweighted "
       "fits with delta = 1e-8, rules at the ends by regression. Error: mean squared distance from the surface at the "
       "same "
       "parameters; response: the largest distance by which the outliers move a point."}};
  result.claims = {
      all_below({"The l1 schemes outperform the least squares schemes.", "Sec. 4; " + place},
                "paired differences of the errors", 0,
                differences(outcomes, robust_over_least_squares, &Outcome::error), Verdict::not_confirmed),
      all_below({"The l1 schemes fit noisy data with outliers better than other subdivision schemes (read as: than the "
                 "biquadratic "
                 "B-spline).",
                 "Sec. 1; " + place},
                "paired differences of the errors", 0, differences(outcomes, over_classical, &Outcome::error)),
      all_below({"The l1 schemes remove outliers (read as: these raise the error by less than a tenth).",
                 "Highlights; " + place},
                "paired differences of the error and 1.1 of that without outliers", 0, excess(outcomes, robust)),
      all_below({"The l1 schemes remove noise (read as: a tenth of its mean square is left).", "Highlights; " + place},
                "error", 3 * variance / 10, means(outcomes, robust, &Outcome::error)),
      all_below({"D_6 fits better than the other schemes.", "Sec. 2.5, Experiment 2"},
                "paired differences of the errors", 0, differences(outcomes, six_over_others, &Outcome::error),
                Verdict::not_confirmed)};
  const std::vector<Method> sixes{surface_methods()[0], surface_methods()[3]};
  result.tables = {
      outcome_table("l1-surface2-measures", "Noise of variance 0.1 and 20 outliers (1 %)", outcomes),
      outcome_table("l1-surface2-many", "The same with 100 outliers (5 %)", study(band_case(many), sixes, options))};
  result.surface_figures.push_back(figure(methods, what, options.seed));
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  return {{"l1-surface2", "mustafa-li-2015", "Surfaces, Experiment 2 and Figure 9: a Moebius band", run}};
}

}  // namespace subcert::experiments::l1_band
