#pragma once
/// What refine() and limit_of_data() are made of. Inner header.

#include "slab_refinement.hpp"

namespace subcert::data {

/// The steps of refine() by factors, and of limit_of_data(), one after another. Domain and errors: as these; a size
/// error where one of `steps_of_limit` would make more than `most` numbers.
std::vector<StepAlong> steps_of_refinement(std::vector<Axis> axes, const LevelMasks& masks,
                                           const RefineOptions& options);
std::vector<StepAlong> steps_of_limit(std::vector<Axis> axes, std::size_t dimension, const std::vector<Mask>& masks,
                                      const RefineOptions& options, double most);

/// Throws a domain error unless there are as many axes as variables and levels >= 0, a size error where the result
/// would have more than `most` numbers.
void require_refinable(const std::vector<Axis>& axes, std::size_t dimension, const LevelMasks& masks, int levels,
                       double most);
/// Throws a domain error where a mask has none, or another dilation.
void require_factors(const LevelMasks& masks);

/// The data after these steps.
template <class Number>
GridData<Number> refined_along_axes(GridData<Number> data, const std::vector<StepAlong>& steps, int threads) {
  for (const StepAlong& step : steps) data = apply_along(data, step.axis, converted<Number>(step.rows), threads);
  return data;
}

/// refine() of a mask as a whole. Domain: as there; data that are canonical and not too many.
template <class Number>
GridData<Number> refined_on_grid(const GridData<Number>& data, const LatticeMask& mask, const RefineOptions& options);

/// Its steps by slices.
SliceSteps grid_steps(std::vector<Axis> axes, std::size_t dimension, const LatticeMask& mask,
                      const RefineOptions& options);

/// The number of points that each axis must have at least.
std::vector<std::size_t> windows(const LatticeMask& mask);

}  // namespace subcert::data
