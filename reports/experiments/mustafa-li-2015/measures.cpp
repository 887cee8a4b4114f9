#include "parts.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::experiments::mustafa_li_2015 {

const std::vector<Method>& curve_methods() {
  static const std::vector<Method> methods{{"S_6", "dual:n=3"},    {"S_7", "dual-odd:n=3"}, {"S_8", "dual:n=4"},
                                           {"D_6", "l1:points=6"}, {"D_7", "l1:points=7"},  {"D_8", "l1:points=8"}};
  return methods;
}

const std::vector<Method>& surface_methods() {
  static const std::vector<Method> methods{{"S_6", "grid:points=6x6,d=1"}, {"S_7", "grid:points=7x7,d=1"},
                                           {"S_8", "grid:points=8x8,d=1"}, {"D_6", "l1:points=6x6"},
                                           {"D_7", "l1:points=7x7"},       {"D_8", "l1:points=8x8"}};
  return methods;
}

double noise_deviation_of(const Run& run) {
  const std::string& noise = run.chosen("noise");
  require(noise == "variance 0.1" || noise == "deviation 0.1", "unknown noise '{}'", noise);
  return noise == "deviation 0.1" ? 0.1 : std::sqrt(0.1);
}

void add_outlier_study(Measured& result, const Run& run, const std::string& table, const std::string& title,
                       const NoisyData& data, const std::vector<Method>& methods, const std::string& prefix,
                       std::vector<SampleMeasure> measures) {
  measures.insert(measures.begin(), {error_measure, error_without_measure, response_measure});
  study(result, data, methods, measures, run, prefix);
  if (!run.is_alternative())
    result.tables.push_back(outlier_table(run.experiment.id + table, title, methods, prefix).filled(result));
}

namespace {

double largest_slope_change(const data::GridData<double>& f) {
  double largest = 0;
  std::size_t stride = 1;
  for (const data::Axis& axis : f.axes) {
    const double step = data::nearest_double(axis.step);
    for (std::size_t i = 0; i < f.values.size(); ++i) {
      const std::size_t place = i / stride % axis.count;
      if (place == 0 || place + 1 == axis.count) continue;
      largest = std::max(largest, std::abs(f.values[i - stride] - 2 * f.values[i] + f.values[i + stride]) / step);
    }
    stride *= axis.count;
  }
  return largest;
}

}  // namespace

void add_smoothness(Measured& result, const std::string& name,
                    const std::function<data::GridData<double>(int level)>& at_level, int first, int last) {
  std::string rates;
  bool all_positive = true;
  double before = largest_slope_change(at_level(first));
  for (int level = first + 1; level <= last; ++level) {
    const double now = largest_slope_change(at_level(level)), rate = std::log2(before / now);
    all_positive = all_positive && rate > 0;
    rates += (rates.empty() ? "" : ", ") + short_number(rate);
    before = now;
  }
  result.add_fact("smooth", name, all_positive, rates);
}

Measures measures() {
  return {{"l1-fig1", outliers_under_linear_schemes},
          {"l1-fig2", limit_functions},
          {"l1-exp1", two_outliers},
          {"l1-exp2", noise_and_outliers},
          {"l1-fig4", iterations},
          {"l1-exp3", spiral},
          {"l1-exp4", impulsive_noise},
          {"l1-surface1", bump},
          {"l1-surface2", moebius_band}};
}

}  // namespace subcert::experiments::mustafa_li_2015
