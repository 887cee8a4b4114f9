#include "expected_error.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <boost/math/distributions/normal.hpp>

#include <cmath>
#include <random>

namespace subcert::data {
namespace {

void require_samples(const SmoothingRow& row, std::size_t count) {
  if (row.first + row.weights.size() > count)
    fail(ErrorKind::domain, "expected_error: need at least {} samples, got {}", row.first + row.weights.size(), count);
}

}  // namespace

ExpectedError expected_error(const SmoothingRow& row, const std::vector<Rational>& samples, const Rational& truth,
                             const Rational& sigma_squared, const Rational& outside) {
  require_samples(row, samples.size());
  ExpectedError error{row.outside * outside - truth, sigma_squared * row.variance};
  for (std::size_t k = 0; k < row.weights.size(); ++k) error.bias += row.weights[k] * samples[row.first + k];
  return error;
}

SimulatedError simulated_error(const SmoothingRow& row, const std::vector<double>& samples, double truth, double sigma,
                               std::size_t runs, std::uint64_t seed, double confidence) {
  require_samples(row, samples.size());
  require(runs >= 2, "simulated_error: need runs >= 2, got {}", runs);
  if (!(confidence > 0 && confidence < 1)) fail(ErrorKind::domain, "simulated_error: need 0 < confidence < 1");
  require(sigma >= 0, "simulated_error: need sigma >= 0");
  std::vector<double> weights;
  for (const Rational& weight : row.weights) weights.push_back(static_cast<double>(weight));
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> noise(0, 1);
  double mean = 0, squares = 0;  // running mean and sum of squared deviations
  for (std::size_t run = 1; run <= runs; ++run) {
    double value = -truth;
    for (std::size_t k = 0; k < weights.size(); ++k)
      value += weights[k] * (samples[row.first + k] + sigma * noise(engine));
    const double step = value * value - mean;
    mean += step / static_cast<double>(run);
    squares += step * (value * value - mean);
  }
  const auto n = static_cast<double>(runs);
  const double width = boost::math::quantile(boost::math::normal(), 0.5 + confidence / 2) *
                       std::sqrt(squares / (n - 1) / n);
  return {mean, mean - width, mean + width, runs};
}

}  // namespace subcert::data
