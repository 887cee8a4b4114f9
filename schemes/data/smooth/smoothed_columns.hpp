#pragma once
// What smooth() and its streams make of the values of a smoother.

#include "smooth.hpp"

namespace subcert::data {

/// The columns for the spacings begin, ..., end - 1 of the smoother, whose first datum is number `before` of the grid.
SmoothedSamples smoothed_columns(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                 const LinearSmoother& smoother, int derivative, std::size_t begin, std::size_t end,
                                 std::size_t before);

}  // namespace subcert::data
