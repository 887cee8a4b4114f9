#include "samples.hpp"

#include "uniform_grid.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

namespace subcert::data {

DataSites Samples::sites() const {
  DataSites sites{count(), weights};
  const double unit = nearest_double(spacing);
  for (const double x : positions) sites.positions.push_back((x - positions.front()) / unit);
  return sites;
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
