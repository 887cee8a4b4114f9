// [DHHS15, sec. 5.2, Figures 18 to 21]: surfaces from noisy points.

#include "limit_trial.hpp"
#include "mechanical_part.hpp"
#include "parts.hpp"

#include <cmath>
#include <numbers>

namespace subcert::experiments::dyn_2015 {
namespace {

/// With pictures of samples and limits.
Measured measured_and_drawn(const LimitTrial& trial, const std::string& samples_id, const Run& run) {
  Measured result = trial.measured(run);
  if (!run.is_alternative())
    result.surface_figures = {trial.samples_figure(samples_id, run), trial.surfaces_figure(run)};
  return result;
}

/// The mean distance of the points of the limit from the torus.
double distance_from_torus(const TrialSample& s) {
  double sum = 0;
  for (std::size_t i = 0; i < s.limit.values.size(); i += 3) {
    const double* const p = &s.limit.values[i];
    sum += std::abs(std::hypot(std::hypot(p[0], p[1]) - 10, p[2]) - 5);
  }
  return sum / static_cast<double>(s.limit.points());
}

/// How often a closed polygon goes round the origin; `at(i)` are its `count` points.
template <typename At>
long winding(std::size_t count, const At& at) {
  double turned = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [x, y] = at(i);
    const auto [u, v] = at((i + 1) % count);
    turned += std::atan2(x * v - y * u, x * u + y * v);
  }
  return std::lround(turned / (2 * std::numbers::pi));
}

/// 1 where each parallel of the limit goes once round the axis and each meridian, in the coordinates of distance from
/// the axis and height, once round its own centre; else 0.
double torus_kept(const TrialSample& s) {
  const std::size_t parallel = s.limit.axes[0].count, meridian = s.limit.axes[1].count;
  const auto point = [&](std::size_t i, std::size_t j) { return &s.limit.values[3 * (j * parallel + i)]; };
  for (std::size_t j = 0; j < meridian; ++j)
    if (winding(parallel, [&](std::size_t i) { return std::array{point(i, j)[0], point(i, j)[1]}; }) != 1) return 0;
  for (std::size_t i = 0; i < parallel; ++i) {
    const auto at = [&](std::size_t j) {
      const double* const p = point(i, j);
      return std::array{std::hypot(p[0], p[1]), p[2]};
    };
    std::array<double, 2> centre{};
    for (std::size_t j = 0; j < meridian; ++j)
      for (std::size_t c = 0; c < 2; ++c) centre[c] += at(j)[c] / static_cast<double>(meridian);
    if (winding(meridian, [&](std::size_t j) { return std::array{at(j)[0] - centre[0], at(j)[1] - centre[1]}; }) != 1)
      return 0;
  }
  return 1;
}

}  // namespace

Measured torus(const Run& run) {
  constexpr std::size_t points = 24;
  return measured_and_drawn({.title = "Torus",
                             .axes = {data::Axis::of(points, true), data::Axis::of(points, true)},
                             .dimension = 3,
                             .shape =
                                 [](double i, double j) {
                                   constexpr double step = 2 * std::numbers::pi / points;
                                   const double u = step * i, v = step * j, radius = 10 + 5 * std::cos(v);
                                   return std::array{std::cos(u) * radius, std::sin(u) * radius, 5 * std::sin(v)};
                                 },
                             .level = 1,
                             .decibels = {15, 6},
                             .schemes = {"primal:n=3", "primal:n=5"},
                             .measures = {{"relative error", point_error},
                                          {"error up to size", shape_error},
                                          {"normals (degrees)", normal_error},
                                          {"distance from torus", distance_from_torus},
                                          {"torus kept", torus_kept},
                                          {"error of samples", sample_error},
                                          {"error of samples up to size", sample_shape_error}},
                             .factor = run.number("decibel")},
                            "fig18", run);
}

Measured mechanical_part(const Run& run) {
  return measured_and_drawn({.title = "Mechanical part",
                             .axes = part_axes(),
                             .dimension = 3,
                             .shape = part_point,
                             .level = 1,
                             .decibels = {24, 18},
                             .schemes = {"primal:n=3", "primal:n=5", "primal:n=4,d=3", "primal:n=6,d=3"},
                             .measures = {{"relative error", point_error}, {"normals (degrees)", normal_error}}},
                            "fig20", run);
}

}  // namespace subcert::experiments::dyn_2015
