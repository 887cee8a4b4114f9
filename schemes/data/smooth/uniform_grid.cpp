
#include "uniform_grid.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace subcert::data {
namespace {

/// The power of ten of the last digit of the shortest text.
long last_place(double value) {
  char text[32];
  const char* const end = std::to_chars(text, text + sizeof text, value).ptr;
  const char* const power = std::find(static_cast<const char*>(text), end, 'e');
  const char* const point = std::find(static_cast<const char*>(text), power, '.');
  long exponent = point == power ? 0 : -(power - point - 1);
  if (power != end) {
    long shift = 0;
    const char* const digits = power + (power[1] == '+' ? 2 : 1);
    std::from_chars(digits, end, shift);
    exponent += shift;
  }
  return exponent;
}

long double rounded_twice(const Rational& value) {
  const double high = nearest_double(value);
  return static_cast<long double>(high) + nearest_double(Rational(value - Rational(high)));
}

}  // namespace

Rational decimal_value(double value) {
  const auto decimal = parse_decimal(shortest_text(value));
  return decimal ? decimal->value : Rational(value);
}

namespace {

/// The first of the spacings that are farthest from the mean, of which doubles find the few that may be. `rounding`: of
/// a spacing's distance in double precision.
std::size_t farthest_spacing(const std::vector<double>& positions, const Rational& mean, double rounding) {
  const double rounded_mean = nearest_double(mean);
  const auto distance = [&](std::size_t i) { return std::abs(positions[i + 1] - positions[i] - rounded_mean); };
  double largest = 0;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) largest = std::max(largest, distance(i));
  std::size_t worst = 0;
  Rational exact_largest = -1;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
    if (distance(i) < largest - 2 * rounding) continue;
    const Rational exact = abs(decimal_value(positions[i + 1]) - decimal_value(positions[i]) - mean);
    if (exact <= exact_largest) continue;
    exact_largest = exact;
    worst = i;
  }
  return worst;
}

}  // namespace

UniformGrid uniform_grid(const std::vector<double>& positions) {
  require(!positions.empty(), "uniform_grid: need a position");
  UniformGrid grid{decimal_value(positions.front())};
  const std::size_t count = positions.size();
  if (count == 1) return grid;
  const Rational mean = (decimal_value(positions.back()) - grid.origin) / Rational(count - 1);
  grid.spacing = mean;
  long place = std::numeric_limits<long>::max();
  for (const double x : positions) place = std::min(place, last_place(x));
  const double largest = std::max(std::abs(positions.front()), std::abs(positions.back()));
  const Rational allowed = std::min(power(Rational(10), place), Rational(mean / 20)) +
                           decimal_value(largest) * power(Rational(2), -48);
  // In double precision deviations are off by less than 8 units of 2^-53 of the largest position.
  const double origin = positions.front(), spacing = nearest_double(mean), rounding = largest * 0x1p-50 + 0x1p-1070;
  const double limit = nearest_double(allowed), margin = limit * 0x1p-50 + rounding;
  for (std::size_t i = 0; grid.uniform && i < count; ++i) {
    const double off = std::abs(positions[i] - origin - spacing * static_cast<double>(i));
    if (off <= limit - margin) continue;
    grid.uniform = off <= limit + margin &&
                   abs(decimal_value(positions[i]) - grid.origin - mean * Rational(i)) <= allowed;
  }
  if (!grid.uniform) grid.worst = farthest_spacing(positions, mean, rounding);
  return grid;
}

GridCheck::GridCheck(Rational origin, Rational spacing)
    : origin_(std::move(origin)),
      spacing_(std::move(spacing)),
      rounded_origin_(nearest_double(origin_)),
      rounded_spacing_(nearest_double(spacing_)) {}

bool GridCheck::accepts(double position) {
  if (const long place = last_place(position); place < place_) {
    place_ = place;
    allowed_ = std::min(power(Rational(10), place), Rational(spacing_ / 20));
  }
  const auto index = static_cast<double>(count_++);
  // The deviation in double precision is off by less than 8 units of 2^-53 of the largest number in it.
  const double part = rounded_spacing_ * index, off = std::abs(position - rounded_origin_ - part);
  const double largest = std::max({std::abs(position), std::abs(rounded_origin_), std::abs(part)});
  if (off <= nearest_double(allowed_) * (1 - 0x1p-50) - largest * 0x1p-50) return true;
  return abs(decimal_value(position) - expected()) <=
         allowed_ + decimal_value(std::abs(position)) * power(Rational(2), -48);
}

GridPositions::GridPositions(Rational origin, const Rational& spacing, std::size_t scale)
    : origin_(std::move(origin)),
      step_(spacing / Rational(scale)),
      rounded_origin_(rounded_twice(origin_)),
      rounded_step_(rounded_twice(step_)) {}

double GridPositions::at(std::size_t index) const {
  // Five roundings, each of at most half a unit in the last place of a number not above `size`.
  const long double part = rounded_step_ * static_cast<long double>(index), sum = rounded_origin_ + part;
  const long double size = std::abs(rounded_origin_) + std::abs(part);
  const long double error = 4 * std::numeric_limits<long double>::epsilon() * size;
  const auto low = static_cast<double>(sum - error), high = static_cast<double>(sum + error);
  if (low == high && size > 0x1p-900L) return low;
  return nearest_double(Rational(origin_ + step_ * Rational(index)));
}

DataSites Samples::sites() const {
  DataSites sites{count(), weights};
  const double unit = nearest_double(spacing);
  sites.derivatives = derivatives;
  const std::size_t kinds = count() / std::max<std::size_t>(1, rows());
  if (!uniform() || kinds > 1) sites.positions.reserve(count());
  for (std::size_t i = 0; i < (uniform() && kinds == 1 ? 0 : rows()); ++i)
    sites.positions.insert(sites.positions.end(), kinds,
                           uniform() ? static_cast<double>(i) : (positions[i] - positions.front()) / unit);
  return sites;
}

std::optional<Rational> common_spacing(const std::vector<double>& positions) {
  require(!positions.empty(), "common_spacing: need a position");
  if (positions.size() < 2) return std::nullopt;
  std::vector<double> gaps;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) gaps.push_back(positions[i + 1] - positions[i]);
  std::vector<double> sorted = gaps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
  std::ranges::nth_element(sorted, middle);
  const double rounding = std::max(std::abs(positions.front()), std::abs(positions.back())) * 0x1p-50;
  const auto is_common = [&](double gap) { return std::abs(gap - *middle) <= rounding; };
  if (2 * std::ranges::count_if(gaps, is_common) < std::ssize(gaps)) return std::nullopt;
  const auto i = static_cast<std::size_t>(std::ranges::find_if(gaps, is_common) - gaps.begin());
  const Rational common = decimal_value(positions[i + 1]) - decimal_value(positions[i]);
  const Rational length = decimal_value(positions.back()) - decimal_value(positions.front());
  if (common <= 0 || length > 2 * common * Rational(static_cast<long>(positions.size()))) return std::nullopt;
  return common;
}

UniformGrid Samples::put_at(std::vector<double> x) {
  const bool once = std::ranges::adjacent_find(x) == x.end();
  std::vector<double> different;
  if (!once) std::ranges::unique_copy(x, std::back_inserter(different));
  const std::vector<double>& places = once ? x : different;
  UniformGrid grid = uniform_grid(places);
  origin = grid.origin;
  spacing = grid.uniform ? grid.spacing : common_spacing(places).value_or(grid.spacing);
  (grid.uniform && once ? given : positions) = std::move(x);
  return grid;
}

bool Samples::repeated() const { return std::ranges::adjacent_find(positions) != positions.end(); }

std::vector<PositionGroup> groups_of_positions(const std::vector<double>& positions) {
  std::vector<PositionGroup> groups;
  for (std::size_t first = 0, end = 0; first < positions.size(); first = end) {
    while (end < positions.size() && positions[end] == positions[first]) ++end;
    groups.push_back({first, end});
  }
  return groups;
}

double mean_of(const std::vector<double>& data, const std::vector<double>& weights, const PositionGroup& group,
               double sum) {
  if (group.end == group.first + 1) return data[group.first];
  double mean = 0;
  for (std::size_t k = group.first; k < group.end; ++k)
    if (const double weight = weights.empty() ? 1 : weights[k]; weight > 0) mean += weight / sum * data[k];
  return mean;
}

Samples merged(const Samples& samples) {
  Samples one = samples;
  const std::vector<PositionGroup> groups = groups_of_positions(samples.positions);
  const std::vector<double> weights = samples.rounded_weights();
  one.weights.assign(groups.size(), 0);
  one.positions.clear();
  for (auto& column : one.columns) column.clear();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t k = groups[g].first; k < groups[g].end; ++k)
      one.weights[g] += samples.weights.empty() ? Rational(1) : samples.weights[k];
    for (std::size_t c = 0; c < samples.columns.size(); ++c)
      one.columns[c].push_back(mean_of(samples.columns[c], weights, groups[g], nearest_double(one.weights[g])));
    one.positions.push_back(samples.positions[groups[g].first]);
  }
  return one;
}

PositionOrder order_of(const std::vector<double>& positions) {
  PositionOrder order;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!std::isnan(positions[i])) order.rows.push_back(i);
  const auto at = [&](std::size_t row) { return positions[row]; };
  order.rising = std::ranges::is_sorted(order.rows, {}, at);
  if (!order.rising) {
    std::ranges::reverse(order.rows);
    order.falling = std::ranges::is_sorted(order.rows, {}, at);
    if (!order.falling) std::ranges::reverse(order.rows);
    std::ranges::stable_sort(order.rows, {}, at);
  }
  const auto found = std::ranges::adjacent_find(order.rows, {}, at);
  if (found != order.rows.end()) order.repeated = static_cast<std::size_t>(found - order.rows.begin()) + 1;
  return order;
}

void Samples::drop_missing() {
  if (weights.empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0) continue;
    for (auto& column : columns) column[kept] = column[i];
    positions[kept] = positions[i];
    weights[kept++] = weights[i];
  }
  require(kept > 0, "Samples: need a positive weight");
  for (auto& column : columns) column.resize(kept);
  positions.resize(kept);
  weights.resize(kept);
  origin = decimal_value(positions.front());
}

std::vector<double> Samples::rounded_weights() const {
  std::vector<double> rounded;
  for (const Rational& weight : weights) rounded.push_back(nearest_double(weight));
  return rounded;
}

}  // namespace subcert::data
