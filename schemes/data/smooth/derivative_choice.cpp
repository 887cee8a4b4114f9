#include "grouped_samples.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace subcert::data {
namespace {

constexpr int degrees_of_pilots = 3;      // the odd ones above the derivative
constexpr std::size_t pilot_windows = 8;  // as wide at most
constexpr std::size_t most_pilots = 16;
constexpr double temperature = 4, least_weight = 0.01;
constexpr double beyond_pilots = 1.4142135623730951;  // of the range of what they tell
constexpr std::size_t drawn_data = 4096, most_draws = 8;

/// A fit that stands for the function, and how likely.
struct Pilot {
  LocalPolynomial method;
  double weight;
};

/// Windows by their estimated errors R of the value: exp(-W (R - least R) / (4 sigma^2)), W the sum of the
/// weights of the data.
std::vector<Pilot> make_pilots(const LocalPolynomial& pattern, const Samples& samples,
                               const std::vector<NoiseEstimate>& noise, const SmoothingOptions& options) {
  const auto missing = std::ranges::count(samples.weights, Rational(0));
  const int present = static_cast<int>(std::min<std::ptrdiff_t>(std::ssize(samples.columns.front()) - missing, 1000));
  std::set<int> degrees;
  for (int k = 0, odd = (options.derivative + 1) / 2 * 2 + 1; k < degrees_of_pilots; ++k, odd += 2)
    degrees.insert(std::max(options.derivative, std::min(odd, present - 3)));
  const std::vector<SmoothingCandidate> candidates = rank_windows(
      {options.derivative, pattern.weight}, {degrees.begin(), degrees.end()}, samples, noise, options);
  double variance = 0, weights = 0;
  for (const NoiseEstimate& one : noise) variance += one.variance;
  for (std::size_t i = 0; i < samples.count(); ++i)
    weights += samples.weights.empty() ? 1 : static_cast<double>(samples.weights[i]);
  std::vector<Pilot> pilots;
  for (const SmoothingCandidate& one : candidates) {
    const double worse = (one.risk.total() - candidates.front().risk.total()) * weights;
    const double weight = worse > 0 ? std::exp(-worse / (temperature * variance)) : 1;
    if (pilots.size() == most_pilots || !(weight >= least_weight)) break;
    pilots.push_back({{one.degree, pattern.weight, one.points}, weight});
  }
  return pilots;
}

std::vector<std::vector<double>> values_of(std::vector<SmoothedData> smoothed) {
  std::vector<std::vector<double>> values;
  for (SmoothedData& one : smoothed) values.push_back(std::move(one.values));
  return values;
}

std::vector<double> drawn_noise(const std::vector<double>& weights, std::size_t count, std::mt19937_64& engine) {
  std::normal_distribution<double> gauss;
  std::vector<double> noise;
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = weights.empty() ? 1 : weights[i];
    noise.push_back(weight > 0 ? gauss(engine) / std::sqrt(weight) : 0);
  }
  return noise;
}

/// The derivatives of one group size against those of pilots.
class DerivativeRisk {
 public:
  DerivativeRisk(const std::vector<Pilot>& pilots, const GroupedSamples& groups, const SmoothingOptions& options)
      : groups_(groups), options_(at_data(options)), weights_(groups.samples.rounded_weights()) {
    std::vector<std::vector<double>> columns = groups.samples.columns;
    const std::size_t count = groups.samples.count();
    std::mt19937_64 engine(2015);
    for (std::size_t draw = 0; draw < std::clamp<std::size_t>(drawn_data / count, 1, most_draws); ++draw)
      columns.push_back(drawn_noise(weights_, count, engine));
    columns_ = columns.size();
    SmoothingOptions derived = options_;
    derived.derivative = options.derivative;
    for (const Pilot& pilot : pilots) {
      LocalPolynomial method = pilot.method;
      method.points = std::max(method.points / groups.size, static_cast<std::size_t>(method.degree) + 2);
      method.points = std::min(method.points, count);
      append(pilots_, LocalSmoother(method, groups.samples.sites(), options_), columns);
      append(derivatives_, LocalSmoother(method, groups.samples.sites(), derived), columns);
      weight_.push_back(pilot.weight);
    }
    options_ = derived;
  }

  /// Sets risk and range of the candidate to those of the method.
  void estimate(SmoothingCandidate& candidate, const LocalPolynomial& method) const {
    const std::vector<SmoothedData> made = LocalSmoother(method, groups_.samples.sites(), options_).apply_to(pilots_);
    const double unit = std::pow(static_cast<double>(groups_.size), -2 * options_.derivative);
    double variance = 0;
    for (const NoiseEstimate& one : groups_.noise) variance += one.variance;
    variance *= mean_variance(made.front());
    double logarithms = 0, weights = 0, least = std::numeric_limits<double>::infinity(), most = 0;
    for (std::size_t p = 0; p < weight_.size(); ++p) {
      const double total = variance + bias_squared(made, p);
      logarithms += weight_[p] * std::log(total);
      weights += weight_[p];
      least = std::min(least, total);
      most = std::max(most, total);
    }
    const double total = std::exp(logarithms / weights);
    candidate.risk = {std::max(0.0, total - variance) * unit, variance * unit};
    candidate.range = {least * unit / beyond_pilots, most * unit * beyond_pilots};
  }

 private:
  static void append(std::vector<std::vector<double>>& all, const LocalSmoother& smoother,
                     const std::vector<std::vector<double>>& columns) {
    std::ranges::move(values_of(smoother.apply_to(columns)), std::back_inserter(all));
  }

  double mean_variance(const SmoothedData& made) const {
    double sum = 0, total = 0;
    for (std::size_t i = 0; i < made.variances.size(); ++i) {
      const double weight = weights_.empty() ? 1 : weights_[i];
      if (weight > 0) sum += weight * made.variances[i];
      total += weight;
    }
    return sum / total;
  }

  /// By the pilot p, less what its noise adds.
  double bias_squared(const std::vector<SmoothedData>& made, std::size_t p) const {
    const auto apart = [&](std::size_t column) {
      const std::size_t at = p * columns_ + column;
      return mean_square_apart(made[at].values, derivatives_[at], weights_);
    };
    const std::size_t given = groups_.samples.columns.size();
    double added = 0, bias = 0;
    for (std::size_t c = given; c < columns_; ++c) added += apart(c) / static_cast<double>(columns_ - given);
    for (std::size_t c = 0; c < given; ++c) bias += std::max(0.0, apart(c) - groups_.noise[c].variance * added);
    return bias;
  }

  const GroupedSamples& groups_;
  SmoothingOptions options_;
  std::vector<double> weights_;
  std::size_t columns_;                                    // of the samples, then of drawn noise
  std::vector<std::vector<double>> pilots_, derivatives_;  // of the columns of each pilot
  std::vector<double> weight_;                             // of pilots
};

}  // namespace

std::vector<SmoothingCandidate> rank_derivatives(const LocalPolynomial& pattern, const std::vector<int>& degrees,
                                                 const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                                 const SmoothingOptions& options) {
  require(options.derivative >= 1, "rank_derivatives: need derivative >= 1, got {}", options.derivative);
  const std::vector<Pilot> pilots = make_pilots(pattern, samples, noise, options);
  std::size_t size = 1, widest = 0;
  while (pilots.front().method.points / (2 * size) >= fine_window) size *= 2;
  const GroupedSamples groups(samples, noise, size);
  for (const Pilot& pilot : pilots) widest = std::max(widest, pilot_windows * (pilot.method.points / size));
  widest = std::min(widest, groups.samples.count());
  const DerivativeRisk risk(pilots, groups, options);
  std::vector<SmoothingCandidate> candidates;
  for (const int degree : degrees)
    for (std::size_t m = static_cast<std::size_t>(degree) + 1; m <= widest; m = next_points(m)) {
      LocalPolynomial method{degree, pattern.weight, m}, whole = pattern;
      whole.degree = degree;
      whole.points = m * size;
      SmoothingCandidate candidate{whole.points, degree, to_text(whole), {}};
      if (add_candidate(candidates, candidate, [&] {
            risk.estimate(candidate, method);
            return candidate.risk;
          }))
        candidates.back().range = candidate.range;
    }
  return ranked(std::move(candidates));
}

}  // namespace subcert::data
