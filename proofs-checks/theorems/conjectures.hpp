#pragma once
/// Conjectures 7 and 8 of [DHHS15] for degree 1 and every n. Each inequality that the proofs use is a check with the
/// number that it has in docs/theorems/degree-one.md.

#include <subcert/analysis/symbol/numbers.hpp>

#include <string>
#include <vector>

namespace subcert::theorems {

struct Check {
  std::string id;     ///< number in the text
  std::string claim;  ///< the inequality, with the numbers it was decided on
  Decision decision;
};

/// yes if all checks are, no if one is, otherwise unknown with the first undecided check.
Decision verdict(const std::vector<Check>& checks);

/// Theorem B: |(n - 1/4) psi_n(x) / c - 1| < 2 / n^2 for all n >= 1 and all x, and Theorem C: |psi_n'| <= D_n with
/// n^2 D_n <= 5 for n >= 3 and n^4 D_n bounded. c = limit_constant(1). Cost: a second.
std::vector<Check> conjecture_7_degree_one();

/// Theorem A: psi_n(x) > psi_{n+1}(x) for all n >= 1 and all x. Cost: a second.
std::vector<Check> conjecture_8_in_n_degree_one();

}  // namespace subcert::theorems
