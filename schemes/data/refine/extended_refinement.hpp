#pragma once
/// Refinement of data that go on past their ends: nearest and constant. Inner header.

#include "slab_refinement.hpp"

namespace subcert::data {

/// Makes the steps for data on these axes.
using StepMaker = std::function<SliceSteps(const std::vector<Axis>& axes, const RefineOptions& options)>;

/// The steps; with nearest and constant those, with `shrink`, of data continued past the ends of open axes, and of
/// their result the points in the domain of the data: what the steps make of infinite data. `fewest`: data that the
/// steps take along each axis. Errors: as the steps. Memory: none for the continuation.
SliceSteps steps_at_boundary(const std::vector<Axis>& axes, std::size_t dimension,
                             const std::vector<std::size_t>& fewest, const RefineOptions& options,
                             const StepMaker& make);

}  // namespace subcert::data
