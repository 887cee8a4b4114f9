#include "degree_study.hpp"

#include <subcert/schemes/data/runtime/parallel.hpp>

#include <algorithm>

namespace subcert::experiments {
namespace {

std::string specification(int points, int degree, bool grid) {
  const std::string side = std::to_string(points);
  return "l1:points=" + side + (grid ? "x" + side : "") + ",d=" + std::to_string(degree);
}

std::string name(const std::string& letter, int points, int degree) {
  return letter + "_" + std::to_string(points) + "^" + std::to_string(degree);
}

constexpr std::size_t share = 24;  // samples that are refined together, an even number

/// The mean squared distance at the data that are the same with and without outliers.
double distance_from_data(const data::GridData<double>& limit, const OutlierCase& what, const OutlierSample& data) {
  const auto at_data = polygon_at(limit, parameters(what.axes[0]));
  const auto outlying = distances(data.with, data.without, what.dimension);
  const auto left = distances(at_data, data.with, what.dimension);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (outlying[i] == 0) {
      sum += left[i] * left[i];
      ++count;
    }
  return sum / static_cast<double>(count);
}

}  // namespace

Method robust_method(int points, int degree, bool grid) {
  return {name("D", points, degree), specification(points, degree, grid)};
}

Method least_squares_method(int points, int degree, bool grid) {
  return {name("S", points, degree), specification(points, degree, grid) + ",iterations=0"};
}

ErrorParts error_parts(const OutlierCase& what, const Method& method, const ExperimentOptions& options) {
  const std::size_t pairs = std::max<std::size_t>(2, options.runs / 2), samples = 2 * pairs;
  ErrorParts parts{std::vector<double>(pairs), std::vector<double>(pairs), std::vector<double>(samples)};
  runtime::parallel_for_each((samples + share - 1) / share, options.jobs, [&](std::size_t task) {
    const std::size_t first = task * share, count = std::min(share, samples - first);
    const Batch drawn = drawn_samples(what, options.seed, first, count);
    Batch with{drawn.axes, drawn.dimension, {}};
    for (std::size_t k = 0; k < count; ++k) with.sets.push_back(drawn.sets[2 * k + 1]);
    Batch fine = refined(method.specification, with, what.levels);
    const std::vector<double> truth = true_points(what, fine.axes);
    const double points = static_cast<double>(truth.size() / what.dimension);
    for (std::size_t k = 0; k < count; ++k) {
      if (what.axes.size() == 1)
        parts.from_data[first + k] = distance_from_data({fine.sets[k], what.dimension, fine.axes}, what,
                                                        {drawn.sets[2 * k], drawn.sets[2 * k + 1]});
      for (std::size_t i = 0; i < truth.size(); ++i) fine.sets[k][i] -= truth[i];
    }
    for (std::size_t k = 0; k < count; k += 2)
      for (std::size_t i = 0; i < truth.size(); ++i) {
        const double e = fine.sets[k][i], f = fine.sets[k + 1][i];
        parts.squared_bias[(first + k) / 2] += e * f / points;
        parts.variance[(first + k) / 2] += (e - f) * (e - f) / 2 / points;
      }
  });
  return parts;
}

NamedMean paired(const std::string& name, const std::vector<double>& first, const std::vector<double>& second,
                 double factor) {
  std::vector<double> scaled(second);
  for (double& value : scaled) value *= factor;
  return {name, mean_difference(first, scaled)};
}

}  // namespace subcert::experiments
