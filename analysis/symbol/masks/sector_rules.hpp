#pragma once
/// Subdivision next to an extraordinary vertex: a mask in each of n sectors, and the rules that differ from it.

#include "mask.hpp"

#include <map>
#include <tuple>
#include <vector>

namespace subcert {

/// What n sectors of the lattice meet in. Each is the quarter plane x, y >= 0; turning by one sector takes (1, 0) to
/// (0, 1).
///   triangles  edges along (1,0), (0,1), (1,-1); the vertex is (0,0), the sectors share their rays
///   quads      edges along (1,0), (0,1); the vertex is (0,0), the sectors share their rays
///   dual       the same; the centre is that of an n-gon with the corners (0,0) of the sectors, which share nothing
enum class SectorLattice { triangles, quads, dual };

/// How many sectors make the plane: at a vertex of this valence the lattice is regular.
constexpr long regular_valence(SectorLattice lattice) { return lattice == SectorLattice::triangles ? 6 : 4; }

/// A point of the sector `turn`. Canonical: x, y >= 0, and in a lattice with a vertex x > 0 unless it is the vertex,
/// which has turn 0; 0 <= turn < n.
struct SectorPoint {
  LatticePoint point;
  long turn = 0;

  bool operator==(const SectorPoint& other) const = default;
  bool operator<(const SectorPoint& other) const { return std::tie(point, turn) < std::tie(other.point, other.turn); }
};

/// One datum of a rule. The weights are polynomials in c = cos(2 pi/n).
struct SectorTerm {
  SectorPoint at;
  LaurentPolynomial weight;
};

/// Data in all sectors at once: the sum over the turns t of cos(2 pi frequency t/n) weight m/n at the point in the
/// sector t, m = 1 for the frequencies 0 and n/2, m = 2 for all others. It acts on that frequency alone, with the
/// factor `weight`. Canonical: 0 <= frequency <= n/2.
struct RingTerm {
  LatticePoint point;
  long frequency;
  LaurentPolynomial weight;
};

struct SectorRule {
  std::vector<SectorTerm> terms;
  std::vector<RingTerm> rings = {};
};

/// A scheme at a vertex of valence n. A new point P of sector 0 is the sum of its rule, or, where it has none of its
/// own, of a_{P - mj} f_j, with the j outside of the sector taken into the sectors beside it; those of the other
/// sectors are turned. Canonical: n >= 3, the dilation m times the identity, m >= 2.
struct SectorRules {
  long valence;
  SectorLattice lattice;
  LatticeMask mask;
  std::map<LatticePoint, SectorRule> rules = {};
  /// Where `mask` is that of two steps of another one, with a dilation whose square is m or -m times the identity.
  std::optional<LatticeMask> step = std::nullopt;

  /// The rule of a canonical point of sector 0, its data canonical, none twice. Errors: throws Error where the mask
  /// needs a datum that no sector beside sector 0 has, or that has different places in the two ways around the vertex.
  SectorRule rule_at(const LatticePoint& point) const;
};

/// In weights with letters powers of c stand for theirs: c^(i + letter_stride (k_1 + letter_powers (k_2 + ...))) is c^i
/// times the k_1-th power of the first letter, and so on. Domain: degrees in c below letter_stride, and below
/// letter_powers in all letters but the last.
inline constexpr long letter_stride = 64, letter_powers = 32;

/// i, k_1, k_2, ... of that power of c. Domain: power >= 0, letters >= 1.
std::vector<long> letter_exponents(long power, std::size_t letters);
/// That power of c. Domain: as above, one exponent of c and one for each letter.
long letter_power(const std::vector<long>& exponents);

/// Such rules with a polynomial in c in the place of each letter.
SectorRules with_letter_values(SectorRules rules, const std::vector<LaurentPolynomial>& values);

/// The highest power of each letter in the weights.
std::vector<long> letter_degrees(const SectorRules& rules, std::size_t letters);

/// The rules of one scheme at vertices of every valence from a least one on.
struct SectorRuleFamily {
  /// So many sectors that all turns of a rule differ as they do in each valence.
  static constexpr long many = 1'000'000;

  SectorRules rules;            ///< of `many` sectors
  long least;                   ///< from here on no rule is one of a single valence, or of the regular one
  SectorRule over_vertex = {};  ///< what the rule of the vertex has more, over n

  /// Those of one valence. Domain: `least` or more, or that of `rules`.
  SectorRules at(long valence) const;
};

/// a(z) a(z^M), the symbol of two steps with the dilation M. Domain: numbers, two variables.
MultivariatePolynomial two_step_symbol(const LatticeMask& mask);

/// A point of the plane of sector 0, and of the half planes beside it, as one of a sector; nothing where it is opposite
/// of sector 0. Domain: valence >= 3.
std::optional<SectorPoint> in_sector(const LatticePoint& point, SectorLattice lattice, long valence);
/// Turned by so many sectors.
SectorPoint turned(SectorPoint point, long turns, SectorLattice lattice, long valence);

/// The weights as numbers, each enclosed with a relative width of about 2^-bits of the largest; no point twice.
std::vector<std::pair<SectorPoint, Enclosure>> weights_at(const SectorRule& rule, SectorLattice lattice, long valence,
                                                          int bits = 64);

}  // namespace subcert
