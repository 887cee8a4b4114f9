#include "cell_range.hpp"

#include <subcert/analysis/outward_rounding/outward.hpp>

#include <limits>

namespace subcert {
namespace {

using namespace outward;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Span {
  double lower, upper;
};

/// Values on |u| <= 1/2 of sum of (c[j] +- r[j]) u^j.
Span polynomial_span(const std::vector<double>& c, const std::vector<double>& r) {
  double low = 0, high = 0, error = 0;
  for (std::size_t j = c.size(); j-- > 1;) {
    const double term = std::ldexp(std::abs(c[j]), -static_cast<int>(j));
    if (j % 2 == 1 || c[j] < 0) low += term;
    if (j % 2 == 1 || c[j] > 0) high += term;
    error += std::ldexp(r[j], -static_cast<int>(j));
  }
  const double centre_error = up(r.empty() ? 0 : r[0]) + (c.empty() ? 0 : std::abs(c[0]) * 0x1p-50);
  const double centre = c.empty() ? 0 : c[0];
  return {centre - up(up(low) + up(error) + centre_error), centre + up(up(high) + up(error) + centre_error)};
}

}  // namespace

CellRange range_of(const CellParts& parts) {
  const std::vector<double>&c = parts.middle, &r = parts.radius;
  CellRange range{};
  range.remainder = up(parts.value_rest + std::max(parts.square_below, parts.square_above));
  const Span value = polynomial_span(c, r);
  const auto outward = [](double low, double high, double margin) {
    const double room = up(margin + (std::abs(low) + std::abs(high)) * 0x1p-50);
    return Span{low - room, high + room};
  };
  const Span all = outward(value.lower - parts.square_below, value.upper + parts.square_above, parts.value_rest);
  range.value_lower = all.lower;
  range.value_upper = all.upper;
  double value_error = 0, slope_error = 0;
  for (std::size_t j = r.size(); j-- > 0;) {
    value_error += half_power(j) * r[j];
    slope_error += 2 * static_cast<double>(j) * half_power(j) * r[j];
  }
  range.value_rounding = 2 * value_error / (range.value_upper - range.value_lower);
  double odd = 0, odd_error = 0, even = 0, even_error = 0, sizes = 0;
  for (std::size_t j = c.size(); j-- > 0;) {
    const double term = std::ldexp(c[j], -static_cast<int>(j)), error = std::ldexp(r[j], -static_cast<int>(j));
    (j % 2 == 1 ? odd : even) += term;
    (j % 2 == 1 ? odd_error : even_error) += up(error + gamma(c.size()) * std::abs(term));
    sizes += std::abs(term);
  }
  const double end_error = up(odd_error + even_error + parts.value_slack + gamma(4) * sizes);
  const Span left = outward(even - odd - parts.square_below, even - odd + parts.square_above, end_error);
  const Span right = outward(even + odd - parts.square_below, even + odd + parts.square_above, end_error);
  range.left_lower = left.lower;
  range.left_upper = left.upper;
  range.right_lower = right.lower;
  range.right_upper = right.upper;
  // What slack and square do to the mean slope over the cell is bounded by their slopes, too.
  double loose = up(up(2 * parts.value_slack + parts.square_below + parts.square_above) * parts.speed);
  if (parts.slopes) loose = std::min(loose, up(parts.slope_slack + parts.square_slope));
  const double rise = up(2 * odd_error) < 2 * std::abs(odd)
                          ? down((2 * std::abs(odd) - up(2 * odd_error)) * parts.speed) - loose
                          : 0;
  range.steepness = std::max(0.0, down(rise));
  if (parts.slopes) {
    std::vector<double> d, e;
    for (std::size_t j = 1; j < c.size(); ++j) {
      const auto factor = static_cast<double>(j);
      d.push_back(factor * c[j]);
      e.push_back(up(factor * r[j] + std::abs(factor * c[j]) * 0x1p-50));
    }
    const Span slope = polynomial_span(d, e);
    const Span moved = outward(slope.lower * parts.speed, slope.upper * parts.speed,
                               parts.slope_rest + parts.square_slope);
    range.slope_lower = moved.lower;
    range.slope_upper = moved.upper;
    range.steepness = std::max({range.steepness, range.slope_lower, -range.slope_upper});
    range.slope_rounding = 2 * slope_error * parts.speed / (range.slope_upper - range.slope_lower);
    range.square_share = parts.square_slope == 0 ? 0 : 2 * parts.square_slope / (range.slope_upper - range.slope_lower);
  } else {
    range.slope_lower = -infinite;
    range.slope_upper = infinite;
  }
  const double square = parts.square_below + parts.square_above;
  if (square > 0) range.square_share = std::max(range.square_share, square / (range.value_upper - range.value_lower));
  return range;
}

}  // namespace subcert
