// [MLZD15, sec. 2.5, Experiments 1, 2 and 4, Figures 1, 3, 5 and 7, Tables 1 and 2]: a function with outliers.

#include "damped_sine.hpp"

#include <subcert/reports/experiments/figures.hpp>

#include <cmath>

namespace subcert::experiments::mustafa_li_2015 {
namespace {

/// The study of curves; as taken with a picture of sample 0, a panel for each method.
Measured curve_study(const Run& run, const std::string& title, const std::string& caption,
                     const std::string& table_title, const damped::Setting& setting, const NoisyData& data,
                     const std::vector<Method>& methods = curve_methods(),
                     const std::vector<SampleMeasure>& measures = {}) {
  Measured result;
  add_outlier_study(result, run, "-measures", table_title, data, methods, "", measures);
  result.numbers = setting.numbers();
  if (!run.is_alternative())
    result.figures = {damped::figure(run.experiment.id, title, "One sample" + caption, methods.size() > 2 ? 3 : 2,
                                     methods, data.first_sample(run.seed))};
  return result;
}

const std::string above_and_below = ". Above least squares, below l1 regression.";

/// A part of the data, in percent, is replaced by numbers uniform in [-8, 8].
NoisyData with_impulses(int percent) {
  const damped::Setting setting;
  NoisyData data = setting.with_outliers(setting.count * static_cast<std::size_t>(percent) / 100, 0);
  data.sigma.reset();
  data.displace = [](std::mt19937_64& engine, double* height) { *height = 8 * (2 * uniform(engine) - 1); };
  return data;
}

constexpr int quarter = 25;
const std::vector<int> parts_of_impulses{10, 20, quarter, 30, 40, 50};

std::string percent_text(int percent) { return std::to_string(percent) + " %"; }

}  // namespace

Measured outliers_under_linear_schemes(const Run& run) {
  const damped::Setting setting;
  return curve_study(run, "Outliers under Chaikin's scheme and a least squares scheme", ".", "Two outliers", setting,
                     setting.with_outliers(2, 0), {{"Chaikin", "bspline:degree=2"}, curve_methods()[0]});
}

Measured two_outliers(const Run& run) {
  const damped::Setting setting = damped::setting(run);
  return curve_study(run, "Two outliers", above_and_below, "Two outliers", setting, setting.with_outliers(2, 0));
}

Measured noise_and_outliers(const Run& run) {
  const std::string title = "Noise and thirteen outliers";
  const damped::Setting setting = damped::setting(run);
  const double sigma = noise_deviation_of(run);
  const NoisyData data = setting.with_outliers(13, sigma);
  Measured result = curve_study(run, title, above_and_below, title, setting, data, curve_methods(),
                                {response_to_noise_measure});
  result.numbers["noise"] = sigma * sigma;
  study(result, data,
        {{"Chaikin", "bspline:degree=2"}, {"cubic B-spline", "bspline:degree=3"}, {"4-point scheme", "dd:n=2"}},
        {overfits_measure}, run);
  return result;
}

/// The errors also with the method as the measure and the part of impulses as the subject.
Measured impulsive_noise(const Run& run) {
  Measured result = curve_study(run, "Impulsive noise", ", 25 % impulses" + above_and_below, "A quarter of impulses",
                                damped::Setting(), with_impulses(quarter));
  formats::Panel over_parts{
      "error over the part of impulses", "impulses (%)", "mean squared error", {}, true, "bottom right"};
  MeansTable errors{"l1-exp4-errors", "Mean squared errors over the part of impulses", {"impulses (%)"}, {}, {}};
  for (const int percent : parts_of_impulses) {
    study(result, with_impulses(percent), curve_methods(), {error_measure}, run, percent_text(percent) + ": ");
    errors.rows.push_back({{std::to_string(percent)}, percent_text(percent)});
  }
  for (const Method& method : curve_methods()) {
    Points means;
    for (const int percent : parts_of_impulses) {
      const auto& error = result.at({percent_text(percent) + ": error", method.name});
      means.emplace_back(percent, mean_interval(error).mean);
      result.samples[{method.name, percent_text(percent)}] = error;
    }
    over_parts.curves.push_back(line(method.name, means, ""));
    over_parts.curves.back().marked = true;
    errors.columns.push_back({method.name, method.name});
  }
  result.tables.push_back(errors.filled(result));
  result.figures.push_back(
      {"l1-exp4-parts", "How many impulses the schemes bear", "Means over the samples.", 1, {over_parts}});
  return result;
}

}  // namespace subcert::experiments::mustafa_li_2015
