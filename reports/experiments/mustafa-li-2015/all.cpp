#include "parts.hpp"

#include <subcert/reports/experiments/papers.hpp>

namespace subcert::experiments::mustafa_li_2015 {

const Names least_squares{"S_6", "S_7", "S_8"}, l1_schemes{"D_6", "D_7", "D_8"};
const NamePairs l1_over_least_squares{{"D_6", "S_6"}, {"D_7", "S_7"}, {"D_8", "S_8"}};
const NamePairs six_over_others = all_pairs({"D_6"}, {"S_6", "S_7", "S_8", "D_7", "D_8"});
const NamePairs more_least_squares_points{{"S_7", "S_6"}, {"S_8", "S_7"}},
    more_l1_points{{"D_7", "D_6"}, {"D_8", "D_7"}};
const NamePairs more_over_fewer_points{{"S_7", "S_6"}, {"S_8", "S_7"}, {"D_7", "D_6"}, {"D_8", "D_7"}};
const Method classical_surface{"biquadratic B-spline", "tensor:(bspline:degree=2)x(bspline:degree=2)"};
const std::vector<SampleMeasure> outlier_measures{error_measure, error_without_measure, response_measure};

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

std::vector<Method> with_classical_surface() {
  std::vector<Method> result = surface_methods();
  result.push_back(classical_surface);
  return result;
}

Experiment with_curve_study(Experiment experiment, const std::string& table_title, const NoisyData& data,
                            const std::vector<Method>& methods, const Picture& picture) {
  experiment.tables.insert(experiment.tables.begin(), outlier_table(experiment.id + "-measures", table_title, methods));
  experiment.measure = [=, more = experiment.measure](const ExperimentOptions& options) {
    Measured result;
    if (more) result = more(options);
    study(result, data, methods, outlier_measures, options);
    result.figures.insert(result.figures.begin(), picture(data.first_sample(options.seed)));
    return result;
  };
  return experiment;
}

Relation smaller(const NamePairs& pairs, const std::string& measure, const std::string& measure_words) {
  return below("paired differences of " + measure_words, 0, differences(measure, pairs));
}

Relation larger(const NamePairs& pairs, const std::string& measure, const std::string& measure_words) {
  return above("paired differences of " + measure_words, 0, differences(measure, pairs));
}

std::vector<Experiment> all() {
  return {outliers_under_linear_schemes(),
          basic_limit_functions(),
          two_outliers(),
          noise_and_outliers(),
          iterations(),
          spiral(),
          impulsive_noise(),
          surface_with_outlier(),
          moebius_band()};
}

}  // namespace subcert::experiments::mustafa_li_2015
