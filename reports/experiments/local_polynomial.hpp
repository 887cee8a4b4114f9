#pragma once
/// Local polynomial regression with automatic bandwidth, by two rules.

#include <subcert/schemes/data/smooth/extension.hpp>

#include <map>
#include <string>
#include <vector>

namespace subcert::experiments {

constexpr double kernel_reach = 9;  ///< bandwidths; the normal kernel is below 3e-18 beyond

/// out = matrix * data, row by row.
class DenseMatrix {
 public:
  DenseMatrix(std::size_t rows, std::size_t columns) : columns_(columns), entries_(rows * columns) {}
  std::size_t rows() const { return entries_.size() / columns_; }
  std::size_t columns() const { return columns_; }
  double& at(std::size_t row, std::size_t column) { return entries_[row * columns_ + column]; }
  double at(std::size_t row, std::size_t column) const { return entries_[row * columns_ + column]; }
  std::vector<double> operator*(const std::vector<double>& data) const;

 private:
  std::size_t columns_;
  std::vector<double> entries_;
};

/// The limit of a linear scheme at the multiples of arity^-level of the spacing; `wrap` data go once around, and so do
/// the outputs. Domain and errors: as LinearSmoother. The entries are rounded.
DenseMatrix limit_matrix(const std::string& specification, std::size_t count, data::Boundary extension, int level);

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

/// The bandwidth sqrt(h_x h_y) for data at the multiples of `spacing`, in spacings: h_v is the median of |v - median v|
/// over 0.6745, times (4/(3N))^(1/5). Domain: spacing > 0, data that are not mostly the same number.
/// Ref: Bowman, Azzalini, Applied Smoothing Techniques for Data Analysis, 1997; so the public MATLAB function ksrlin
/// (File Exchange, Yi Cao, 2008).
double median_bandwidth(const std::vector<double>& data, double spacing);

/// Local linear regression with the normal kernel on data at 0, 1, 2, ..., at the multiples of 2^-level up to the last.
/// Domain: at least two data, bandwidth >= 1/10. Cost: a window of 18 bandwidths for each value.
std::vector<double> local_linear(const std::vector<double>& data, double bandwidth, int level);

}  // namespace subcert::experiments
