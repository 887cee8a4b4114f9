#pragma once
/// Linear refinement of data.

#include "boundary.hpp"
#include "grid_data.hpp"

#include <subcert/analysis/symbol/mask.hpp>

#include <vector>

namespace subcert::data {

struct RefineOptions {
  int levels = 1;
  Boundary boundary = Boundary::regression;
  int threads = 1;
};

/// Numbers (points times coordinates) that a refinement may make.
constexpr double most_refined_numbers = 1e8;

/// Applies masks[k] along axis k, `levels` times. The output axes keep the domain of the data; docs/data.md says which
/// points are made and how rules at the ends read. Polynomials of each mask's reproduction degree are refined exactly,
/// up to the ends with `regression` and `shrink`. Domain: one mask with coset sums 1 for each axis, levels >= 0; at
/// least as many points as the stencils along each axis. Errors: throws a domain error that names the
/// inequality, a size error with an estimate where the result would pass most_refined_numbers. Cost: linear in the
/// output.
template <class Number>
GridData<Number> refine(const GridData<Number>& data, const std::vector<Mask>& masks, const RefineOptions& options);

template <class Number>
GridData<Number> refine(const GridData<Number>& data, const Mask& mask, const RefineOptions& options) {
  return refine(data, std::vector<Mask>{mask}, options);
}

/// Throws a size error where `levels` refinements by the factor `growth` of `numbers` numbers would pass
/// most_refined_numbers. Domain: growth >= 2.
void require_refinable(std::size_t numbers, long growth, long levels);

}  // namespace subcert::data
