#pragma once
/// Exact values of vectors of functions whose matrices have a square root, by points; of rational ones in the same
/// form.

#include "limit_values.hpp"

#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/symbol/polynomials/quadratic_number.hpp>

#include <map>
#include <optional>
#include <vector>

namespace subcert {

/// The values of all functions at M^-level i, by i; points where all are 0 are left out.
using FieldValues = std::map<LatticePoint, std::vector<QuadraticNumber>>;

/// Of sequences whose last coordinate is the component; with a root those of its multiples come after those of 1
/// (QuadraticMask).
FieldValues by_points(const LatticeSequence& values, std::size_t components, long root);

/// limit_values() of `meant` where there is such, else of the mask: D^orders phi of the solution with these values at
/// lattice points. Domain, errors and cost: as there, of twice as many functions for a root.
FieldValues limit_values(const LatticeMask& mask, const std::optional<QuadraticMask>& meant,
                         const LatticeSequence& values, int level, const LatticePoint& orders = {});

/// A solution times a number of the field of the root, such that the values sum to 1, or, where they sum to 0, that the
/// first is 1. Domain: components of the functions, half of those of the sequence; a root; not 0.
LatticeSequence normalised(const LatticeSequence& values, std::size_t components, long root);

/// Error: relative, below 2^(2-bits).
Rational rounded(const QuadraticNumber& number, long bits);

}  // namespace subcert
