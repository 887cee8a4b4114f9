#include "batch.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>

#include <algorithm>
#include <stdexcept>

namespace subcert::experiments {

Batch refined(const std::string& specification, const Batch& data, int levels) {
  const AnyScheme scheme = make_any_scheme(specification);
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme); l1 && l1->rules.options.joint_residuals)
    fail(ErrorKind::domain, "refined: need separate residuals, got {}", specification);
  // The sets are coordinates of one set of points, and no scheme here mixes coordinates.
  const std::size_t sets = data.sets.size(), k = data.dimension;
  data::GridData<double> joined{{}, sets * k, data.axes};
  const std::size_t points = joined.points();
  joined.values.resize(points * sets * k);
  for (std::size_t s = 0; s < sets; ++s)
    for (std::size_t p = 0; p < points; ++p) std::copy_n(&data.sets[s][p * k], k, &joined.values[(p * sets + s) * k]);
  const data::GridData<double> fine = refine(joined, scheme, {levels, data::Boundary::regression, 1});
  Batch result{fine.axes, k, std::vector<std::vector<double>>(sets, std::vector<double>(fine.points() * k))};
  for (std::size_t s = 0; s < sets; ++s)
    for (std::size_t p = 0; p < fine.points(); ++p)
      std::copy_n(&fine.values[(p * sets + s) * k], k, &result.sets[s][p * k]);
  return result;
}

std::vector<double> parameters(const data::Axis& axis) {
  std::vector<double> result;
  for (std::size_t i = 0; i < axis.count; ++i) result.push_back(data::nearest_double(axis.parameter(i)));
  return result;
}

}  // namespace subcert::experiments
