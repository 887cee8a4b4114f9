#include "canonical_surface.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace subcert::atlas {
namespace {

using Points = std::vector<LatticePoint>;

long determinant(const LatticePoint& a, const LatticePoint& b) { return a[0] * b[1] - a[1] * b[0]; }

LatticePoint primitive(const LatticePoint& vector) {
  const long divisor = std::gcd(vector[0], vector[1]);
  return {vector[0] / divisor, vector[1] / divisor};
}

/// The s with s[0] e[0] + s[1] e[1] = 1. Domain: e is primitive.
LatticePoint bezout(const LatticePoint& e) {
  LatticePoint now{1, 0}, next{0, 1}, rest = e;
  while (rest[1] != 0) {
    const long quotient = rest[0] / rest[1];
    rest = {rest[1], rest[0] - quotient * rest[1]};
    now = std::exchange(next, {now[0] - quotient * next[0], now[1] - quotient * next[1]});
  }
  return rest[0] > 0 ? now : LatticePoint{-now[0], -now[1]};
}

/// The rows of the only T with determinant 1 or -1, T e = (1, 0) and T f = (p, q), 0 <= p < q. Domain: e is primitive,
/// f no multiple of it.
Points straightening(const LatticePoint& e, const LatticePoint& f) {
  LatticePoint first = bezout(e), second{-e[1], e[0]};
  if (determinant(e, f) < 0) second = {e[1], -e[0]};
  const long p = first[0] * f[0] + first[1] * f[1], q = second[0] * f[0] + second[1] * f[1];
  const long times = p / q - (p % q < 0 ? 1 : 0);
  return {{first[0] - times * second[0], first[1] - times * second[1]}, second};
}

/// Of a matrix with determinant 1 or -1.
Points inverse(const Points& t) {
  const long sign = determinant(t[0], t[1]);
  return {{sign * t[1][1], -sign * t[0][1]}, {-sign * t[1][0], sign * t[0][0]}};
}

/// The mask in the coordinates T x, with lowest exponents 0; nothing where its dilation is beyond what Dilation treats.
std::optional<LatticeMask> moved(const LatticeMask& mask, const Points& t) {
  std::vector<Monomial> terms;
  for (const LatticeMask::Term& term : mask.terms()) terms.push_back({term.coefficient, times(t, term.exponents)});
  const MultivariatePolynomial symbol(2, terms);
  const LatticePoint low = symbol.lowest();
  try {
    return LatticeMask(symbol.shifted({-low[0], -low[1]}),
                       Dilation(times(times(t, mask.dilation().rows()), inverse(t))));
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Of the support, or of that of two steps where it is on a line.
Points corners_of(const LatticeMask& mask) {
  Points support, two_steps;
  for (const LatticeMask::Term& term : mask.terms()) support.push_back(term.exponents);
  const Points corners = corners_of_hull(support);
  if (corners.size() >= 3) return corners;
  for (const LatticePoint& first : corners)
    for (const LatticePoint& second : corners) two_steps.push_back(first + mask.dilation() * second);
  return corners_of_hull(two_steps);
}

/// By area of the box, dilation, and coefficients; equal only for one mask.
auto order_of(const LatticeMask& mask) {
  const LatticePoint high = mask.symbol().highest();
  return std::tuple((high[0] + 1) * (high[1] + 1), mask.dilation().rows(), to_mask_text(mask));
}

}  // namespace

std::vector<LatticePoint> corners_of_hull(std::vector<LatticePoint> points) {
  std::ranges::sort(points);
  points.erase(std::ranges::unique(points).begin(), points.end());
  if (points.size() < 3) return points;
  Points hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const LatticePoint& point : points) {
      while (hull.size() >= begin + 2 && determinant(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

LatticeMask canonical_surface(const LatticeMask& mask) {
  require(mask.dimension() == 2 && mask.components() == 1, "canonical_surface: need numbers in two variables");
  const Points corners = corners_of(mask);
  if (corners.size() < 3)
    fail(ErrorKind::usage, "atlas: need a mask whose support is not on a line, got {}", to_mask_text(mask));
  std::optional<LatticeMask> best;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const LatticePoint after = corners[(k + 1) % corners.size()] - corners[k],
                       before = corners[(k + corners.size() - 1) % corners.size()] - corners[k];
    for (const auto& [e, f] : {std::pair(after, before), std::pair(before, after)}) {
      auto candidate = moved(mask, straightening(primitive(e), f));
      if (candidate && (!best || order_of(*candidate) < order_of(*best))) best = std::move(candidate);
    }
  }
  if (!best) fail(ErrorKind::size, "atlas: the dilation {} is too slanted", mask.dilation().to_text());
  return *best;
}

}  // namespace subcert::atlas
