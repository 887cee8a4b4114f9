#include "vertex_rules.hpp"

#include "regression_rules.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/specification_text.hpp>

#include <fmt/ranges.h>

#include <functional>

namespace subcert {
namespace {

const LatticePoint centre{0, 0}, ray{1, 0}, diagonal{1, 1};

LaurentPolynomial c() { return LaurentPolynomial::monomial(1, 1); }

/// The same coefficients at other places.
template <class Place>
LatticeMask placed(const MultivariatePolynomial& symbol, int arity, Place place) {
  std::vector<Monomial> terms;
  for (const Monomial& term : symbol.terms()) terms.push_back({term.coefficient, place(term.exponents)});
  return {MultivariatePolynomial(2, terms), arity};
}

/// From the directions (1,0), (0,1), (1,1) to those of a sector.
LatticeMask with_triangles(const LatticeMask& mask) {
  return placed(mask.symbol(), mask.arity(), [](const LatticePoint& at) { return LatticePoint{at[0] - at[1], at[1]}; });
}

/// New points around the middle of the old ones: the mask has its middle in (m - 1)/2 along each axis.
LatticeMask with_dual_middle(const LatticeMask& mask) {
  const LatticePoint low = mask.symbol().lowest(), high = mask.symbol().highest();
  return placed(mask.symbol(), mask.arity(), [&](const LatticePoint& at) {
    LatticePoint result = at;
    for (std::size_t v = 0; v < 2; ++v) result[v] += (mask.arity() - 1 - low[v] - high[v]) / 2;
    return result;
  });
}

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

SectorRules loop_rules(const LatticeMask& mask, long n) {
  const LaurentPolynomial inner = LaurentPolynomial(Rational(3, 8)) + Rational(1, 4) * c();
  SectorRules result{n, SectorLattice::triangles, with_triangles(mask)};
  result.rules[centre] = towards_the_mean(LaurentPolynomial(Rational(5, 8)) - inner * inner);
  return result;
}

SectorRules catmull_clark_rules(const LatticeMask& mask, long n) {
  SectorRules result{n, SectorLattice::quads, mask};
  add(result.rules[centre], centre, Rational(1));
  return result;
}

SectorRule catmull_clark_over_valence() {
  SectorRule vertex;
  add(vertex, centre, Rational(-7, 4));
  add_ring(vertex, ray, 0, Rational(3, 2));
  return add_ring(vertex, diagonal, 0, Rational(1, 4));
}

SectorRules doo_sabin_rules(const LatticeMask& mask, long n) {
  SectorRules result{n, SectorLattice::dual, with_dual_middle(mask)};
  SectorRule& corner = add(result.rules[centre], centre, Rational(1, 4));
  add_ring(corner, centre, 0, Rational(3, 4));
  add_ring(corner, centre, 1, Rational(1, 4));
  return result;
}

SectorRules midedge_rules(const LatticeMask&, long n) {
  SectorRules result{n, SectorLattice::dual, with_dual_middle(make_linear_scheme("zwart-powell:").mask)};
  SectorRule& corner = add(result.rules[centre], centre, Rational(1, 2));
  add(corner, centre, Rational(1, 4), 1);
  add(corner, centre, Rational(1, 4), n - 1);
  return result;
}

SectorRules butterfly_rules(const LatticeMask& mask, long n) {
  return {n, SectorLattice::triangles, with_triangles(mask)};
}

SectorRules modified_butterfly_rules(const LatticeMask& mask, long n) {
  SectorRules result = butterfly_rules(mask, n);
  if (n == 6) return result;
  SectorRule& edge = add(result.rules[ray], centre, Rational(3, 4));
  add_ring(edge, ray, 0, Rational(1, 4));
  add_ring(edge, ray, 1, Rational(1, 2));
  if (n > 3) add_ring(edge, ray, 2, Rational(1, 4));
  return result;
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

struct Maker {
  std::function<SectorRules(const Scheme&, long)> rules;
  SectorRule over_vertex = {};
  bool of_all_valences = true;  ///< the weights are polynomials in c, and those of the vertex in 1/n, the same for all

  SectorRuleFamily of(const Scheme& scheme, long valence, long least) const {
    return {rules(scheme, valence), least, over_vertex};
  }
};

Maker of_mask(SectorRules (*rules)(const LatticeMask&, long), const SectorRule& over_vertex = {}) {
  return {[rules](const Scheme& scheme, long n) { return rules(scheme.mask, n); }, over_vertex};
}

const std::map<std::string, Maker, std::less<>>& makers() {
  static const std::map<std::string, Maker, std::less<>> table{
      {"loop", of_mask(loop_rules)},
      {"catmull-clark", of_mask(catmull_clark_rules, catmull_clark_over_valence())},
      {"doo-sabin", of_mask(doo_sabin_rules)},
      {"midedge", of_mask(midedge_rules)},
      {"butterfly", of_mask(butterfly_rules)},
      {"modified-butterfly", of_mask(modified_butterfly_rules)},
      {"sqrt3", of_mask(two_step_sqrt3_rules)},
      {"triangular", {triangular_rules, {}, false}}};
  return table;
}

auto found_maker(const Scheme& scheme) {
  return makers().find(scheme.specification.substr(0, scheme.specification.find(':')));
}

const Maker& maker_of(const Scheme& scheme) {
  const auto maker = found_maker(scheme);
  require(maker != makers().end(), "rules at a vertex: need one of {}, got {}",
          fmt::join(schemes_with_vertex_rules(), ", "), scheme.specification);
  return maker->second;
}

}  // namespace

SectorRule sqrt3_vertex_rule() { return towards_the_mean(Rational(1, 9) * (LaurentPolynomial(4) - 2 * c())); }

SectorRules vertex_rules(std::string_view specification, long valence) {
  require(valence >= smallest_valence, "rules at a vertex: need valence >= {}, got {}", smallest_valence, valence);
  const Scheme scheme = make_linear_scheme(specification);
  return maker_of(scheme).of(scheme, valence, valence).at(valence);
}

SectorRuleFamily vertex_rule_family(std::string_view specification) {
  const Scheme scheme = make_linear_scheme(specification);
  const Maker& maker = maker_of(scheme);
  require(maker.of_all_valences, "rules at a vertex: those of {} are not the same polynomials for all valences",
          scheme.specification);
  // The rules of smaller valences, and of regular ones, are their own.
  return maker.of(scheme, SectorRuleFamily::many, 7);
}

std::vector<SectorRules> vertex_rules(std::string_view specification, const std::vector<int>& valences) {
  std::vector<SectorRules> result;
  for (const int n : valences) result.push_back(vertex_rules(specification, n));
  return result;
}

bool has_vertex_rules(const Scheme& scheme) { return found_maker(scheme) != makers().end(); }

std::vector<std::string> schemes_with_vertex_rules() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : makers()) names.push_back(name);
  return names;
}

}  // namespace subcert
