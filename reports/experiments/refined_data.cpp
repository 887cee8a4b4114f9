#include "refined_data.hpp"

#include "batch.hpp"

#include <subcert/analysis/symbol/index_arithmetic.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::experiments {
namespace {

double as_double(const Rational& value) { return value.convert_to<double>(); }

formats::Curve drawn(const std::string& label, const data::GridData<double>& data, bool joined,
                     const std::string& colour) {
  formats::Curve result{label, {}, !joined, joined, colour};
  const std::size_t points = data.points();
  for (std::size_t k = 0; k < points + (joined && data.axes[0].closed && data.dimension > 1); ++k) {
    const double* point = data.values.data() + k % points * data.dimension;
    if (data.dimension == 1)
      result.points.emplace_back(as_double(data.axes[0].parameter(k)), point[0]);
    else
      result.points.emplace_back(point[0], point[1]);
  }
  return result;
}

}  // namespace

data::GridData<double> refined(const std::string& specification, const data::GridData<double>& data, int levels) {
  Batch fine = refined(specification, Batch{data.axes, data.dimension, {data.values}}, levels);
  return {std::move(fine.sets.front()), fine.dimension, fine.axes};
}

std::vector<double> polygon_at(const data::GridData<double>& curve, const std::vector<double>& parameters) {
  const data::Axis& axis = curve.axes[0];
  const double first = as_double(axis.first), step = as_double(axis.step);
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

const std::string pale = "#9aa5b1";

formats::Curve drawn_points(const std::string& label, const data::GridData<double>& data, const std::string& colour) {
  return drawn(label, data, false, colour);
}

formats::Curve drawn_line(const std::string& label, const data::GridData<double>& data, const std::string& colour) {
  return drawn(label, data, true, colour);
}

formats::DrawnSurface drawn_surface(const std::string& title, const data::GridData<double>& surface) {
  const data::Axis &x = surface.axes[0], &y = surface.axes[1];
  formats::DrawnSurface result{title, x.count, y.count, x.closed, y.closed, {}, surface.dimension == 1};
  for (std::size_t j = 0; j < y.count; ++j)
    for (std::size_t i = 0; i < x.count; ++i) {
      const double* value = surface.values.data() + (j * x.count + i) * surface.dimension;
      if (result.heights)
        result.points.push_back({as_double(x.parameter(i)), as_double(y.parameter(j)), value[0]});
      else
        result.points.push_back({value[0], value[1], value[2]});
    }
  return result;
}

data::GridData<double> rounded(const data::GridData<Rational>& data) {
  data::GridData<double> result{{}, data.dimension, data.axes};
  for (const Rational& value : data.values) result.values.push_back(as_double(value));
  return result;
}

void Evidence::require(const std::string& name, bool holds, const std::string& numbers) {
  holds_ = holds_ && holds;
  numbers_ += (numbers_.empty() ? "" : "; ") + name + (name.empty() ? "" : ": ") + numbers;
}

}  // namespace subcert::experiments
