#pragma once
/// The expected squared error of a smoothed value, exact, and the same by simulation.

#include "linear_smoother.hpp"

#include <cstdint>

namespace subcert::data {

/// For y_i = samples[i] + noise of mean 0 and variance sigma^2 / (prior weight), independent.
struct ExpectedError {
  Rational bias;      ///< expected value of the limit minus the true value
  Rational variance;  ///< sigma^2 times the variance of the row
  Rational total() const { return bias * bias + variance; }
};

/// Eq. (16) of [DHHS15] at the position of the row, for data of any number and any extension. Domain: as many samples
/// as data; `outside` is the constant of Boundary::constant. Ref: [DHHS15, eq. (16)].
ExpectedError expected_error(const SmoothingRow& row, const std::vector<Rational>& samples, const Rational& truth,
                             const Rational& sigma_squared, const Rational& outside = 0);

/// Mean squared error over simulated normal noise, and its confidence interval by the central limit theorem.
struct SimulatedError {
  double mean;
  double lower;
  double upper;
  std::size_t runs;
};

/// Domain: runs >= 2, 0 < confidence < 1, sigma >= 0, equal prior weights. Errors: throws a domain error.
/// Cost: runs times the width of the row. The same seed gives the same numbers.
SimulatedError simulated_error(const SmoothingRow& row, const std::vector<double>& samples, double truth, double sigma,
                               std::size_t runs, std::uint64_t seed, double confidence = 0.95);

}  // namespace subcert::data
