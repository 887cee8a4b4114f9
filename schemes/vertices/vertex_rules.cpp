#include "vertex_rules.hpp"

#include "regression_rules.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/specification_text.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

namespace subcert {
namespace {

const LatticePoint centre{0, 0}, ray{1, 0}, diagonal{1, 1};

LaurentPolynomial c() { return LaurentPolynomial::monomial(1, 1); }

SectorRule& add(SectorRule& rule, const LatticePoint& point, const LaurentPolynomial& weight, long turn = 0) {
  rule.terms.push_back({{point, turn}, weight});
  return rule;
}

SectorRule& add_ring(SectorRule& rule, const LatticePoint& point, long frequency, const LaurentPolynomial& weight) {
  rule.rings.push_back({point, frequency, weight});
  return rule;
}

SectorRule towards_the_mean(const LaurentPolynomial& part) {
  SectorRule rule;
  add(rule, centre, LaurentPolynomial(1) - part);
  return add_ring(rule, ray, 0, part);
}

/// The mean of points of the plane of sector 0 and beside it.
SectorRule mean_of(const std::vector<LatticePoint>& points, const SectorRules& at) {
  SectorRule rule;
  for (const LatticePoint& point : points)
    rule.terms.push_back({*in_sector(point, at.lattice, at.valence), Rational(1, static_cast<long>(points.size()))});
  return rule;
}

/// A sum of rules, datum by datum.
void add(SectorRule& sum, const Rational& factor, const SectorRule& rule, long turns, const SectorRules& at) {
  for (const SectorTerm& term : rule.terms)
    sum.terms.push_back({turned(term.at, turns, at.lattice, at.valence), factor * term.weight});
  for (const RingTerm& ring : rule.rings) sum.rings.push_back({ring.point, ring.frequency, factor * ring.weight});
}

/// One step of sqrt3 at a regular vertex: a third of the way to the mean of its six neighbours.
SectorRule sqrt3_regular(const LatticePoint& vertex, const SectorRules& at) {
  std::vector<LatticePoint> points(12, vertex);
  for (const LatticePoint& step : std::vector<LatticePoint>{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}})
    points.push_back(vertex + step);
  return mean_of(points, at);
}

std::map<LatticePoint, SectorRule> sqrt3_rules(const SectorRules& at) {
  const LatticePoint next{0, 1};
  const SectorRule vertex = sqrt3_vertex_rule(), middle = mean_of({centre, ray, next}, at),
                   across = mean_of({ray, next, diagonal}, at);
  const Rational third = Rational(1, 3);
  // The middles of the triangles at the vertex have the mean 1/3 of it and 2/3 of that of its neighbours.
  const LaurentPolynomial part = vertex.rings.front().weight, rest = LaurentPolynomial(1) - part;
  std::map<LatticePoint, SectorRule> rules;
  rules[centre] = towards_the_mean(rest * part + Rational(2, 3) * part);
  add(rules[ray], third, vertex, 0, at);
  add(rules[ray], third, middle, 0, at);
  add(rules[ray], third, middle, -1, at);
  // The middle of the first triangle, with valence 6 from then on, among the new vertices around it.
  SectorRule& inner = rules[diagonal];
  add(inner, Rational(2, 3), middle, 0, at);
  for (const SectorRule& corner : {vertex, sqrt3_regular(ray, at), sqrt3_regular(next, at), across})
    add(inner, Rational(1, 18), corner, 0, at);
  for (const long turns : {-1L, 1L}) add(inner, Rational(1, 18), middle, turns, at);
  return rules;
}

WrittenWeights all_of(const LatticePoint& point, const char* weight) { return {point, std::nullopt, {weight}}; }
WrittenWeights one_of(const LatticePoint& point, long turn, const char* weight) { return {point, turn, {weight}}; }

/// Rules as they are printed where they come from.
WrittenRules written(const LatticeMask& mask, SectorLattice lattice, std::vector<WrittenRule> rules) {
  return {lattice, mask_in_sectors(mask, lattice), std::move(rules)};
}

WrittenRules loop_rules(const LatticeMask& mask) {
  return written(mask, SectorLattice::triangles,
                 {{centre, {one_of(centre, 0, "3/8 + (3/8 + c/4)^2"), all_of(ray, "(5/8 - (3/8 + c/4)^2)/n")}}});
}

WrittenRules catmull_clark_rules(const LatticeMask& mask) {
  return written(
      mask, SectorLattice::quads,
      {{centre, {one_of(centre, 0, "1 - 7/(4*n)"), all_of(ray, "3/(2*n^2)"), all_of(diagonal, "1/(4*n^2)")}}});
}

WrittenRules doo_sabin_rules(const LatticeMask& mask) {
  return written(mask, SectorLattice::dual, {{centre, {one_of(centre, 0, "1/4"), all_of(centre, "(3 + 2*C)/(4*n)")}}});
}

WrittenRules midedge_rules(const LatticeMask&) {
  return written(make_linear_scheme("zwart-powell:").mask, SectorLattice::dual,
                 {{centre, {one_of(centre, 0, "1/2"), one_of(centre, 1, "1/4"), one_of(centre, -1, "1/4")}}});
}

WrittenRules butterfly_rules(const LatticeMask& mask) { return written(mask, SectorLattice::triangles, {}); }

/// cos(4 pi t/n) is 2 C^2 - 1.
WrittenRules modified_butterfly_rules(const LatticeMask& mask) {
  const auto edge = [](const char* weights) {
    return std::vector<WrittenWeights>{one_of(centre, 0, "3/4"), all_of(ray, weights)};
  };
  const char* const usual = "(1/4 + C + (2*C^2 - 1)/2)/n";
  return written(mask, SectorLattice::triangles,
                 {{ray, edge("(1/4 + C)/n"), 3, 3},
                  {ray, edge("(1/4 + C + (2*C^2 - 1)/4)/n"), 4, 4},
                  {ray, edge(usual), 5, 5},
                  {ray, edge(usual), 7}});
}

SectorRules two_step_sqrt3_rules(const LatticeMask& mask, long n) {
  SectorRules result{n, SectorLattice::triangles, {two_step_symbol(mask), 3}};
  result.rules = sqrt3_rules(result);
  result.step = mask;
  return result;
}

SectorRules triangular_rules(const Scheme& scheme, long n) {
  return {n, SectorLattice::triangles, scheme.mask,
          regression_rules_at(*specification_text::ball_regression_of(scheme.specification), n)};
}

using WrittenMaker = WrittenRules (*)(const LatticeMask& mask);

const std::map<std::string, WrittenMaker, std::less<>>& written_makers() {
  static const std::map<std::string, WrittenMaker, std::less<>> table{
      {"loop", loop_rules},           {"catmull-clark", catmull_clark_rules},
      {"doo-sabin", doo_sabin_rules}, {"midedge", midedge_rules},
      {"butterfly", butterfly_rules}, {"modified-butterfly", modified_butterfly_rules}};
  return table;
}

/// Those that are computed from others.
struct Maker {
  std::function<SectorRules(const Scheme&, long)> rules;
  bool of_all_valences;  ///< the weights are polynomials in c, the same for all
};

const std::map<std::string, Maker, std::less<>>& makers() {
  static const std::map<std::string, Maker, std::less<>> table{
      {"sqrt3", {[](const Scheme& scheme, long n) { return two_step_sqrt3_rules(scheme.mask, n); }, true}},
      {"triangular", {triangular_rules, false}}};
  return table;
}

std::string name_of(const Scheme& scheme) { return scheme.specification.substr(0, scheme.specification.find(':')); }

}  // namespace

SectorRule sqrt3_vertex_rule() { return towards_the_mean(Rational(1, 9) * (LaurentPolynomial(4) - 2 * c())); }

VertexScheme VertexScheme::named(std::string_view specification) {
  const Scheme scheme = make_linear_scheme(specification);
  VertexScheme result{scheme.specification, scheme.title, {}, {}};
  if (const auto rules = written_makers().find(name_of(scheme)); rules != written_makers().end()) {
    result.written = rules->second(scheme.mask);
    return result;
  }
  const auto maker = makers().find(name_of(scheme));
  require(maker != makers().end(), "rules at a vertex: need one of {}, got {}",
          fmt::join(schemes_with_vertex_rules(), ", "), scheme.specification);
  result.computed = [scheme, rules = maker->second.rules](long n) { return rules(scheme, n); };
  result.of_all_valences = maker->second.of_all_valences;
  return result;
}

SectorRules VertexScheme::at(long valence) const {
  require(valence >= smallest_valence, "rules at a vertex: need valence >= {}, got {}", smallest_valence, valence);
  return written ? rules_at(*written, valence) : computed(valence);
}

std::vector<SectorRules> VertexScheme::at(const std::vector<int>& valences) const {
  std::vector<SectorRules> result;
  for (const int n : valences) result.push_back(at(n));
  return result;
}

SectorRuleFamily VertexScheme::family() const {
  require(of_all_valences, "rules at a vertex: those of {} are not the same polynomials for all valences",
          specification);
  // The rules of smaller valences, and of regular ones, are their own.
  return written ? rule_family(*written) : SectorRuleFamily{computed(SectorRuleFamily::many), 7};
}

SectorRules vertex_rules(std::string_view specification, long valence) {
  return VertexScheme::named(specification).at(valence);
}

SectorRuleFamily vertex_rule_family(std::string_view specification) {
  return VertexScheme::named(specification).family();
}

bool has_vertex_rules(const Scheme& scheme) {
  return written_makers().contains(name_of(scheme)) || makers().contains(name_of(scheme));
}

std::vector<std::string> schemes_with_vertex_rules() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : written_makers()) names.push_back(name);
  for (const auto& [name, maker] : makers()) names.push_back(name);
  std::ranges::sort(names);
  return names;
}

}  // namespace subcert
