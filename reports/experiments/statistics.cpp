#include "statistics.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace subcert::experiments {

std::mt19937_64 generator(std::uint64_t seed, std::size_t run) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                         static_cast<std::uint32_t>(run)};
  return std::mt19937_64(sequence);
}

std::vector<double> normal_noise(std::mt19937_64& engine, std::size_t count) {
  boost::random::normal_distribution<double> normal;
  std::vector<double> result(count);
  for (double& value : result) value = normal(engine);
  return result;
}

double uniform(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

std::vector<std::size_t> chosen_indices(std::mt19937_64& engine, std::size_t count, std::size_t size) {
  std::vector<std::size_t> all(size);
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (std::size_t i = 0; i < count; ++i)
    std::swap(all[i], all[boost::random::uniform_int_distribution<std::size_t>(i, size - 1)(engine)]);
  all.resize(count);
  return all;
}

std::string MeanInterval::text() const { return short_number(mean) + " ± " + short_number(half_width); }

double each_of(std::size_t count) {
  require(count >= 1, "each_of: need count >= 1");
  return 1 - (1 - together) / static_cast<double>(count * (1 + patience.size()));
}

namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// By Student's t.
MeanInterval normal_interval(const std::vector<double>& values, double confidence) {
  require(values.size() >= 2, "mean_interval: need at least 2 values");
  const auto count = static_cast<double>(values.size());
  const double mean = mean_of(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double quantile = boost::math::quantile(boost::math::students_t(count - 1), (1 + confidence) / 2);
  return {mean, quantile * std::sqrt(squares / (count - 1) / count)};
}

/// By Clopper and Pearson, the farther end on both sides.
MeanInterval interval_of_part(const std::vector<double>& values, double confidence) {
  using Binomial = boost::math::binomial_distribution<double>;
  const auto count = static_cast<double>(values.size());
  const double mean = mean_of(values), successes = mean * count, outside = (1 - confidence) / 2;
  return {mean, std::max(mean - Binomial::find_lower_bound_on_p(count, successes, outside),
                         Binomial::find_upper_bound_on_p(count, successes, outside) - mean)};
}

}  // namespace

MeanInterval mean_interval(const std::vector<double>& values, double confidence) {
  const bool is_part = std::ranges::all_of(values, [](double value) { return value == 0 || value == 1; });
  return is_part && values.size() >= 2 ? interval_of_part(values, confidence) : normal_interval(values, confidence);
}

MeanInterval mean_difference(const std::vector<double>& first, const std::vector<double>& second, double confidence) {
  std::vector<double> difference(first);
  for (std::size_t i = 0; i < first.size(); ++i) difference[i] -= second[i];
  return normal_interval(difference, confidence);
}

double noise_deviation(double mean_square, double decibel, double factor) {
  return std::sqrt(mean_square / (std::pow(10.0, 2 * decibel / factor) - 1));
}

double mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum / static_cast<double>(values.size());
}

std::string short_number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace subcert::experiments
