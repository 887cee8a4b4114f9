#include "l1_smoother.hpp"

#include "local_windows.hpp"
#include "robust_local.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/regression_fit.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace subcert::data {
namespace {

constexpr std::size_t fits_per_thread = 512;
constexpr double median_efficiency = 0.37;  // of the median of moduli beside the mean square, for normal noise

/// One window: data, their weights and places relative to that of the fit.
struct UnevenWindow {
  std::vector<double> nodes, weights, residuals, moved;
};

/// Takes the least squares fit out of the residuals; returns its value at 0.
double take_fit(UnevenWindow& window, const std::vector<double>& weights, int degree) {
  double value = 0;
  regression_fit::for_terms(window.nodes, weights, degree, 0.0, 0,
                            [&](double scale, const std::vector<double>& polynomial) {
                              double norm = 0, moment = 0;
                              for (std::size_t i = 0; i < weights.size(); ++i) {
                                norm += weights[i] * polynomial[i] * polynomial[i];
                                moment += weights[i] * polynomial[i] * window.residuals[i];
                              }
                              if (!(norm > 0)) return;
                              for (std::size_t i = 0; i < weights.size(); ++i)
                                window.residuals[i] -= moment / norm * polynomial[i];
                              value += scale * moment;
                            });
  return value;
}

/// The l1 fit at 0, as L1Fitter's. Domain: residuals are the data.
double l1_value(UnevenWindow& window, int degree, const L1Options& options) {
  double value = take_fit(window, window.weights, degree);
  std::vector<double> weights(window.weights.size());
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double r = window.residuals[i];
      weights[i] = window.weights[i] / std::sqrt(window.weights[i] * r * r + options.delta);
    }
    window.moved = window.residuals;
    value += take_fit(window, weights, degree);
    double most = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
      most = std::max(most, std::abs(window.moved[i] - window.residuals[i]));
    if (options.tolerance > 0 && most <= options.tolerance) break;
  }
  return value;
}

/// The data continued past their ends, and the windows of the rule among them.
class UnevenData {
 public:
  UnevenData(const L1Scheme& scheme, const DataSites& sites, Boundary boundary, const std::vector<double>& data)
      : scheme_(scheme),
        points_(static_cast<std::size_t>(scheme.points[0])),
        sites_({boundary, 1, 0}, sites),
        windows_(sites_, boundary, {scheme.degree, LocalWeight::box, points_}) {
    for (std::size_t k = 0; k < windows_.count(); ++k) {
      const long index = windows_.index(k);
      values_.push_back(data[sites_.at<double>(index).terms.front().first]);
      weights_.push_back(static_cast<double>(sites_.weight(index)));
    }
  }

  double fit_at(double place, UnevenWindow& window) const {
    const auto [first, end] = range_at(place);
    const std::vector<double>& at = windows_.positions();
    const double reach = std::max({std::abs(at[first] - place), std::abs(at[end - 1] - place), 1e-300});
    window.nodes.clear();
    for (std::size_t k = first; k < end; ++k) window.nodes.push_back((at[k] - place) / reach);
    window.weights.assign(weights_.begin() + static_cast<std::ptrdiff_t>(first),
                          weights_.begin() + static_cast<std::ptrdiff_t>(end));
    window.residuals.assign(values_.begin() + static_cast<std::ptrdiff_t>(first),
                            values_.begin() + static_cast<std::ptrdiff_t>(end));
    return l1_value(window, scheme_.degree, scheme_.options);
  }

 private:
  /// As many data as the rule has, more where they stand at too few positions.
  std::pair<std::size_t, std::size_t> range_at(double place) const {
    const std::vector<double>& at = windows_.positions();
    const auto next = static_cast<long>(std::ranges::upper_bound(at, place) - at.begin());
    const auto half = static_cast<long>(points_ / 2);
    long start = next - half;
    if (points_ % 2 == 1 && next > 0 && next < static_cast<long>(at.size())) {
      const auto i = static_cast<std::size_t>(next);
      start = (place - at[i - 1] < at[i] - place ? next - 1 : next) - half;
    }
    start = std::clamp(start, 0L, static_cast<long>(at.size() - points_));
    LocalWindows::Window window{place, static_cast<std::size_t>(start), static_cast<std::size_t>(start) + points_, 0};
    while (!windows_.determines(window) && (window.first > 0 || window.end < at.size())) {
      if (window.first > 0) --window.first;
      if (window.end < at.size()) ++window.end;
    }
    return {window.first, window.end};
  }

  const L1Scheme& scheme_;
  std::size_t points_;
  ExtendedData sites_;
  LocalWindows windows_;
  std::vector<double> values_, weights_;
};

/// As many levels that the points are as near to each other as after these binary ones.
int levels_of(int arity, int binary) {
  int levels = 0;
  for (std::size_t finest = std::size_t{1} << binary, reached = 1; reached < finest; ++levels)
    reached *= static_cast<std::size_t>(arity);
  return levels;
}

double median_of_moduli(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return median(std::move(values));
}

}  // namespace

L1Smoother::L1Smoother(const DataDependentScheme& scheme, DataSites sites, const SmoothingOptions& options)
    : scheme_(scheme), sites_(std::move(sites)), options_(options) {
  const std::string& name = scheme.specification;
  require(scheme.rules.points.size() == 1, "{}: expected a scheme for curves", name);
  require(options.derivative == 0, "a derivative needs a linear scheme; {} is none", name);
  require(plain() || !scheme.rules.options.exact,
          "{}: exact fits need uniform data without weights or gaps; iterations=auto takes all", name);
  require(options.boundary != Boundary::nearest && options.boundary != Boundary::constant,
          "{}: expected the boundary interp, mirror or wrap", name);
  const std::size_t missing = static_cast<std::size_t>(std::ranges::count(sites_.weights, Rational(0)));
  if (sites_.count - missing < static_cast<std::size_t>(scheme.rules.points[0]))
    fail(ErrorKind::data, "expected at least {} rows for {}; found {}", scheme.rules.points[0], name,
         sites_.count - missing);
  const double length = sites_.positions.empty() ? static_cast<double>(sites_.count - 1) : sites_.positions.back();
  require(options.boundary != Boundary::periodic || std::abs(length - std::round(length)) < 1e-6 * (1 + length),
          "{}: the boundary wrap needs a range that is a multiple of the spacing", name);
  const std::size_t scale = std::size_t{1} << options.level;
  const std::size_t last = static_cast<std::size_t>(std::ceil(length - 1e-6 * (1 + length)));
  grid_ = last + 1;
  if (grid_ < static_cast<std::size_t>(scheme.rules.points[0]))
    fail(ErrorKind::data, "expected a spacing that puts at least {} outputs in the range, for {}; found {}",
         scheme.rules.points[0], name, grid_);
  for (std::size_t i = 0; i < sites_.count; ++i)
    data_places_.push_back(sites_.positions.empty() ? Rational(i) : Rational(sites_.positions[i]));
  if (options.at_data)
    places_ = data_places_;
  else if (!options.places.empty())
    for (const double place : options.places) places_.emplace_back(place);
  else
    for (std::size_t o = 0, end = count_outputs(length, scale); o < end; ++o)
      places_.push_back(Rational(o) / Rational(scale));
}

std::vector<double> L1Smoother::values(const std::vector<double>& data, const std::vector<Rational>& places, int binary,
                                       int threads) const {
  const int levels = levels_of(scheme_.rules.arity, binary);
  const RefineOptions refinement{levels, options_.boundary, threads};
  if (plain()) return interpolate(refine(curve_data(data), scheme_.rules, refinement), places);
  GridData<double> first = refine(curve_data(std::vector<double>(grid_, 0)), scheme_.rules,
                                  {1, options_.boundary, threads});
  const UnevenData uneven(scheme_.rules, sites_, options_.boundary, data);
  const auto start = static_cast<double>(first.axes[0].first), step = static_cast<double>(first.axes[0].step);
  parallel_ranges(first.values.size(), first.values.size() / fits_per_thread, threads,
                  [&](std::size_t begin, std::size_t end) {
                    UnevenWindow window;
                    for (std::size_t o = begin; o < end; ++o)
                      first.values[o] = uneven.fit_at(start + step * static_cast<double>(o), window);
                  });
  return interpolate(refine(first, scheme_.rules, {levels - 1, options_.boundary, threads}), places);
}

std::vector<double> L1Smoother::values(const std::vector<double>& data, int threads) const {
  require(data.size() == sites_.count, "smoothing: need {} data, got {}", sites_.count, data.size());
  const int level = options_.on_grid() ? options_.level : 0;
  return values(data, places_, level + finer_levels, threads);
}

std::vector<double> L1Smoother::residuals(const std::vector<double>& data, const std::vector<double>& fits) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const double weight = sites_.weights.empty() ? 1 : static_cast<double>(sites_.weights[i]);
    if (weight > 0) result.push_back(std::sqrt(weight) * (data[i] - fits[i]));
  }
  return result;
}

L1Smoother::Spread L1Smoother::bootstrap(const std::vector<double>& data, int threads) const {
  const int levels = (options_.on_grid() ? options_.level : 0) + 1;
  const auto roots = [&](std::size_t i) {
    return sites_.weights.empty() ? 1.0 : std::sqrt(static_cast<double>(sites_.weights[i]));
  };
  const auto drawn = [&](std::mt19937_64& engine, auto draw) {
    std::vector<double> noise;
    for (std::size_t i = 0; i < data.size(); ++i) noise.push_back(roots(i) > 0 ? draw(engine) / roots(i) : 0);
    return noise;
  };
  std::mt19937_64 engine(options_.seed);
  std::normal_distribution<double> gauss;
  const std::vector<double> noise = drawn(engine, gauss), fits = values(data, data_places_, levels, threads);
  std::vector<double> left = residuals(data, fits);
  const double kept = median_of_moduli(residuals(noise, values(noise, data_places_, levels, threads))) /
                      median_of_moduli(residuals(noise, std::vector<double>(data.size(), 0)));
  const double middle = median(left);
  for (double& r : left) r = (r - middle) / kept;

  const auto runs = static_cast<std::size_t>(options_.resamples);
  std::vector<std::vector<double>> again(runs);
  std::uniform_int_distribution<std::size_t> any(0, left.size() - 1);
  for (auto& one : again) {
    one = drawn(engine, [&](std::mt19937_64& from) { return left[any(from)]; });
    for (std::size_t i = 0; i < one.size(); ++i) one[i] += fits[i];
  }
  parallel_for_each(runs, threads, [&](std::size_t run) { again[run] = values(again[run], places_, levels, 1); });
  Spread result{std::vector<double>(outputs()), {}};
  for (std::size_t o = 0; o < outputs(); ++o) {
    double mean = 0, squares = 0;
    for (const auto& one : again) mean += one[o] / static_cast<double>(runs);
    for (const auto& one : again) squares += (one[o] - mean) * (one[o] - mean);
    result.deviations[o] = std::sqrt(squares / static_cast<double>(runs - 1));
  }
  const double sigma = median_of_moduli(left) / normal_quartile;
  result.noise = {sigma * sigma, median_efficiency * static_cast<double>(left.size()), left.size()};
  return result;
}

}  // namespace subcert::data
