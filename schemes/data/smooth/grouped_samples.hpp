#pragma once
/// Data in groups of neighbours, for wide windows. Inner header.

#include "method_choice.hpp"

#include <vector>

namespace subcert::data {

/// Groups in a window: the fewest that stand for data, and the most that are tried of one size.
constexpr std::size_t fine_window = 32, coarse_window = 64;

/// Data in groups of `size` neighbours, each its mean by the prior weights; the last ones, too few for a group, are
/// left out. The noise is that of a mean where all weights are equal; else the sums of the weights say it.
struct GroupedSamples {
  std::size_t size;
  Samples samples;
  std::vector<NoiseEstimate> noise;

  /// Domain: size >= 1; `of_data` has an estimate for each column. Cost: one pass.
  GroupedSamples(const Samples& all, std::vector<NoiseEstimate> of_data, std::size_t size);
};

/// Outputs at the data, as these are observed, as methods are judged by.
SmoothingOptions at_data(const SmoothingOptions& options);

/// The mean square of what one leaves of the other, by the weights, all 1 where there are none. Domain: equal lengths,
/// a weight that is not zero.
double mean_square_apart(const std::vector<double>& one, const std::vector<double>& other,
                         const std::vector<double>& weights);

}  // namespace subcert::data
