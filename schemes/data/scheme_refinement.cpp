#include "scheme_refinement.hpp"

#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/refine/grid_refinement.hpp>

namespace subcert::data {

GridData<double> refine(const GridData<double>& data, const AnyScheme& scheme, const RefineOptions& options) {
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme)) return refine(data, l1->rules, options);
  const std::vector<Mask> masks = axis_masks(scheme);
  return masks.empty() ? refine(data, std::get<MultivariateScheme>(scheme).mask, options)
                       : refine(data, masks, options);
}

std::vector<std::size_t> fewest_points(const AnyScheme& scheme, Boundary boundary) {
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme))
    return {l1->rules.points.begin(), l1->rules.points.end()};
  const std::vector<Mask> masks = axis_masks(scheme);
  if (masks.empty()) return windows(std::get<MultivariateScheme>(scheme).mask);
  std::vector<std::size_t> fewest;
  for (const Mask& mask : masks) fewest.push_back(AxisRefiner(mask, boundary).window());
  return fewest;
}

}  // namespace subcert::data
