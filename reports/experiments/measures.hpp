#pragma once
/// What experiments on points in the plane and in space share: coordinates, noise, errors, tables of means.

#include "experiment.hpp"
#include "linear_method.hpp"
#include "statistics.hpp"

#include <array>
#include <span>

namespace subcert::experiments {

using Coordinate = std::vector<double>;

/// As [DHHS15] names it: primal:n=4,d=3 is S_4^3. Other specifications stay as they are.
std::string scheme_name(const std::string& specification);

/// The deviation in each coordinate that gives the ratio `decibel` for all coordinates together.
double noise_deviation(std::span<const Coordinate> samples, double decibel);

/// Adds independent normal noise to every coordinate.
void add_noise(std::span<Coordinate> samples, double sigma, std::mt19937_64& engine);

/// The norm of the difference over the norm of the truth, all coordinates together.
double relative_error(std::span<const Coordinate> values, std::span<const Coordinate> truth);

/// Low and high noise in decibel.
using TwoLevels = std::array<double, 2>;

/// A number for each sample: [scheme][low or high noise][run].
using Measured = std::vector<std::array<std::vector<double>, 2>>;
Measured empty_measure(std::size_t schemes, std::size_t runs);

formats::PlainTable measures_table(const std::string& id, const std::string& title,
                                   const std::vector<std::string>& schemes, const TwoLevels& decibels,
                                   const std::vector<std::pair<std::string, const Measured*>>& columns);

/// Whether each of `good` has smaller errors than each of `bad` at this level of noise, by the paired differences.
struct Dominance {
  bool shown;
  std::string numbers;
};
Dominance dominance(const Measured& error, std::size_t noise, const std::vector<std::string>& schemes,
                    const std::vector<std::size_t>& good, const std::vector<std::size_t>& bad);

}  // namespace subcert::experiments
