#include "smooth.hpp"

#include "hermite_samples.hpp"
#include "robust_local.hpp"
#include "uniform_grid.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace subcert::data {

const std::vector<std::string>& band_kind_names() {
  static const std::vector<std::string> names{"pointwise", "prediction", "simultaneous"};
  return names;
}

std::string to_text(BandKind kind) { return band_kind_names()[static_cast<std::size_t>(kind)]; }

std::optional<BandKind> parse_band_kind(std::string_view name) {
  for (const BandKind kind : {BandKind::pointwise, BandKind::prediction, BandKind::simultaneous})
    if (name == to_text(kind)) return kind;
  return std::nullopt;
}

std::string to_text(BandMethod method) {
  static const std::string names[]{"linear", "sandwich", "bootstrap"};
  return names[static_cast<std::size_t>(method)];
}

std::vector<double> SmoothedColumn::half_widths(double level, BandKind kind) const {
  std::vector<double> widths = deviations;
  if (widths.empty()) return widths;
  const double factor = kind == BandKind::simultaneous ? simultaneous_band_factor(level, *noise, path)
                                                       : band_factor(level, *noise);
  const double added = kind == BandKind::prediction ? noise->variance : 0;
  for (double& width : widths) width = factor * (added == 0 ? width : std::sqrt(width * width + added));
  return widths;
}

namespace {

LocalPolynomial in_spacings(LocalPolynomial method, const Samples& samples) {
  method.width /= nearest_double(samples.spacing);
  return method;
}

}  // namespace

std::unique_ptr<LinearSmoother> make_smoother(const Samples& samples, const SmoothingMethod& method,
                                              const SmoothingOptions& options) {
  if (const auto* scheme = std::get_if<Scheme>(&method)) {
    require_derivative(scheme->specification, scheme->mask, {options.derivative});
    require(!samples.repeated(), "smoothing: need one datum for each position for schemes");
    return std::make_unique<SchemeSmoother>(scheme->mask.curve(), samples.sites(), options, scheme->rules);
  }
  const auto* local = std::get_if<LocalPolynomial>(&method);
  require(local != nullptr, "smoothing: {} is not linear", to_text(method));
  return std::make_unique<LocalSmoother>(in_spacings(*local, samples), samples.sites(), options);
}

namespace {

/// Of the outputs begin, ..., end - 1.
std::vector<double> output_positions(const Samples& samples, std::size_t scale, std::size_t begin, std::size_t end) {
  const GridPositions grid(samples.origin, samples.spacing, scale);
  std::vector<double> positions;
  positions.reserve(end - begin);
  for (std::size_t o = begin; o < end; ++o) positions.push_back(grid.at(o));
  return positions;
}

void set_positions_of_data(SmoothedSamples& result, const Samples& samples, const SmoothingOptions& options) {
  const std::vector<double>& own = samples.uniform() ? samples.given : samples.positions;
  if (options.at_data && !own.empty()) result.positions = own;
}

/// At the data one output for each position, though there be derivatives.
void leave_values(SmoothedSamples& result, const Samples& samples, const SmoothingOptions& options) {
  if (!options.at_data) return;
  for (SmoothedColumn& column : result.columns) {
    column.values = data_of_order(samples, column.values, 0);
    column.deviations = data_of_order(samples, column.deviations, 0);
  }
}

/// Of the outputs of a grid or, at the data, of these.
void set_positions(SmoothedSamples& result, const Samples& samples, const SmoothingOptions& options) {
  const std::size_t scale = options.at_data ? 1 : std::size_t{1} << options.level;
  result.positions = output_positions(samples, scale, 0, result.columns.front().values.size());
  set_positions_of_data(result, samples, options);
}

SmoothedSamples smooth_by(const DataDependentScheme& scheme, const Samples& samples, const SmoothingOptions& options,
                          int threads) {
  const L1Smoother smoother(scheme, samples.sites(), options);
  SmoothedSamples result{scheme.specification, {}, {}, {}, BandMethod::bootstrap};
  for (const auto& column : samples.columns) {
    SmoothedColumn& made = result.columns.emplace_back(SmoothedColumn{smoother.values(column, threads)});
    if (options.resamples == 0) continue;
    auto [deviations, noise] = smoother.bootstrap(column, threads);
    made.deviations = std::move(deviations);
    made.noise = noise;
  }
  set_positions(result, samples, options);
  return result;
}

SmoothedSamples smooth_by(const LocalPolynomial& method, const Samples& samples, const SmoothingOptions& options,
                          int threads) {
  const DataSites sites = samples.sites();
  const double unit = std::pow(nearest_double(samples.spacing), -options.derivative);
  SmoothedSamples result{to_text(method), {}, {}, {}, BandMethod::sandwich};
  for (const auto& column : samples.columns) {
    RobustFit fit = robust_fit(in_spacings(method, samples), sites, options, column, threads);
    for (double& value : fit.values) value *= unit;
    for (double& deviation : fit.deviations) deviation *= unit;
    result.columns.push_back({std::move(fit.values), fit.noise, std::move(fit.deviations), fit.path});
  }
  leave_values(result, samples, options);
  set_positions(result, samples, options);
  return result;
}

}  // namespace

namespace {

/// Errors: throws a data error for values beyond double precision, as of derivatives with tiny spacings.
SmoothedSamples finite(SmoothedSamples result) {
  for (const SmoothedColumn& column : result.columns)
    if (!std::ranges::all_of(column.values, [](double value) { return std::isfinite(value); }))
      fail(ErrorKind::data, "smoothing: values beyond the range of double precision; expected other units");
  return result;
}

/// Of options whose places are in spacings and in order.
SmoothedSamples smooth_in_spacings(const Samples& samples, const SmoothingMethod& method,
                                   const SmoothingOptions& options, int threads) {
  const auto* scheme = std::get_if<DataDependentScheme>(&method);
  const auto* local = std::get_if<LocalPolynomial>(&method);
  const bool linear = !scheme && !(local && local->robust > 0);
  require(linear || !samples.noise, "smoothing: a known noise is for linear methods; {} finds its own",
          to_text(method));
  if (!linear)
    return finite(scheme ? smooth_by(*scheme, samples, options, threads)
                         : smooth_by(*local, samples, options, threads));
  // Rules of schemes take data one after another: they get the means of those at one position.
  std::optional<Samples> means;
  if (std::holds_alternative<Scheme>(method) && samples.repeated()) means = merged(samples);
  const Samples& used = means ? *means : samples;
  const std::unique_ptr<LinearSmoother> smoother = make_smoother(used, method, options);
  SmoothedSamples result = smoothed_columns(used, estimate_noise(samples), *smoother, options.derivative, 0,
                                            smoother->spacings(), 0);
  const int order = std::min(options.derivative, samples.derivatives);
  const std::vector<double> weights = data_of_order(samples, samples.rounded_weights(), order);
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    const std::vector<double> data = data_of_order(samples, samples.columns[c], order);
    result.columns[c].outliers = count_outliers(data, weights, samples.positions);
    if (!samples.noise) result.columns[c].correlated = correlated_differences(data, weights, samples.positions);
  }
  result.method = to_text(method);
  if (samples.derivatives > 0) {
    leave_values(result, samples, options);
    if (options.at_data) set_positions(result, samples, options);
  } else {
    set_positions_of_data(result, samples, options);
  }
  return finite(std::move(result));
}

/// From its positions in spacings.
class Range {
 public:
  explicit Range(const Samples& samples)
      : samples_(samples),
        last_(static_cast<double>(samples.rows()) - 1),
        ends_(samples.uniform() ? samples.given : samples.positions) {
    if (!ends_.empty()) ends_ = {ends_.front(), ends_.back()};
    if (ends_.empty())
      ends_ = {nearest_double(samples.origin), nearest_double(samples.origin + samples.spacing * Rational(last_))};
    if (!samples.uniform()) last_ = samples.sites().positions.back();
  }
  double first() const { return ends_.front(); }
  double last() const { return ends_.back(); }
  bool holds(double position) const { return position >= first() && position <= last(); }
  double in_spacings(double position) const {
    const double place = samples_.uniform()
                             ? nearest_double((decimal_value(position) - samples_.origin) / samples_.spacing)
                             : (position - samples_.positions.front()) / nearest_double(samples_.spacing);
    return std::clamp(place, 0.0, last_);
  }

 private:
  const Samples& samples_;
  double last_;
  std::vector<double> ends_;
};

/// Puts values of the outputs where they belong; NaN elsewhere.
void spread(std::vector<double>& values, const std::vector<std::size_t>& outputs, std::size_t count) {
  if (values.empty()) return;
  std::vector<double> all(count, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t o = 0; o < outputs.size(); ++o) all[outputs[o]] = values[o];
  values = std::move(all);
}

SmoothedSamples smooth_at_places(const Samples& samples, const SmoothingMethod& method, SmoothingOptions options,
                                 int threads) {
  require(!options.at_data, "smoothing: need values at the data or at given places, got both");
  const Range range(samples);
  std::vector<double> places;
  places.swap(options.places);
  std::vector<std::size_t> outputs;
  for (std::size_t i = 0; i < places.size(); ++i) {
    require(std::isfinite(places[i]), "smoothing: need finite places, got {}", places[i]);
    if (range.holds(places[i])) outputs.push_back(i);
  }
  if (outputs.empty())
    fail(ErrorKind::data, "expected a position between the first datum and the last, {} and {}; found none",
         shortest_text(range.first()), shortest_text(range.last()));
  std::ranges::stable_sort(outputs, {}, [&](std::size_t i) { return places[i]; });
  for (const std::size_t i : outputs) options.places.push_back(range.in_spacings(places[i]));
  SmoothedSamples result = smooth_in_spacings(samples, method, options, threads);
  for (SmoothedColumn& column : result.columns) {
    spread(column.values, outputs, places.size());
    spread(column.deviations, outputs, places.size());
  }
  result.outside = places.size() - outputs.size();
  result.positions = std::move(places);
  return result;
}

}  // namespace

SmoothedSamples smooth(const Samples& samples, const SmoothingMethod& method, const SmoothingOptions& options,
                       int threads) {
  if (options.at_data && !samples.uniform() && std::holds_alternative<Scheme>(method)) {
    SmoothingOptions there = options;
    there.at_data = false;
    there.places = samples.positions;
    return smooth_at_places(samples, method, std::move(there), threads);
  }
  return options.places.empty() ? smooth_in_spacings(samples, method, options, threads)
                                : smooth_at_places(samples, method, options, threads);
}

SmoothedSamples smoothed_columns(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                 const LinearSmoother& smoother, int derivative, std::size_t begin, std::size_t end,
                                 std::size_t before) {
  const std::size_t scale = smoother.scale(), shift = before * scale;
  SmoothedSamples result;
  result.positions = output_positions(samples, scale, shift + begin * scale,
                                      shift + std::min(end * scale, smoother.outputs()));
  const double unit = std::pow(nearest_double(samples.spacing), -derivative);
  std::vector<SmoothedData> all = smoother.apply_to(samples.columns, begin, end);
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    SmoothedData& smoothed = all[c];
    SmoothedColumn& column = result.columns.emplace_back(SmoothedColumn{std::move(smoothed.values), noise[c]});
    for (double& value : column.values) value *= unit;
    if (!noise[c].exists()) continue;
    column.path = smoothed.path;
    column.deviations = std::move(smoothed.variances);
    for (double& deviation : column.deviations) deviation = unit * std::sqrt(noise[c].variance * deviation);
  }
  return result;
}

bool takes_any_positions(std::string_view specification) {
  return specification.empty() || is_local_specification(specification);
}

bool finds_its_noise(std::string_view specification) {
  return is_l1_specification(specification) || is_robust_specification(specification);
}

namespace {

/// Of values with slopes: the noise is that of the values, or of the derivative that is asked for.
SmoothedSamples smooth_with_slopes(const Samples& samples, std::string_view specification,
                                   const SmoothingOptions& options, int threads) {
  require(takes_any_positions(specification), "smoothing: values with slopes need local polynomials, local:..., got {}",
          specification);
  const Samples joined = with_slopes_after_values(samples, finds_its_noise(specification));
  SmoothedSamples result = smooth(joined, specification, options, threads);
  if (options.derivative > 0) return result;
  SmoothingOptions of_slopes = options;
  of_slopes.derivative = 1;
  SmoothedSamples slopes = smooth(joined, make_smoothing_method(result.method), of_slopes, threads);
  const double unit = nearest_double(samples.spacing);
  for (SmoothedColumn& column : slopes.columns) {
    column.noise->variance /= joined.derivative_weight * unit * unit;
    result.columns.push_back(std::move(column));
  }
  return result;
}

}  // namespace

SmoothedSamples smooth(const Samples& samples, std::string_view specification, const SmoothingOptions& options,
                       int threads) {
  if (samples.slopes) return smooth_with_slopes(samples, specification, options, threads);
  require_squares(samples);
  std::optional<LocalPolynomial> pattern;
  if (!specification.empty()) {
    const SmoothingMethod method = make_smoothing_method(specification);
    const auto* local = std::get_if<LocalPolynomial>(&method);
    if (!local || local->is_complete()) return smooth(samples, method, options, threads);
    pattern = *local;
  }
  MethodChoice choice = choose_method(samples, options, pattern, threads);
  SmoothedSamples result = smooth(samples, choice.method, options, threads);
  result.choice = std::move(choice);
  return result;
}

}  // namespace subcert::data
