#pragma once
/// Points in the plane and in space by their coordinates: noise and errors, all coordinates together.

#include <subcert/reports/experiments/statistics.hpp>

#include <span>

namespace subcert::experiments::dyn_2015 {

using Coordinate = std::vector<double>;

/// As [DHHS15] names it: primal:n=4,d=3 is S_4^3. Other specifications stay as they are.
std::string scheme_name(const std::string& specification);

/// The deviation in each coordinate that gives the ratio `decibel` for all coordinates together.
double noise_deviation(std::span<const Coordinate> samples, double decibel);

/// Adds independent normal noise to every coordinate.
void add_noise(std::span<Coordinate> samples, double sigma, std::mt19937_64& engine);

/// The norm of the difference over the norm of the truth.
double relative_error(std::span<const Coordinate> values, std::span<const Coordinate> truth);

}  // namespace subcert::experiments::dyn_2015
