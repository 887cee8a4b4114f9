#include "mechanical_part.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::experiments::dyn_2015 {
namespace {

/// 0 before `from`, 1 after `to`, with a continuous slope between.
double rise(double t, double from, double to) {
  const double s = std::clamp((t - from) / (to - from), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

/// The upper half of a circle about 0.
double half_circle(double t, double radius) { return std::sqrt(std::max(0.0, radius * radius - t * t)); }

}  // namespace

double part_height(double x, double y) {
  const double groove = half_circle(y - 28, 4);
  double height = 6 * rise(y, 13, 16) - groove;
  const double to_boss = std::hypot(x - 3, y + 14), foot = 3 * std::pow(std::clamp((17 - to_boss) / 5, 0.0, 1.0), 2);
  height += foot + 9 * (1 - rise(to_boss, 9.5, 12.5)) - 8 * (1 - rise(to_boss, 3.5, 6.5));
  return height + half_circle(x + 18, 4) * (1 - rise(std::abs(y + 12), 20, 22));
}

std::vector<data::Axis> part_axes() { return {data::Axis::of(49), data::Axis::of(81)}; }

std::array<double, 3> part_point(double i, double j) { return {i - 24, j - 40, part_height(i - 24, j - 40)}; }

}  // namespace subcert::experiments::dyn_2015
