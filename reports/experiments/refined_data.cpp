#include "refined_data.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::experiments {
Batch refined(const std::string& specification, const Batch& data, int levels) {
  const AnyScheme scheme = make_any_scheme(specification);
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme); l1 && l1->rules.options.joint_residuals)
    fail(ErrorKind::domain, "refined: need separate residuals, got {}", specification);
  // The sets are coordinates of one set of points, and no scheme here mixes coordinates.
  const std::size_t sets = data.sets.size(), k = data.dimension;
  data::GridData<double> joined{{}, sets * k, data.axes};
  const std::size_t points = joined.points();
  joined.values.resize(points * sets * k);
  for (std::size_t s = 0; s < sets; ++s)
    for (std::size_t p = 0; p < points; ++p) std::copy_n(&data.sets[s][p * k], k, &joined.values[(p * sets + s) * k]);
  const data::GridData<double> fine = refine(joined, scheme, {levels, data::Boundary::regression, 1});
  Batch result{fine.axes, k, std::vector<std::vector<double>>(sets, std::vector<double>(fine.points() * k))};
  for (std::size_t s = 0; s < sets; ++s)
    for (std::size_t p = 0; p < fine.points(); ++p)
      std::copy_n(&fine.values[(p * sets + s) * k], k, &result.sets[s][p * k]);
  return result;
}

data::GridData<double> refined(const std::string& specification, const data::GridData<double>& data, int levels) {
  Batch fine = refined(specification, Batch{data.axes, data.dimension, {data.values}}, levels);
  return {std::move(fine.sets.front()), fine.dimension, fine.axes};
}

std::vector<double> parameters(const data::Axis& axis) {
  std::vector<double> result;
  for (std::size_t i = 0; i < axis.count; ++i) result.push_back(data::nearest_double(axis.parameter(i)));
  return result;
}

data::Axis finer(data::Axis axis, int factor) {
  const auto steps = static_cast<std::size_t>(factor);
  axis.count = axis.closed ? axis.count * steps : (axis.count - 1) * steps + 1;
  axis.step /= factor;
  return axis;
}

data::GridData<double> sampled(const std::vector<data::Axis>& axes, std::size_t dimension, const PointAt& point) {
  const auto xs = parameters(axes[0]), ys = axes.size() > 1 ? parameters(axes[1]) : std::vector<double>{0};
  data::GridData<double> result{{}, dimension, axes};
  for (const double y : ys)
    for (const double x : xs) {
      const auto p = point(x, y);
      result.values.insert(result.values.end(), p.begin(), p.begin() + static_cast<std::ptrdiff_t>(dimension));
    }
  return result;
}

std::vector<double> polygon_at(const data::GridData<double>& curve, const std::vector<double>& parameters) {
  const data::Axis& axis = curve.axes[0];
  const double first = data::nearest_double(axis.first), step = data::nearest_double(axis.step);
  const auto count = static_cast<long>(axis.count);
  std::vector<double> result;
  result.reserve(parameters.size() * curve.dimension);
  for (const double parameter : parameters) {
    const double place = (parameter - first) / step;
    long edge = static_cast<long>(std::floor(place));
    if (!axis.closed) edge = std::clamp(edge, 0L, count - 2);
    const auto left = static_cast<std::size_t>(modulo(edge, count));
    const std::size_t right = (left + 1) % axis.count;
    const double share = place - static_cast<double>(edge);
    for (std::size_t c = 0; c < curve.dimension; ++c)
      result.push_back((1 - share) * curve.values[left * curve.dimension + c] +
                       share * curve.values[right * curve.dimension + c]);
  }
  return result;
}

std::vector<double> mesh_at(const data::GridData<double>& surface, const std::vector<data::Axis>& finer) {
  // The rows are the points of a curve along the second axis.
  const std::size_t columns = surface.axes[0].count, width = columns * surface.dimension;
  const std::vector<double> rows = polygon_at({surface.values, width, {surface.axes[1]}}, parameters(finer[1])),
                            x = parameters(finer[0]);
  std::vector<double> result;
  for (std::size_t j = 0; j < finer[1].count; ++j) {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(j * width);
    const auto row = polygon_at(
        {std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(width)), surface.dimension, {surface.axes[0]}},
        x);
    result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

std::vector<double> distances(const std::vector<double>& first, const std::vector<double>& second,
                              std::size_t dimension) {
  std::vector<double> result(first.size() / dimension);
  for (std::size_t k = 0; k < result.size(); ++k) {
    double square = 0;
    for (std::size_t i = k * dimension; i < (k + 1) * dimension; ++i)
      square += (first[i] - second[i]) * (first[i] - second[i]);
    result[k] = std::sqrt(square);
  }
  return result;
}

double diameter(const std::vector<double>& points, std::size_t dimension) {
  double square = 0;
  for (std::size_t c = 0; c < dimension; ++c) {
    double least = points[c], largest = points[c];
    for (std::size_t i = c; i < points.size(); i += dimension) {
      least = std::min(least, points[i]);
      largest = std::max(largest, points[i]);
    }
    square += (largest - least) * (largest - least);
  }
  return std::sqrt(square);
}

double largest_distance(const std::vector<double>& first, const std::vector<double>& second, std::size_t dimension) {
  const auto all = distances(first, second, dimension);
  return *std::max_element(all.begin(), all.end());
}

double relative_distance(const std::vector<double>& values, const std::vector<double>& truth, std::size_t dimension) {
  return largest_distance(values, truth, dimension) / diameter(truth, dimension);
}

data::GridData<double> rounded(const data::GridData<Rational>& data) {
  data::GridData<double> result{{}, data.dimension, data.axes};
  for (const Rational& value : data.values) result.values.push_back(subcert::data::nearest_double(value));
  return result;
}

}  // namespace subcert::experiments
