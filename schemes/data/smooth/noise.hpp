#pragma once
/// How noisy data are, and how wide bands must be for that.

#include "uniform_grid.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace subcert::data {

/// The median of the modulus of a standard normal variable.
constexpr double normal_quartile = 0.6744897501960817;

/// Variance of the noise of data with prior weight 1. Computed from sums of squares in `terms` second differences,
/// which linear trends do not enter, and of what several data at one position differ from their mean; distributed
/// nearly as chi squared with `degrees_of_freedom` where the noise is normal. Infinitely many degrees where it is
/// known, none where data have no estimate.
struct NoiseEstimate {
  double variance = 0;
  double degrees_of_freedom = 0;
  std::size_t terms = 0;
  std::size_t ties = 0;  ///< of the terms, those of data beside others at their position

  bool exists() const { return degrees_of_freedom > 0; }
};

/// Whether this can be the standard deviation of noise: its square, and those of data beside it, are doubles.
inline bool is_noise(double deviation) { return deviation >= 1e-150 && deviation <= 1e150; }

/// The noise of this standard deviation. Domain: is_noise(deviation).
NoiseEstimate known_noise(double deviation);

/// From the distances of data to the chords of their neighbours. Domain: as many prior weights, and positions, as data,
/// or none; positions in order, ties in any; a weight 0 means missing. Without ties or three neighbouring data there is
/// no estimate. Ref: [GSJ86].
NoiseEstimate estimate_noise(const std::vector<double>& data, const std::vector<double>& prior_weights = {},
                             const std::vector<double>& positions = {});

/// That of each column, with the weights and positions of the samples; the known one where they have it. Of values with
/// derivatives the larger variance of both, with the fewer degrees of freedom.
std::vector<NoiseEstimate> estimate_noise(const Samples& samples);

/// The standard deviation of the bulk of the data: the median modulus of second differences, in units of that of normal
/// noise; 0 where there are none. Domain: as estimate_noise.
double bulk_deviation(const std::vector<double>& data, const std::vector<double>& prior_weights = {},
                      const std::vector<double>& positions = {});

/// How many data stand out from both neighbours, not as steps and bends do, by more than six standard deviations of the
/// bulk of the data, where such differences raise the estimate of the variance by more than half; else 0. Two to five
/// data side by side count where they stand out together from a line through two data on either side, and where such
/// runs are at most a fifth of the data. The deviation of the bulk is that of the median of second differences. Domain:
/// as estimate_noise.
std::size_t count_outliers(const std::vector<double>& data, const std::vector<double>& prior_weights = {},
                           const std::vector<double>& positions = {});

/// The correlation of neighbouring second differences, where it is above what independent noise gives, -2/3 on uniform
/// data, by more than four standard deviations, and below 0: noise that is correlated from datum to datum, which bands
/// know nothing of, or a mean that bends within few data. Nothing else, and for fewer than 30 such pairs. Domain: as
/// estimate_noise. Ref: [Bar46]; docs/smoothing.md, section 3.
std::optional<double> correlated_differences(const std::vector<double>& data,
                                             const std::vector<double>& prior_weights = {},
                                             const std::vector<double>& positions = {});

/// What such correlations, of columns by their names, say of the noise and the bands. Domain: one or more.
std::string remark_on_correlations(const std::vector<std::pair<std::string, double>>& found);

/// The factor between the standard deviation of a value and half the width of its confidence band of this level:
/// a quantile of Student's distribution with the degrees of freedom of the noise. Domain: 0 < level < 1, an estimate
/// that exists. Errors: throws a domain error.
double band_factor(double level, const NoiseEstimate& noise);

/// The same for bands that hold at all positions at once with at least this probability, the estimate taken as
/// independent of the values: `path` is the length of the path on the unit sphere through the coefficients of the
/// values, one after another. Domain: as above; path >= 0. Ref: [Nai86], [SL94]; docs/smoothing.md, section 3.
double simultaneous_band_factor(double level, const NoiseEstimate& noise, double path);

}  // namespace subcert::data
