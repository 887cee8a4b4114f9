// [DHHS15, sec. 5.1, Figures 14 to 17]: curves in the plane from noisy points.

#include "limit_trial.hpp"
#include "parts.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace subcert::experiments::dyn_2015 {
namespace {

using Curve = data::GridData<double>;

double x_of(const Curve& c, std::size_t i) { return c.values[2 * i]; }
double y_of(const Curve& c, std::size_t i) { return c.values[2 * i + 1]; }

/// Twice the area of the triangle of three points of a curve, with its sign.
double orientation(const Curve& c, std::size_t i, std::size_t j, std::size_t k) {
  return (x_of(c, j) - x_of(c, i)) * (y_of(c, k) - y_of(c, i)) - (y_of(c, j) - y_of(c, i)) * (x_of(c, k) - x_of(c, i));
}

/// Pairs of edges of the open polygon that cross properly. Cost: a comparison for each pair whose ranges of x meet.
std::size_t crossings(const Curve& c) {
  struct Edge {
    std::size_t begin;
    double low, high;
  };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i + 1 < c.points(); ++i) {
    const auto [low, high] = std::minmax({x_of(c, i), x_of(c, i + 1)});
    edges.push_back({i, low, high});
  }
  std::ranges::sort(edges, {}, &Edge::low);
  std::size_t result = 0;
  for (auto one = edges.begin(); one != edges.end(); ++one)
    for (auto other = one + 1; other != edges.end() && other->low <= one->high; ++other) {
      const auto [i, j] = std::minmax({one->begin, other->begin});
      result += j > i + 1 && orientation(c, i, i + 1, j) * orientation(c, i, i + 1, j + 1) < 0 &&
                orientation(c, j, j + 1, i) * orientation(c, j, j + 1, i + 1) < 0;
    }
  return result;
}

double crossings_kept(const TrialSample& s) { return crossings(s.limit) == crossings(s.truth); }

/// The sum of the moduli of the angles between edges of the open polygon.
double total_turning(const Curve& limit) {
  double result = 0;
  for (std::size_t i = 0; i + 2 < limit.points(); ++i) {
    const double ux = x_of(limit, i + 1) - x_of(limit, i), uy = y_of(limit, i + 1) - y_of(limit, i),
                 vx = x_of(limit, i + 2) - x_of(limit, i + 1), vy = y_of(limit, i + 2) - y_of(limit, i + 1);
    result += std::abs(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy));
  }
  return result;
}

double turning_of_limit(const TrialSample& s) { return total_turning(s.limit); }

/// 1 where the closed polygon turns to one side only, else 0.
double convex(const TrialSample& s) {
  const std::size_t count = s.limit.points();
  bool left = false, right = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = orientation(s.limit, i, (i + 1) % count, (i + 2) % count);
    left = left || turn > 0;
    right = right || turn < 0;
  }
  return !(left && right);
}

/// The smallest distance from the origin over the largest.
double roundness(const TrialSample& s) {
  const Curve& limit = s.limit;
  double least = INFINITY, largest = 0;
  for (std::size_t i = 0; i < limit.points(); ++i) {
    const double radius = std::hypot(x_of(limit, i), y_of(limit, i));
    least = std::min(least, radius);
    largest = std::max(largest, radius);
  }
  return least / largest;
}

/// "phi(0) of S_3" and the like, rounded from the exact values. Where a limit is nearer to the noisy samples than to
/// the exact ones is seen from them alone: the residuals at the samples and the errors there have the same bias, and
/// away from the ends the variances 1 - 2 phi(0) + psi(0) and psi(0), times that of the noise.
void add_values_at_zero(Measured& result, const std::vector<std::string>& schemes) {
  for (const std::string& scheme : schemes)
    result.numbers["phi(0) of " + scheme_name(scheme)] = data::nearest_double(
        limit_values(make_scheme(scheme).mask.curve(), 0).at(0));
}

}  // namespace

Measured alpha_curve(const Run& run) {
  constexpr std::size_t points = 30;
  const LimitTrial trial{.title = "Alpha curve",
                         .axes = {data::Axis::of(points)},
                         .dimension = 2,
                         .shape =
                             [](double i, double) {
                               const double t = -1.4 + 2.8 * i / (points - 1);
                               return std::array{3 * std::pow(t, 4) + t * t + 1, std::pow(t, 5) - 2 * t, 0.0};
                             },
                         .level = 3,
                         .decibels = {17, 4},
                         .schemes = {"primal:n=3", "primal:n=5"},
                         .measures = {{"relative error", point_error},
                                      {"total turning", turning_of_limit},
                                      {"crossings kept", crossings_kept},
                                      {"from samples", square_to_noisy},
                                      {"from curve", square_to_exact},
                                      {"squared bias", squared_bias},
                                      {"from noise", squared_noise}},
                         .factor = run.number("decibel"),
                         .ends = data::parse_boundary(run.chosen("ends of the curve")).value()};
  Measured result = trial.measured(run);
  const Curve truth = trial.truth();
  result.numbers = {{"crossings", crossings(truth)}, {"total turning", total_turning(truth)}};
  add_values_at_zero(result, trial.schemes);
  if (!run.is_alternative()) result.figures = {trial.curves_figure(run)};
  return result;
}

Measured star(const Run& run) {
  constexpr std::size_t points = 50;
  const LimitTrial trial{
      .title = "Star",
      .axes = {data::Axis::of(points, true)},
      .dimension = 2,
      .shape =
          [](double i, double) {
            const double t = 2 * std::numbers::pi * i / points;
            return std::array{4 * std::cos(t) + std::cos(4 * t), 4 * std::sin(t) - std::sin(4 * t), 0.0};
          },
      .level = 3,
      .decibels = {19, 10},
      .schemes = {"primal:n=3", "primal:n=5", "primal:n=4,d=3", "primal:n=6,d=3"},
      .measures = {{"relative error", point_error},
                   {"smallest / largest radius", roundness},
                   {"total turning", turning_of_limit},
                   {"convex", convex},
                   {"from samples", square_to_noisy},
                   {"from curve", square_to_exact},
                   {"squared bias", squared_bias},
                   {"from noise", squared_noise}},
      .factor = run.number("decibel")};
  Measured result = trial.measured(run);
  result.numbers = {{"middle", (0.6 + std::cos(std::numbers::pi / 5)) / 2}};  // of a star and a pentagon
  add_values_at_zero(result, trial.schemes);
  if (!run.is_alternative()) result.figures = {trial.curves_figure(run)};
  return result;
}

}  // namespace subcert::experiments::dyn_2015
