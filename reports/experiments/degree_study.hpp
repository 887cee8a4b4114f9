#pragma once
/// How well local l1 and least squares polynomials of several degrees follow noisy data with outliers.

#include "outlier_study.hpp"
#include "refined_data.hpp"

namespace subcert::experiments {

/// D_p^d: l1 regression of degree d on p data, on curves or (grid) on p x p data. S_p^d: the same by least squares.
Method robust_method(int points, int degree, bool grid = false);
Method least_squares_method(int points, int degree, bool grid = false);

/// Estimates from pairs of independent samples with outliers, one of each for each pair, as means over the points of
/// the last level. With the errors e and e' of a pair, the mean of e . e' is unbiased for the squared bias, and that of
/// |e - e'|^2 / 2 for the variance.
struct ErrorParts {
  std::vector<double> squared_bias;
  std::vector<double> variance;
  /// [run]: the mean squared distance between the limit and the data that are no outliers. Curves only.
  std::vector<double> from_data;
};

/// Domain: options.runs >= 2; at least 4 samples are drawn.
ErrorParts error_parts(const OutlierCase& what, const Method& method, const ExperimentOptions& options);

/// first - factor * second, paired.
NamedMean paired(const std::string& name, const std::vector<double>& first, const std::vector<double>& second,
                 double factor = 1);

}  // namespace subcert::experiments
