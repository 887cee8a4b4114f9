#pragma once
/// Conjecture 8 of [DHHS15] over a range: psi grows with d and falls as n grows, at every point.

#include "conjecture_7.hpp"

namespace subcert::conjectures {

/// One comparison. yes: the curve of `larger` is above the other everywhere; no: it is below it at the witness, by
/// -difference; unknown: with the reason, also where curves touch, which the conjecture allows.
struct ComparisonRow {
  VariancePair pair;
  Decision holds;
  std::optional<Rational> witness;
  std::optional<Rational> difference;
};

struct Conjecture8 {
  std::vector<ComparisonRow> rows;  ///< those of the shard
  Truth verdict = Truth::unknown;   ///< of all rows

  std::size_t count(Truth truth) const;
};

/// Computes the comparisons of neighbours that no journal has. Returns nothing on ranks other than 0. Errors: throws a
/// usage error where the range has no two schemes to compare; else as run_sweep. Cost: compare_variance for each pair.
std::optional<Conjecture8> check_conjecture_8(const PrimalSchemes& range, const CaseBudget& budget,
                                              const sweeps::SweepOptions& options);

}  // namespace subcert::conjectures
