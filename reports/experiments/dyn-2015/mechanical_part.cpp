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

PointGrid mechanical_part(std::size_t refinement) {
  const auto unit = static_cast<double>(refinement);
  return sampled_grid(48 * refinement + 1, 80 * refinement + 1, 3, [unit](double i, double j) {
    const double x = i / unit - 24, y = j / unit - 40;
    return std::array{x, y, part_height(x, y)};
  });
}

}  // namespace subcert::experiments::dyn_2015
