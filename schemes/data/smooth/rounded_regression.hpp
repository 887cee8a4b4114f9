#pragma once
/// Weights of local regressions in double precision, for the many different windows that prior weights make.

#include <vector>

namespace subcert::data {

/// regression_weights() in double precision. Domain: as there; degree at most 30, nodes within a few hundreds of x.
/// Error: a small multiple of 2^-53 times the largest weight for degrees up to 5, not bounded here; the tests compare
/// with exact weights. Cost: nodes * degree operations.
std::vector<double> rounded_regression_weights(const std::vector<double>& nodes, const std::vector<double>& weights,
                                               int degree, double x, int derivative = 0);

}  // namespace subcert::data
