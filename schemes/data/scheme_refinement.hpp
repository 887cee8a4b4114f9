#pragma once
/// Refinement of data by a scheme of any family.

#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::data {

/// Applies the scheme `options.levels` times. Domain: as many axes as the scheme has variables, and at least
/// fewest_points() along each. Errors: as the refine() of its kind.
GridData<double> refine(const GridData<double>& data, const AnyScheme& scheme, const RefineOptions& options);

/// The fewest points that refine() takes, along each axis; as many numbers as the scheme has variables. Along closed
/// axes it is that with Boundary::periodic.
std::vector<std::size_t> fewest_points(const AnyScheme& scheme, Boundary boundary);

}  // namespace subcert::data
