#pragma once
/// Refinement of data by a scheme of any family.

#include <subcert/schemes/data/refine/slab_refinement.hpp>
#include <subcert/schemes/specification.hpp>

#include <functional>
#include <optional>

namespace subcert::data {

/// Reads the specification of whatever acts on data: numbers, data-dependent, or of vectors. Errors: throws
/// SpecificationError.
AnyScheme make_data_scheme(std::string_view specification);

/// Applies the scheme `options.levels` times. With r components r blocks of coordinates are the numbers of each point:
/// for Hermite schemes values, first derivatives, ... with respect to the parameter, in which data are 1 apart; or,
/// with one coordinate more in front of these, with respect to that, which then is refined as the position that it is.
/// Domain: as many axes as the scheme has variables, and at least fewest_points() along each; columns as
/// require_columns() asks. Errors: as the refine() of its kind.
GridData<double> refine(const GridData<double>& data, const AnyScheme& scheme, const RefineOptions& options);

/// The steps of this by slices; nothing for schemes of vectors, whose results are made whole. Domain: as above; errors:
/// as refinement_steps() of the kind.
std::optional<SliceSteps> refinement_steps(const std::vector<Axis>& axes, std::size_t dimension,
                                           const AnyScheme& scheme, const RefineOptions& options);

/// Throws a data error unless there are as many coordinates as the numbers of a vector, or a multiple of them, or for
/// Hermite schemes one more, of which the first are positions that rise in equal steps. `place` names the datum, or all
/// data, for the error. Of schemes of numbers nothing is asked.
void require_columns(const AnyScheme& scheme, const GridData<double>& data,
                     const std::function<std::string(std::optional<std::size_t>)>& place);

/// The data without derivatives, or coefficients other than the first.
GridData<double> without_derivatives(const AnyScheme& scheme, const GridData<double>& data);

/// The fewest points that refine() takes, along each axis; as many numbers as the scheme has variables. Along closed
/// axes it is that with Boundary::periodic.
std::vector<std::size_t> fewest_points(const AnyScheme& scheme, Boundary boundary);

}  // namespace subcert::data
