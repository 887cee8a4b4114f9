#pragma once
/// Conjecture 7 of [DHHS15] over a range: max psi ~ 1/n and max |psi'| ~ 1/n^2 for every degree.

#include "conjecture_limit.hpp"
#include "primal_schemes.hpp"

#include <subcert/proofs-checks/sweeps/sweep.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace subcert::conjectures {

/// How exact the enclosures of a case are to be, and how long it may take.
struct CaseBudget {
  double relative_width = 1e-6;
  double seconds = 60;

  /// As the names of cases state it.
  std::string text() const;
};

/// What is certified about one scheme.
struct VarianceRow {
  PrimalScheme scheme;
  Enclosure sup;                   ///< max psi
  std::optional<Enclosure> slope;  ///< max |psi'|; else slope_reason says why nothing is proved
  std::string slope_reason;
  Rational mean;
  bool complete = false;  ///< the enclosures have the width asked for
};

/// What the rows of one degree say about one half of the conjecture.
struct DegreeDecay {
  int d;
  std::string quantity;  ///< as in "max psi"
  DecayFinding decay;
};

struct Conjecture7 {
  std::vector<VarianceRow> rows;          ///< those of the shard, by d and then n
  std::vector<DegreeDecay> findings;      ///< none for a part of the range
  std::map<int, LimitComparison> limits;  ///< of the degrees whose constant is computed
  /// yes: all rows are complete and all upper bounds proved; no: one of these is refuted.
  Truth verdict = Truth::unknown;
  bool has_rate = false;  ///< without a degree of two n or more the verdict says nothing about the conjecture

  /// n max psi / C_d - 1; nothing for degrees without a constant.
  std::optional<Enclosure> deviation(const PrimalScheme& scheme) const;
};

/// Computes the cases that no journal has, and decides. Domain: range.schemes by d and then n, not empty. Returns
/// nothing on ranks other than 0. Errors: as run_sweep. Cost: variance_range for each scheme.
std::optional<Conjecture7> check_conjecture_7(const PrimalSchemes& range, const CaseBudget& budget,
                                              const sweeps::SweepOptions& options);

}  // namespace subcert::conjectures
