#pragma once
/// Rules at vertices of any valence as they are written down: rows of weights, or expressions.

#include <subcert/analysis/symbol/masks/sector_rules.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert {

/// Weights of data at one point of a sector: of that of one sector, or of those of all. Each is an expression in
/// c = cos(2 pi/n) and n; one for all sectors t = 0, ..., n-1 may have C = cos(2 pi t/n).
struct WrittenWeights {
  LatticePoint point;
  std::optional<long> turn;         ///< of one sector, counted from that of the new point; negative backwards
  std::vector<std::string> values;  ///< one, or one for each sector from 0 on
  std::string place = {};           ///< where they stand, for errors
};

/// The rule of one new point at vertices of some valences.
struct WrittenRule {
  LatticePoint point;
  std::vector<WrittenWeights> weights;
  long first = 3;
  std::optional<long> last = std::nullopt;  ///< none: all that follow
  std::string place = {};

  bool covers(long valence) const { return first <= valence && (!last || valence <= *last); }
};

/// A number that a rule leaves free, by its letter: it may have a value.
struct WrittenLetter {
  char name;
  std::optional<Rational> value = std::nullopt;
};

/// A scheme with rules of its own at vertices. Points without any rule have that of the mask; others need one for each
/// valence that is asked for, but for the regular one, where that of the mask is taken if there is none.
struct WrittenRules {
  SectorLattice lattice;
  LatticeMask mask;
  std::vector<WrittenRule> rules = {};
  std::vector<WrittenLetter> letters = {};  ///< different ones

  /// The first letter without a value, if there is one.
  const WrittenLetter* free_letter() const;
  /// Such rules with these letters, in this order, as those without values. Errors: throws a usage Error unless these
  /// are letters, and all others have values.
  WrittenRules with_free(const std::vector<std::string>& names) const;
  /// The same with numbers in the place of the letters that have values.
  WrittenRules with_numbers() const;
};

/// How a mask is laid into sectors: of triangles with edges along (1,0), (0,1), (1,1), those of a sector; of a dual
/// scheme new points around the middle of the old ones. Domain: two variables, m times the identity.
LatticeMask mask_in_sectors(const LatticeMask& mask, SectorLattice lattice);

/// The rules at a vertex of one valence. Domain: 3 <= valence <= 1000; all letters have values. Errors: throws Error,
/// with the place, for what is no such expression, a quotient by 0, a row with more or fewer weights than sectors, a
/// valence without a rule, and weights that do not sum to 1, which is decided exactly.
SectorRules rules_at(const WrittenRules& written, long valence);

/// Reads each rule, at the least of its valences. Errors: as rules_at().
void check_rules(const WrittenRules& written);

/// The same with the letters that have no values as such: weights are polynomials in c and in them, see letter_stride.
/// Domain: one such letter or more. Errors: as above, but that sums of weights are not looked at.
SectorRules rules_with_letters(const WrittenRules& written, long valence);

/// Those of all valences from a least one on, 7 or more: each point has one rule then. Errors: throws Error where it
/// has not, and for weights that are not a polynomial in c and, at the point (0, 0) alone, one over n.
SectorRuleFamily rule_family(const WrittenRules& written);

}  // namespace subcert
