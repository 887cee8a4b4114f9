// [MH, abstract and sec. 1.1, Figure 7]: data without noise.

#include "parts.hpp"

#include <subcert/reports/experiments/figures.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace subcert::experiments::mustafa_hameed {
namespace {

constexpr std::size_t vertices = 60;

/// A flower with five petals.
std::array<double, 3> flower(double i, double) {
  const double t = 2 * std::numbers::pi * i / vertices, radius = 4 + std::cos(5 * t);
  return {radius * std::cos(t), radius * std::sin(t)};
}

/// A star with ten edges of six parts.
std::array<double, 3> star(double i, double) {
  const auto corner = [](double k) {
    const double t = std::numbers::pi * (0.5 + k / 5), radius = std::fmod(k, 2) == 0 ? 5 : 2.4;
    return std::array{radius * std::cos(t), radius * std::sin(t)};
  };
  const double edge = std::floor(i / 6), part = i - 6 * edge;
  const auto from = corner(edge), to = corner(edge + 1);
  return {((6 - part) * from[0] + part * to[0]) / 6, ((6 - part) * from[1] + part * to[1]) / 6};
}

data::GridData<double> limit_of(const Method& method, const data::GridData<double>& data) {
  return refined(method.specification, data, 6);
}

/// The extrema of both coordinates along a closed polygon, without those that the coordinate leaves by at most `height`
/// before it turns again.
std::size_t extrema(const data::GridData<double>& curve, double height) {
  std::size_t result = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    int direction = 0;
    double extreme = curve.values[c];
    for (const bool counts : {false, true})  // the first round finds the direction at the start
      for (std::size_t i = c; i < curve.values.size(); i += 2) {
        const double value = curve.values[i];
        if (direction != 0 && (value - extreme) * direction >= 0) {
          extreme = value;
        } else if (std::abs(value - extreme) > height) {
          result += counts;
          direction = value > extreme ? 1 : -1;
          extreme = value;
        }
      }
  }
  return result;
}

constexpr double rounding = 1e-12;  ///< heights of rounding errors
/// Heights below this part of the diameter are not seen.
constexpr double visible = 1.0 / 100;

struct Polygon {
  std::string name;
  data::GridData<double> data;
};

/// Distances from the vertices and extrema of the limits, all schemes.
void compare_with_polygon(Measured& measured, const Polygon& polygon, formats::PlainTable& table) {
  const double lowest = visible * diameter(polygon.data.values, 2);
  const std::size_t wanted = extrema(polygon.data, rounding), wanted_high = extrema(polygon.data, lowest);
  for (const int points : {6, 7, 8}) {
    double of_linear = 0;
    for (const int degree : {1, 2, 3}) {
      const Method method = l1_method(points, degree);
      const data::GridData<double> fine = limit_of(method, polygon.data);
      const double distance = relative_distance(polygon_at(fine, parameters(polygon.data.axes[0])), polygon.data.values,
                                                2);
      const std::size_t all = extrema(fine, rounding), high = extrema(fine, lowest);
      const std::string name = polygon.name + ", " + method.name, shown = short_number(distance);
      table.rows.push_back({polygon.name, method.name, shown, std::to_string(all), std::to_string(high),
                            std::to_string(wanted), std::to_string(wanted_high)});
      if (degree == 1) {
        of_linear = distance;
        continue;
      }
      measured.add_fact("near the " + polygon.name, name, distance < 0.01, shown);
      measured.add_fact("visible extrema", name, high == wanted_high,
                        std::to_string(high) + " of " + std::to_string(wanted_high));
      measured.add_fact("better", name, distance < of_linear, short_number(distance / of_linear));
    }
  }
}

}  // namespace

Measured data_without_noise(const Run&) {
  formats::PlainTable table{
      "nonlinear-fig7-distances",
      "Data without noise: largest distance of the limit from the vertices over the diameter, and extrema of both "
      "coordinates",
      {"polygon", "scheme", "distance", "extrema", "visible ones", "of the polygon", "visible ones"},
      {}};
  formats::Figure figure{"nonlinear-fig7", "Data without noise", "", 3, {}};
  Measured result;
  const std::vector<data::Axis> axes{data::Axis::of(vertices, true)};
  for (const Polygon& polygon :
       {Polygon{"flower", sampled(axes, 2, flower)}, Polygon{"star", sampled(axes, 2, star)}}) {
    compare_with_polygon(result, polygon, table);
    for (const Method& method : {l1_method(6, 1), l1_method(6, 2), l1_method(6, 3)})
      figure.panels.push_back(plain_panel(method.name,
                                          {dots("data", points_of(polygon.data), colour::dark),
                                           line("limit", line_of(limit_of(method, polygon.data)), colour::blue)},
                                          true));
  }
  result.tables = {table};
  result.figures = {figure};
  return result;
}

}  // namespace subcert::experiments::mustafa_hameed
