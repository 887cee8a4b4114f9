#pragma once
/// Refinement of vectors: values and derivatives by Hermite schemes, coefficients of vectors of functions.

#include "axis_refinement.hpp"
#include "refine.hpp"

#include <subcert/schemes/specification.hpp>

namespace subcert::data {

/// How a Hermite scheme keeps polynomials with their derivatives: the centre tau is such that linear ones are kept
/// where that can be, and the degree is the largest for which D^(n+1) p((i - tau)/a) = sum over j of P_{i-aj} D^n p(j);
/// -1 where the values 1 with derivatives 0 are not kept. Of a rounded mask it is the degree of the one that is
/// `meant`, and the centre differs from its own as the roots do. Domain: one variable. Cost: the entries times the
/// degree.
struct HermiteReproduction {
  Rational centre;
  int degree = -1;
};
HermiteReproduction hermite_reproduction(const LatticeMask& mask,
                                         const std::optional<QuadraticMask>& meant = std::nullopt);

/// The rule P_k, A_k transposed, of a mask of matrices A_k. With `hermite` it acts on values and derivatives per unit
/// of the spacing of its data; its centre and degree are those with which polynomials and their derivatives are kept,
/// D^(n+1) p((i - tau)/a) = sum over j of P_{i-aj} D^n p(j). Otherwise the centre is 0 and the degree -1: nothing is
/// known of what the numbers are. Domain: one variable, r >= 2 components; of `hermite` one that keeps constants.
/// Weights are those of the mask, also where it is a rounded one; `meant`: as above. Errors: throws a domain error.
/// Cost: the entries times the degree.
AxisRule axis_rule(const LatticeMask& mask, VectorForm form, const std::optional<QuadraticMask>& meant = std::nullopt);

/// Applies the rule of the mask `levels` times to points of r blocks of numbers, as many in each: block k has the k-th
/// derivatives of all coordinates, per unit of a parameter in which data are `spacing` apart, or the k-th coefficients.
/// Points are made as by refine(); with `regression` the values and derivatives beyond complete stencils are those of
/// the polynomial of HermiteFit with the degree of the rule. Domain: as axis_rule; r divides data.dimension; one axis;
/// open axes with `regression` (Hermite schemes alone) or `shrink`; spacing > 0. Errors: throws a domain error; a size
/// error where the result is too long, or beyond the range of doubles. Cost: linear in the output times the entries of
/// the stencils.
template <class Number>
GridData<Number> refine_vectors(const GridData<Number>& data, const LatticeMask& mask, VectorForm form,
                                const RefineOptions& options, const Rational& spacing = 1,
                                const std::optional<QuadraticMask>& meant = std::nullopt);
/// The same with a mask for each level. Domain: matrices of one size and of one arity; as many masks as levels, and
/// one at least, where none come again.
template <class Number>
GridData<Number> refine_vectors(const GridData<Number>& data, const LevelMasks& masks, VectorForm form,
                                const RefineOptions& options, const Rational& spacing = 1);

}  // namespace subcert::data
