#include "local_windows.hpp"

#include "linear_smoother.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace subcert::data {
namespace {

/// The first number from `from` on, at most `last`, for which `before` no longer holds. Domain: it holds up to there.
template <class Before>
std::size_t first_after(std::size_t from, std::size_t last, const Before& before) {
  std::size_t step = 1;
  while (from < last && before(std::min(last, from + step) - 1)) {
    from = std::min(last, from + step);
    step *= 2;
  }
  std::size_t end = std::min(last, from + step);
  while (from < end) {
    const std::size_t middle = from + (end - from) / 2;
    if (before(middle))
      from = middle + 1;
    else
      end = middle;
  }
  return from;
}

}  // namespace

LocalWindows::LocalWindows(const ExtendedData& data, Boundary boundary, const LocalPolynomial& method)
    : weight_(method.weight),
      degree_(static_cast<std::size_t>(method.degree)),
      kinds_(data.kinds()),
      points_(method.points * kinds_),
      width_(method.width) {
  require(method.is_complete(), "smoothing: need points or a width for local polynomials");
  std::vector<long> low, high;
  if (boundary != Boundary::regression) {
    low = indices_beyond(data, -1);
    high = indices_beyond(data, 1);
  }
  const std::size_t count = low.size() + data.count() + high.size();
  bool consecutive = true;
  positions_.reserve(count);
  const auto add = [&](long index) {
    if (!positions_.empty()) repeated_ = repeated_ || positions_.back() == data.position(index);
    positions_.push_back(data.position(index));
    if (!consecutive) indices_.push_back(index);
  };
  std::ranges::reverse(low);
  before_ = static_cast<long>(low.size());
  shift_ = (kinds_ - low.size() % kinds_) % kinds_;
  consecutive = low.empty() || low.front() == -before_;
  if (!high.empty() && high.back() != static_cast<long>(data.count() + high.size()) - 1) consecutive = false;
  for (long i = 0; consecutive && data.weighted() && i < static_cast<long>(data.count()); ++i)
    consecutive = data.is_present(i);
  if (!consecutive) indices_.reserve(count);
  for (const long index : low) add(index);
  for (long i = 0; i < static_cast<long>(data.count()); ++i)
    if (data.is_present(i)) add(i);
  for (const long index : high) add(index);
}

/// The data past an end, the nearest first, that a window about a position at this end may hold.
std::vector<long> LocalWindows::indices_beyond(const ExtendedData& data, long step) const {
  const auto last = static_cast<long>(data.count()) - 1;
  const double end = step < 0 ? 0 : data.position(last);
  std::vector<long> indices;
  std::size_t different = 0;
  double before = std::numeric_limits<double>::quiet_NaN();
  const std::size_t most = most_smoothed_values + 4 * (data.count() + points_);
  long index = step < 0 ? -1 : last + 1;
  for (std::size_t seen = 0; seen < most; ++seen, index += step) {
    if (!data.is_present(index)) continue;
    const double at = data.position(index);
    if (points_ == 0 && std::abs(at - end) > width_) return indices;
    indices.push_back(index);
    different += at != before ? 1 : 0;
    before = at;
    const bool whole = data.order(step < 0 ? index : index + 1) == 0;  // all data of this position are taken
    if (points_ > 0 && indices.size() >= points_ && different > degree_ + 1 && whole) return indices;
  }
  if (points_ == 0)
    fail(ErrorKind::size, "smoothing: need at most {} data past an end in a window, got more in the width {}", most,
         width_);
  return indices;
}

double LocalWindows::factor(const Window& window, std::size_t k) const {
  if (window.radius == 0) return 1;
  return distance_factor(weight_, std::abs(positions_[k] - window.position) / window.radius);
}

void LocalWindows::nodes_and_factors(const Window& window, std::vector<double>& nodes,
                                     std::vector<double>& factors) const {
  const std::size_t count = window.end - window.first;
  const double unit = window.radius > 0 ? window.radius : 1;
  nodes.resize(count);
  factors.assign(count, 1);
  const double* const at = positions_.data() + window.first;
  for (std::size_t k = 0; k < count; ++k) nodes[k] = (at[k] - window.position) / unit;
  if (window.radius == 0) return;
  const auto set = [&](const auto& factor) {
    for (std::size_t k = 0; k < count; ++k) factors[k] = factor(std::abs(nodes[k]));
  };
  // One loop for each, without branches.
  switch (weight_) {
    case LocalWeight::box: return;
    case LocalWeight::triangle: return set([](double u) { return distance_factor(LocalWeight::triangle, u); });
    case LocalWeight::epanechnikov: return set([](double u) { return distance_factor(LocalWeight::epanechnikov, u); });
    case LocalWeight::biweight: return set([](double u) { return distance_factor(LocalWeight::biweight, u); });
    case LocalWeight::tricube: return set([](double u) { return distance_factor(LocalWeight::tricube, u); });
  }
}

void LocalWindows::take_all_within(Window& window) const {
  while (window.first > 0 && window.position - positions_[window.first - 1] <= window.radius) --window.first;
  while (window.end < count() && positions_[window.end] - window.position <= window.radius) ++window.end;
}

LocalWindows::Window LocalWindows::nearest(double position, std::size_t from) const {
  const std::size_t points = std::min(points_, count());
  const std::size_t first = first_after(from, count() - points, [&](std::size_t k) {
    return positions_[k + points] - position < position - positions_[k];
  });
  Window window{position, first, first + points, 0};
  window.radius = std::max(std::abs(position - positions_[first]), std::abs(positions_[window.end - 1] - position));
  take_all_within(window);
  return window;
}

LocalWindows::Window LocalWindows::within(double position, const Window& before) const {
  const std::size_t first = first_after(before.first, count(),
                                        [&](std::size_t k) { return position - positions_[k] > width_; });
  const std::size_t end = first_after(std::max(before.end, first), count(),
                                      [&](std::size_t k) { return positions_[k] - position <= width_; });
  return {position, first, end, width_};
}

LocalWindows::Window LocalWindows::at(double position, const Window& before) const {
  if (points_ == 0) return within(position, before);
  Window window = nearest(position, before.first);
  if (!repeated_) return window;
  // Data at one position are one condition on the polynomial: then the window grows until it has enough others.
  constexpr double none = std::numeric_limits<double>::infinity();
  while (!determines(window) && (window.first > 0 || window.end < count())) {
    const double left = window.first > 0 ? position - positions_[window.first - 1] : none;
    const double right = window.end < count() ? positions_[window.end] - position : none;
    window.radius = std::min(left, right);
    take_all_within(window);
  }
  return window;
}

}  // namespace subcert::data
