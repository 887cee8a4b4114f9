#include "vertex_smoothness.hpp"

#include "characteristic_map.hpp"
#include "required_rules.hpp"
#include "vertex_evidence.hpp"
#include "vertex_spectrum.hpp"

#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <fmt/format.h>

namespace subcert {
namespace {

using namespace vertex;

constexpr int most_levels = 7;
constexpr slong first_bits = 128, last_bits = 512;

/// Whether the rules are those of the mask itself: the valence is regular, and each weight is that of the mask.
bool is_regular_vertex(const SectorRules& rules) {
  const long n = rules.valence;
  if (n != regular_valence(rules.lattice)) return false;
  const CosineField field(n);
  for (const auto& [point, rule] : rules.rules) {
    std::map<SectorPoint, LaurentPolynomial> difference;
    for (const SectorTerm& term : rule.terms) difference[term.at] += field.number(term.weight).polynomial();
    for (const RingTerm& ring : rule.rings)
      for (long t = 0; t < n; ++t) {
        const Rational share(Integer(ring.frequency == 0 || 2 * ring.frequency == n ? 1 : 2), Integer(n));
        difference[turned({ring.point, 0}, t, rules.lattice, n)] +=
            (field.number(LaurentPolynomial(share) * ring.weight) * field.cosine(ring.frequency * t)).polynomial();
      }
    SectorRules plain{n, rules.lattice, rules.mask};
    for (const SectorTerm& term : plain.rule_at(point).terms) difference[term.at] -= term.weight;
    for (const auto& [at, weight] : difference)
      if (!weight.is_zero()) return false;
  }
  return true;
}

/// Whether both have the same limits: the dilation M of the step has M^2 = m or -m, the mask m for its dilation, and
/// where it is -m the symbol is even.
bool is_of_two_steps(const LatticeMask& mask, const LatticeMask& step) {
  const long m = mask.arity();
  const std::vector<LatticePoint> square = times(step.dilation().rows(), step.dilation().rows());
  const bool turns = square == std::vector<LatticePoint>{{-m, 0}, {0, -m}};
  return (turns || square == std::vector<LatticePoint>{{m, 0}, {0, m}}) && two_step_symbol(step) == mask.symbol() &&
         (!turns || mask.symbol().reversed() == mask.symbol());
}

std::string about(const FrequencyGroup& group) {
  return fmt::format("{:.6f} of frequency {}", abs(group.value).middle(), group.frequency);
}

Enclosure minimum(const Enclosure& a, const Enclosure& b) {
  Enclosure result;
  if (a.lower && b.lower) result.lower = std::min(*a.lower, *b.lower);
  if (a.upper && b.upper)
    result.upper = std::min(*a.upper, *b.upper);
  else
    result.upper = a.upper ? a.upper : b.upper;
  return result;
}

/// min of the regular part and log mu / log lambda. Where that is a whole number, the eigenfunction of mu may be a
/// polynomial of F, and the upper end is that of the regular part.
Enclosure exponent_at(const Ball& lambda, const Ball& mu, bool is_square, const Enclosure& regular) {
  const Enclosure ratio = is_square ? Enclosure::exactly(2) : (log(mu) / log(lambda)).enclosure();
  if (!ratio.is_bounded()) return {std::nullopt, regular.upper};
  const bool may_be_whole = to_integer(*ratio.lower, subcert::Rounding::up) <=
                            to_integer(*ratio.upper, subcert::Rounding::down);
  return minimum(regular, may_be_whole ? Enclosure::at_least(*ratio.lower) : ratio);
}

class VertexProof {
 public:
  VertexProof(const SectorRules& rules, const RegularPart& regular)
      : rules_(rules), regular_(regular), set_(smallest_closed_set(rules)) {
    result_.valence = rules.valence;
    require_rules(rules, set_, regular, CosineField(rules.valence));
  }

  VertexSmoothness run() {
    for (bits_ = first_bits; bits_ <= last_bits && !spectrum_; bits_ *= 2)
      spectrum_ = vertex_spectrum(rules_, set_, bits_);
    bits_ /= 2;
    if (!spectrum_) {
      result_.c1.reason = "the eigenvalues are not separated";
      return result_;
    }
    if (Ball(1, bits_).is_less(abs(spectrum_->groups.front().value))) {
      result_.c1 = {Truth::no, "an eigenvalue has a modulus above 1"};
      keep_evidence_above_one(spectrum_->groups.front());
      return result_;
    }
    const auto leader = leader_of(*spectrum_, rules_, set_);
    if (!leader) {
      result_.c1.reason = fmt::format("no single real subdominant eigenvalue is proved; the largest is about {}",
                                      about(spectrum_->groups.front()));
      return result_;
    }
    const std::vector<Leader::Share> largest = leader->largest();
    result_.frequency = largest.front().frequency;
    result_.subdominant = leader->value.enclosure();
    if (!regular_.c1.is_yes())
      result_.c1.reason = "the regular part is not proved to be C1: " + regular_.c1.reason;
    else if (!Ball(1, bits_).is_less(1 / leader->value))
      result_.c1.reason = "the subdominant eigenvalue is not below 1";
    else if (largest.size() > 1)
      refute_by_several(largest, leader->value);
    else
      result_.frequency == 1 ? prove(largest.front(), leader->value) : refute(largest.front(), leader->value);
    return result_;
  }

 private:
  std::optional<CharacteristicMap> map_of(const Leader::Share& share, const Ball& value) {
    return CharacteristicMap::find(rules_, set_, *regular_.forms, share, value, BallField(rules_.valence, bits_));
  }

  void prove(const Leader::Share& share, const Ball& value) {
    const auto map = map_of(share, value);
    if (!map) {
      result_.c1.reason = "no eigenvector of the subdominant eigenvalue is found";
      return;
    }
    const MapProof proof = map->prove(most_levels);
    result_.levels = proof.levels;
    result_.squares = proof.squares;
    const Decision& deciding = proof.regular.is_yes() ? proof.half_plane : proof.regular;
    result_.c1 = {deciding.truth,
                  deciding.is_yes() ? "the characteristic map is regular and injective" : deciding.reason};
    if (!spectrum_->has_simple_leader()) return;
    if (result_.c1.is_yes())
      look_behind(spectrum_->groups.front());
    else if (proof.folds.empty())
      return;
    keep_evidence(*map, share.frequency, value, {}, proof.folds);
  }

  void keep_evidence(const CharacteristicMap& map, long frequency, const Ball& value, std::optional<long> around,
                     std::vector<LatticePoint> folds) {
    auto evidence = evidence_of(rules_, set_, map, frequency, value, BallField(rules_.valence, bits_),
                                regular_.forms->are_hulls());
    if (!evidence) return;
    evidence->around = around;
    evidence->folds = std::move(folds);
    result_.evidence = std::make_shared<const VertexEvidence>(std::move(*evidence));
  }

  /// Where it is one real number, and the limits of the mask are what certificates ask for.
  void keep_evidence_above_one(const FrequencyGroup& group) {
    const Ball value = group.value.real();
    if (!regular_.c1.is_yes() || group.count > 1 || !Ball(1, bits_).is_less(abs(value))) return;
    const auto map = CharacteristicMap::find(rules_, set_, *regular_.forms, group.frequency, value,
                                             BallField(rules_.valence, bits_));
    if (map) keep_evidence(*map, group.frequency, value, {}, {});
  }

  void refute(const Leader::Share& share, const Ball& value) {
    const auto map = map_of(share, value);
    const std::string what = fmt::format("the subdominant eigenvalue has frequency {}", share.frequency);
    if (const auto curve = map ? map->winds(most_levels) : std::nullopt) {
      result_.c1 = {Truth::no, what};
      if (!spectrum_->has_simple_leader() || curve->is_diagonal) return;
      if (const auto place = map->winds_by_small_squares(*curve))
        keep_evidence(*map, share.frequency, value, place, {});
    } else {
      result_.c1.reason = what + ", and no closed curve without a zero of its map is found";
    }
  }

  /// Three functions or more that lead are those of no graph.
  void refute_by_several(const std::vector<Leader::Share>& shares, const Ball& value) {
    std::vector<long> frequencies;
    for (const Leader::Share& share : shares) frequencies.push_back(share.frequency);
    const std::string what = fmt::format("the subdominant eigenvalue has frequencies {}", fmt::join(frequencies, ", "));
    const bool known = std::ranges::all_of(shares, [&](const Leader::Share& share) {
      const auto map = map_of(share, value);
      return map && map->has_values();
    });
    if (known)
      result_.c1 = {Truth::no, what};
    else
      result_.c1.reason = what + ", and not all of their functions are proved not to be 0";
  }

  /// How |mu| and lambda^2 compare: none where nothing is proved.
  std::optional<CurvatureLimit> compared(const FrequencyGroup& next, const FrequencyGroup& leader) {
    const Ball square = leader.value.real() * leader.value.real(), modulus = abs(next.value);
    if (modulus.is_less(square)) return CurvatureLimit::zero;
    if (square.is_less(modulus)) return CurvatureLimit::unbounded;
    if (next.count > 1) return std::nullopt;
    if (!is_square_) is_square_.emplace(leader, rules_, set_);
    return (*is_square_)(next) ? std::optional(CurvatureLimit::bounded) : std::nullopt;
  }

  /// The eigenvalue behind the leader.
  void look_behind(const FrequencyGroup& leader) {
    if (is_regular_vertex(rules_)) result_.exponent = regular_.exponent;
    if (spectrum_->groups.size() < 2) return;
    const FrequencyGroup& next = spectrum_->groups[1];
    // Of several with moduli that are not told apart the largest may be any: their hull, and the answer of all.
    Ball modulus = abs(next.value);
    std::optional<CurvatureLimit> limit = compared(next, leader);
    for (std::size_t i = 2; i < spectrum_->groups.size(); ++i) {
      const FrequencyGroup& other = spectrum_->groups[i];
      if (abs(other.value).is_less(abs(next.value))) continue;
      modulus = max(modulus, abs(other.value));
      if (limit != compared(other, leader)) limit.reset();
    }
    result_.next = modulus.enclosure();
    if (regular_.curved || limit == CurvatureLimit::unbounded) result_.curvature = limit;
    if (!is_regular_vertex(rules_))
      result_.exponent = exponent_at(leader.value.real(), modulus, limit == CurvatureLimit::bounded, regular_.exponent);
  }

  const SectorRules& rules_;
  const RegularPart& regular_;
  ClosedSet set_;
  VertexSmoothness result_;
  slong bits_ = first_bits;
  std::optional<VertexSpectrum> spectrum_;
  std::optional<SquareTest> is_square_;  // of the leader
};

}  // namespace

std::string to_text(CurvatureLimit limit) {
  return limit == CurvatureLimit::zero ? "zero" : limit == CurvatureLimit::bounded ? "bounded" : "unbounded";
}

RegularPart regular_part(const SectorRules& rules, const Budget& budget) {
  require(!rules.step || is_of_two_steps(rules.mask, *rules.step), "regular part: need the mask of two steps");
  const LatticeMask& mask = rules.step ? *rules.step : rules.mask;
  RegularPart result{rules.mask, {}, regularity_of(mask, budget).exponent(), false, nullptr};
  result.curved = (result.exponent.lower && *result.exponent.lower > 2) || has_bounded_second_derivatives(rules.mask);
  if (result.exponent.lower && *result.exponent.lower > 1) {
    result.c1 = {Truth::yes, "the exponent is above 1"};
  } else {
    ProofLimits limits;
    limits.deadline = budget.deadline;
    for (const LatticePoint& orders : std::vector<LatticePoint>{{1, 0}, {0, 1}}) {
      result.c1 = has_derivative(mask, orders, limits).decision;
      if (!result.c1.is_yes()) break;
    }
  }
  if (result.c1.is_yes()) result.forms = std::make_shared<const CellForms>(rules.mask);
  return result;
}

VertexSmoothness vertex_smoothness(const SectorRules& rules, const RegularPart& regular) {
  return VertexProof(rules, regular).run();
}

std::vector<VertexSmoothness> vertex_smoothness(const std::vector<SectorRules>& rules, const RegularPart& regular,
                                                int threads) {
  std::vector<VertexSmoothness> result(rules.size());
  parallel_for_each(rules.size(), threads, [&](std::size_t i) { result[i] = vertex_smoothness(rules[i], regular); });
  return result;
}

}  // namespace subcert
