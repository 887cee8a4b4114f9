#include "grouped_samples.hpp"

#include <utility>

namespace subcert::data {

GroupedSamples::GroupedSamples(const Samples& all, std::vector<NoiseEstimate> of_data, std::size_t group)
    : size(group), noise(std::move(of_data)) {
  if (size == 1) {
    samples = all;
    return;
  }
  const std::vector<double> weights = all.rounded_weights();
  const std::size_t groups = all.count() / size;
  samples.columns.assign(all.columns.size(), std::vector<double>(groups));
  samples.spacing = all.spacing * Rational(size);
  if (weights.empty())
    for (NoiseEstimate& one : noise) one.variance /= static_cast<double>(size);
  for (std::size_t g = 0; g < groups; ++g) {
    const std::size_t first = g * size;
    const auto weight = [&](std::size_t i) { return weights.empty() ? 1 : weights[first + i]; };
    double sum = 0;
    for (std::size_t i = 0; i < size; ++i) sum += weight(i);
    if (!weights.empty()) samples.weights.push_back(Rational(sum));
    const auto mean = [&](const std::vector<double>& values) {
      double total = 0;
      for (std::size_t i = 0; i < size; ++i) total += weight(i) * (values[first + i] - values[first]);
      return sum > 0 ? values[first] + total / sum : values[first];
    };
    for (std::size_t c = 0; c < all.columns.size(); ++c) samples.columns[c][g] = mean(all.columns[c]);
    if (!all.uniform()) samples.positions.push_back(mean(all.positions));
  }
}

SmoothingOptions at_data(const SmoothingOptions& options) {
  SmoothingOptions there{options.boundary, 0, 0, options.constant, true, false};
  there.selection = options.selection;
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
