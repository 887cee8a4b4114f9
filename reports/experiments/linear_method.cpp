#include "linear_method.hpp"

#include <subcert/schemes/data/smoothing.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>
#include <stdexcept>

namespace subcert {

std::vector<double> DenseMatrix::operator*(const std::vector<double>& data) const {
  std::vector<double> result(rows());
  for (std::size_t r = 0; r < result.size(); ++r) {
    const double* row = entries_.data() + r * columns_;
    double sum = 0;
    for (std::size_t c = 0; c < columns_; ++c) sum += row[c] * data[c];
    result[r] = sum;
  }
  return result;
}

DenseMatrix limit_matrix(const std::string& specification, std::size_t count, Extension extension, int level) {
  const Scheme scheme = make_scheme(specification);
  const LinearSmoother smoother(scheme.mask, count, {extension, level, 0});
  // Wrapped data: the outputs past the last datum are those before datum 1 of the data turned by one place.
  std::vector<double> unit(count, 0.0);
  std::size_t scale = 1;
  for (int l = 0; l < level; ++l) scale *= static_cast<std::size_t>(scheme.mask.arity());
  const std::size_t outputs = extension == Extension::wrap ? count * scale : smoother.outputs();
  DenseMatrix result(outputs, count);
  for (std::size_t c = 0; c < count; ++c) {
    unit[c] = 1;
    const auto values = smoother.apply(unit).values;
    unit[c] = 0;
    for (std::size_t r = 0; r < values.size(); ++r) result.at(r, c) = values[r];
    for (std::size_t r = values.size(); r < outputs; ++r) result.at(r, (c + 1) % count) = values[r - scale];
  }
  return result;
}

namespace {

/// The row of the local linear fit about x.
void fill_row(DenseMatrix& matrix, std::size_t row, double x, double bandwidth) {
  double moments[3] = {0, 0, 0};
  const auto kernel = [&](std::size_t i) {
    const double u = (static_cast<double>(i) - x) / bandwidth;
    return std::exp(-u * u / 2);
  };
  for (std::size_t i = 0; i < matrix.columns(); ++i) {
    const double distance = static_cast<double>(i) - x, weight = kernel(i);
    moments[0] += weight;
    moments[1] += weight * distance;
    moments[2] += weight * distance * distance;
  }
  const double determinant = moments[0] * moments[2] - moments[1] * moments[1];
  for (std::size_t i = 0; i < matrix.columns(); ++i)
    matrix.at(row, i) = kernel(i) * (moments[2] - moments[1] * (static_cast<double>(i) - x)) / determinant;
}

}  // namespace

LocalLinearRegression::LocalLinearRegression(std::size_t count, const std::vector<double>& positions) {
  if (count < 8) throw std::invalid_argument("LocalLinearRegression: need count >= 8, got " + std::to_string(count));
  for (double bandwidth = lowest; bandwidth <= static_cast<double>(count) / 4; bandwidth *= ratio) {
    bandwidths_.push_back(bandwidth);
    DenseMatrix data(count, count), other(positions.size(), count);
    for (std::size_t i = 0; i < count; ++i) fill_row(data, i, static_cast<double>(i), bandwidth);
    for (std::size_t i = 0; i < positions.size(); ++i) fill_row(other, i, positions[i], bandwidth);
    at_data_.push_back(std::move(data));
    at_positions_.push_back(std::move(other));
  }
}

std::size_t LocalLinearRegression::choice(const std::vector<double>& data) const {
  std::size_t best = 0;
  double smallest = 0;
  for (std::size_t b = 0; b < bandwidths_.size(); ++b) {
    const auto fit = at_data_[b] * data;
    double sum = 0;
    for (std::size_t i = 0; i < data.size(); ++i) {
      const double left_out = (data[i] - fit[i]) / (1 - at_data_[b].at(i, i));
      sum += left_out * left_out;
    }
    if (b == 0 || sum < smallest) {
      best = b;
      smallest = sum;
    }
  }
  return best;
}

std::vector<double> LocalLinearRegression::operator()(const std::vector<double>& data) const {
  return at_positions_[choice(data)] * data;
}

double LocalLinearRegression::bandwidth(const std::vector<double>& data) const { return bandwidths_[choice(data)]; }

}  // namespace subcert
