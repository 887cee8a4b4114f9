#include "method_choice.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include "robust_local.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

namespace subcert::data {
namespace {

constexpr std::size_t many_data = 20'000;
constexpr double least_rest = 1e-9;  // of 1 where a fit is taken to depend on more than its own datum

SmoothingOptions at_data(const SmoothingOptions& options) {
  SmoothingOptions there{options.boundary, 0, 0, options.constant, true, false};
  there.selection = options.selection;
  return there;
}

void require_data(const char* who, const Samples& samples) {
  require(samples.count() >= 4, "{}: need at least 4 data, got {}", who, samples.count());
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

void raise_biases(std::vector<SmoothingCandidate>& candidates) {
  double least = 0;
  for (const SmoothingCandidate& one : candidates) least = std::min(least, one.risk.bias_squared);
  for (SmoothingCandidate& one : candidates) one.risk.bias_squared -= least;
}

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
                           const std::vector<NoiseEstimate>& noise, Selection selection) {
  const std::vector<double> weights = samples.rounded_weights();
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
  require(std::isfinite(risk.total()), "smoothing: the squares of the data pass the range of doubles; scale them");
  return risk;
}

namespace {

/// Four standard deviations of the mean square of the noise of the data, by their weights.
double spread_of_noise(const Samples& samples, const std::vector<NoiseEstimate>& noise) {
  double count = 0, total = 0, variance = 0;
  for (const double weight :
       samples.weights.empty() ? std::vector<double>(samples.count(), 1) : samples.rounded_weights()) {
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

/// Data in groups of `size` neighbours, each its mean by the prior weights; the last ones, too few for a group, are
/// left out.
struct GroupedSamples {
  std::size_t size;
  Samples samples;
  std::vector<NoiseEstimate> noise;

  GroupedSamples(const Samples& all, std::vector<NoiseEstimate> of_data, std::size_t group)
      : size(group), noise(std::move(of_data)) {
    if (size == 1) {
      samples = all;
      return;
    }
    const std::size_t groups = all.count() / size;
    const std::vector<double> weights = all.rounded_weights();
    samples.columns.assign(all.columns.size(), std::vector<double>(groups));
    samples.spacing = all.spacing * Rational(size);
    if (weights.empty())
      for (NoiseEstimate& one : noise) one.variance /= static_cast<double>(size);
    for (std::size_t g = 0; g < groups; ++g) {
      const auto mean = [&](const std::vector<double>& values, double sum) {
        double total = 0;
        for (std::size_t i = g * size; i < (g + 1) * size; ++i)
          total += (weights.empty() ? 1 : weights[i]) * (values[i] - values[g * size]);
        return sum > 0 ? values[g * size] + total / sum : values[g * size];
      };
      double sum = weights.empty() ? static_cast<double>(size) : 0;
      if (!weights.empty()) {
        sum = std::accumulate(weights.begin() + static_cast<std::ptrdiff_t>(g * size),
                              weights.begin() + static_cast<std::ptrdiff_t>((g + 1) * size), 0.0);
        samples.weights.push_back(Rational(sum));
      }
      for (std::size_t c = 0; c < all.columns.size(); ++c) samples.columns[c][g] = mean(all.columns[c], sum);
      if (!all.uniform()) samples.positions.push_back(mean(all.positions, sum));
    }
  }
};

constexpr std::size_t fine_window = 32, coarse_window = 64;  // groups in a window

/// Ranks windows of one degree from the widest on, group size after group size.
class WindowRanking {
 public:
  WindowRanking(const LocalPolynomial& pattern, const SmoothingOptions& options, std::size_t least_points)
      : pattern_(pattern), options_(options), least_(least_points) {}

  bool done() const { return done_; }

  /// Adds the windows of these groups until the bound excludes them; `widest`: these are the largest groups.
  void add(const GroupedSamples& groups, bool widest, std::vector<SmoothingCandidate>& candidates, Bound& bound) {
    const std::vector<std::size_t> sizes = sizes_of(groups, widest);
    double offset = 0;
    for (std::size_t k = sizes.size(); k-- > 0 && !done_;) {
      const std::size_t points = sizes[k] * groups.size;
      LocalPolynomial method = pattern_, whole = pattern_;
      method.points = sizes[k];
      whole.points = points;
      std::vector<SmoothingCandidate> one;
      if (!add_candidate(one, {points, pattern_.degree, to_text(whole), {}}, [&] {
            return estimate_risk(LocalSmoother(method, groups.samples.sites(), at_data(options_)), groups.samples,
                                 groups.noise, options_.selection);
          }))
        continue;
      RiskEstimate& risk = one.front().risk;
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
    const std::size_t last = widest ? samples.count() - missing : coarse_window;
    const std::size_t first = groups.size == 1 ? std::max(static_cast<std::size_t>(pattern_.degree) + 1, least_)
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
  const std::size_t largest = largest_group(samples.count());
  for (std::size_t size = largest; size > 0; size /= 2) {
    if (std::ranges::all_of(rankings, &WindowRanking::done)) break;
    const GroupedSamples groups(samples, noise, size);
    bound.set_spread(spread_of_noise(groups.samples, groups.noise));
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

namespace {

/// The mean square of what the derivative leaves of the pilot's, by the weights.
double mean_square_apart(const std::vector<double>& derivative, const std::vector<double>& of_pilot,
                         const std::vector<double>& weights) {
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < derivative.size(); ++i) {
    const double weight = weights.empty() ? 1 : weights[i], apart = derivative[i] - of_pilot[i];
    if (weight == 0) continue;
    sum += weight * apart * apart;
    total += weight;
  }
  return sum / total;
}

std::vector<std::vector<double>> values_of(std::vector<SmoothedData> smoothed) {
  std::vector<std::vector<double>> values;
  for (SmoothedData& one : smoothed) values.push_back(std::move(one.values));
  return values;
}

std::vector<double> drawn_noise(const std::vector<double>& weights, std::size_t count) {
  std::mt19937_64 engine(2015);
  std::normal_distribution<double> gauss;
  std::vector<double> noise;
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = weights.empty() ? 1 : weights[i];
    noise.push_back(weight > 0 ? gauss(engine) / std::sqrt(weight) : 0);
  }
  return noise;
}

constexpr int above_derivative = 4;       // the degree of the pilot
constexpr std::size_t pilot_windows = 8;  // as wide at most

/// The derivatives of one group size against those of a pilot.
class DerivativeRisk {
 public:
  DerivativeRisk(const LocalPolynomial& pilot, const GroupedSamples& groups, const SmoothingOptions& options)
      : groups_(groups), options_(at_data(options)), weights_(groups.samples.rounded_weights()) {
    std::vector<std::vector<double>> columns = groups.samples.columns;
    columns.push_back(drawn_noise(weights_, groups.samples.count()));
    pilots_ = values_of(LocalSmoother(pilot, groups.samples.sites(), options_).apply_to(columns));
    options_.derivative = options.derivative;
    derivatives_ = values_of(LocalSmoother(pilot, groups.samples.sites(), options_).apply_to(columns));
  }

  RiskEstimate of(const LocalPolynomial& method) const {
    const std::vector<SmoothedData> made = LocalSmoother(method, groups_.samples.sites(), options_).apply_to(pilots_);
    const SmoothedData& on_noise = made.back();
    const double added = mean_square_apart(on_noise.values, derivatives_.back(), weights_);
    double variances = 0, total = 0;
    for (std::size_t i = 0; i < on_noise.variances.size(); ++i) {
      const double weight = weights_.empty() ? 1 : weights_[i];
      if (weight > 0) variances += weight * on_noise.variances[i];
      total += weight;
    }
    RiskEstimate risk;
    for (std::size_t c = 0; c + 1 < made.size(); ++c) {
      const double variance = groups_.noise[c].variance;
      const double apart = mean_square_apart(made[c].values, derivatives_[c], weights_);
      risk.bias_squared += std::max(0.0, apart - variance * added);
      risk.variance += variance * variances / total;
    }
    const double unit = std::pow(static_cast<double>(groups_.size), -2 * options_.derivative);
    return {risk.bias_squared * unit, risk.variance * unit};
  }

 private:
  const GroupedSamples& groups_;
  SmoothingOptions options_;
  std::vector<double> weights_;
  std::vector<std::vector<double>> pilots_, derivatives_;  // of the columns, then of drawn noise
};

}  // namespace

std::vector<SmoothingCandidate> rank_derivatives(const LocalPolynomial& pattern, const std::vector<int>& degrees,
                                                 const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                                 const SmoothingOptions& options) {
  require(options.derivative >= 1, "rank_derivatives: need derivative >= 1, got {}", options.derivative);
  const auto missing = std::ranges::count(samples.weights, Rational(0));
  const int present = static_cast<int>(std::min<std::ptrdiff_t>(std::ssize(samples.columns.front()) - missing, 1000));
  LocalPolynomial pilot{std::max(options.derivative, std::min(options.derivative + above_derivative, present - 3)),
                        pattern.weight};
  pilot.points = rank_windows(pilot, {pilot.degree}, samples, noise, options).front().points;
  std::size_t size = 1;
  while (pilot.points / (2 * size) >= fine_window) size *= 2;
  const GroupedSamples groups(samples, noise, size);
  const std::size_t widest = std::min(groups.samples.count(), pilot_windows * (pilot.points / size));
  pilot.points /= size;
  const DerivativeRisk risk(pilot, groups, options);
  std::vector<SmoothingCandidate> candidates;
  for (const int degree : degrees)
    for (std::size_t m = static_cast<std::size_t>(degree) + 1; m <= widest; m = next_points(m)) {
      LocalPolynomial method{degree, pattern.weight, m}, whole = pattern;
      whole.degree = degree;
      whole.points = m * size;
      add_candidate(candidates, {whole.points, degree, to_text(whole), {}}, [&] { return risk.of(method); });
    }
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
  pilot.points = std::min(pilot.points, samples.count());
  for (auto& column : cleaned.columns)
    column = robust_fit(pilot, samples.sites(), at_data(options), column, threads).pseudodata;
  return cleaned;
}

}  // namespace

MethodChoice choose_method(const Samples& samples, const SmoothingOptions& options,
                           const std::optional<LocalPolynomial>& pattern, int threads) {
  if (samples.count() < 4)
    fail(ErrorKind::data, "expected at least 4 rows to choose a scheme; found {}; name a scheme", samples.count());
  std::optional<Samples> cleaned;
  if (pattern && pattern->robust > 0) cleaned = without_outliers(samples, options, pseudodata_pilot, threads);
  const Samples& used = cleaned ? *cleaned : samples;
  const std::vector<NoiseEstimate> noise = estimate_noise(used);
  for (const NoiseEstimate& one : noise)
    if (!one.exists()) fail(ErrorKind::data, "expected three neighbouring data to estimate the noise; found none");
  std::vector<SmoothingCandidate> candidates = rank_all(used, noise, options, pattern);
  raise_biases(candidates);
  const double unit = std::pow(nearest_double(samples.spacing), -2 * options.derivative);
  for (SmoothingCandidate& one : candidates) one.risk = {one.risk.bias_squared * unit, one.risk.variance * unit};
  SmoothingMethod method = make_smoothing_method(candidates.front().specification);
  return {std::move(method), std::move(candidates), samples.count()};
}

}  // namespace subcert::data
