#include "data_figure.hpp"

#include <subcert/schemes/data/refine/axis_refinement.hpp>

namespace subcert::formats {

Curve data_curve(const data::GridData<double>& data, const std::string& label, bool joined) {
  const std::size_t k = data.dimension, count = data.points();
  Curve result{label, {}, !joined, joined};
  for (std::size_t i = 0; i < count + (joined && data.axes[0].closed && k > 1 ? 1 : 0); ++i) {
    const double* point = data.values.data() + (i % count) * k;
    if (k == 1)
      result.points.emplace_back(data::nearest_double(data.axes[0].parameter(i)), point[0]);
    else
      result.points.emplace_back(point[0], point[1]);
  }
  return result;
}

}  // namespace subcert::formats
