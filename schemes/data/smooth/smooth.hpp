#pragma once
/// Smoothing of samples from end to end: noise, limit, standard deviations, bands.

#include "scheme_choice.hpp"

#include <optional>
#include <vector>

namespace subcert::data {

/// What smoothing makes of one column.
struct SmoothedColumn {
  std::vector<double> values;               ///< of the limit or its derivative
  std::optional<NoiseEstimate> noise = {};  ///< nothing for a scheme that is not linear
  std::vector<double> deviations = {};      ///< standard deviations; none where the noise has no estimate

  /// Half the widths of the pointwise confidence bands for the expected value of the limit; none without deviations.
  /// Domain: 0 < level < 1. Errors: throws a domain error.
  std::vector<double> half_widths(double level) const;
  /// The same of bands for a new datum with prior weight 1 at each position: t sqrt(sd^2 + the variance of the noise).
  /// Domain: also derivative 0.
  std::vector<double> prediction_half_widths(double level) const;
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
