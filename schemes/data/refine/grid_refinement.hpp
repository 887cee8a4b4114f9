#pragma once
/// Refinement of surfaces and volumes by masks that are not products. Inner header.

#include "refine.hpp"

namespace subcert::data {

/// refine() of a mask as a whole. Domain: as there; data that are canonical and not too many.
template <class Number>
GridData<Number> refined_on_grid(const GridData<Number>& data, const LatticeMask& mask, const RefineOptions& options);

/// The number of points that each axis must have at least.
std::vector<std::size_t> windows(const LatticeMask& mask);

}  // namespace subcert::data
