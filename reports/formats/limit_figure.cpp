
#include "limit_figure.hpp"

#include <subcert/analysis/limit/field_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::formats {
namespace {

constexpr double points_of_surface = 20'000, points_of_curve = 2'000;

/// How gnuplot is told to print these characters as they are.
std::string verbatim(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string("@^_{}&~").find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string title_of(const std::string& title, DrawnLimit what, int level) {
  return verbatim(title) +
         (what == DrawnLimit::values ? "" : ": unit sequence after " + std::to_string(level) + " steps");
}

/// The largest level with at most `most` points in an interval or box of this size, at least 1.
int largest_level(double size, double factor, double most) {
  return std::max(1, static_cast<int>(std::log(most / size) / std::log(factor)));
}

bool keeps_axes(const std::vector<LatticePoint>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const LatticePoint& row) {
    return std::count(row.begin(), row.end(), 0) + 1 == static_cast<std::ptrdiff_t>(row.size());
  });
}

int level_of_surface(const LatticeMask& mask) {
  double area = 1;
  for (const Interval& side : limit_support(mask)) area *= std::max(1.0, side.width().convert_to<double>());
  const Dilation& dilation = mask.dilation();
  const int last = largest_level(area, static_cast<double>(dilation.classes()), points_of_surface);
  int chosen = last;
  std::vector<LatticePoint> power{{1, 0}, {0, 1}};  // columns of M^level
  for (int level = 1; level <= last; ++level) {
    for (LatticePoint& column : power) column = dilation * column;
    if (level + 3 >= last && keeps_axes(power)) chosen = level;
  }
  return chosen;
}

/// Exact values where they are asked for and not too many.
template <class Exact, class Delta>
auto drawn_values(DrawnLimit& what, Exact exact, Delta delta) {
  if (what == DrawnLimit::values) try {
      return exact();
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::size) throw;
      what = DrawnLimit::refined_delta;
    }
  return delta();
}

LimitValues refined_delta(const Mask& mask, int level) {
  LaurentPolynomial refined(1);
  for (long n = 0, factor = 1; n < level; ++n, factor *= mask.arity()) refined *= mask.symbol().dilated(factor);
  return {mask.arity(), level, 0, refined.lowest(), refined.coefficients()};
}

}  // namespace

DrawnSurface limit_surface(const LatticeMask& mask, const std::string& title, DrawnLimit what) {
  require(mask.dimension() == 2, "limit_surface: need two variables, got {}", mask.dimension());
  const int level = level_of_surface(mask);
  const LatticeSequence values = drawn_values(
      what, [&] { return limit_values(mask, level); }, [&] { return subcert::refined_delta(mask, level); });
  LatticePoint low = values.begin()->first, high = low;
  LatticeSequence heights = values;  // and zeros around
  for (const auto& [point, value] : values)
    for (const LatticePoint& near : points_of_box({point[0] - 1, point[1] - 1}, {point[0] + 1, point[1] + 1})) {
      heights.emplace(near, 0);
      for (std::size_t v = 0; v < 2; ++v) {
        low[v] = std::min(low[v], near[v]);
        high[v] = std::max(high[v], near[v]);
      }
    }
  DrawnSurface surface{title_of(title, what, level),
                       static_cast<std::size_t>(high[0] - low[0] + 1),
                       static_cast<std::size_t>(high[1] - low[1] + 1),
                       false,
                       false,
                       {},
                       true};
  std::vector<std::vector<Rational>> columns{{1, 0}, {0, 1}};  // of M^-level
  for (std::vector<Rational>& column : columns)
    for (int n = 0; n < level; ++n) column = mask.dilation().inverse_times(column);
  for (const LatticePoint& index : points_of_box(low, high)) {
    const auto coordinate = [&](std::size_t v) {
      return Rational(index[0] * columns[0][v] + index[1] * columns[1][v]).convert_to<double>();
    };
    const auto height = heights.find(index);
    surface.points.push_back(
        {coordinate(0), coordinate(1), height == heights.end() ? std::nan("") : height->second.convert_to<double>()});
  }
  return surface;
}

Panel limit_panel(const Mask& mask, const std::string& title, DrawnLimit what, int order) {
  const Interval support = limit_support(mask);
  const int level = largest_level(support.width().convert_to<double>(), mask.arity(), points_of_curve);
  const LimitValues values = order > 0 ? limit_values(mask, level, order)
                                       : drawn_values(
                                             what, [&] { return limit_values(mask, level); },
                                             [&] { return refined_delta(mask, level); });
  Curve curve{"", {}};
  for (std::size_t i = 0; i < values.values.size(); ++i)
    curve.points.emplace_back(values.point(i).convert_to<double>(), values.values[i].convert_to<double>());
  return {title_of(title, what, level), "x", "", {curve}};
}

Panel vector_panel(const LatticeMask& mask, const std::optional<QuadraticMask>& meant, const LatticeSequence& values,
                   const std::string& title) {
  constexpr long bits = 64;
  const Interval support = limit_support(mask).front();
  const int level = largest_level(support.width().convert_to<double>(), mask.arity(),
                                  points_of_curve / static_cast<double>(mask.components()));
  const double scale = std::pow(mask.arity(), -level);
  Panel panel{verbatim(title), "x", "", {}};
  for (std::size_t c = 0; c < mask.components(); ++c)
    panel.curves.push_back({"phi_" + std::to_string(c + 1), {{support.lower.convert_to<double>(), 0}}});
  long index = floor_index(support.lower * power(Rational(mask.arity()), level)) + 1;
  const long last = ceil_index(support.upper * power(Rational(mask.arity()), level));
  const FieldValues finer = limit_values(mask, meant, values, level);
  for (; index < last; ++index) {
    const auto at = finer.find({index});
    for (std::size_t c = 0; c < mask.components(); ++c)
      panel.curves[c].points.emplace_back(static_cast<double>(index) * scale,
                                          at == finer.end() ? 0 : rounded(at->second[c], bits).convert_to<double>());
  }
  for (Curve& curve : panel.curves) curve.points.emplace_back(support.upper.convert_to<double>(), 0);
  return panel;
}

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
