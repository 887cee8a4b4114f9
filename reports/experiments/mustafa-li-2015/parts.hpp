#pragma once
/// What the experiments of [MLZD15] measure, and what they share.

#include <subcert/reports/experiments/noisy_data.hpp>
#include <subcert/reports/experiments/papers.hpp>

namespace subcert::experiments::mustafa_li_2015 {

Measured outliers_under_linear_schemes(const Run& run);
Measured limit_functions(const Run& run);
Measured two_outliers(const Run& run);
Measured noise_and_outliers(const Run& run);
Measured iterations(const Run& run);
Measured spiral(const Run& run);
Measured impulsive_noise(const Run& run);
Measured bump(const Run& run);
Measured moebius_band(const Run& run);

/// S_6, S_7, S_8 by least squares and D_6, D_7, D_8 by l1 regression, on curves and on grids.
const std::vector<Method>& curve_methods();
const std::vector<Method>& surface_methods();

/// The deviation of the noise by the choice `noise`: `variance 0.1` or `deviation 0.1`.
double noise_deviation_of(const Run& run);

/// Measures "error", "error without", "response" and these `measures` of the methods, with the table of them as
/// taken. The names of the measures begin with `prefix`, the id of the table ends with `table`.
void add_outlier_study(Measured& result, const Run& run, const std::string& table, const std::string& title,
                       const NoisyData& data, const std::vector<Method>& methods, const std::string& prefix = "",
                       std::vector<SampleMeasure> measures = {});

/// Adds the fact "smooth" of this name: whether the largest change of slope between neighbouring edges along an axis
/// falls with each level from `first` to `last`. Domain: first < last; at_level(k) has values of dimension 1.
void add_smoothness(Measured& result, const std::string& name,
                    const std::function<data::GridData<double>(int level)>& at_level, int first, int last);

}  // namespace subcert::experiments::mustafa_li_2015
