#pragma once
/// Refinement of curves, grids and volumes by the data-dependent schemes of local l1 regression.

#include "l1_regression.hpp"

#include <subcert/schemes/data/refine/slab_refinement.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::data {

/// The window of a scheme, about the datum at 0; its outputs are numbered with x running fastest.
/// Domain: one to three numbers of points, each >= 2 and > degree. Errors: throws a domain error.
RegressionWindow l1_window(const L1Scheme& scheme);

/// The linear scheme that has all weights 1, for curves: ary(arity, points, degree).
LocalRegression l1_linear_part(const L1Scheme& scheme);

/// Refines curves, grids and volumes `options.levels` times; the output has the points that refine() makes for linear
/// schemes. At the ends, `regression` evaluates the l1 fit of the nearest complete window. Domain: one axis for each
/// number of points, at least as many points along it, finite values, levels >= 0. Errors: as refine(). Cost: one
/// L1Fitter::fit for each window, of which a step has as many as data.
GridData<double> refine(const GridData<double>& data, const L1Scheme& scheme, const RefineOptions& options);

/// Its steps by slices. Domain and errors: as above, with most_streamed_numbers.
SliceSteps refinement_steps(const std::vector<Axis>& axes, std::size_t dimension, const L1Scheme& scheme,
                            const RefineOptions& options);

/// The values at this level from the data 1 at 0 and 0 elsewhere, over the whole support of the scheme.
/// Domain: a scheme for curves, 0 <= level <= 16. Ref: [MLZD15, sec. 2.4, Prop. 1].
GridData<double> l1_impulse_response(const L1Scheme& scheme, int level);

}  // namespace subcert::data
