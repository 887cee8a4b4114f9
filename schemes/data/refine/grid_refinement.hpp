#pragma once
/// Refinement of surfaces and volumes by masks that are not products.

#include "refine.hpp"

namespace subcert::data {

/// Applies the mask `levels` times. Points, domains and boundaries are, axis by axis, those of refine(); with
/// `regression` an output whose box of data passes an end takes the least squares polynomial of the reproduced total
/// degree on the nearest complete box. Polynomials of this total degree are refined exactly. Domain: as many axes as
/// variables, coset sums 1, levels >= 0; at least as many points as the stencils along each axis. Errors: as refine().
/// Cost: linear in the output times the size of the stencils.
template <class Number>
GridData<Number> refine(const GridData<Number>& data, const MultivariateMask& mask, const RefineOptions& options);

/// The number of points that each axis must have at least.
std::vector<std::size_t> windows(const MultivariateMask& mask);

}  // namespace subcert::data
