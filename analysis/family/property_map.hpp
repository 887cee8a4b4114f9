#pragma once
/// For which values of several parameters a scheme has a property, with proof.

#include "property_range.hpp"

#include <subcert/analysis/symbol/polynomials/cell_map.hpp>

namespace subcert {

struct PropertyMap : CellMap {
  int sum_rules = 0;  ///< that hold for all values
};

/// Decides a property over a box of two or three letters by cells that are halved in each of them: proved by the joint
/// spectral radius of the control matrices of a cell, refuted by an eigenvalue of one product that is too large all
/// over the cell, and by the stability of the shifts. Domain: coset sums 1 for all values, or a mask of matrices; as
/// many letters as the mask has; `convergent`, and `smooth`, `holder` or, of matrices, `hermite` with an order below
/// the number of sum rules; 1 <= resolution <= 1024; arity * (degree in the first letter + 1) * (degree in the second +
/// 1) ... at most 64. Errors: throws Error. Error: none; what is not decided, as where a denominator may vanish, is
/// left `unknown`. Cost: one joint spectral radius for each cell. Ref: docs/families.md.
PropertyMap property_map(const ParametricMask& mask, const RangeProperty& property, const Box& box,
                         const MapOptions& options);

}  // namespace subcert
