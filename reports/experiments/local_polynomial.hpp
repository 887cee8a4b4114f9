#pragma once
/// Local polynomial regression with automatic bandwidth.

#include "linear_method.hpp"

#include <map>

namespace subcert::experiments {

/// Local polynomial regression with the normal kernel on the data 0, ..., count - 1. The bandwidth is the one of the
/// grid (degree + 1)/4 * ratio^k, in spacings, with the smallest sum of squared residuals when each datum is left out.
/// Ref: [DHHS15, sec. 3.2].
class LocalPolynomialRegression {
 public:
  static constexpr double ratio = 1.15;

  /// Evaluates at `positions`. The bandwidths go up to a quarter of the data. Domain: 0 <= degree <= 3, count >= 8.
  LocalPolynomialRegression(int degree, std::size_t count, const std::vector<double>& positions);
  std::vector<double> operator()(const std::vector<double>& data) const;
  /// The bandwidth chosen for these data.
  double bandwidth(const std::vector<double>& data) const;

 private:
  friend class RegressionOfSum;
  std::vector<double> left_out_residuals(std::size_t bandwidth, const std::vector<double>& data) const;

  std::vector<double> bandwidths_;
  std::vector<DenseMatrix> at_data_;
  std::vector<DenseMatrix> at_positions_;
};

/// The regression of signal + sigma * noise for many sigma: with a fixed bandwidth it is linear, so that its criterion
/// is a quadratic polynomial in sigma. Cost: of the constructor, that of one choice of the bandwidth.
class RegressionOfSum {
 public:
  RegressionOfSum(const LocalPolynomialRegression& regression, const std::vector<double>& signal,
                  const std::vector<double>& noise);
  /// Each bandwidth is applied once.
  std::vector<double> operator()(double sigma);
  std::size_t choice(double sigma) const;

 private:
  struct Criterion {
    double signal, mixed, noise;
  };
  const LocalPolynomialRegression& regression_;
  const std::vector<double>& signal_;
  const std::vector<double>& noise_;
  std::vector<Criterion> criteria_;
  std::map<std::size_t, std::pair<std::vector<double>, std::vector<double>>> fits_;
};

}  // namespace subcert::experiments
