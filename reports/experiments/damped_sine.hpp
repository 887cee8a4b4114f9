#pragma once
/// The function of the experiments on curves in [MLZD15, sec. 2.5], sampled with outliers.

#include "outlier_study.hpp"

namespace subcert::experiments {

/// f_1(x) = sin(3x) e^(-x/3).
double damped_sine(double x);

namespace damped {

constexpr std::size_t count = 101;
constexpr int levels = 5;
/// Datum u stands here: -5, -4.9, ..., 5.
inline double position(double u) { return -5 + u / 10; }

std::vector<double> samples();
/// Largest minus smallest value of f_1 on [-5, 5], on the points of the last level.
double range();

/// Adds numbers of random sign and of a modulus between 4 and 8 to `outliers` data.
void add_outliers(std::mt19937_64& engine, std::vector<double>& data, std::size_t outliers);

/// Normal noise of this deviation, and outliers.
OutlierCase with_outliers(std::size_t outliers, double sigma);

/// The data, which of them are outliers, f_1 and the curve of a scheme; the panel is blue for l1 schemes, else red.
formats::Panel panel(const std::string& title, const std::string& specification, const OutlierSample& sample,
                     int refinements = levels);

/// A panel for each method, three in a row.
formats::Figure figure(const std::string& id, const std::string& title, const std::string& caption,
                       const std::vector<Method>& methods, const OutlierSample& sample);

/// What all experiments with f_1 choose.
std::string setup();

}  // namespace damped
}  // namespace subcert::experiments
