#include "every_valence.hpp"

#include "characteristic_map.hpp"
#include "family_spectrum.hpp"
#include "required_rules.hpp"

#include <fmt/format.h>

namespace subcert {
namespace {

using namespace vertex;

constexpr int most_cuts = 2, most_halvings = 12;
constexpr slong bits = 64;
constexpr long first_together = 13;

struct Piece {
  Rational low, high;  // of 1/n
  int halvings = 0;

  /// The valences in it.
  EveryValence::Range valences() const {
    EveryValence::Range range{to_integer(Rational(1 / high), subcert::Rounding::up).convert_to<long>(), {}};
    if (low > 0) range.last = to_integer(Rational(1 / low), subcert::Rounding::down).convert_to<long>();
    return range;
  }
};

class FamilyProof {
 public:
  FamilyProof(const SectorRuleFamily& family, const RegularPart& regular)
      : regular_(regular), rules_(family.at(SectorRuleFamily::many)), set_(smallest_closed_set(rules_)) {
    require(rules_.lattice != SectorLattice::dual || family.over_vertex.rings.empty(),
            "smoothness at vertices: need rules of corners without 1/n");
    // The weights are affine in 1/n: what holds at two valences holds at all.
    for (const long valence : {SectorRuleFamily::many, 2 * SectorRuleFamily::many}) {
      const SectorRules rules = family.at(valence);
      require_rules(rules, with_rules_of(rules, set_), regular, LetterRing(0));
    }
    spectrum_.emplace(family, set_);
  }

  bool holds_on(const Piece& piece, long& squares) {
    const auto leader = spectrum_->leader_on(piece.low, piece.high, bits);
    if (!leader) return false;
    const BallField field(Ball::containing({piece.low, piece.high}, bits));
    const auto map = leader->decay ? CharacteristicMap::find_near_one(rules_, set_, *regular_.forms, leader->value,
                                                                      *leader->decay, field)
                                   : CharacteristicMap::find(rules_, set_, *regular_.forms, 1, leader->value, field);
    if (!map) return false;
    const MapProof proof = map->prove(most_cuts);
    squares += proof.squares;
    if (!proof.regular.is_yes() || !proof.half_plane.is_yes()) return false;
    if (piece.low == 0) subdominant_ = Rational(leader->value.middle());
    return true;
  }

  /// Domain: all intervals are proved.
  EveryValence::Evidence evidence() const {
    EveryValence::Evidence result{{}, subdominant_};
    for (const auto& [point, rule] : set_.rules) result.points.push_back(point);
    return result;
  }

 private:
  const RegularPart& regular_;
  SectorRules rules_;
  ClosedSet set_;
  std::optional<FamilySpectrum> spectrum_;
  Rational subdominant_ = 0;  // in the interval from 0 on
};

std::string to_text(const EveryValence::Range& range) {
  if (!range.last) return fmt::format("{} and all that follow", range.first);
  return range.first == *range.last ? std::to_string(range.first) : fmt::format("{}..{}", range.first, *range.last);
}

void add(std::vector<EveryValence::Range>& open, const EveryValence::Range& range) {
  if (range.last && *range.last < range.first) return;
  // From large valences to small ones.
  if (!open.empty() && range.last && *range.last + 1 >= open.front().first)
    open.front().first = range.first;
  else
    open.insert(open.begin(), range);
}

}  // namespace

long first_of_all(const SectorRuleFamily& family) { return std::max(first_together, family.least); }

EveryValence every_valence(const SectorRuleFamily& family, const RegularPart& regular, long first,
                           const Budget& budget) {
  require(first >= family.least, "smoothness at vertices: need a first valence >= {}, got {}", family.least, first);
  EveryValence result{first, {}, {}};
  FamilyProof proof(family, regular);
  if (!regular.c1.is_yes()) {
    result.open = {{first, std::nullopt}};
    result.c1.reason = "the regular part is not proved to be C1: " + regular.c1.reason;
    return result;
  }
  std::vector<Piece> open{{0, Rational(1) / Rational(first)}};
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    const bool in_time = !budget.deadline.expired();
    if (in_time && proof.holds_on(piece, result.squares)) {
      ++result.intervals;
    } else if (!in_time || piece.halvings == most_halvings) {
      add(result.open, piece.valences());
    } else {
      const Rational centre = (piece.low + piece.high) / 2;
      open.push_back({centre, piece.high, piece.halvings + 1});
      open.push_back({piece.low, centre, piece.halvings + 1});
    }
  }
  if (result.open.empty()) {
    result.c1 = {Truth::yes, "the characteristic maps are regular and injective"};
    if (regular.forms->are_hulls()) result.evidence = proof.evidence();
    return result;
  }
  for (const EveryValence::Range& range : result.open)
    result.c1.reason += (result.c1.reason.empty() ? "open for n = " : ", ") + to_text(range);
  return result;
}

}  // namespace subcert
