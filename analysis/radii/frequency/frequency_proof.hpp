#pragma once
/// Joint spectral radii of transition matrices, bounded from above by a function of frequency that a transfer operator
/// does not enlarge by more than a factor.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <optional>
#include <vector>

namespace subcert {

/// What proves the bound: frequencies pi (m .. A m)/(A^(j+1) m) are cells of shell j < `shells`, with m = `cells` and
/// the arity A; on each the modulus of the symbol is bounded by Taylor polynomials. The rest follows from the weights.
struct FrequencyProof {
  Rational bound;
  int cells, shells;
  int steps;                     ///< parts of the image of a cell of shell 0; fewer on the other shells
  int group;                     ///< so many of these parts share a Taylor polynomial
  int terms;                     ///< of a Taylor polynomial
  int bits;                      ///< that a check needs
  std::vector<Integer> weights;  ///< positive, one for each cell of shell 0
};

/// Of the transition matrices of `scheme`, b: their radius is the growth of the largest coefficient of b(z) b(z^A) ...
/// Nothing where none is found. Domain: coset sums need not be 1; meant for divided difference schemes of the largest
/// order; cells >= 1. Errors: throws a domain error. Error: none, balls decide. Cost: for 100 coefficients and 32 cells
/// a tenth of a second; grows with the square of their number. Ref: SPEC.md, theorem 40.
std::optional<FrequencyProof> frequency_proof(const Mask& scheme, int cells, const Deadline& deadline = {});

}  // namespace subcert
