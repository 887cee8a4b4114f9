#include "batch.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/schemes/data/axis_refinement.hpp>
#include <subcert/schemes/data/grid_refinement.hpp>
#include <subcert/schemes/data/l1_specification.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <stdexcept>

namespace subcert::experiments {
namespace {

data::GridData<double> refine_any(const std::string& specification, const data::GridData<double>& data,
                                  const data::RefineOptions& options) {
  if (data::is_l1_specification(specification)) {
    const data::L1Scheme scheme = data::make_l1_scheme(specification).scheme;
    if (scheme.options.joint_residuals)
      fail(ErrorKind::domain, "refined: need separate residuals, got {}", specification);
    return refine(data, scheme, options);
  }
  const AnyScheme any = make_any_scheme(specification);
  if (const auto* scheme = std::get_if<Scheme>(&any)) return refine(data, scheme->mask, options);
  const auto& scheme = std::get<MultivariateScheme>(any);
  return scheme.factors.empty() ? refine(data, scheme.mask, options) : refine(data, scheme.factors, options);
}

}  // namespace

Batch refined(const std::string& specification, const Batch& data, int levels) {
  // The sets are coordinates of one set of points, and no scheme here mixes coordinates.
  const std::size_t sets = data.sets.size(), k = data.dimension;
  data::GridData<double> joined{{}, sets * k, data.axes};
  const std::size_t points = joined.points();
  joined.values.resize(points * sets * k);
  for (std::size_t s = 0; s < sets; ++s)
    for (std::size_t p = 0; p < points; ++p) std::copy_n(&data.sets[s][p * k], k, &joined.values[(p * sets + s) * k]);
  const data::GridData<double> fine = refine_any(specification, joined, {levels, data::Boundary::regression, 1});
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
