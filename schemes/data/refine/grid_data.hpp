#pragma once
/// Points on uniform grids: curves, surfaces and volumes in one container.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <cstddef>
#include <vector>

namespace subcert::data {

/// One direction of a grid. Parameters count in spacings of the first data, so that datum j of these is at j, and the
/// domain is [0, length]. Canonical: count >= 1, step > 0.
struct Axis {
  std::size_t count;
  bool closed;      ///< the first point follows the last
  Rational length;  ///< count for closed first data, count - 1 for open ones; refinement keeps it
  Rational first = 0;
  Rational step = 1;

  /// The axis of first data.
  static Axis of(std::size_t count, bool closed = false) {
    return {count, closed, closed ? Rational(count) : Rational(count) - 1};
  }
  /// The first point follows the last from now on, one step away.
  void close() {
    if (!closed) length += step;
    closed = true;
  }
  Rational parameter(std::size_t i) const { return first + step * Rational(i); }
};

/// Points with `dimension` coordinates on a grid of one to three axes. Coordinate c of the point (i, j, k) is
/// values[((k * axes[1].count + j) * axes[0].count + i) * dimension + c].
/// Canonical: dimension >= 1, values.size() == points() * dimension.
template <class Number>
struct GridData {
  std::vector<Number> values;
  std::size_t dimension = 1;
  std::vector<Axis> axes;

  std::size_t points() const {
    std::size_t product = 1;
    for (const Axis& axis : axes) product *= axis.count;
    return product;
  }
  bool is_canonical() const { return dimension >= 1 && !axes.empty() && values.size() == points() * dimension; }
};

/// A sequence of points: one axis. Domain: dimension >= 1 divides values.size().
template <class Number>
GridData<Number> curve_data(std::vector<Number> values, std::size_t dimension = 1, bool closed = false) {
  const std::size_t count = values.size() / dimension;
  return {std::move(values), dimension, {Axis::of(count, closed)}};
}

}  // namespace subcert::data
