#include "method_choice.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert::data {
namespace {

/// Adds the candidate with its risk, where each of its windows has data for a fit.
void add_candidate(std::vector<SmoothingCandidate>& candidates, SmoothingCandidate candidate,
                   const LinearSmoother& smoother, const Samples& samples, const std::vector<NoiseEstimate>& noise) {
  try {
    candidate.risk = estimate_risk(smoother, samples, noise);
    candidates.push_back(std::move(candidate));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::data) throw;  // else a gap is too wide for its windows
  }
}

std::vector<SmoothingCandidate> ranked(std::vector<SmoothingCandidate> candidates) {
  if (candidates.empty()) fail(ErrorKind::data, "no candidate has enough data in every window; gaps are too wide");
  std::stable_sort(candidates.begin(), candidates.end(), [](const SmoothingCandidate& a, const SmoothingCandidate& b) {
    return a.risk.total() < b.risk.total();
  });
  return candidates;
}

SmoothingOptions at_data(const SmoothingOptions& options) { return {options.boundary, 0, 0, options.constant, true}; }

bool has_derivatives(const SmoothingMethod& method, int order) {
  if (const auto* scheme = std::get_if<Scheme>(&method))
    return order == 0 || proved_smoothness(scheme->mask).order >= order;
  return std::get<LocalPolynomial>(method).degree >= order;
}

}  // namespace

SmoothingMethod make_smoothing_method(std::string_view specification) {
  if (is_local_specification(specification)) return make_local_polynomial(specification);
  if (is_l1_specification(specification)) return make_l1_scheme(specification);
  return make_scheme(specification);
}

std::string to_text(const SmoothingMethod& method) {
  if (const auto* local = std::get_if<LocalPolynomial>(&method)) return to_text(*local);
  if (const auto* scheme = std::get_if<Scheme>(&method)) return scheme->specification;
  return std::get<DataDependentScheme>(method).specification;
}

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
  std::vector<SmoothingCandidate> candidates;
  for (const int degree : {1, 3, 5})
    for (int n = (degree + 1) / 2; n <= max_n && 4 * static_cast<std::size_t>(n) <= count; ++n) {
      const Scheme scheme = make_scheme(fmt::format("primal:n={},d={}", n, degree));
      const SchemeSmoother smoother(scheme.mask.curve(), samples.sites(), at_data(options), scheme.rules);
      add_candidate(candidates, {2 * static_cast<std::size_t>(n), degree, scheme.specification, {}}, smoother, samples,
                    noise);
    }
  return ranked(std::move(candidates));
}

std::vector<SmoothingCandidate> rank_windows(const LocalPolynomial& pattern, const Samples& samples,
                                             const std::vector<NoiseEstimate>& noise, const SmoothingOptions& options,
                                             std::size_t max_points) {
  const std::size_t count = samples.count();
  require(count >= 4, "rank_windows: need at least 4 data, got {}", count);
  const auto missing = std::count(samples.weights.begin(), samples.weights.end(), Rational(0));
  const std::size_t most = std::min(count - static_cast<std::size_t>(missing), max_points);
  std::vector<SmoothingCandidate> candidates;
  for (std::size_t points = static_cast<std::size_t>(pattern.degree) + 1; points <= most; points += 1 + points / 5) {
    LocalPolynomial method = pattern;
    method.points = points;
    const LocalSmoother smoother(method, samples.sites(), at_data(options));
    add_candidate(candidates, {points, method.degree, to_text(method), {}}, smoother, samples, noise);
  }
  return ranked(std::move(candidates));
}

bool MethodChoice::widest_tried() const {
  const SmoothingCandidate& best = candidates[chosen];
  return std::none_of(candidates.begin(), candidates.end(), [&](const SmoothingCandidate& other) {
    return other.degree == best.degree && other.points > best.points;
  });
}

MethodChoice choose_method(const Samples& samples, const SmoothingOptions& options,
                           const std::optional<LocalPolynomial>& pattern) {
  if (samples.count() < 4)
    fail(ErrorKind::data, "expected at least 4 rows to choose a scheme; found {}", samples.count());
  const std::vector<NoiseEstimate> noise = estimate_noise(samples);
  for (const NoiseEstimate& one : noise)
    if (!one.exists()) fail(ErrorKind::data, "expected three neighbouring data to estimate the noise; found none");
  std::vector<SmoothingCandidate> candidates = pattern || !samples.uniform()
                                                   ? rank_windows(pattern.value_or(LocalPolynomial{}), samples, noise,
                                                                  options)
                                                   : rank_schemes(samples, noise, options);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (SmoothingMethod method = make_smoothing_method(candidates[i].specification);
        has_derivatives(method, options.derivative))
      return {std::move(method), std::move(candidates), i};
  fail(ErrorKind::domain, "derivative {}: no candidate is proved to be so smooth", options.derivative);
}

}  // namespace subcert::data
