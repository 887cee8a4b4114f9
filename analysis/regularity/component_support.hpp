#pragma once
/// Where the functions of a vector are not 0.

#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/transition/lattice_window.hpp>

#include <optional>
#include <vector>

namespace subcert {

/// The smallest closed interval outside of which phi_c is 0, for each c: of the continuous solution of the refinement
/// equation that has these values at lattice points. Nothing for a function that is 0 everywhere. Domain: a mask of
/// matrices of one variable with an arity; the solution is continuous. Errors: throws Error, of kind undecided where
/// the digits of an end show no period, or the values span no space that is found. Cost: spinning of the values,
/// products of rows and matrices of that size. Proof: docs/vectors.md.
std::vector<std::optional<Interval>> component_supports(const LatticeMask& mask, const LatticeSequence& values);

}  // namespace subcert
