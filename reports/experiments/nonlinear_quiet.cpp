// [MH, abstract and sec. 1.1, Figure 7]: data without noise.

#include "degree_study.hpp"
#include "families.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace subcert::experiments::nonlinear_quiet {
namespace {

constexpr int levels = 6;
const std::vector<int> windows{6, 7, 8};

/// A flower with five petals.
data::GridData<double> flower() {
  constexpr std::size_t count = 60;
  data::GridData<double> data{{}, 2, {data::Axis::of(count, true)}};
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / count, radius = 4 + std::cos(5 * t);
    data.values.insert(data.values.end(), {radius * std::cos(t), radius * std::sin(t)});
  }
  return data;
}

/// A star with ten edges of six parts.
data::GridData<double> star() {
  data::GridData<double> data{{}, 2, {data::Axis::of(60, true)}};
  const auto corner = [](int k) {
    const double t = std::numbers::pi * (0.5 + k / 5.0), radius = k % 2 == 0 ? 5 : 2.4;
    return std::array<double, 2>{radius * std::cos(t), radius * std::sin(t)};
  };
  for (int k = 0; k < 10; ++k)
    for (int part = 0; part < 6; ++part)
      for (std::size_t c = 0; c < 2; ++c)
        data.values.push_back(((6 - part) * corner(k)[c] + part * corner(k + 1)[c]) / 6);
  return data;
}

data::GridData<double> limit(const Method& method, const data::GridData<double>& data) {
  return refined(method.specification, data, levels);
}

/// The largest distance of the limit from the data at their parameters, over the diameter.
double distance_from_data(const data::GridData<double>& limit, const data::GridData<double>& data) {
  const auto all = distances(polygon_at(limit, parameters(data.axes[0])), data.values, data.dimension);
  return *std::max_element(all.begin(), all.end()) / diameter(data.values, data.dimension);
}

/// The extrema of both coordinates along a closed polygon, without those that the coordinate leaves by at most `height`
/// before it turns again.
std::size_t extrema(const data::GridData<double>& curve, double height) {
  const std::size_t points = curve.points();
  std::size_t result = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    int direction = 0;
    double extreme = curve.values[c];
    for (std::size_t i = 0; i < 2 * points; ++i) {  // the first round finds the direction at the start
      const double value = curve.values[2 * (i % points) + c];
      if (direction != 0 && (value - extreme) * direction >= 0) {
        extreme = value;
      } else if (std::abs(value - extreme) > height) {
        if (i >= points) ++result;
        direction = value > extreme ? 1 : -1;
        extreme = value;
      }
    }
  }
  return result;
}

constexpr double rounding = 1e-12;  ///< heights of rounding errors
/// Heights below this part of the diameter are not seen.
constexpr double visible = 1.0 / 200;

struct Shape {
  std::string name;
  data::GridData<double> data;
};

ExperimentResult run(const ExperimentOptions&) {
  const std::vector<Shape> shapes{{"flower", flower()}, {"star", star()}};
  ExperimentResult result{
      {"The data are not published. Two closed polygons with 60 vertices: r = 4 + cos 5t, and a star with ten straight "
       "edges. Schemes D_6, D_7, D_8 of degrees 1, 2, 3 with 6 iterations and delta = 1e-8, 6 levels. The limit at a "
       "vertex is that at its parameter."}};
  result.random = false;
  formats::PlainTable table{
      "nonlinear-fig7-distances",
      "Data without noise: largest distance of the limit from the vertices over the diameter, and extrema "
      "of both coordinates",
      {"polygon", "scheme", "distance", "extrema", "visible ones", "of the polygon", "visible ones"},
      {}};
  Evidence through, near, near_corners, kept, seen, better;
  for (const Shape& shape : shapes) {
    const double lowest = visible * diameter(shape.data.values, 2);
    const std::size_t wanted = extrema(shape.data, rounding), wanted_high = extrema(shape.data, lowest);
    for (const int points : windows) {
      double of_linear = 0;
      for (const int degree : {1, 2, 3}) {
        const Method method = robust_method(points, degree);
        const data::GridData<double> fine = limit(method, shape.data);
        const double distance = distance_from_data(fine, shape.data);
        const std::size_t all = extrema(fine, rounding), high = extrema(fine, lowest);
        const std::string name = shape.name + ", " + method.name;
        table.rows.push_back({shape.name, method.name, short_number(distance), std::to_string(all),
                              std::to_string(high), std::to_string(wanted), std::to_string(wanted_high)});
        if (degree == 1) {
          of_linear = distance;
          continue;
        }
        through.require(name, distance < 1e-6, short_number(distance));
        (shape.name == "flower" ? near : near_corners).require(name, distance < 0.01, short_number(distance));
        kept.require(name, all == wanted, std::to_string(all) + " of " + std::to_string(wanted));
        seen.require(name, high == wanted_high, std::to_string(high) + " of " + std::to_string(wanted_high));
        better.require(name, distance < of_linear, short_number(distance / of_linear));
      }
    }
  }
  const std::string measure = "largest distance of the limit from the vertices over the diameter, ";
  result.claims = {
      through.decides({"The schemes show interpolatory behaviour on data without noise: literally, limits pass through "
                       "the vertices.",
                       "Sec. 1.1, Fig. 7"},
                      measure + "below 1e-6", Verdict::not_confirmed),
      near.decides(
          {"Interpolatory behaviour on smooth data, read as: nearer than 1/100 of the diameter.", "Sec. 1.1, Fig. 7"},
          measure + "below 1/100"),
      near_corners.decides(
          {"Interpolatory behaviour on a polygon with corners, read as: nearer than 1/100 of the diameter.",
           "Sec. 1.1, Fig. 7"},
          measure + "below 1/100", Verdict::not_confirmed),
      kept.decides(
          {"Although not interpolatory, the schemes preserve the shape of the initial polygon.", "Abstract, Fig. 7"},
          "the limit has as many extrema of its coordinates as the polygon", Verdict::not_confirmed),
      seen.decides(
          {"The schemes preserve the shape of the initial polygon, but for what cannot be seen.", "Abstract, Fig. 7"},
          "the same count without extrema that are lower than 1/200 of the diameter"),
      better.decides(
          {"The schemes of non-linear polynomials perform better than those of linear ones, on data without noise.",
           "Abstract, Fig. 7"},
          "largest distance from the vertices, smaller than with degree 1 on as many data; the ratio")};
  formats::Figure figure{"nonlinear-fig7", "Data without noise", "", 3, {}};
  for (const Shape& shape : shapes)
    for (const int degree : {1, 2, 3}) {
      const Method method = robust_method(6, degree);
      figure.panels.push_back(
          {method.name,
           "",
           "",
           {drawn_points("data", shape.data, "#5a6773"), drawn_line("limit", limit(method, shape.data), "#0b559f")},
           false,
           "below",
           true});
    }
  result.tables.push_back(table);
  result.figures.push_back(figure);
  return result;
}

}  // namespace

std::vector<Experiment> all() { return {{"nonlinear-fig7", "mustafa-hameed", "Figure 7: data without noise", run}}; }

}  // namespace subcert::experiments::nonlinear_quiet
