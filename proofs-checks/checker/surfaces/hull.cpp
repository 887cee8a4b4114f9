#include "hull.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

constexpr std::int64_t max_reach = 64;  // of an index

std::int64_t remainder(std::int64_t x, std::int64_t m) { return (x % m + m) % m; }

std::int64_t ceiling_of(std::int64_t x, std::int64_t m) { return (x + remainder(-x, m)) / m; }

}  // namespace

LatticeMask lattice_mask(const Mask& mask, const Dilation& dilation) {
  const std::int64_t m = dilation.rows[0][0];
  require(m > 1 && dilation.rows == Matrix{{{m, 0, 0}, {0, m, 0}, {0, 0, 1}}},
          "the dilation around a vertex is no multiple of the unit matrix of two variables");
  LatticeMask result{m, {}, mask.denominator};
  for (std::size_t i = 0; i < mask.points(); ++i) {
    if (mask.coefficients[i] == 0) continue;
    const mpz_class place[]{mask.first[0] + i % mask.sizes[0], mask.first[1] + i / mask.sizes[0]};
    Point k{};
    for (std::size_t v = 0; v < 2; ++v) {
      require(abs(place[v]) <= max_reach, "an index of the mask is too large");
      k[v] = place[v].get_si();
    }
    result.coefficients[k] = mask.coefficients[i];
  }
  return result;
}

mpz_class LatticeMask::at(const Point& k) const {
  const auto place = coefficients.find(k);
  return place == coefficients.end() ? mpz_class(0) : place->second;
}

std::set<Point> LatticeMask::window() const {
  Point low = coefficients.begin()->first, high = low;
  for (const auto& [k, value] : coefficients)
    for (std::size_t v = 0; v < 2; ++v) {
      low[v] = std::min(low[v], k[v]);
      high[v] = std::max(high[v], k[v]);
    }
  std::set<Point> window;
  const auto meets = [&](std::int64_t k, std::size_t v) {
    return k * (arity - 1) > -high[v] && (k - 1) * (arity - 1) < -low[v];
  };
  for (std::int64_t x = -max_reach; x <= max_reach + 1; ++x)
    for (std::int64_t y = -max_reach; y <= max_reach + 1; ++y)
      if (meets(x, 0) && meets(y, 1)) window.insert({x, y, 0});
  for (;;) {
    std::set<Point> next;
    for (const Point& p : window)
      for (const auto& [k, value] : coefficients)
        next.insert({ceiling_of(p[0] - k[0], arity), ceiling_of(p[1] - k[1], arity), 0});
    if (next == window) return window;
    window = std::move(next);
  }
}

LatticeMask LatticeMask::of_differences(std::size_t axis) const {
  LatticeMask result{arity, {}, denominator};
  std::int64_t end = -max_reach;
  for (const auto& [k, value] : coefficients) end = std::max(end, k[axis]);
  std::set<Point> places;
  for (const auto& [k, value] : coefficients)
    for (Point p = k; p[axis] <= end; ++p[axis]) places.insert(p);
  std::map<Point, mpz_class> sums;
  for (const Point& p : places) {  // along the axis one after another
    mpz_class value = at(p) * arity;
    Point q = p;
    for (std::int64_t j = 1; j < arity; ++j) {
      --q[axis];
      value -= result.at(q);
    }
    if (value == 0) continue;
    require(p[axis] <= end - (arity - 1), "the mask does not refine differences along an axis");
    require(value > 0, "a coefficient of the scheme of the differences is negative");
    sums[{remainder(p[0], arity), remainder(p[1], arity), 0}] += value;
    result.coefficients[p] = value;
  }
  require(sums.size() == static_cast<std::size_t>(arity * arity) &&
              std::ranges::all_of(sums, [&](const auto& sum) { return sum.second == denominator; }),
          "the scheme of the differences does not keep constants");
  return result;
}

}  // namespace subcert_check
