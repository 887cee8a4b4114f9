#pragma once
/// Certified extremes of the variance curves of single schemes, for the sources of this floor.

#include <subcert/analysis/symbol/numbers.hpp>

#include <optional>
#include <vector>

namespace subcert::theorems {

/// Of psi over a period; slope: the largest |psi'|, absent where psi is not proved to be C^1.
struct VarianceEnds {
  Enclosure minimum;
  Enclosure maximum;
  std::optional<Enclosure> slope;
};

/// Of the scheme primal:n=N,d=D; kept for the next call. Domain and cost: as variance_range.
const VarianceEnds& variance_ends(int n, int degree);

/// Computes variance_ends for all n from first to last and these degrees, `threads` at a time.
void prepare_variance_ends(int first, int last, const std::vector<int>& degrees, int threads);

}  // namespace subcert::theorems
