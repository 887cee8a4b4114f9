#include "sector_block.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace subcert::vertex {
namespace {

std::set<LatticePoint> data_of(const SectorRule& rule) {
  std::set<LatticePoint> points;
  for (const SectorTerm& term : rule.terms) points.insert(term.at.point);
  for (const RingTerm& ring : rule.rings) points.insert(ring.point);
  return points;
}

/// Rules of these points and of all they depend on.
std::map<LatticePoint, SectorRule> closure(std::vector<LatticePoint> open, const SectorRules& rules) {
  std::map<LatticePoint, SectorRule> known;
  while (!open.empty()) {
    const LatticePoint point = open.back();
    open.pop_back();
    if (known.count(point) > 0) continue;
    const SectorRule& rule = known[point] = rules.rule_at(point);
    for (const LatticePoint& datum : data_of(rule)) open.push_back(datum);
  }
  return known;
}

}  // namespace

ClosedSet smallest_closed_set(const SectorRules& rules) {
  // A datum of P has |x| + |y| <= (that of P + reach) / m + 1.
  long reach = 0;
  for (const Monomial& term : rules.mask.symbol().terms())
    reach = std::max(reach, std::abs(term.exponents[0]) + std::abs(term.exponents[1]));
  const long m = rules.mask.arity(), size = (reach + m) / (m - 1), least = rules.lattice == SectorLattice::dual ? 0 : 1;
  std::vector<LatticePoint> start;
  for (const LatticePoint& point : points_of_box({least, 0}, {size, size})) start.push_back(point);
  for (const auto& [point, rule] : rules.rules) start.push_back(point);
  if (least == 1) start.push_back({0, 0});
  const std::map<LatticePoint, SectorRule> known = closure(std::move(start), rules);
  std::vector<LatticePoint> recurrent;
  for (const auto& [point, rule] : known) {
    const std::set<LatticePoint> data = data_of(rule);
    if (closure({data.begin(), data.end()}, rules).count(point) > 0) recurrent.push_back(point);
  }
  return {closure(std::move(recurrent), rules)};
}

ClosedSet with_rules_of(const SectorRules& rules, ClosedSet set) {
  for (auto& [point, rule] : set.rules) rule = rules.rule_at(point);
  return set;
}

SectorPoint mirror_image(const LatticePoint& point, const SectorRules& rules) {
  return *in_sector({point[1], point[0]}, rules.lattice, rules.valence);
}

bool turns_with_sectors(const SectorRules& rules) {
  const bool is_dual = rules.lattice == SectorLattice::dual, is_triangular = rules.lattice == SectorLattice::triangles;
  const long shift = is_dual ? rules.mask.arity() - 1 : 0;
  for (const LatticeMask::Term& term : rules.mask.terms()) {
    const long x = term.exponents[0], y = term.exponents[1];
    if (rules.mask.symbol().coefficient({shift - y, is_triangular ? x + y : x}) != term.coefficient) return false;
  }
  const LatticePoint vertex{0, 0};
  if (is_dual || (rules.rules.count(vertex) == 0 && rules.valence == regular_valence(rules.lattice))) return true;
  const SectorRule rule = rules.rule_at(vertex);
  return std::ranges::all_of(rule.terms, [&](const SectorTerm& term) { return term.at.point == vertex; }) &&
         std::ranges::all_of(rule.rings, [](const RingTerm& ring) { return ring.frequency == 0; });
}

bool is_symmetric(const SectorRules& rules, const ClosedSet& set) {
  for (const Monomial& term : rules.mask.symbol().terms())
    if (rules.mask.symbol().coefficient({term.exponents[1], term.exponents[0]}) != term.coefficient) return false;
  using Sum = std::map<SectorPoint, LaurentPolynomial>;
  for (const auto& [point, rule] : set.rules) {
    const SectorPoint image = mirror_image(point, rules);
    const SectorRule other = rules.rule_at(image.point);
    // Rings stand apart from all turns. One is even in the turns: turned, it is the same only with frequency 0.
    Sum mirrored, expected;
    for (const SectorTerm& term : rule.terms)
      mirrored[turned(mirror_image(term.at.point, rules), -term.at.turn, rules.lattice, rules.valence)] += term.weight;
    for (const SectorTerm& term : other.terms)
      expected[turned(term.at, image.turn, rules.lattice, rules.valence)] += term.weight;
    for (const RingTerm& ring : rule.rings) {
      const SectorPoint at = mirror_image(ring.point, rules);
      if (ring.frequency != 0 && at.turn != image.turn) return false;
      mirrored[{at.point, -1 - ring.frequency}] += ring.weight;
    }
    for (const RingTerm& ring : other.rings) expected[{ring.point, -1 - ring.frequency}] += ring.weight;
    for (Sum* sum : {&mirrored, &expected})
      std::erase_if(*sum, [](const auto& entry) { return entry.second.is_zero(); });
    if (mirrored != expected) return false;
  }
  return true;
}

}  // namespace subcert::vertex
