#include "sector_rules.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

/// Turned by one sector against the sense of turning, about the vertex or the centre.
LatticePoint turned_back(const LatticePoint& point, SectorLattice lattice) {
  const long x = point[0], y = point[1];
  if (lattice == SectorLattice::triangles) return {x + y, -x};
  return {y, lattice == SectorLattice::dual ? -x - 1 : -x};
}

bool is_in_sector_zero(const LatticePoint& point, SectorLattice lattice) {
  return point[1] >= 0 && point[0] >= (lattice == SectorLattice::dual ? 0 : 1);
}

bool is_vertex(const LatticePoint& point, SectorLattice lattice) {
  return lattice != SectorLattice::dual && point == LatticePoint{0, 0};
}

Ball value_of(const LaurentPolynomial& p, const Ball& at) {
  Ball value(0, at.bits());
  for (long k = p.is_zero() ? -1 : p.highest(); k >= 0; --k) value = value * at + Ball(p.coefficient(k), at.bits());
  return value;
}

template <class Rules, class Visit>
void for_each_weight(Rules& rules, const Visit& visit) {
  for (auto& [point, rule] : rules.rules) {
    for (auto& term : rule.terms) visit(term.weight);
    for (auto& ring : rule.rings) visit(ring.weight);
  }
}

}  // namespace

MultivariatePolynomial two_step_symbol(const LatticeMask& mask) {
  std::vector<Monomial> coarse;
  for (const Monomial& term : mask.symbol().terms())
    coarse.push_back({term.coefficient, mask.dilation() * term.exponents});
  return mask.symbol() * MultivariatePolynomial(2, coarse);
}

SectorPoint turned(SectorPoint point, long turns, SectorLattice lattice, long valence) {
  if (!is_vertex(point.point, lattice)) point.turn = ((point.turn + turns) % valence + valence) % valence;
  return point;
}

std::optional<SectorPoint> in_sector(const LatticePoint& point, SectorLattice lattice, long valence) {
  if (is_vertex(point, lattice)) return SectorPoint{point};
  const long all = regular_valence(lattice);
  LatticePoint at = point;
  long turns = 0;
  for (; !is_in_sector_zero(at, lattice); ++turns) at = turned_back(at, lattice);
  if (2 * turns == all && valence != all) return std::nullopt;
  return turned({at, 0}, 2 * turns > all ? turns - all : turns, lattice, valence);
}

SectorRule SectorRules::rule_at(const LatticePoint& point) const {
  std::map<SectorPoint, LaurentPolynomial> sum;
  SectorRule result;
  if (const auto own = rules.find(point); own != rules.end()) {
    for (const SectorTerm& term : own->second.terms) sum[term.at] += term.weight;
    result.rings = own->second.rings;
  } else {
    const long factor = mask.arity();
    for (const LatticeMask::Term& term : mask.terms()) {
      const long x = point[0] - term.exponents[0], y = point[1] - term.exponents[1];
      if (x % factor != 0 || y % factor != 0) continue;
      const auto at = in_sector({x / factor, y / factor}, lattice, valence);
      require(at.has_value(), "rule at ({}, {}) of a vertex of valence {}: need data beside the sector, got ({}, {})",
              point[0], point[1], valence, x / factor, y / factor);
      sum[*at] += term.coefficient;
    }
  }
  for (auto& [at, weight] : sum)
    if (!weight.is_zero()) result.terms.push_back({at, std::move(weight)});
  return result;
}

std::vector<long> letter_exponents(long power, std::size_t letters) {
  std::vector<long> result{power % letter_stride};
  long rest = power / letter_stride;
  for (std::size_t v = 1; v < letters; ++v) {
    result.push_back(rest % letter_powers);
    rest /= letter_powers;
  }
  result.push_back(rest);
  return result;
}

long letter_power(const std::vector<long>& exponents) {
  long result = exponents.back();
  for (std::size_t v = exponents.size() - 1; v-- > 0;)
    result = result * (v == 0 ? letter_stride : letter_powers) + exponents[v];
  return result;
}

SectorRules with_letter_values(SectorRules rules, const std::vector<LaurentPolynomial>& values) {
  for_each_weight(rules, [&](LaurentPolynomial& weight) {
    LaurentPolynomial result;
    for (long power = weight.is_zero() ? 0 : weight.lowest(); !weight.is_zero() && power <= weight.highest(); ++power) {
      if (weight.coefficient(power) == 0) continue;
      const std::vector<long> exponents = letter_exponents(power, values.size());
      LaurentPolynomial product = LaurentPolynomial::monomial(weight.coefficient(power), exponents[0]);
      for (std::size_t v = 0; v < values.size(); ++v) product *= values[v].pow(exponents[v + 1]);
      result += product;
    }
    weight = std::move(result);
  });
  return rules;
}

std::vector<long> letter_degrees(const SectorRules& rules, std::size_t letters) {
  std::vector<long> degrees(letters, 0);
  for_each_weight(rules, [&](const LaurentPolynomial& weight) {
    for (long power = weight.is_zero() ? 0 : weight.lowest(); !weight.is_zero() && power <= weight.highest(); ++power) {
      if (weight.coefficient(power) == 0) continue;
      const std::vector<long> exponents = letter_exponents(power, letters);
      for (std::size_t v = 0; v < letters; ++v) degrees[v] = std::max(degrees[v], exponents[v + 1]);
    }
  });
  return degrees;
}

SectorRules SectorRuleFamily::at(long valence) const {
  require(valence >= least || valence == rules.valence, "rules at a vertex: need valence >= {}, got {}", least,
          valence);
  SectorRules result = rules;
  result.valence = valence;
  for (auto& [point, rule] : result.rules)
    for (SectorTerm& term : rule.terms) {
      const long turns = 2 * term.at.turn > rules.valence ? term.at.turn - rules.valence : term.at.turn;
      term.at = turned({term.at.point, 0}, turns, rules.lattice, valence);
    }
  if (over_vertex.terms.empty() && over_vertex.rings.empty()) return result;
  const LaurentPolynomial share = Rational(Integer(1), Integer(valence));
  SectorRule& vertex = result.rules[{0, 0}];
  const auto add = [&](auto& sum, const auto& more, const auto& place) {
    for (auto term : more) {
      term.weight *= share;
      const auto own = std::ranges::find(sum, place(term), place);
      own == sum.end() ? sum.push_back(term) : void(own->weight += term.weight);
    }
  };
  add(vertex.terms, over_vertex.terms, [](const SectorTerm& term) { return term.at; });
  add(vertex.rings, over_vertex.rings, [](const RingTerm& ring) { return std::pair(ring.point, ring.frequency); });
  return result;
}

std::vector<std::pair<SectorPoint, Enclosure>> weights_at(const SectorRule& rule, SectorLattice lattice, long valence,
                                                          int bits) {
  const slong working = bits + 30;
  const auto cosine = [&](long multiple) {
    return cos(Ball::pi(working) * Ball(Rational(Integer(2 * (multiple % valence)), Integer(valence)), working));
  };
  const Ball c = cosine(1);
  std::map<SectorPoint, Ball> sum;
  const auto add = [&](const SectorPoint& at, const Ball& weight) {
    const auto [entry, is_new] = sum.try_emplace(at, weight);
    if (!is_new) entry->second += weight;
  };
  for (const SectorTerm& term : rule.terms) add(term.at, value_of(term.weight, c));
  for (const RingTerm& ring : rule.rings) {
    const bool is_alone = ring.frequency == 0 || 2 * ring.frequency == valence;
    const Ball weight = value_of(ring.weight, c) * (is_alone ? 1 : 2) / valence;
    for (long t = 0; t < valence; ++t)
      add(turned({ring.point, 0}, t, lattice, valence), weight * cosine(ring.frequency * t));
  }
  std::vector<std::pair<SectorPoint, Enclosure>> result;
  for (const auto& [at, weight] : sum) result.emplace_back(at, weight.enclosure(bits));
  return result;
}

}  // namespace subcert
