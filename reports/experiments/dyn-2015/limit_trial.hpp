#pragma once
/// Curves and surfaces from noisy points: limits of several schemes at two levels of noise.

#include <subcert/reports/experiments/experiment.hpp>
#include <subcert/reports/experiments/local_polynomial.hpp>
#include <subcert/reports/experiments/refined_data.hpp>

namespace subcert::experiments::dyn_2015 {

/// As [DHHS15] names it: primal:n=4,d=3 is S_4^3. Other specifications stay as they are.
std::string scheme_name(const std::string& specification);

/// The norm of the difference over the norm of the truth. Domain: as many values in both.
double relative_error(const std::vector<double>& values, const std::vector<double>& truth);

/// One scheme along every axis of the data, its limit at the multiples of 2^-level; open ends are continued by `ends`.
class TensorLimit {
 public:
  TensorLimit(const std::string& specification, const std::vector<data::Axis>& axes, int level,
              data::Boundary ends = data::Boundary::regression);
  /// Domain: data on these axes.
  data::GridData<double> operator()(const data::GridData<double>& data) const;

 private:
  std::vector<DenseMatrix> along_;
  std::vector<data::Axis> axes_;  ///< of the limit
};

/// One sample and its limit.
struct TrialSample {
  const data::GridData<double>& limit;
  const data::GridData<double>& truth;  ///< at the same parameters
  const data::GridData<double>& quiet;  ///< the limit of the samples without noise
  const data::GridData<double>& noisy;
  const data::GridData<double>& exact;  ///< the samples without noise
};

using LimitMeasure = double (*)(const TrialSample& sample);

double point_error(const TrialSample& sample);
/// After the limit is scaled about its centre so that it fits best.
double shape_error(const TrialSample& sample);
/// The root mean square of the angles between the normals of facets, in degrees. Domain: two axes.
double normal_error(const TrialSample& sample);
/// Of the noisy samples: what a limit has to better.
double sample_error(const TrialSample& sample);
double sample_shape_error(const TrialSample& sample);
/// The mean squared distances of the limit from the limit without noise, and of that from the truth.
double squared_noise(const TrialSample& sample);
double squared_bias(const TrialSample& sample);
/// The mean squared distances, at the parameters of the samples, of the limit from the noisy samples and from the exact
/// ones. Domain: one axis.
double square_to_noisy(const TrialSample& sample);
double square_to_exact(const TrialSample& sample);

/// A shape, its noisy samples and the limits of schemes.
struct LimitTrial {
  std::string title;
  std::vector<data::Axis> axes;  ///< of the samples
  std::size_t dimension;
  PointAt shape;
  int level;                       ///< limits stand at the multiples of 2^-level
  std::array<double, 2> decibels;  ///< low and high noise
  std::vector<std::string> schemes;
  std::vector<std::pair<std::string, LimitMeasure>> measures;
  double factor = 20;  ///< of log10 in the decibel
  data::Boundary ends = data::Boundary::regression;

  data::GridData<double> samples() const { return sampled(axes, dimension, shape); }
  data::GridData<double> truth() const;
  /// The measures of "S_3 at 17 dB" and the like, and their table: a row for each scheme and level of noise.
  Measured measured(const Run& run) const;
  /// One sample of the noise: the limits of curves with data and truth, those of surfaces alone.
  formats::Figure curves_figure(const Run& run) const;
  formats::SurfaceFigure surfaces_figure(const Run& run) const;
  /// The surface and its noisy points.
  formats::SurfaceFigure samples_figure(const std::string& figure_id, const Run& run) const;
};

}  // namespace subcert::experiments::dyn_2015
