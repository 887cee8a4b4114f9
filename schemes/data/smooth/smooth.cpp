#include "smooth.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/refine/interpolation.hpp>

#include <cmath>

namespace subcert::data {
namespace {

void require_limits(const Scheme& scheme, int derivative) {
  if (derivative == 0) {
    const Decision convergence = converges(scheme.mask);
    require(convergence.is_yes(), "{}: no proof that the scheme converges ({})", scheme.specification,
            convergence.reason);
    return;
  }
  const SmoothnessProof smoothness = proved_smoothness(scheme.mask);
  require(smoothness.order >= derivative,
          "derivative {}: {} is not proved to have continuous derivatives of that order; {}", derivative,
          scheme.specification, smoothness.obstacle);
}

}  // namespace

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

std::vector<SmoothedColumn> smoothed_columns(const Samples& samples, const Scheme& scheme,
                                             const SmoothingOptions& options) {
  require_limits(scheme, options.derivative);
  const LinearSmoother smoother(scheme.mask, samples.count(), options, scheme.rules, samples.weights);
  const double unit = std::pow(nearest_double(samples.spacing), -options.derivative);
  std::vector<SmoothedColumn> result;
  const std::vector<NoiseEstimate> noise = estimate_noise(samples);
  for (std::size_t c = 0; c < samples.columns.size(); ++c) {
    auto smoothed = smoother.apply(samples.columns[c]);
    SmoothedColumn& column = result.emplace_back(SmoothedColumn{std::move(smoothed.values), noise[c]});
    for (double& value : column.values) value *= unit;
    if (noise[c].terms == 0) continue;
    column.path = smoothed.path;
    column.deviations = std::move(smoothed.variances);
    for (double& deviation : column.deviations) deviation = unit * std::sqrt(noise[c].variance * deviation);
  }
  return result;
}

SmoothedSamples smooth(const Samples& samples, const Scheme& scheme, const SmoothingOptions& options) {
  SmoothedSamples result{{}, smoothed_columns(samples, scheme, options)};
  const Rational scale = power(Rational(scheme.mask.arity()), options.level);
  for (std::size_t o = 0; o < result.columns.front().values.size(); ++o)
    result.positions.push_back(Rational(o) / scale);
  return result;
}

SmoothedSamples smooth(const Samples& samples, const DataDependentScheme& scheme, const SmoothingOptions& options,
                       int threads) {
  const auto require_linear = [&](bool satisfied, const char* what) {
    require(satisfied, "{} needs a linear scheme; {} is none", what, scheme.specification);
  };
  require(scheme.rules.points.size() == 1, "{}: expected a scheme for curves", scheme.specification);
  require_linear(options.derivative == 0, "a derivative");
  require_linear(samples.weights.empty(), "a fit with prior weights or missing data");
  if (samples.count() < static_cast<std::size_t>(scheme.rules.points[0]))
    fail(ErrorKind::data, "expected at least {} rows for {}; found {}", scheme.rules.points[0], scheme.specification,
         samples.count());
  const auto scale = static_cast<std::size_t>(1) << options.level;
  require_smoothable(samples.count(), scale);
  SmoothedSamples result;
  for (std::size_t o = 0; o <= (samples.count() - 1) * scale; ++o)
    result.positions.push_back(Rational(o) / Rational(scale));
  for (const auto& column : samples.columns)
    result.columns.push_back({interpolate(
        refine(curve_data(column), scheme.rules, {options.level + finer_levels, options.boundary, threads}),
        result.positions)});
  return result;
}

}  // namespace subcert::data
