#pragma once
/// Certified extremes of the variance curves of single schemes, for the sources of this floor. Proofs:
/// docs/theorems/variance-curves.tex, sections 1 and 2.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <string>
#include <vector>

namespace subcert::theorems {

/// Of psi over a period; slope: bounds the largest |psi'| from above where its upper end is there.
struct VarianceEnds {
  Enclosure minimum;
  Enclosure maximum;
  Enclosure slope;
};

/// Of a scheme by its specification, kept for the next call. Mean and ripple of Proposition 1; where the ripple is more
/// than a part in 256 of the mean, also exact values on a grid and the slope. Domain: as curve_bounds. Cost: for 200
/// coefficients a tenth of a second.
const VarianceEnds& variance_ends(const std::string& scheme);
/// Of primal:n=N,d=D.
const VarianceEnds& variance_ends(int n, int degree);

/// Computes variance_ends for these schemes, `threads` at a time.
void prepare_variance_ends(const std::vector<std::string>& schemes, int threads);
/// For the primal schemes with all n from first to last and these degrees.
void prepare_variance_ends(int first, int last, const std::vector<int>& degrees, int threads);

}  // namespace subcert::theorems
