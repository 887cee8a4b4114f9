#pragma once
/// Conjecture 7 of [DHHS15] over a range: max psi ~ 1/n and max |psi'| ~ 1/n^2 for every degree.

#include "decay.hpp"
#include "primal_schemes.hpp"

#include <subcert/proofs-checks/sweeps/sweep.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace subcert::conjectures {

/// n max psi / C_d - 1 for one degree. The limit for n to infinity is 0, like 1 / (4n) (docs/limit-constants.md).
struct LimitComparison {
  int degree;
  Enclosure constant;                       ///< C_d
  std::vector<CertifiedMaximum> deviation;  ///< n max psi / C_d - 1 for each n
  /// The deviation falls like n^-r from n = rate_from to the last; nothing for a single n. An end is absent where the
  /// deviation is not proved to be positive.
  int rate_from = 0;
  std::optional<Enclosure> exponent;

  std::string sentence() const;
};

/// `maxima`: max psi for each n, as decay_finding takes them. Nothing for degrees above 99, whose constants are not
/// computed. Domain: at least one value, n increasing. Cost: milliseconds to a second, by the degree. Ref: [LC, thm 5].
std::optional<LimitComparison> limit_comparison(int degree, const std::vector<CertifiedMaximum>& maxima);

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
