#pragma once
/// Linear refinement of data.

#include "boundary.hpp"
#include "grid_data.hpp"

#include <subcert/analysis/symbol/masks/level_masks.hpp>

#include <vector>

namespace subcert::data {

struct RefineOptions {
  int levels = 1;
  Boundary boundary = Boundary::regression;
  int threads = 1;
  double constant = 0;  ///< past the ends, for Boundary::constant
};

/// Numbers (points times coordinates) that a refinement may make.
constexpr double most_refined_numbers = 1e8;

/// Applies the mask `levels` times. The output axes keep the domain of the data; docs/data.md says which points are
/// made and how rules at the ends read. Factors are applied axis by axis; polynomials of the reproduction degree of
/// each are refined exactly, up to the ends with `regression` and `shrink`. Of masks without factors `regression` takes
/// for an output whose box of data passes an end the least squares polynomial of the reproduced total degree on the
/// nearest complete box; polynomials of this total degree are refined exactly. Domain: as many axes as variables, coset
/// sums 1, levels >= 0; without factors a dilation that is a multiple of the identity; at least fewest_points() along
/// each axis. Errors: throws a domain error that names the inequality, a size error with an estimate where the result
/// would pass most_refined_numbers. Cost: linear in the output times the size of the stencils.
template <class Number>
GridData<Number> refine(const GridData<Number>& data, const LatticeMask& mask, const RefineOptions& options);
/// The same with a mask for each level. Domain: all masks with factors, and of one arity along each axis; where there
/// are none after the first ones, as many as levels.
template <class Number>
GridData<Number> refine(const GridData<Number>& data, const LevelMasks& masks, const RefineOptions& options);

/// The number of points that each axis must have at least; 1 along closed axes and with periodic, nearest, constant.
std::vector<std::size_t> fewest_points(const LatticeMask& mask, Boundary boundary);

/// Throws a size error where `levels` refinements by the factor `growth` of `numbers` numbers would pass `most`.
/// Domain: growth >= 2.
void require_refinable(std::size_t numbers, long growth, long levels, double most = most_refined_numbers);

/// The piecewise linear function through the points at these parameters. Domain: one axis with at least two points of
/// one coordinate; beyond the ends of an open one the first or last piece goes on. Errors: throws a domain error. Cost:
/// linear.
std::vector<double> interpolate(const GridData<double>& curve, const std::vector<Rational>& parameters);

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
