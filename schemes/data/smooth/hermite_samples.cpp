#include "hermite_samples.hpp"

#include "noise.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::data {
namespace {

constexpr double largest_ratio = 1e4;

/// Standard deviations for weight 1, 0 where there is no estimate.
double deviation_of(const Samples& samples, std::size_t column, const std::optional<double>& known, bool robust) {
  if (known) return *known;
  const std::vector<double> weights = samples.rounded_weights();
  const std::vector<double>& data = samples.columns[column];
  return robust ? bulk_deviation(data, weights, samples.positions)
                : std::sqrt(estimate_noise(data, weights, samples.positions).variance);
}

/// Of the noise of values to that of slopes by the spacing.
double ratio_of_noises(const Samples& samples, bool robust) {
  const std::size_t half = samples.columns.size() / 2;
  const double unit = nearest_double(samples.spacing);
  double logarithms = 0;
  std::size_t known = 0;
  for (std::size_t c = 0; c < half; ++c) {
    const double ratio = deviation_of(samples, c, samples.noise, robust) /
                         (unit * deviation_of(samples, half + c, samples.slope_noise, robust));
    if (!(ratio > 0) || std::isinf(ratio)) continue;
    logarithms += std::log(ratio);
    ++known;
  }
  if (known == 0) return 1;
  return std::clamp(std::exp(logarithms / static_cast<double>(known)), 1 / largest_ratio, largest_ratio);
}

}  // namespace

Samples with_slopes_after_values(const Samples& samples, bool robust) {
  const std::size_t half = samples.columns.size() / 2;
  if (samples.columns.size() != 2 * half)
    fail(ErrorKind::data, "expected columns of values and as many of their slopes behind; found {} in all",
         samples.columns.size());
  Samples result = samples;
  result.slopes = false;
  result.derivatives = 1;
  const double ratio = ratio_of_noises(samples, robust), unit = nearest_double(samples.spacing);
  result.derivative_weight = ratio * ratio;
  result.columns.assign(half, {});
  for (std::size_t c = 0; c < half; ++c)
    for (std::size_t i = 0; i < samples.count(); ++i) {
      result.columns[c].push_back(samples.columns[c][i]);
      result.columns[c].push_back(samples.columns[half + c][i] * unit);
    }
  const Rational slope_weight(result.derivative_weight);
  result.weights.clear();
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const Rational weight = samples.weights.empty() ? Rational(1) : samples.weights[i];
    result.weights.push_back(weight);
    result.weights.push_back(weight * slope_weight);
  }
  return result;
}

std::vector<double> data_of_order(const Samples& samples, const std::vector<double>& data, int order) {
  if (samples.derivatives == 0) return data;
  std::vector<double> result;
  const auto kinds = static_cast<std::size_t>(samples.derivatives) + 1;
  for (auto i = static_cast<std::size_t>(order); i < data.size(); i += kinds) result.push_back(data[i]);
  return result;
}

std::vector<double> weights_of_order(const Samples& samples, int order) {
  std::vector<double> weights = samples.rounded_weights();
  if (samples.derivatives == 0) return weights;
  const auto kinds = static_cast<std::size_t>(samples.derivatives) + 1;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (i % kinds != static_cast<std::size_t>(order)) weights[i] = 0;
  return weights;
}

}  // namespace subcert::data
