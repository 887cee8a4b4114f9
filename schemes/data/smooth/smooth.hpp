#pragma once
/// Smoothing of samples from end to end: noise, limit, standard deviations, bands.

#include "l1_smoother.hpp"
#include "method_choice.hpp"

#include <memory>
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
  double path = 0;                          ///< SmoothedData::path
  std::size_t outliers = 0;                 ///< that a linear method was given: count_outliers
  std::optional<double> correlated = {};    ///< of its data: correlated_differences

  /// Half the widths of the bands; none without deviations. Domain: 0 < level < 1; prediction with derivative 0.
  /// Errors: throws a domain error.
  std::vector<double> half_widths(double level, BandKind kind = BandKind::pointwise) const;
};

/// What deviations are computed from: the exact variances of a linear method, the influence of each datum on a robust
/// fit, or smoothing of data drawn again from the residuals.
enum class BandMethod { linear, sandwich, bootstrap };
std::string to_text(BandMethod method);

struct SmoothedSamples {
  std::string method;                  ///< what smoothed
  std::optional<MethodChoice> choice;  ///< where it was chosen
  std::vector<double> positions;       ///< of the values, rounded to nearest
  std::vector<SmoothedColumn> columns;
  BandMethod band_method = BandMethod::linear;
  std::size_t outside = 0;  ///< of given places, those not between the first datum and the last: NaN there
};

/// Whether positions that are not uniform are taken as they are where nobody says so: by local polynomials, which are
/// made for them, and where the method is chosen.
bool takes_any_positions(std::string_view specification);

/// Whether errors of data are weights alone: robust and l1 methods find the noise by themselves. Errors: as
/// make_smoothing_method().
bool finds_its_noise(std::string_view specification);

/// Smooths by a method; derivatives are with respect to the positions of the samples. Domain: for data-dependent
/// schemes as L1Smoother. Errors: throws NoLimit where convergence, or the smoothness that a derivative needs, has no
/// proof; a domain error that says what needs a linear method; a data error for too few samples; else as the smoothers
/// and refine(); a data error where none of given places lies between the ends. Cost: as LinearSmoother::apply.
SmoothedSamples smooth(const Samples& samples, const SmoothingMethod& method, const SmoothingOptions& options,
                       int threads = 1);

/// The same by the method with this specification: empty, or local without points and width, for choose_method().
SmoothedSamples smooth(const Samples& samples, std::string_view specification, const SmoothingOptions& options,
                       int threads = 1);

/// A smoother of the samples by a linear method, robust steps left out. Errors: as smooth().
std::unique_ptr<LinearSmoother> make_smoother(const Samples& samples, const SmoothingMethod& method,
                                              const SmoothingOptions& options);

/// The columns for the spacings begin, ..., end - 1 of the smoother, whose first datum is number `before` of the grid.
SmoothedSamples smoothed_columns(const Samples& samples, const std::vector<NoiseEstimate>& noise,
                                 const LinearSmoother& smoother, int derivative, std::size_t begin, std::size_t end,
                                 std::size_t before);

}  // namespace subcert::data
