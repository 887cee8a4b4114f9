#include "measures.hpp"

#include <cmath>

namespace subcert::experiments::dyn_2015 {

std::string scheme_name(const std::string& specification) {
  const std::string prefix = "primal:n=";
  if (!specification.starts_with(prefix)) return specification;
  const std::size_t comma = specification.find(",d=");
  std::string name = "S_" + specification.substr(prefix.size(), comma - prefix.size());
  if (comma != std::string::npos) name += "^" + specification.substr(comma + 3);
  return name;
}

double noise_deviation(std::span<const Coordinate> samples, double decibel) {
  double square = 0;
  for (const Coordinate& coordinate : samples) square += mean_square(coordinate) / static_cast<double>(samples.size());
  return experiments::noise_deviation(square, decibel);
}

void add_noise(std::span<Coordinate> samples, double sigma, std::mt19937_64& engine) {
  for (Coordinate& coordinate : samples) {
    const auto noise = normal_noise(engine, coordinate.size());
    for (std::size_t i = 0; i < coordinate.size(); ++i) coordinate[i] += sigma * noise[i];
  }
}

double relative_error(std::span<const Coordinate> values, std::span<const Coordinate> truth) {
  double error = 0, norm = 0;
  for (std::size_t c = 0; c < truth.size(); ++c)
    for (std::size_t i = 0; i < truth[c].size(); ++i) {
      error += (values[c][i] - truth[c][i]) * (values[c][i] - truth[c][i]);
      norm += truth[c][i] * truth[c][i];
    }
  return std::sqrt(error / norm);
}

}  // namespace subcert::experiments::dyn_2015
