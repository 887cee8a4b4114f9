#pragma once
/// The limit itself on a grid of parameters, without refining to it.

#include "refine.hpp"

namespace subcert::data {

/// The limits of data, with one factor of the mask along each axis, at the parameters i / arity^levels in the domain of
/// the data: at the data themselves for levels = 0. Exact in rational numbers. The boundaries are those of refine(), so
/// these are the limits of its points: with `shrink` where the support of the limit function lies within the data, with
/// `regression` up to the ends. Domain: a mask with factors that all converge, levels >= 0; otherwise as refine().
/// Errors: as refine(), and as limit_values_at(); a domain error where refinement does not converge at an end. Cost:
/// linear in the output; with `regression` times some ten, because the data are refined until only the ends are near
/// the ends. Proof: docs/data.md.
template <class Number>
GridData<Number> limit_of_data(const GridData<Number>& data, const LatticeMask& mask, const RefineOptions& options);

}  // namespace subcert::data
