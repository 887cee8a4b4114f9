#include "method_choice.hpp"

#include "grouped_samples.hpp"
#include "hermite_samples.hpp"
#include "robust_local.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace subcert::data {
namespace {

constexpr std::size_t many_data = 20'000;
constexpr double least_spread = 1e-12;  // of the mean where a column is no constant
constexpr double least_rest = 1e-9;     // of 1 where a fit is taken to depend on more than its own datum

void require_data(const char* who, const Samples& samples) {
  require(samples.rows() >= 4, "{}: need at least 4 data, got {}", who, samples.rows());
}

}  // namespace

bool add_candidate(std::vector<SmoothingCandidate>& candidates, SmoothingCandidate candidate,
                   const std::function<RiskEstimate()>& risk) {
  try {
    candidate.risk = risk();
    candidates.push_back(std::move(candidate));
    return true;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::data) throw;  // else a gap is too wide for its windows
    return false;
  }
}

std::vector<SmoothingCandidate> ranked(std::vector<SmoothingCandidate> candidates) {
  if (candidates.empty())
    fail(ErrorKind::data,
         "no candidate has data at enough positions in every window; there are too few, or gaps are too wide; name a "
         "scheme");
  std::ranges::stable_sort(candidates, {},
                           [](const SmoothingCandidate& one) { return std::pair(one.risk.total(), one.points); });
  return candidates;
}

void raise_biases(std::vector<SmoothingCandidate>& candidates, double spread) {
  double least = std::numeric_limits<double>::infinity();
  for (const SmoothingCandidate& one : candidates) least = std::min(least, one.risk.bias_squared);
  if (least > spread) return;
  for (SmoothingCandidate& one : candidates) one.risk.bias_squared -= least;
}

namespace {

/// What a word of other programs is called here, or a misspelt `local`; empty for other words.
std::string_view local_meant(std::string_view family) {
  constexpr std::pair<std::string_view, std::string_view> names[] = {
      {"savgol", "local:points=21,d=2,weight=box"},
      {"savitzky-golay", "local:points=21,d=2,weight=box"},
      {"loess", "local:points=75,d=2 for three quarters of 100 data (family = \"symmetric\": and robust=3)"},
      {"lowess", "local:points=67,d=1,robust=3 for two thirds of 100 data"},
      {"robust", "local:d=1,robust=3"},
      {"local", "local:points=21,d=1"}};
  std::vector<std::string> words;
  for (const auto& [word, meant] : names) words.emplace_back(word);
  const std::string nearest = nearest_word(family, words);
  for (const auto& [word, meant] : names)
    if (word == nearest) return meant;
  return "";
}

}  // namespace

SmoothingMethod make_smoothing_method(std::string_view specification) {
  if (is_local_specification(specification)) return make_local_polynomial(specification);
  if (is_l1_specification(specification)) return make_l1_scheme(specification);
  try {
    return make_scheme(specification);
  } catch (const SpecificationError& error) {
    const std::string_view family = specification.substr(0, specification.find(':'));
    const std::string_view meant = local_meant(family);
    if (meant.empty() || error.token() != family) throw;
    throw SpecificationError(family, 1, fmt::format("a scheme, or local polynomials, as {}", meant));
  }
}

std::string to_text(const SmoothingMethod& method) {
  if (const auto* local = std::get_if<LocalPolynomial>(&method)) return to_text(*local);
  if (const auto* scheme = std::get_if<Scheme>(&method)) return scheme->specification;
  return std::get<DataDependentScheme>(method).specification;
}

RiskEstimate estimate_risk(const LinearSmoother& smoother, const Samples& samples,
                           const std::vector<NoiseEstimate>& noise, Selection selection, int order) {
  const std::vector<double> weights = weights_of_order(samples, order);
  RiskEstimate risk;
  const std::vector<SmoothedData> all = smoother.apply_to(samples.columns);
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    const std::vector<double>& column = samples.columns[c];
    const SmoothedData& smoothed = all[c];
    double residuals = 0, trace = 0, variances = 0, total_weight = 0, predictions = 0;
    std::size_t present = 0;
    for (std::size_t i = 0; i < column.size(); ++i) {
      const double w = weights.empty() ? 1 : weights[i];
      if (w <= 0) continue;
      const double r = column[i] - smoothed.values[i], rest = 1 - smoothed.leverages[i];
      residuals += w * r * r;
      if (selection == Selection::cross_validation && !(rest > least_rest))
        fail(ErrorKind::data, "smoothing: the fit at a datum hangs on it alone");
      predictions += w * (r / rest) * (r / rest);
      trace += smoothed.leverages[i];
      variances += w * smoothed.variances[i];
      total_weight += w;
      ++present;
    }
    const double variance = noise[c].variance * variances / total_weight;
    // E sum w r^2 = sum w bias^2 + sigma^2 (count - 2 trace + sum w variance).
    const double expected_noise = noise[c].variance * (static_cast<double>(present) - 2 * trace + variances);
    if (selection == Selection::risk)
      risk.bias_squared += (residuals - expected_noise) / total_weight;
    else
      risk.bias_squared += (predictions - noise[c].variance * static_cast<double>(present)) / total_weight - variance;
    risk.variance += variance;
  }
  if (!std::isfinite(risk.total()))
    fail(ErrorKind::data, "smoothing: the squares of the data pass the range of doubles; scale them");
  return risk;
}

namespace {

/// Four standard deviations of the mean square of the noise of the data, by their weights.
double spread_of_noise(const Samples& samples, const std::vector<NoiseEstimate>& noise, int order = 0) {
  double count = 0, total = 0, variance = 0;
  for (const double weight :
       samples.weights.empty() ? std::vector<double>(samples.count(), 1) : weights_of_order(samples, order)) {
    count += weight > 0 ? 1 : 0;
    total += weight;
  }
  for (const NoiseEstimate& one : noise) variance += one.variance;
  return 4 * variance * std::sqrt(2 * count) / total;
}

/// What no candidate with a larger variance can be better than.
class Bound {
 public:
  explicit Bound(double spread) : spread_(spread) {}
  /// Whether the candidate, and so all with a larger variance, is worse than one before.
  bool excludes(const RiskEstimate& risk) {
    smallest_ = std::min(smallest_, risk.variance + std::max(0.0, risk.bias_squared) + spread_);
    return risk.variance > smallest_;
  }
  void set_spread(double spread) { spread_ = spread; }

 private:
  double spread_;
  double smallest_ = std::numeric_limits<double>::infinity();
};

/// Adds schemes with n = max_n and fewer, until the bound excludes them.
void add_schemes(std::vector<SmoothingCandidate>& candidates, const Samples& samples,
                 const std::vector<NoiseEstimate>& noise, const SmoothingOptions& options, int max_n, Bound* bound) {
  const bool many = bound && samples.count() > many_data;
  for (const int degree : {1, 3, 5})
    for (int n = max_n; n >= (degree + 1) / 2; n -= many ? 1 + n / 7 : 1) {
      if (4 * static_cast<std::size_t>(n) > samples.count()) continue;
      const Scheme scheme = make_scheme(fmt::format("primal:n={},d={}", n, degree));
      const bool added = add_candidate(
          candidates, {2 * static_cast<std::size_t>(n), degree, scheme.specification, {}}, [&] {
            return estimate_risk(SchemeSmoother(scheme.mask.curve(), samples.sites(), at_data(options), scheme.rules),
                                 samples, noise, options.selection);
          });
      if (added && bound && bound->excludes(candidates.back().risk)) break;
    }
}

}  // namespace

std::vector<SmoothingCandidate> rank_schemes(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                             const SmoothingOptions& options, int max_n) {
  require_data("rank_schemes", samples);
  std::vector<SmoothingCandidate> candidates;
  add_schemes(candidates, samples, noise, options, max_n, nullptr);
  return ranked(std::move(candidates));
}

namespace {

/// Of the data at which errors are looked at.
int judged_order(const Samples& samples, const SmoothingOptions& options) {
  return samples.derivatives > 0 ? options.derivative : 0;
}

/// Ranks windows of one degree from the widest on, group size after group size.
class WindowRanking {
 public:
  WindowRanking(const LocalPolynomial& pattern, const SmoothingOptions& options, std::size_t least_points)
      : pattern_(pattern), options_(options), least_(least_points) {}

  bool done() const { return done_; }

  /// Adds the windows of these groups until the bound excludes them; `widest`: these are the largest groups.
  void add(const GroupedSamples& groups, bool widest, std::vector<SmoothingCandidate>& candidates, Bound& bound) {
    const std::vector<std::size_t> sizes = sizes_of(groups, widest);
    const int order = judged_order(groups.samples, options_);
    double offset = 0;
    for (std::size_t k = sizes.size(); k-- > 0 && !done_;) {
      const std::size_t points = sizes[k] * groups.size;
      LocalPolynomial method = pattern_, whole = pattern_;
      method.points = sizes[k];
      whole.points = points;
      std::vector<SmoothingCandidate> one;
      if (!add_candidate(one, {points, pattern_.degree, to_text(whole), {}}, [&] {
            return estimate_risk(LocalSmoother(method, groups.samples.sites(), at_data(options_)), groups.samples,
                                 groups.noise, options_.selection, order);
          }))
        continue;
      RiskEstimate& risk = one.front().risk;
      const double unit = std::pow(static_cast<double>(groups.size), -2 * order);
      risk = {risk.bias_squared * unit, risk.variance * unit};
      if (last_points_ == points) {
        // Both group sizes have this window: their estimates differ by the noise of the noise. Where the bias is large,
        // by the coarseness of the larger groups, and neither matters.
        if (last_.bias_squared < 10 * last_.variance) offset = last_.total() - risk.total();
        continue;
      }
      risk.bias_squared += offset;
      last_points_ = points;
      last_ = risk;
      done_ = bound.excludes(risk);
      candidates.push_back(std::move(one.front()));
    }
  }

 private:
  std::vector<std::size_t> sizes_of(const GroupedSamples& groups, bool widest) const {
    const Samples& samples = groups.samples;
    const auto missing = static_cast<std::size_t>(std::ranges::count(samples.weights, Rational(0)));
    const std::size_t kinds = samples.count() / samples.rows();
    const std::size_t last = widest ? (samples.count() - missing) / kinds : coarse_window;
    const std::size_t first = groups.size == 1
                                  ? std::max((static_cast<std::size_t>(pattern_.degree) + kinds) / kinds, least_)
                                  : fine_window;
    std::vector<std::size_t> sizes;
    for (std::size_t m = first; m < last; m = next_points(m)) sizes.push_back(m);
    if (last >= first) sizes.push_back(last);
    return sizes;
  }

  LocalPolynomial pattern_;
  SmoothingOptions options_;
  std::size_t least_;
  bool done_ = false;
  std::size_t last_points_ = 0;
  RiskEstimate last_;
};

std::size_t largest_group(std::size_t count) {
  std::size_t size = 1;
  while (count / (2 * size) >= coarse_window) size *= 2;
  return size;
}

/// Adds windows of these degrees.
void add_windows(std::vector<SmoothingCandidate>& candidates, const LocalPolynomial& pattern,
                 const std::vector<int>& degrees, const Samples& samples, const std::vector<NoiseEstimate>& noise,
                 const SmoothingOptions& options, std::size_t least_points, Bound& bound) {
  std::vector<WindowRanking> rankings;
  for (const int degree : degrees) {
    LocalPolynomial one = pattern;
    one.degree = degree;
    rankings.emplace_back(one, options, least_points);
  }
  const std::size_t largest = largest_group(samples.rows());
  for (std::size_t size = largest; size > 0; size /= 2) {
    if (std::ranges::all_of(rankings, &WindowRanking::done)) break;
    const GroupedSamples groups(samples, noise, size);
    const int order = judged_order(samples, options);
    bound.set_spread(spread_of_noise(groups.samples, groups.noise, order) *
                     std::pow(static_cast<double>(size), -2 * order));
    for (WindowRanking& ranking : rankings)
      if (!ranking.done()) ranking.add(groups, size == largest, candidates, bound);
  }
}

}  // namespace

std::vector<SmoothingCandidate> rank_windows(const LocalPolynomial& pattern, const std::vector<int>& degrees,
                                             const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                             const SmoothingOptions& options) {
  require_data("rank_windows", samples);
  std::vector<SmoothingCandidate> candidates;
  Bound bound(0);
  add_windows(candidates, pattern, degrees, samples, noise, options, 1, bound);
  return ranked(std::move(candidates));
}

bool MethodChoice::widest_tried() const {
  const SmoothingCandidate& best = candidates.front();
  return best.points < data && std::ranges::none_of(candidates, [&](const SmoothingCandidate& other) {
           return other.degree == best.degree && other.points > best.points;
         });
}

namespace {

constexpr int last_chosen_derivative = 16;
constexpr int longest_scheme = 20;  // n
constexpr LocalPolynomial pseudodata_pilot{1, LocalWeight::tricube, 31, 0, 3};

std::vector<SmoothingCandidate> rank_all(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                         const SmoothingOptions& options,
                                         const std::optional<LocalPolynomial>& pattern) {
  const LocalPolynomial like = pattern.value_or(LocalPolynomial{});
  if (samples.derivatives > 0) {
    require(options.derivative <= samples.derivatives,
            "derivative {}: of values with slopes windows are chosen for these; name points or a width",
            options.derivative);
    return rank_windows(like, pattern ? std::vector{like.degree} : std::vector{1, 3, 5}, samples, noise, options);
  }
  if (const int derivative = options.derivative; derivative > 0) {
    require(derivative <= last_chosen_derivative, "derivative {}: windows are chosen up to {}", derivative,
            last_chosen_derivative);
    std::vector<int> degrees{derivative + 1, derivative + 3};
    if (pattern) degrees = {like.degree};
    return rank_derivatives(like, degrees, samples, noise, options);
  }
  if (pattern) return rank_windows(like, {like.degree}, samples, noise, options);
  if (!samples.uniform()) return rank_windows(like, {1, 3}, samples, noise, options);
  std::vector<SmoothingCandidate> candidates;
  Bound bound(0);
  if (samples.count() > 2 * longest_scheme)
    add_windows(candidates, like, {1, 3, 5}, samples, noise, options, 2 * longest_scheme + 1, bound);
  bound.set_spread(spread_of_noise(samples, noise));
  add_schemes(candidates, samples, noise, options, longest_scheme, &bound);
  return ranked(std::move(candidates));
}

Samples without_outliers(const Samples& samples, const SmoothingOptions& options, LocalPolynomial pilot, int threads) {
  Samples cleaned = samples;
  pilot.points = std::min(pilot.points, samples.rows());
  for (auto& column : cleaned.columns)
    column = robust_fit(pilot, samples.sites(), at_data(options), column, threads).pseudodata;
  return cleaned;
}

/// Each column, and its noise, divided by the standard deviation of the data about their mean, so that no column
/// outweighs others by its units.
Samples in_units_of_spread(Samples samples, std::vector<NoiseEstimate>& noise) {
  const std::vector<double> weights = weights_of_order(samples, 0);
  const PositionGroup all{0, samples.count()};
  const double sum = weights.empty() ? static_cast<double>(samples.count())
                                     : std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    std::vector<double>& column = samples.columns[c];
    const double mean = mean_of(column, weights, all, sum);
    const double spread = std::sqrt(mean_square_apart(column, std::vector<double>(column.size(), mean), weights));
    if (!(spread > least_spread * std::abs(mean))) continue;
    for (double& value : column) value /= spread;
    noise[c].variance /= spread * spread;
  }
  return samples;
}

}  // namespace

void require_squares(const Samples& samples) {
  constexpr double least = 1e-140, most = 1e150;
  for (const auto& column : samples.columns) {
    double largest = 0;
    for (const double value : column) largest = std::max(largest, std::abs(value));
    if (largest > most || (largest > 0 && largest < least))
      fail(ErrorKind::data,
           "expected numbers whose squares are within double precision; the largest modulus is {:g} (take other units)",
           largest);
  }
}

MethodChoice choose_method(const Samples& samples, const SmoothingOptions& options,
                           const std::optional<LocalPolynomial>& pattern, int threads) {
  require_squares(samples);
  if (samples.rows() < 4)
    fail(ErrorKind::data, "expected at least 4 rows to choose a scheme; found {}; name a scheme", samples.rows());
  std::optional<Samples> cleaned;
  if (pattern && pattern->robust > 0) cleaned = without_outliers(samples, options, pseudodata_pilot, threads);
  const Samples& given = cleaned ? *cleaned : samples;
  std::vector<NoiseEstimate> noise = estimate_noise(given);
  for (const NoiseEstimate& one : noise)
    if (!one.exists()) fail(ErrorKind::data, "expected three neighbouring data to estimate the noise; found none");
  std::optional<Samples> comparable;
  if (given.columns.size() > 1) comparable = in_units_of_spread(given, noise);
  std::vector<SmoothingCandidate> candidates = rank_all(comparable ? *comparable : given, noise, options, pattern);
  if (options.derivative <= samples.derivatives)
    raise_biases(candidates, spread_of_noise(comparable ? *comparable : given, noise, options.derivative));
  const double unit = std::pow(nearest_double(samples.spacing), -2 * options.derivative);
  for (SmoothingCandidate& one : candidates) {
    one.risk = {one.risk.bias_squared * unit, one.risk.variance * unit};
    if (one.range) one.range = {one.range->first * unit, one.range->second * unit};
  }
  SmoothingMethod method = make_smoothing_method(candidates.front().specification);
  return {std::move(method), std::move(candidates), samples.rows()};
}

}  // namespace subcert::data
