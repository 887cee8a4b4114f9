#include "grouped_samples.hpp"

#include <cmath>
#include <utility>

namespace subcert::data {

GroupedSamples::GroupedSamples(const Samples& all, std::vector<NoiseEstimate> of_data, std::size_t group)
    : size(group), noise(std::move(of_data)) {
  if (size == 1) {
    samples = all;
    return;
  }
  const std::vector<double> weights = all.rounded_weights();
  const std::size_t groups = all.rows() / size, kinds = all.count() / all.rows();
  samples.columns.assign(all.columns.size(), std::vector<double>(groups * kinds));
  samples.derivatives = all.derivatives;
  samples.spacing = all.spacing * Rational(size);
  if (weights.empty())
    for (NoiseEstimate& one : noise) one.variance /= static_cast<double>(size);
  for (std::size_t k = 0; k < groups * kinds; ++k) {
    const std::size_t first = k / kinds * size, kind = k % kinds;
    // Derivatives are by the spacing, which is `size` times as large.
    const double unit = std::pow(static_cast<double>(size), static_cast<double>(kind));
    const auto weight = [&](std::size_t i) { return weights.empty() ? 1 : weights[(first + i) * kinds + kind]; };
    double sum = 0;
    for (std::size_t i = 0; i < size; ++i) sum += weight(i);
    if (!weights.empty()) samples.weights.push_back(Rational(sum / (unit * unit)));
    const auto mean = [&](const double* values, std::size_t step) {
      double total = 0;
      for (std::size_t i = 0; i < size; ++i) total += weight(i) * (values[i * step] - values[0]);
      return sum > 0 ? values[0] + total / sum : values[0];
    };
    for (std::size_t c = 0; c < all.columns.size(); ++c)
      samples.columns[c][k] = unit * mean(all.columns[c].data() + first * kinds + kind, kinds);
    if (!all.uniform() && kind == 0) samples.positions.push_back(mean(all.positions.data() + first, 1));
  }
}

SmoothingOptions at_data(const SmoothingOptions& options) {
  SmoothingOptions there{options.boundary, 0, 0, options.constant, true, false};
  there.selection = options.selection;
  there.as_observed = true;
  return there;
}

double mean_square_apart(const std::vector<double>& one, const std::vector<double>& other,
                         const std::vector<double>& weights) {
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double weight = weights.empty() ? 1 : weights[i], apart = one[i] - other[i];
    if (weight == 0) continue;
    sum += weight * apart * apart;
    total += weight;
  }
  return sum / total;
}

}  // namespace subcert::data
