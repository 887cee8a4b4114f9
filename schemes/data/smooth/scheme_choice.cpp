#include "scheme_choice.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>

namespace subcert::data {

RiskEstimate estimate_risk(const LinearSmoother& smoother, const Samples& samples,
                           const std::vector<NoiseEstimate>& noise) {
  const std::vector<double> weights = samples.rounded_weights();
  RiskEstimate risk;
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    const std::vector<double>& column = samples.columns[c];
    const auto smoothed = smoother.apply(column);
    double residuals = 0, trace = 0, variances = 0, total_weight = 0;
    std::size_t present = 0;
    for (std::size_t i = 0; i < column.size(); ++i) {
      const double w = weights.empty() ? 1 : weights[i];
      if (w <= 0) continue;
      const double r = column[i] - smoothed.values[i];
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

std::vector<SmoothingCandidate> rank_schemes(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                             const SmoothingOptions& options, int max_n) {
  const std::size_t count = samples.count();
  require(count >= 4, "rank_schemes: need at least 4 data, got {}", count);
  const SmoothingOptions at_data{options.boundary, 0, 0, options.constant};
  std::vector<SmoothingCandidate> candidates;
  for (const int degree : {1, 3, 5})
    for (int n = (degree + 1) / 2; n <= max_n && static_cast<std::size_t>(4 * n) <= count; ++n) {
      const Scheme scheme = make_scheme(fmt::format("primal:n={},d={}", n, degree));
      const LinearSmoother smoother(scheme.mask, count, at_data, scheme.rules, samples.weights);
      try {
        candidates.push_back({n, degree, scheme.specification, estimate_risk(smoother, samples, noise)});
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

bool SchemeChoice::widest_tried() const {
  const SmoothingCandidate& best = candidates[chosen];
  return std::none_of(candidates.begin(), candidates.end(),
                      [&](const SmoothingCandidate& other) { return other.degree == best.degree && other.n > best.n; });
}

SchemeChoice choose_scheme(const Samples& samples, const SmoothingOptions& options) {
  if (samples.count() < 4)
    fail(ErrorKind::data, "expected at least 4 rows to choose a scheme; found {}", samples.count());
  const std::vector<NoiseEstimate> noise = estimate_noise(samples);
  for (const NoiseEstimate& one : noise)
    if (one.terms == 0) fail(ErrorKind::data, "expected three neighbouring data to estimate the noise; found none");
  std::vector<SmoothingCandidate> candidates = rank_schemes(samples, noise, options);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Scheme scheme = make_scheme(candidates[i].specification);
    if (options.derivative == 0 || proved_smoothness(scheme.mask).order >= options.derivative)
      return {std::move(scheme), std::move(candidates), i};
  }
  fail(ErrorKind::domain, "derivative {}: no scheme tried has limits proved to be so smooth", options.derivative);
}

}  // namespace subcert::data
