#pragma once
/// Smoothing of samples from end to end: noise, limit, standard deviations, bands.

#include "scheme_choice.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// What a band covers with its probability: the expected value of the limit, at each position by itself; a new datum of
/// prior weight 1 there; the expected value at all positions of the output at once.
enum class BandKind { pointwise, prediction, simultaneous };

/// `pointwise` and so on, and the kinds by these names, the default first.
std::string to_text(BandKind kind);
std::optional<BandKind> parse_band_kind(std::string_view name);
const std::vector<std::string>& band_kind_names();

/// What smoothing makes of one column.
struct SmoothedColumn {
  std::vector<double> values;               ///< of the limit or its derivative
  std::optional<NoiseEstimate> noise = {};  ///< nothing for a scheme that is not linear
  std::vector<double> deviations = {};      ///< standard deviations; none where the noise has no estimate
  double path = 0;                          ///< LinearSmoother::Smoothed::path

  /// Half the widths of the bands; none without deviations. Domain: 0 < level < 1; prediction with derivative 0.
  /// Errors: throws a domain error.
  std::vector<double> half_widths(double level, BandKind kind = BandKind::pointwise) const;
};

struct SmoothedSamples {
  std::vector<Rational> positions;  ///< in spacings, from the first datum
  std::vector<SmoothedColumn> columns;
};

/// The limit of the scheme from the samples; derivatives are with respect to the positions of the samples, not to
/// their indices. Errors: throws a domain error where convergence, or the smoothness that a derivative needs, has no
/// proof; else as LinearSmoother. Cost: as LinearSmoother::apply.
SmoothedSamples smooth(const Samples& samples, const Scheme& scheme, const SmoothingOptions& options);

/// The columns of smooth(); the value o belongs to the position o / arity^level, which is not stored. Errors and cost:
/// as there.
std::vector<SmoothedColumn> smoothed_columns(const Samples& samples, const Scheme& scheme,
                                             const SmoothingOptions& options);

/// Levels below the output grid at which data-dependent schemes, whose limits are not known, are interpolated.
constexpr int finer_levels = 6;

/// The same by a data-dependent scheme, refined finer_levels more times and interpolated linearly. Domain: a scheme
/// for curves, derivative 0, no weights; boundary regression, reflect or periodic. Errors: throws a domain error that
/// says what needs a linear scheme, a data error for fewer samples than the scheme has points; else as refine().
SmoothedSamples smooth(const Samples& samples, const DataDependentScheme& scheme, const SmoothingOptions& options,
                       int threads = 1);

}  // namespace subcert::data
