#pragma once
/// Data in groups of neighbours, for wide windows.

#include "method_choice.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace subcert::data {

/// Outputs at the data, as methods are judged by.
inline SmoothingOptions at_data(const SmoothingOptions& options) {
  SmoothingOptions there{options.boundary, 0, 0, options.constant, true, false};
  there.selection = options.selection;
  return there;
}

/// Data in groups of `size` neighbours, each its mean by the prior weights; the last ones, too few for a group, are
/// left out.
struct GroupedSamples {
  std::size_t size;
  Samples samples;
  std::vector<NoiseEstimate> noise;

  GroupedSamples(const Samples& all, std::vector<NoiseEstimate> of_data, std::size_t group)
      : size(group), noise(std::move(of_data)) {
    if (size == 1) {
      samples = all;
      return;
    }
    const std::size_t groups = all.count() / size;
    const std::vector<double> weights = all.rounded_weights();
    samples.columns.assign(all.columns.size(), std::vector<double>(groups));
    samples.spacing = all.spacing * Rational(size);
    if (weights.empty())
      for (NoiseEstimate& one : noise) one.variance /= static_cast<double>(size);
    for (std::size_t g = 0; g < groups; ++g) {
      const auto mean = [&](const std::vector<double>& values, double sum) {
        double total = 0;
        for (std::size_t i = g * size; i < (g + 1) * size; ++i)
          total += (weights.empty() ? 1 : weights[i]) * (values[i] - values[g * size]);
        return sum > 0 ? values[g * size] + total / sum : values[g * size];
      };
      double sum = weights.empty() ? static_cast<double>(size) : 0;
      if (!weights.empty()) {
        sum = std::accumulate(weights.begin() + static_cast<std::ptrdiff_t>(g * size),
                              weights.begin() + static_cast<std::ptrdiff_t>((g + 1) * size), 0.0);
        samples.weights.push_back(Rational(sum));
      }
      for (std::size_t c = 0; c < all.columns.size(); ++c) samples.columns[c][g] = mean(all.columns[c], sum);
      if (!all.uniform()) samples.positions.push_back(mean(all.positions, sum));
    }
  }
};

constexpr std::size_t fine_window = 32, coarse_window = 64;  // groups in a window

/// The mean square of what one leaves of the other, by the weights.
inline double mean_square_apart(const std::vector<double>& one, const std::vector<double>& other,
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
