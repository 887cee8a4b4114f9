#include "scheme_refinement.hpp"

#include <subcert/schemes/data/l1/l1_refinement.hpp>

namespace subcert::data {

GridData<double> refine(const GridData<double>& data, const AnyScheme& scheme, const RefineOptions& options) {
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme)) return refine(data, l1->rules, options);
  return refine(data, std::get<Scheme>(scheme).mask, options);
}

std::vector<std::size_t> fewest_points(const AnyScheme& scheme, Boundary boundary) {
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme))
    return {l1->rules.points.begin(), l1->rules.points.end()};
  return fewest_points(std::get<Scheme>(scheme).mask, boundary);
}

}  // namespace subcert::data
