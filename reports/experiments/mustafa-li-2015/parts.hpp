#pragma once
/// The experiments of [MLZD15], and what they share.

#include <subcert/reports/experiments/noisy_data.hpp>

namespace subcert::experiments::mustafa_li_2015 {

Experiment outliers_under_linear_schemes();
Experiment basic_limit_functions();
Experiment two_outliers();
Experiment noise_and_outliers();
Experiment iterations();
Experiment spiral();
Experiment impulsive_noise();
Experiment surface_with_outlier();
Experiment moebius_band();

/// S_6, S_7, S_8 by least squares and D_6, D_7, D_8 by l1 regression, on curves and on grids.
const std::vector<Method>& curve_methods();
const std::vector<Method>& surface_methods();
/// The biquadratic B-spline, and all methods on grids with it at the end.
extern const Method classical_surface;
std::vector<Method> with_classical_surface();

extern const Names least_squares, l1_schemes;
/// D_k and S_k.
extern const NamePairs l1_over_least_squares;
/// D_6 and each other one.
extern const NamePairs six_over_others;
/// The schemes with more points and those with fewer: S, D, both.
extern const NamePairs more_least_squares_points, more_l1_points, more_over_fewer_points;

/// "error", "error without" and "response".
extern const std::vector<SampleMeasure> outlier_measures;

/// Draws sample 0 in a figure.
using Picture = std::function<formats::Figure(const OutlierSample& sample)>;
/// The experiment with the table and the measures of curves, and a picture.
Experiment with_curve_study(Experiment experiment, const std::string& table_title, const NoisyData& data,
                            const std::vector<Method>& methods, const Picture& picture);

/// The paired differences of this measure are negative (positive). `measure_words` name the measure in the statistic.
Relation smaller(const NamePairs& pairs, const std::string& measure = "error",
                 const std::string& measure_words = "the errors");
Relation larger(const NamePairs& pairs, const std::string& measure = "error",
                const std::string& measure_words = "the errors");

}  // namespace subcert::experiments::mustafa_li_2015
