#include "smooth.hpp"

#include "uniform_grid.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/refine/refine.hpp>

#include <cmath>

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

std::vector<double> SmoothedColumn::half_widths(double level, BandKind kind) const {
  std::vector<double> widths = deviations;
  if (widths.empty()) return widths;
  const double factor = kind == BandKind::simultaneous ? simultaneous_band_factor(level, *noise, path)
                                                       : band_factor(level, *noise);
  const double added = kind == BandKind::prediction ? noise->variance : 0;
  for (double& width : widths) width = factor * (added == 0 ? width : std::sqrt(width * width + added));
  return widths;
}

std::unique_ptr<LinearSmoother> make_smoother(const Samples& samples, const SmoothingMethod& method,
                                              const SmoothingOptions& options) {
  if (const auto* scheme = std::get_if<Scheme>(&method)) {
    require_derivative(scheme->specification, scheme->mask, {options.derivative});
    require(!samples.repeated(), "smoothing: need one datum for each position for schemes");
    return std::make_unique<SchemeSmoother>(scheme->mask.curve(), samples.sites(), options, scheme->rules);
  }
  const auto* local = std::get_if<LocalPolynomial>(&method);
  require(local != nullptr, "smoothing: {} is not linear", to_text(method));
  LocalPolynomial in_spacings = *local;
  in_spacings.width /= nearest_double(samples.spacing);
  return std::make_unique<LocalSmoother>(in_spacings, samples.sites(), options);
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

SmoothedSamples smooth_by(const DataDependentScheme& scheme, const Samples& samples, const SmoothingOptions& options,
                          int threads) {
  const auto require_linear = [&](bool satisfied, const char* what) {
    require(satisfied, "{} needs a linear scheme; {} is none", what, scheme.specification);
  };
  require(scheme.rules.points.size() == 1, "{}: expected a scheme for curves", scheme.specification);
  require_linear(options.derivative == 0, "a derivative");
  require_linear(samples.weights.empty(), "a fit with prior weights or missing data");
  require_linear(samples.uniform(), "a fit at given positions");
  if (samples.count() < static_cast<std::size_t>(scheme.rules.points[0]))
    fail(ErrorKind::data, "expected at least {} rows for {}; found {}", scheme.rules.points[0], scheme.specification,
         samples.count());
  const int level = options.at_data ? 0 : options.level;
  const auto scale = static_cast<std::size_t>(1) << level;
  const std::size_t outputs = count_outputs(static_cast<double>(samples.count() - 1), scale);
  std::vector<Rational> places;
  for (std::size_t o = 0; o < outputs; ++o) places.push_back(Rational(o) / Rational(scale));
  int levels = 0;  // as many that the points are as near to each other as binary ones
  for (std::size_t finest = scale << finer_levels, reached = 1; reached < finest; ++levels)
    reached *= static_cast<std::size_t>(scheme.rules.arity);
  SmoothedSamples result{scheme.specification, {}, output_positions(samples, scale, 0, outputs), {}};
  for (const auto& column : samples.columns)
    result.columns.push_back(
        {interpolate(refine(curve_data(column), scheme.rules, {levels, options.boundary, threads}), places)});
  set_positions_of_data(result, samples, options);
  return result;
}

}  // namespace

SmoothedSamples smooth(const Samples& samples, const SmoothingMethod& method, const SmoothingOptions& options,
                       int threads) {
  if (const auto* scheme = std::get_if<DataDependentScheme>(&method))
    return smooth_by(*scheme, samples, options, threads);
  // Rules of schemes take data one after another: they get the means of those at one position.
  std::optional<Samples> means;
  if (std::holds_alternative<Scheme>(method) && samples.repeated()) means = merged(samples);
  const Samples& used = means ? *means : samples;
  const std::unique_ptr<LinearSmoother> smoother = make_smoother(used, method, options);
  SmoothedSamples result = smoothed_columns(used, estimate_noise(samples), *smoother, options.derivative, 0,
                                            smoother->spacings(), 0);
  result.method = to_text(method);
  set_positions_of_data(result, samples, options);
  return result;
}

SmoothedSamples smoothed_columns(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                 const LinearSmoother& smoother, int derivative, std::size_t begin, std::size_t end,
                                 std::size_t before) {
  const std::size_t scale = smoother.scale(), shift = before * scale;
  SmoothedSamples result;
  result.positions = output_positions(samples, scale, shift + begin * scale,
                                      shift + std::min(end * scale, smoother.outputs()));
  const double unit = std::pow(nearest_double(samples.spacing), -derivative);
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    SmoothedData smoothed = smoother.apply(samples.columns[c], begin, end);
    SmoothedColumn& column = result.columns.emplace_back(SmoothedColumn{std::move(smoothed.values), noise[c]});
    for (double& value : column.values) value *= unit;
    if (!noise[c].exists()) continue;
    column.path = smoothed.path;
    column.deviations = std::move(smoothed.variances);
    for (double& deviation : column.deviations) deviation = unit * std::sqrt(noise[c].variance * deviation);
  }
  return result;
}

SmoothedSamples smooth(const Samples& samples, std::string_view specification, const SmoothingOptions& options,
                       int threads) {
  std::optional<LocalPolynomial> pattern;
  if (!specification.empty()) {
    const SmoothingMethod method = make_smoothing_method(specification);
    const auto* local = std::get_if<LocalPolynomial>(&method);
    if (!local || local->is_complete()) return smooth(samples, method, options, threads);
    pattern = *local;
  }
  MethodChoice choice = choose_method(samples, options, pattern);
  SmoothedSamples result = smooth(samples, choice.method, options, threads);
  result.choice = std::move(choice);
  return result;
}

}  // namespace subcert::data
