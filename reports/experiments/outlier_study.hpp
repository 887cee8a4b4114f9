#pragma once
/// What outliers do to the schemes of [MLZD15].

#include "batch.hpp"
#include "decided.hpp"

#include <array>
#include <functional>
#include <random>

namespace subcert::experiments {

/// A scheme under the name that the paper gives it.
struct Method {
  std::string name;
  std::string specification;
};

/// S_6, S_7, S_8 by least squares and D_6, D_7, D_8 by l1 regression, on curves and on grids.
const std::vector<Method>& curve_methods();
const std::vector<Method>& surface_methods();

/// The same data without and with outliers.
struct OutlierSample {
  std::vector<double> without;
  std::vector<double> with;
};

struct OutlierCase {
  std::vector<data::Axis> axes;
  std::size_t dimension;
  int levels;
  /// One sample of noise and outliers.
  std::function<OutlierSample(std::mt19937_64&)> draw;
  /// The point from which the data come, at a parameter of each axis; `dimension` numbers are read.
  std::function<std::array<double, 3>(double, double)> truth;
};

/// The points from which the data come, at the parameters of these axes; ordered as GridData::values.
std::vector<double> true_points(const OutlierCase& what, const std::vector<data::Axis>& axes);

/// The samples first, ..., first + count - 1; each set without outliers is followed by that with them.
Batch drawn_samples(const OutlierCase& what, std::uint64_t seed, std::size_t first, std::size_t count);

/// Measures of one scheme, one value for each sample. Errors are mean squared distances from the truth over the points
/// of the last level; the response is the largest distance by which the outliers move a point of the last level.
struct Outcome {
  Method method;
  std::vector<double> error;
  std::vector<double> error_without;  ///< of the data without outliers
  std::vector<double> response;
  std::vector<double> roughness;  ///< on grids: mean square of the second differences along both axes, with outliers
};

/// Sample r is drawn by generator(options.seed, r). Domain: options.runs >= 2.
std::vector<Outcome> study(const OutlierCase& what, const std::vector<Method>& methods,
                           const ExperimentOptions& options);

/// Errors: throws a domain error.
const Outcome& outcome(const std::vector<Outcome>& outcomes, const std::string& name);

using Measure = std::vector<double> Outcome::*;
using Names = std::vector<std::string>;
using NamePairs = std::vector<std::pair<std::string, std::string>>;

std::vector<NamedMean> means(const std::vector<Outcome>& outcomes, const Names& names, Measure measure);
/// The paired differences first - second.
std::vector<NamedMean> differences(const std::vector<Outcome>& outcomes, const NamePairs& pairs, Measure measure);
/// The paired differences first - factor * second.
std::vector<NamedMean> differences(const std::vector<Outcome>& outcomes, const NamePairs& pairs, Measure measure,
                                   double factor);

extern const Names least_squares, robust;
/// D_k and S_k.
extern const NamePairs robust_over_least_squares;
/// D_6 and each other one.
extern const NamePairs six_over_others;
/// The schemes with more points and those with fewer: S, D, both.
extern const NamePairs more_least_squares_points, more_robust_points, more_over_fewer_points;

/// Errors, errors without outliers, responses.
formats::PlainTable outcome_table(const std::string& id, const std::string& title,
                                  const std::vector<Outcome>& outcomes);

/// The printed table beside the errors, none of them reproducible, and the claim that says so.
formats::ComparisonTable printed_errors(const std::string& table, const std::vector<Outcome>& outcomes);
Claim printed_errors_claim(const std::string& table, const std::vector<Outcome>& outcomes);

}  // namespace subcert::experiments
