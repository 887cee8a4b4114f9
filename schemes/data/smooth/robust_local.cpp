#include "robust_local.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace subcert::data {

double median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

namespace {

constexpr double scale_factor = 6;  // medians of the moduli of the residuals
constexpr double kept = 0.001, left_out = 0.999;
constexpr double vanishing = 1e-7;

/// Of the data that count: their residuals times the roots of their prior weights.
std::vector<double> scaled_residuals(const DataSites& sites, const std::vector<double>& data,
                                     const std::vector<double>& fits) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const double weight = sites.weights.empty() ? 1 : static_cast<double>(sites.weights[i]);
    residuals.push_back(weight > 0 ? std::sqrt(weight) * (data[i] - fits[i])
                                   : std::numeric_limits<double>::quiet_NaN());
  }
  return residuals;
}

double scale_of(const std::vector<double>& residuals) {
  std::vector<double> moduli;
  double mean = 0;
  for (const double r : residuals)
    if (!std::isnan(r)) {
      moduli.push_back(std::abs(r));
      mean += moduli.back();
    }
  mean /= static_cast<double>(moduli.size());
  const double middle = median(std::move(moduli));
  return scale_factor * (middle > vanishing * mean ? middle : mean);
}

double bisquare_weight(double u) {
  u = std::abs(u);
  if (u <= kept) return 1;
  if (!(u <= left_out)) return 0;
  return (1 - u * u) * (1 - u * u);
}

/// Sums over the data that count.
struct Influence {
  double squares = 0;  ///< of psi
  double slopes = 0;   ///< psi'
  double count = 0;
  double scale = 0;

  Influence(const std::vector<double>& residuals, double S) : scale(S) {
    for (const double r : residuals) {
      if (std::isnan(r)) continue;
      ++count;
      const double u = S > 0 ? r / S : 0;
      if (!(std::abs(u) < 1)) continue;
      const double rest = 1 - u * u;
      squares += S * S * u * u * rest * rest * rest * rest;
      slopes += rest * (1 - 5 * u * u);
    }
  }
  double mean_slope() const { return slopes / count; }
};

/// The variance that each datum adds as if the fit were linear, from `freedom` degrees.
NoiseEstimate sandwich_noise(const Influence& influence, double freedom) {
  if (!(freedom > 0) || !(influence.slopes > 0)) return {};
  const double slope = influence.mean_slope();
  return {influence.squares / freedom / (slope * slope), freedom, static_cast<std::size_t>(influence.count)};
}

}  // namespace

RobustFit robust_fit(const LocalPolynomial& method, const DataSites& sites, const SmoothingOptions& options,
                     const std::vector<double>& data, int threads) {
  SmoothingOptions there = options;
  there.level = there.derivative = 0;
  there.at_data = true;
  there.path = false;
  there.as_observed = true;
  there.places.clear();
  const LocalSmoother at_data(method, sites, there);
  std::vector<double> factors(data.size(), 1);
  std::vector<double> fits = at_data.values(data, factors, threads), residuals = scaled_residuals(sites, data, fits);
  for (int step = 0; step < method.robust; ++step) {
    const double scale = scale_of(residuals);
    if (!(scale > 0)) break;
    std::ranges::transform(residuals, factors.begin(), [&](double r) { return bisquare_weight(r / scale); });
    fits = at_data.values(data, factors, threads);
    residuals = scaled_residuals(sites, data, fits);
  }
  const Influence influence(residuals, scale_of(residuals));
  const SmoothedData plain = at_data.apply(data);
  double freedom = influence.count;
  for (std::size_t i = 0; i < data.size(); ++i)
    if (!std::isnan(residuals[i])) {
      const double weight = sites.weights.empty() ? 1 : static_cast<double>(sites.weights[i]);
      freedom += weight * plain.variances[i] - 2 * plain.leverages[i];
    }
  const bool values = sites.derivatives == 0 && options.derivative == 0;
  const bool same = options.at_data && values && !options.path;  // outputs
  const LocalSmoother smoother(method, sites, same ? there : options);
  RobustFit result{
      same ? fits : smoother.values(data, factors, threads), {}, sandwich_noise(influence, freedom), 0, fits};
  const double slope = influence.mean_slope();
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (std::isnan(residuals[i]) || !(slope > 0)) continue;
    const double u = influence.scale > 0 ? residuals[i] / influence.scale : 0;
    const double rest = std::abs(u) < 1 ? 1 - u * u : 0;
    result.pseudodata[i] += (data[i] - fits[i]) * rest * rest / slope;
  }
  if (!result.noise.exists()) return result;
  SmoothedData linear = same ? plain : smoother.apply(data);
  result.path = linear.path;
  result.deviations = std::move(linear.variances);
  for (double& deviation : result.deviations) deviation = std::sqrt(result.noise.variance * deviation);
  return result;
}

}  // namespace subcert::data
