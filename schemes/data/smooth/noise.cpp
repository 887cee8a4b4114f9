#include "noise.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <boost/math/distributions/students_t.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace subcert::data {
namespace {

/// A second difference y[i-1]/2 - y[i] + y[i+1]/2, normed to the variance of a datum of weight 1.
struct SecondDifference {
  std::size_t middle;
  double scale;
};

constexpr std::array<double, 3> difference{0.5, -1, 0.5};

double weight_at(const std::vector<double>& weights, std::size_t i) { return weights.empty() ? 1 : weights[i]; }

/// The covariance of two normed second differences for noise of variance 1 / weight.
double covariance(const SecondDifference& a, const SecondDifference& b, const std::vector<double>& weights) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = a.middle - 1 + k;
    if (i + 1 < b.middle || i > b.middle + 1) continue;
    sum += difference[k] * difference[i + 1 - b.middle] / weight_at(weights, i);
  }
  return sum * a.scale * b.scale;
}

}  // namespace

NoiseEstimate estimate_noise(const std::vector<double>& data, const std::vector<double>& prior_weights) {
  if (!prior_weights.empty() && prior_weights.size() != data.size())
    fail(ErrorKind::domain, "estimate_noise: need as many weights as data, got {} for {}", prior_weights.size(),
         data.size());
  std::vector<SecondDifference> terms;
  double sum = 0;
  for (std::size_t i = 1; i + 1 < data.size(); ++i) {
    double variance = 0;
    bool present = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double w = weight_at(prior_weights, i - 1 + k);
      present = present && w > 0;
      variance += difference[k] * difference[k] / w;
    }
    if (!present) continue;
    terms.push_back({i, 1 / std::sqrt(variance)});
    const double residual = (0.5 * data[i - 1] - data[i] + 0.5 * data[i + 1]) * terms.back().scale;
    sum += residual * residual;
  }
  if (terms.empty()) return {};
  // The mean of m squares with covariances r has mean 1 and variance 2 sum r^2 / m^2, as chi squared / nu has 2 / nu.
  double squares = 0;
  for (std::size_t a = 0; a < terms.size(); ++a)
    for (std::size_t b = a; b < terms.size() && terms[b].middle <= terms[a].middle + 2; ++b) {
      const double r = covariance(terms[a], terms[b], prior_weights);
      squares += (a == b ? 1 : 2) * r * r;
    }
  const auto m = static_cast<double>(terms.size());
  return {sum / m, m * m / squares, terms.size()};
}

std::vector<NoiseEstimate> estimate_noise(const Samples& samples) {
  std::vector<NoiseEstimate> noise;
  for (const auto& column : samples.columns) noise.push_back(estimate_noise(column, samples.rounded_weights()));
  return noise;
}

namespace {

void require_band(double level, const NoiseEstimate& noise) {
  require(level > 0 && level < 1, "band_factor: need 0 < level < 1, got {}", level);
  require(noise.terms > 0, "band_factor: need an estimate of the noise from at least one second difference");
}

}  // namespace

double band_factor(double level, const NoiseEstimate& noise) {
  require_band(level, noise);
  return boost::math::quantile(boost::math::students_t(noise.degrees_of_freedom), 0.5 + level / 2);
}

double simultaneous_band_factor(double level, const NoiseEstimate& noise, double path) {
  require_band(level, noise);
  require(path >= 0, "simultaneous_band_factor: need path >= 0, got {}", path);
  const double nu = noise.degrees_of_freedom;
  const boost::math::students_t student(nu);
  const auto outside = [&](double c) {
    return path / std::numbers::pi * std::pow(1 + c * c / nu, -nu / 2) +
           2 * boost::math::cdf(boost::math::complement(student, c));
  };
  double low = 0, high = 1;
  while (outside(high) > 1 - level && high < 1e300) high *= 2;
  for (int step = 0; step < 100; ++step) {
    const double middle = (low + high) / 2;
    (outside(middle) > 1 - level ? low : high) = middle;
  }
  return high;
}

}  // namespace subcert::data
