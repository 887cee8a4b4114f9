
#include "local_polynomial.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/smooth/scheme_smoother.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace subcert::experiments {
namespace {

/// The row of the local fit about x, by orthonormal polynomials for the kernel.
void fill_row(DenseMatrix& matrix, std::size_t row, int degree, double x, double bandwidth) {
  const double last = static_cast<double>(matrix.columns() - 1);
  const auto low = static_cast<std::size_t>(std::max(0.0, std::ceil(x - kernel_reach * bandwidth)));
  const auto high = static_cast<std::size_t>(std::min(last, std::floor(x + kernel_reach * bandwidth)));
  const std::size_t count = high - low + 1;
  std::vector<double> kernel(count), power(count, 1.0);
  const auto distance = [&](std::size_t i) { return (static_cast<double>(low + i) - x) / bandwidth; };
  for (std::size_t i = 0; i < count; ++i) kernel[i] = std::exp(-distance(i) * distance(i) / 2);
  const auto product = [&](const std::vector<double>& p, const std::vector<double>& q) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += kernel[i] * p[i] * q[i];
    return sum;
  };
  std::vector<std::pair<std::vector<double>, double>> basis;  // values at the data and at x
  for (int k = 0; k <= degree; ++k) {
    std::vector<double> next(power);
    double at_x = k == 0 ? 1 : 0;
    for (const auto& [values, value] : basis) {
      const double part = product(next, values);
      for (std::size_t i = 0; i < count; ++i) next[i] -= part * values[i];
      at_x -= part * value;
    }
    const double norm = std::sqrt(product(next, next));
    for (double& value : next) value /= norm;
    at_x /= norm;
    for (std::size_t i = 0; i < count; ++i) {
      matrix.at(row, low + i) += kernel[i] * at_x * next[i];
      power[i] *= distance(i);
    }
    basis.emplace_back(std::move(next), at_x);
  }
}

/// The mean of the middle two for an even number of values. Domain: at least one.
double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// The deviation of normal numbers with the same median distance from their median.
double median_deviation(std::vector<double> values) {
  const double middle = median(values);
  for (double& value : values) value = std::abs(value - middle);
  return median(std::move(values)) / 0.6745;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

LocalPolynomialRegression::LocalPolynomialRegression(int degree, std::size_t count,
                                                     const std::vector<double>& positions) {
  if (degree < 0 || degree > 3)
    fail(ErrorKind::domain, "LocalPolynomialRegression: need 0 <= degree <= 3, got {}", degree);
  require(count >= 8, "LocalPolynomialRegression: need count >= 8, got {}", count);
  double bandwidth = (degree + 1) / 4.0;
  while (bandwidth <= static_cast<double>(count) / 4) {
    bandwidths_.push_back(bandwidth);
    DenseMatrix data(count, count), other(positions.size(), count);
    for (std::size_t i = 0; i < count; ++i) fill_row(data, i, degree, static_cast<double>(i), bandwidth);
    for (std::size_t i = 0; i < positions.size(); ++i) fill_row(other, i, degree, positions[i], bandwidth);
    at_data_.push_back(std::move(data));
    at_positions_.push_back(std::move(other));
    bandwidth *= ratio;
  }
}

std::vector<double> LocalPolynomialRegression::left_out_residuals(std::size_t bandwidth,
                                                                  const std::vector<double>& data) const {
  std::vector<double> result = at_data_[bandwidth] * data;
  for (std::size_t i = 0; i < data.size(); ++i) result[i] = (data[i] - result[i]) / (1 - at_data_[bandwidth].at(i, i));
  return result;
}

std::vector<double> LocalPolynomialRegression::operator()(const std::vector<double>& data) const {
  const std::vector<double> none(data.size());
  return RegressionOfSum(*this, data, none)(0);
}

double LocalPolynomialRegression::bandwidth(const std::vector<double>& data) const {
  const std::vector<double> none(data.size());
  return bandwidths_[RegressionOfSum(*this, data, none).choice(0)];
}

RegressionOfSum::RegressionOfSum(const LocalPolynomialRegression& regression, const std::vector<double>& signal,
                                 const std::vector<double>& noise)
    : regression_(regression), signal_(signal), noise_(noise) {
  for (std::size_t b = 0; b < regression.bandwidths_.size(); ++b) {
    const auto of_signal = regression.left_out_residuals(b, signal), of_noise = regression.left_out_residuals(b, noise);
    criteria_.push_back({dot(of_signal, of_signal), 2 * dot(of_signal, of_noise), dot(of_noise, of_noise)});
  }
}

std::size_t RegressionOfSum::choice(double sigma) const {
  const auto sum = [&](const Criterion& c) { return c.signal + sigma * (c.mixed + sigma * c.noise); };
  const auto best = std::min_element(criteria_.begin(), criteria_.end(),
                                     [&](const Criterion& a, const Criterion& b) { return sum(a) < sum(b); });
  return static_cast<std::size_t>(best - criteria_.begin());
}

std::vector<double> RegressionOfSum::operator()(double sigma) {
  const std::size_t bandwidth = choice(sigma);
  const auto [fit, fresh] = fits_.try_emplace(bandwidth);
  if (fresh) {
    const DenseMatrix& matrix = regression_.at_positions_[bandwidth];
    fit->second = {matrix * signal_, matrix * noise_};
  }
  std::vector<double> result(fit->second.first);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] += sigma * fit->second.second[i];
  return result;
}

double median_bandwidth(const std::vector<double>& data, double spacing) {
  std::vector<double> positions;
  for (std::size_t i = 0; i < data.size(); ++i) positions.push_back(spacing * static_cast<double>(i));
  const double deviations = std::sqrt(median_deviation(std::move(positions)) * median_deviation(data));
  return deviations * std::pow(4.0 / (3 * static_cast<double>(data.size())), 0.2) / spacing;
}

DenseMatrix limit_matrix(const std::string& specification, std::size_t count, data::Boundary extension, int level) {
  const Scheme scheme = make_scheme(specification);
  const data::SchemeSmoother smoother(scheme.mask.curve(), count, {extension, level, 0});
  // Wrapped data: the outputs past the last datum are those before datum 1 of the data turned by one place.
  std::size_t scale = 1;
  for (int l = 0; l < level; ++l) scale *= static_cast<std::size_t>(scheme.mask.curve().arity());
  const std::size_t outputs = extension == data::Boundary::periodic ? count * scale : smoother.outputs();
  DenseMatrix result(outputs, count);
  const auto rows = smoother.rounded_rows();
  for (std::size_t r = 0; r < outputs; ++r) {
    const bool turned = r >= rows.size();
    const auto& row = rows[turned ? r - scale : r];
    for (std::size_t k = 0; k < row.weights.size(); ++k)
      result.at(r, (row.first + k + (turned ? 1 : 0)) % count) = row.weights[k];
  }
  return result;
}

}  // namespace subcert::experiments
