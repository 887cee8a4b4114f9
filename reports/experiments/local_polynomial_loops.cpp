// Loops over many numbers, compiled for speed.
#include "local_polynomial.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace subcert::experiments {
namespace {

/// The weights of data around an output, `phase` steps after a datum: 1, x and x^2 times the kernel, x in steps.
struct Window {
  Window(const std::vector<double>& kernel, long steps, long phase) {
    const long wide = static_cast<long>(kernel.size()) - 1;
    first = -((wide - phase) / steps);
    for (long away = first * steps - phase; away <= wide; away += steps) {
      const double weight = kernel[static_cast<std::size_t>(std::abs(away))], x = static_cast<double>(away);
      zeroth.push_back(weight);
      weighted.push_back(weight * x);
      squared.push_back(weight * x * x);
    }
  }

  long first;  ///< place of the first weight, from the datum
  std::vector<double> zeroth, weighted, squared;
};

/// The sums of local linear fits at neighbouring outputs of one phase, side by side so that none waits for another.
struct LocalSums {
  static constexpr long lanes = 4;

  double s0[lanes] = {}, s1[lanes] = {}, s2[lanes] = {}, t0[lanes] = {}, t1[lanes] = {};

  void add(std::size_t lane, const Window& window, std::size_t k, double y) {
    s0[lane] += window.zeroth[k];
    s1[lane] += window.weighted[k];
    s2[lane] += window.squared[k];
    t0[lane] += window.zeroth[k] * y;
    t1[lane] += window.weighted[k] * y;
  }

  void add_to_all(const Window& window, std::size_t k, const double* y) {
    const double zeroth = window.zeroth[k], weighted = window.weighted[k], squared = window.squared[k];
    for (long l = 0; l < lanes; ++l) s0[l] += zeroth;
    for (long l = 0; l < lanes; ++l) s1[l] += weighted;
    for (long l = 0; l < lanes; ++l) s2[l] += squared;
    for (long l = 0; l < lanes; ++l) t0[l] += zeroth * y[l];
    for (long l = 0; l < lanes; ++l) t1[l] += weighted * y[l];
  }

  std::array<double, lanes> fits() const {
    std::array<double, lanes> result;
    for (std::size_t l = 0; l < lanes; ++l)
      result[l] = (s2[l] * t0[l] - s1[l] * t1[l]) / (s0[l] * s2[l] - s1[l] * s1[l]);
    return result;
  }
};

/// Of the outputs after the data at place, place + 1, ..., each from the first datum of its window to the last. Lanes
/// beyond the last datum hold anything.
LocalSums sums_from(const std::vector<double>& data, long place, const Window& window) {
  constexpr long lanes = LocalSums::lanes;
  const long count = static_cast<long>(window.zeroth.size()), size = static_cast<long>(data.size());
  const auto begin = [&](long lane) { return std::max(0L, -(place + lane + window.first)); };
  const auto end = [&](long lane) {
    return std::max(begin(lane), std::min(count, size - (place + lane + window.first)));
  };
  // What all lanes have.
  const long from = begin(0), to = std::max(from, end(lanes - 1));
  LocalSums sums;
  const auto add = [&](long lane, long k) {
    sums.add(static_cast<std::size_t>(lane), window, static_cast<std::size_t>(k),
             data[static_cast<std::size_t>(place + lane + window.first + k)]);
  };
  for (long lane = 1; lane < lanes; ++lane)
    for (long k = begin(lane); k < std::min(from, end(lane)); ++k) add(lane, k);
  for (long k = from; k < to; ++k)
    sums.add_to_all(window, static_cast<std::size_t>(k), data.data() + place + window.first + k);
  for (long lane = 0; lane < lanes; ++lane)
    for (long k = std::max(to, begin(lane)); k < end(lane); ++k) add(lane, k);
  return sums;
}

}  // namespace

std::vector<double> local_linear(const std::vector<double>& data, double bandwidth, int level) {
  require(data.size() >= 2 && bandwidth >= 0.1, "local_linear: need two data and a bandwidth >= 1/10, got {}",
          bandwidth);
  const long steps = 1L << level, last = static_cast<long>(data.size()) - 1,
             wide = std::lround(std::ceil(std::max(2.0, kernel_reach * bandwidth) * static_cast<double>(steps)));
  std::vector<double> kernel;
  for (long k = 0; k <= wide; ++k)
    kernel.push_back(std::exp(-std::pow(static_cast<double>(k) / static_cast<double>(steps) / bandwidth, 2) / 2));
  std::vector<double> result(static_cast<std::size_t>(last * steps) + 1);
  for (long phase = 0; phase < steps; ++phase) {
    const Window window(kernel, steps, phase);
    const long end = phase == 0 ? last : last - 1;
    for (long place = 0; place <= end; place += LocalSums::lanes) {
      const auto fits = sums_from(data, place, window).fits();
      for (long l = 0; l < LocalSums::lanes && place + l <= end; ++l)
        result[static_cast<std::size_t>((place + l) * steps + phase)] = fits[static_cast<std::size_t>(l)];
    }
  }
  return result;
}

std::vector<double> DenseMatrix::operator*(const std::vector<double>& data) const {
  std::vector<double> result(rows());
  const auto multiply = [&]<std::size_t together>(std::integral_constant<std::size_t, together>, std::size_t r) {
    const double* row = entries_.data() + r * columns_;
    double sums[together] = {};
    for (std::size_t c = 0; c < columns_; ++c)
      for (std::size_t l = 0; l < together; ++l) sums[l] += row[l * columns_ + c] * data[c];
    std::copy(sums, sums + together, &result[r]);
  };
  std::size_t r = 0;
  // Side by side, so that no sum waits for another.
  for (; r + 4 <= result.size(); r += 4) multiply(std::integral_constant<std::size_t, 4>(), r);
  for (; r < result.size(); ++r) multiply(std::integral_constant<std::size_t, 1>(), r);
  return result;
}

}  // namespace subcert::experiments
