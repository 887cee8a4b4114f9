#include "smoothing_choice.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

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

RiskEstimate estimate_risk(const LinearSmoother& smoother, const std::vector<std::vector<double>>& columns,
                           const std::vector<NoiseEstimate>& noise, const std::vector<double>& prior_weights,
                           double constant) {
  RiskEstimate risk;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto smoothed = smoother.apply(columns[c], constant);
    double residuals = 0, trace = 0, variances = 0, total_weight = 0;
    std::size_t present = 0;
    for (std::size_t i = 0; i < columns[c].size(); ++i) {
      const double w = weight_at(prior_weights, i);
      if (w <= 0) continue;
      const double r = columns[c][i] - smoothed.values[i];
      residuals += w * r * r;
      trace += smoothed.leverages[i];
      variances += w * smoothed.variances[i];
      total_weight += w;
      ++present;
    }
    // E sum w r^2 = sum w bias^2 + sigma^2 (count - 2 trace + sum w variance).
    const double expected_noise = noise[c].variance * (static_cast<double>(present) - 2 * trace + variances);
    risk.bias_squared += (residuals - expected_noise) / total_weight;
    risk.variance += noise[c].variance * variances / total_weight;
  }
  return risk;
}

std::vector<SmoothingCandidate> rank_schemes(const std::vector<std::vector<double>>& columns,
                                             const std::vector<NoiseEstimate>& noise, Extension extension,
                                             const std::vector<Rational>& prior_weights, double constant, int max_n) {
  const std::size_t count = columns.empty() ? 0 : columns.front().size();
  require(count >= 4, "rank_schemes: need at least 4 data, got {}", count);
  std::vector<double> weights;
  for (const Rational& weight : prior_weights) weights.push_back(static_cast<double>(weight));
  std::vector<SmoothingCandidate> candidates;
  for (const int degree : {1, 3, 5})
    for (int n = (degree + 1) / 2; n <= max_n && static_cast<std::size_t>(4 * n) <= count; ++n) {
      const Scheme scheme = make_scheme("primal:n=" + std::to_string(n) + ",d=" + std::to_string(degree));
      const LinearSmoother smoother(scheme.mask, count, {extension, 0, 0}, scheme.rules, prior_weights);
      try {
        candidates.push_back(
            {n, degree, scheme.specification, estimate_risk(smoother, columns, noise, weights, constant)});
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::data) throw;  // else a gap is too wide for its windows
      }
    }
  if (candidates.empty()) fail(ErrorKind::data, "no scheme has enough data in every window; gaps are too wide");
  std::stable_sort(candidates.begin(), candidates.end(), [](const SmoothingCandidate& a, const SmoothingCandidate& b) {
    return a.risk.total() < b.risk.total();
  });
  return candidates;
}

}  // namespace subcert::data
