#pragma once
/// Whether the limits of a scheme are smooth at vertices of every valence, proved for all at once.

#include "vertex_smoothness.hpp"

namespace subcert {

/// Of all valences n >= first.
struct EveryValence {
  struct Range {
    long first;
    std::optional<long> last;  ///< none: all that follow
  };

  /// Where a checker of certificates begins. Proof: SPEC.md, section 5.12.
  struct Evidence {
    std::vector<LatticePoint> points;  ///< of a closed set
    Rational subdominant;              ///< about, for n -> infinity
  };

  long first;
  /// As VertexSmoothness::c1, of all of them; never no.
  Decision c1;
  std::vector<Range> open;                          ///< where it is not proved, in order
  long intervals = 0;                               ///< of 1/n, in which it is
  long squares = 0;                                 ///< that the proofs looked at, in all intervals
  std::optional<Evidence> evidence = std::nullopt;  ///< where c1 is yes, by hulls
};

/// From which valence on all are proved at once; those before are looked at one by one.
long first_of_all(const SectorRuleFamily& family);

/// Domain: rules with the mask of the regular part, first >= family.least. Errors: as vertex_smoothness(). Cost: a
/// proof for each interval of 1/n, which are halved where none is found, until the budget is spent. Proof:
/// docs/all-valences.md.
EveryValence every_valence(const SectorRuleFamily& family, const RegularPart& regular, long first,
                           const Budget& budget);

}  // namespace subcert
