#pragma once
/// Refinement of data that go on past their ends: nearest and constant. Inner header.

#include "slab_refinement.hpp"

namespace subcert::data {

/// Makes the steps for data on these axes.
using StepMaker = std::function<SliceSteps(const std::vector<Axis>& axes, const RefineOptions& options)>;

/// The data continued past the ends of open axes as options.boundary says, the steps with `shrink`, and of their result
/// the points in the domain of the data: those of the steps on infinite data. `fewest`: data that the steps take along
/// each axis. Domain: nearest or constant. Errors: as the steps.
SliceSteps extended_steps(const std::vector<Axis>& axes, std::size_t dimension, const std::vector<std::size_t>& fewest,
                          const RefineOptions& options, const StepMaker& make);

}  // namespace subcert::data
