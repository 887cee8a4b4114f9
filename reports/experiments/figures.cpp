#include "figures.hpp"

#include <subcert/schemes/data/refine/axis_refinement.hpp>

namespace subcert::experiments {

Points points_of(const data::GridData<double>& data) {
  Points result;
  for (std::size_t k = 0; k < data.points(); ++k) {
    const double* point = &data.values[k * data.dimension];
    if (data.dimension == 1)
      result.emplace_back(data::nearest_double(data.axes[0].parameter(k)), point[0]);
    else
      result.emplace_back(point[0], point[1]);
  }
  return result;
}

Points line_of(const data::GridData<double>& data) {
  Points result = points_of(data);
  if (data.axes[0].closed && data.dimension > 1) result.push_back(result.front());
  return result;
}

Points over_steps(const std::vector<double>& values, double step) {
  Points result;
  for (const double value : values) result.emplace_back(step * static_cast<double>(result.size()), value);
  return result;
}

formats::Curve dots(const std::string& label, Points points, const std::string& colour) {
  return {.label = label, .points = std::move(points), .joined = false, .colour = colour};
}

formats::Curve line(const std::string& label, Points points, const std::string& colour) {
  return {.label = label, .points = std::move(points), .colour = colour};
}

formats::Panel plain_panel(const std::string& title, std::vector<formats::Curve> curves, bool equal_units) {
  return {.title = title,
          .x_label = "",
          .y_label = "",
          .curves = std::move(curves),
          .key = "below",
          .equal_units = equal_units};
}

formats::DrawnSurface drawn_surface(const std::string& title, const data::GridData<double>& surface, std::size_t keep) {
  const data::Axis &x = surface.axes[0], &y = surface.axes[1];
  formats::DrawnSurface result{title, (x.count + keep - 1) / keep, (y.count + keep - 1) / keep, x.closed, y.closed,
                               {},    surface.dimension == 1};
  for (std::size_t j = 0; j < y.count; j += keep)
    for (std::size_t i = 0; i < x.count; i += keep) {
      const double* value = &surface.values[(j * x.count + i) * surface.dimension];
      if (result.heights)
        result.points.push_back({data::nearest_double(x.parameter(i)), data::nearest_double(y.parameter(j)), value[0]});
      else
        result.points.push_back({value[0], value[1], value[2]});
    }
  return result;
}

data::GridData<double> placed(data::GridData<double> data, const Rational& origin, const Rational& scale) {
  for (data::Axis& axis : data.axes) {
    axis.first = origin + scale * axis.first;
    axis.step *= scale;
  }
  return data;
}

}  // namespace subcert::experiments
