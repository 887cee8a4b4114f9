#pragma once
/// Curves and surfaces from data with noise and outliers, refined by several schemes.

#include "experiment.hpp"
#include "refined_data.hpp"

#include <random>

namespace subcert::experiments {

/// A scheme under the name that the paper gives it.
struct Method {
  std::string name;
  std::string specification;
  std::optional<int> levels = {};  ///< where not those of the data
};

/// A row for each method, with its name.
std::vector<MeansTable::Row> rows_of(const std::vector<Method>& methods);

/// The same data without and with outliers.
struct OutlierSample {
  std::vector<double> without;
  std::vector<double> with;
};

struct NoisyData {
  std::vector<data::Axis> axes;
  std::size_t dimension = 1;
  int levels;                        ///< refinements
  PointAt truth;                     ///< from which the data come
  std::optional<double> sigma = {};  ///< deviation of the normal noise in each coordinate; none is drawn where empty
  std::size_t outliers = 0;
  std::function<void(std::mt19937_64&, double* point)> displace = {};  ///< makes an outlier of a point

  /// Draws the noise, then the places of the outliers, then each. `points`: the values of true_points().
  OutlierSample draw(std::mt19937_64& engine, std::vector<double> points) const;
  OutlierSample draw(std::mt19937_64& engine) const { return draw(engine, true_points().values); }
  OutlierSample first_sample(std::uint64_t seed) const;
  /// Sample 0 with its outliers.
  data::GridData<double> first_data(std::uint64_t seed) const { return as_grid(first_sample(seed).with); }
  data::GridData<double> as_grid(std::vector<double> values) const { return {std::move(values), dimension, axes}; }
  /// The points from which the data come, at the parameters of these axes or of the data.
  data::GridData<double> true_points(const std::vector<data::Axis>& at) const { return sampled(at, dimension, truth); }
  data::GridData<double> true_points() const { return true_points(axes); }
};

/// Adds a number between `low` and `low` + `width` to a height, of random sign.
std::function<void(std::mt19937_64&, double*)> vertical_outlier(double low, double width);

/// One sample refined by a scheme, with the truth at its points. What no measure reads is not refined: then `without`
/// is `with`, and `exact` is empty.
struct RefinedSample {
  const NoisyData& data;
  const OutlierSample& drawn;
  const std::vector<data::Axis>& axes;
  const std::vector<double>& points;  ///< the truth at the data
  const std::vector<double>& truth;
  const std::vector<double>& without;
  const std::vector<double>& with;
  const std::vector<double>& exact;  ///< from the data without noise and outliers
};

/// Which data a measure reads beside those with outliers.
enum class Reads { with_outliers, without_outliers, exact };

struct SampleMeasure {
  std::string name;
  double (*value)(const RefinedSample& sample);
  Reads reads = Reads::with_outliers;  ///< the last one all
};

/// "error" and "error without": the mean squared distance from the truth over the points, with outliers and without.
/// "response": the largest distance by which the outliers move a point.
extern const SampleMeasure error_measure, error_without_measure, response_measure;
/// "response to noise": the largest distance by which the noise, without outliers, moves a point.
extern const SampleMeasure response_to_noise_measure;
/// "roughness", on grids: the mean square of the second differences along both axes, with outliers.
extern const SampleMeasure roughness_measure;
/// "from data", on curves: the mean squared distance of the limit from the data that are no outliers.
extern const SampleMeasure from_data_measure;
/// "overfits", on curves: 1 where the mean squared distance of the limit at the data from these, outliers too, is
/// smaller than that from the true points, else 0.
extern const SampleMeasure overfits_measure;

/// Adds each measure for each method, its name preceded by `prefix`. Sample r is drawn by generator(options.seed, r).
/// Domain: options.runs >= 2.
void study(Measured& measured, const NoisyData& data, const std::vector<Method>& methods,
           const std::vector<SampleMeasure>& measures, const ExperimentOptions& options,
           const std::string& prefix = "");

/// Adds "squared bias" and "variance" of the limits of data with outliers, estimated from pairs of independent samples,
/// one of each for each pair, as means over the points. With the errors e and e' of a pair, the mean of e . e' is
/// unbiased for the squared bias, and that of |e - e'|^2 / 2 for the variance.
/// Domain: options.runs >= 2; at least 4 samples are drawn.
void study_error_parts(Measured& measured, const NoisyData& data, const std::vector<Method>& methods,
                       const ExperimentOptions& options);

/// Errors, errors without outliers and responses of the methods.
MeansTable outlier_table(const std::string& id, const std::string& title, const std::vector<Method>& methods,
                         const std::string& prefix = "");

}  // namespace subcert::experiments
