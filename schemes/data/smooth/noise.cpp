#include "noise.hpp"

#include "hermite_samples.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace subcert::data {
namespace {

double at_or_one(const std::vector<double>& values, std::size_t i) { return values.empty() ? 1 : values[i]; }

/// A datum less the chord of its neighbours, normed to the variance of a datum of weight 1.
struct SecondDifference {
  std::size_t middle;
  std::array<double, 3> coefficients;  // before norming
  double scale;

  /// For three neighbouring data, of coefficients 1/2, -1, 1/2 where they are uniform.
  SecondDifference(std::size_t at, const std::vector<double>& weights, const std::vector<double>& positions)
      : middle(at), coefficients{0.5, -1, 0.5}, scale(1) {
    if (!positions.empty() && positions[at - 1] < positions[at + 1]) {
      coefficients[0] = (positions[at + 1] - positions[at]) / (positions[at + 1] - positions[at - 1]);
      coefficients[2] = 1 - coefficients[0];
    }
    double variance = 0;
    for (std::size_t k = 0; k < 3; ++k) variance += coefficients[k] * coefficients[k] / at_or_one(weights, at - 1 + k);
    scale = 1 / std::sqrt(variance);
  }

  double of(const std::vector<double>& data) const {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += coefficients[k] * data[middle - 1 + k];
    return sum * scale;
  }
};

/// Data at different positions: of several at one their weighted mean, with the sum of their weights; and what these
/// spread about their means, which has as many degrees of freedom. In whatever order they came.
struct DifferentPositions {
  std::vector<double> data, weights, positions;
  double spread = 0;
  std::size_t degrees = 0;

  DifferentPositions(const std::vector<double>& all, const std::vector<double>& prior_weights,
                     const std::vector<double>& places) {
    for (const PositionGroup& group : groups_of_positions(places)) {
      double weight = 0;
      std::size_t present = 0;
      for (std::size_t k = group.first; k < group.end; ++k) {
        weight += at_or_one(prior_weights, k);
        present += at_or_one(prior_weights, k) > 0 ? 1 : 0;
      }
      const double mean = mean_of(all, prior_weights, group, weight);
      for (std::size_t k = group.first; k < group.end && present > 1; ++k)
        if (const double own = at_or_one(prior_weights, k); own > 0) spread += own * (all[k] - mean) * (all[k] - mean);
      degrees += present > 1 ? present - 1 : 0;
      data.push_back(mean), weights.push_back(weight), positions.push_back(places[group.first]);
    }
  }
};

bool has_ties(const std::vector<double>& positions) { return std::ranges::adjacent_find(positions) != positions.end(); }

/// The covariance of two second differences for noise of variance 1 / weight.
double covariance(const SecondDifference& a, const SecondDifference& b, const std::vector<double>& weights) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = a.middle - 1 + k;
    if (i + 1 < b.middle || i > b.middle + 1) continue;
    sum += a.coefficients[k] * b.coefficients[i + 1 - b.middle] / at_or_one(weights, i);
  }
  return sum * a.scale * b.scale;
}

}  // namespace

NoiseEstimate known_noise(double deviation) {
  require(is_noise(deviation), "known_noise: need 1e-150 <= deviation <= 1e150, got {}", deviation);
  return {deviation * deviation, std::numeric_limits<double>::infinity(), 0};
}

NoiseEstimate estimate_noise(const std::vector<double>& data, const std::vector<double>& prior_weights,
                             const std::vector<double>& positions) {
  for (const auto* other : {&prior_weights, &positions})
    require(other->empty() || other->size() == data.size(),
            "estimate_noise: need as many weights and positions as data, got {} for {}", other->size(), data.size());
  if (has_ties(positions)) {
    // Means are independent of what the data spread about them.
    const DifferentPositions means(data, prior_weights, positions);
    const NoiseEstimate between = estimate_noise(means.data, means.weights, means.positions);
    const auto m = static_cast<double>(between.terms), within = static_cast<double>(means.degrees);
    if (m + within == 0) return {};
    const double squares = between.exists() ? m * m / between.degrees_of_freedom : 0;
    return {(m * between.variance + means.spread) / (m + within), (m + within) * (m + within) / (squares + within),
            between.terms + means.degrees, means.degrees};
  }
  std::vector<SecondDifference> terms;
  double sum = 0;
  const auto is_present = [&](std::size_t i) { return at_or_one(prior_weights, i) > 0; };
  for (std::size_t i = 1; i + 1 < data.size(); ++i) {
    if (!is_present(i - 1) || !is_present(i) || !is_present(i + 1)) continue;
    const double residual = terms.emplace_back(i, prior_weights, positions).of(data);
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
  if (samples.noise) return std::vector<NoiseEstimate>(samples.columns.size(), known_noise(*samples.noise));
  std::vector<NoiseEstimate> noise;
  const std::vector<double> weights = samples.rounded_weights();
  for (const auto& column : samples.columns)
    for (int order = 0; order <= samples.derivatives; ++order) {
      const NoiseEstimate one = estimate_noise(data_of_order(samples, column, order),
                                               data_of_order(samples, weights, order), samples.positions);
      if (order == 0) {
        noise.push_back(one);
        continue;
      }
      NoiseEstimate& all = noise.back();
      all = {std::max(all.variance, one.variance), std::min(all.degrees_of_freedom, one.degrees_of_freedom),
             all.terms + one.terms, all.ties + one.ties};
    }
  return noise;
}

namespace {

constexpr double far = 6, raised = 1.5;
constexpr double answer = -0.25;  // of a neighbour's difference to an outlier, -1/2 where data are uniform
constexpr std::size_t longest_run = 5;

/// A datum less the line through two others, normed to the variance of a datum of weight 1.
double beside_chord(const std::vector<double>& data, const std::vector<double>& weights,
                    const std::vector<double>& positions, std::size_t first, std::size_t second, std::size_t at) {
  const auto place = [&](std::size_t i) { return positions.empty() ? static_cast<double>(i) : positions[i]; };
  const double t = (place(at) - place(first)) / (place(second) - place(first));
  const double variance = 1 / at_or_one(weights, at) + (1 - t) * (1 - t) / at_or_one(weights, first) +
                          t * t / at_or_one(weights, second);
  return (data[at] - (1 - t) * data[first] - t * data[second]) / std::sqrt(variance);
}

/// Whether the data from `first` to `last` stand out together, on one side and about as far, from a line through two
/// data on either side that rises by less.
bool stand_out_together(const std::vector<double>& data, const std::vector<double>& weights,
                        const std::vector<double>& positions, std::size_t first, std::size_t last, double deviation) {
  const auto off = [&](std::size_t i) {
    return beside_chord(data, weights, positions, first - 1, last + 1, i) / deviation;
  };
  constexpr double on_line = 3, alike = 0.5;
  if (std::abs(off(first - 2)) > on_line || std::abs(off(last + 2)) > on_line) return false;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  const double side = off(first) < 0 ? -1 : 1;
  for (std::size_t i = first; i <= last; ++i) {
    least = std::min(least, side * off(i));
    most = std::max(most, side * off(i));
  }
  return least > far && least > alike * most && std::abs(data[last + 1] - data[first - 1]) < least * deviation;
}

/// Marks runs of outliers side by side, unless they are more than a fifth of the data.
void mark_runs(const std::vector<double>& data, const std::vector<double>& weights,
               const std::vector<double>& positions, double deviation, std::vector<bool>& marked) {
  std::vector<bool> in_runs(data.size(), false);
  std::size_t next = 2;  // no run is told by data of the one before
  for (std::size_t end = 4; end + 2 <= data.size(); ++end)
    for (std::size_t length = 2; length <= longest_run && next + length <= end; ++length) {
      const std::size_t first = end - length;
      bool present = true;
      for (std::size_t i = first - 2; i < end + 2; ++i) present = present && at_or_one(weights, i) > 0;
      if (!present || !stand_out_together(data, weights, positions, first, end - 1, deviation)) continue;
      std::fill(in_runs.begin() + static_cast<std::ptrdiff_t>(first),
                in_runs.begin() + static_cast<std::ptrdiff_t>(end), true);
      next = end + 2;
      break;
    }
  if (5 * std::ranges::count(in_runs, true) > std::ssize(data)) return;
  for (std::size_t i = 0; i < data.size(); ++i) marked[i] = marked[i] || in_runs[i];
}

/// At the middle of three neighbouring data, NaN elsewhere.
std::vector<double> second_differences(const std::vector<double>& data, const std::vector<double>& prior_weights,
                                       const std::vector<double>& positions) {
  const auto is_present = [&](std::size_t i) { return at_or_one(prior_weights, i) > 0; };
  std::vector<double> differences(data.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 1; i + 1 < data.size(); ++i)
    if (is_present(i - 1) && is_present(i) && is_present(i + 1))
      differences[i] = SecondDifference(i, prior_weights, positions).of(data);
  return differences;
}

double bulk_of(const std::vector<double>& differences) {
  std::vector<double> moduli;
  for (const double difference : differences)
    if (!std::isnan(difference)) moduli.push_back(std::abs(difference));
  if (moduli.empty()) return 0;
  const auto middle = moduli.begin() + static_cast<std::ptrdiff_t>(moduli.size() / 2);
  std::nth_element(moduli.begin(), middle, moduli.end());
  return *middle / normal_quartile;
}

}  // namespace

double bulk_deviation(const std::vector<double>& data, const std::vector<double>& prior_weights,
                      const std::vector<double>& positions) {
  if (has_ties(positions)) {
    const DifferentPositions means(data, prior_weights, positions);
    return bulk_deviation(means.data, means.weights, means.positions);
  }
  return bulk_of(second_differences(data, prior_weights, positions));
}

std::size_t count_outliers(const std::vector<double>& data, const std::vector<double>& prior_weights,
                           const std::vector<double>& positions) {
  if (has_ties(positions)) {
    const DifferentPositions means(data, prior_weights, positions);
    return count_outliers(means.data, means.weights, means.positions);
  }
  const std::vector<double> differences = second_differences(data, prior_weights, positions);
  const double deviation = bulk_of(differences);
  double all = 0, bulk = 0;
  std::vector<bool> outliers(data.size(), false);
  for (std::size_t i = 1; i + 1 < data.size(); ++i) {
    const double e = differences[i], before = differences[i - 1] / e, after = differences[i + 1] / e;
    if (std::isnan(e)) continue;
    all += e * e;
    if (std::abs(e) <= far * deviation)
      bulk += e * e;
    else if (!(before > answer) && !(after > answer) && (before <= answer || after <= answer))
      outliers[i] = true;
  }
  if (!(deviation > 0 && all > raised * bulk)) return 0;
  mark_runs(data, prior_weights, positions, deviation, outliers);
  return static_cast<std::size_t>(std::ranges::count(outliers, true));
}

std::optional<double> correlated_differences(const std::vector<double>& data, const std::vector<double>& prior_weights,
                                             const std::vector<double>& positions) {
  if (has_ties(positions)) {
    const DifferentPositions means(data, prior_weights, positions);
    return correlated_differences(means.data, means.weights, means.positions);
  }
  // Of noise in the order of the data; Bartlett's variance of the lag-1 correlation of second differences.
  constexpr double variance = 0.30247, beyond = 4;
  constexpr std::size_t fewest = 30;
  const auto is_present = [&](std::size_t i) { return at_or_one(prior_weights, i) > 0; };
  double products = 0, squares = 0, expected = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 1; i + 1 < data.size(); ++i) {
    if (!is_present(i - 1) || !is_present(i) || !is_present(i + 1)) continue;
    const SecondDifference here(i, prior_weights, positions);
    const double value = here.of(data);
    squares += value * value;
    if (i == 1 || !is_present(i - 2)) continue;
    const SecondDifference before(i - 1, prior_weights, positions);
    products += before.of(data) * value;
    expected += covariance(before, here, prior_weights);
    ++pairs;
  }
  if (pairs < fewest || !(squares > 0)) return std::nullopt;
  const auto m = static_cast<double>(pairs);
  const double correlation = products / squares;
  const bool is_beyond = correlation - expected / m > beyond * std::sqrt(variance / m) && correlation < 0;
  return is_beyond ? std::optional(correlation) : std::nullopt;
}

std::string remark_on_correlations(const std::vector<std::pair<std::string, double>>& found) {
  std::string names, which = "these correlations";
  if (found.size() == 1) {
    names = found.front().first;
    which = fmt::format("the correlation {:.3g}", found.front().second);
  } else {
    for (const auto& [name, correlation] : found)
      names += fmt::format("{}{} ({:.3g})", names.empty() ? "" : ", ", name, correlation);
  }
  return fmt::format(
      "{}: neighbouring second differences have {}, beyond that of independent noise, about -2/3: the noise is "
      "correlated from datum to datum, and bands are too narrow, or the mean bends within few data; "
      "docs/smoothing.md, section 3",
      names, which);
}

namespace {

void require_band(double level, const NoiseEstimate& noise) {
  require(level > 0 && level < 1, "band_factor: need 0 < level < 1, got {}", level);
  require(noise.exists(), "band_factor: need an estimate of the noise from at least one second difference");
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
    const double radial = std::isinf(nu) ? std::exp(-c * c / 2) : std::pow(1 + c * c / nu, -nu / 2);
    return path / std::numbers::pi * radial + 2 * boost::math::cdf(boost::math::complement(student, c));
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
