#include "interpolation.hpp"

#include "axis_refinement.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>

#include <algorithm>

namespace subcert::data {

std::vector<double> interpolate(const GridData<double>& curve, const std::vector<Rational>& parameters) {
  require(curve.is_canonical() && curve.axes.size() == 1 && curve.dimension == 1 && curve.points() >= 2,
          "interpolate: need at least two points of one coordinate");
  const Axis& axis = curve.axes[0];
  const auto count = static_cast<long>(axis.count);
  const auto at = [&](long i) { return curve.values[static_cast<std::size_t>(modulo(i, count))]; };
  std::vector<double> result;
  for (const Rational& parameter : parameters) {
    const Rational place = (parameter - axis.first) / axis.step;
    const long left = floor_index(place);
    const long i = axis.closed ? left : std::clamp(left, 0L, count - 2);
    const double t = nearest_double(place - i);
    result.push_back((1 - t) * at(i) + t * at(i + 1));
  }
  return result;
}

}  // namespace subcert::data
