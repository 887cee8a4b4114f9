#pragma once
/// Data refined by any scheme, and refined data as functions of the parameter.

#include <subcert/schemes/data/refine/grid_data.hpp>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace subcert::experiments {

/// Sets of points with `dimension` coordinates on the same axes; sets[k] is ordered as GridData::values.
/// Canonical: every set has as many values.
struct Batch {
  std::vector<data::Axis> axes;
  std::size_t dimension = 1;
  std::vector<std::vector<double>> sets;
};

/// Applies the scheme of one or two variables, linear or of local l1 regression with separate residuals, `levels`
/// times; rules at open ends by regression. Each set is refined as if it were alone, to the bit; what is exact is done
/// once for all. Errors: throws SpecificationError, a domain error for three variables or joint residuals, else
/// as refine().
Batch refined(const std::string& specification, const Batch& data, int levels);
data::GridData<double> refined(const std::string& specification, const data::GridData<double>& data, int levels);

/// The parameters of the points of an axis.
std::vector<double> parameters(const data::Axis& axis);

/// The axis with `factor` steps for each. Domain: factor >= 1.
data::Axis finer(data::Axis axis, int factor);

/// A curve or surface by its parameters, the second 0 for curves; the first `dimension` numbers are coordinates.
using PointAt = std::function<std::array<double, 3>(double, double)>;
data::GridData<double> sampled(const std::vector<data::Axis>& axes, std::size_t dimension, const PointAt& point);

/// The polygon through the points of a curve at these parameters: coordinate c of parameter k at [k * dimension + c].
/// Beyond the first and last point of open data the outer edges are continued. Domain: one axis, at least two points.
std::vector<double> polygon_at(const data::GridData<double>& curve, const std::vector<double>& parameters);

/// A surface, bilinear between its points, at the parameters of a finer one. Domain: two axes, at least two points in
/// each.
std::vector<double> mesh_at(const data::GridData<double>& surface, const std::vector<data::Axis>& finer);

/// The Euclidean distances between points k of both, of `dimension` coordinates. Domain: as many values in both.
std::vector<double> distances(const std::vector<double>& first, const std::vector<double>& second,
                              std::size_t dimension);
/// The largest of them. Domain: at least one point.
double largest_distance(const std::vector<double>& first, const std::vector<double>& second, std::size_t dimension);
/// The same over the diameter of the truth.
double relative_distance(const std::vector<double>& values, const std::vector<double>& truth, std::size_t dimension);

/// The diagonal of the smallest box, with sides along the axes, that contains all points.
double diameter(const std::vector<double>& points, std::size_t dimension);

data::GridData<double> rounded(const data::GridData<Rational>& data);

}  // namespace subcert::experiments
