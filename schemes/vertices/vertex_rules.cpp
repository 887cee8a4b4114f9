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

/// The four-point rule along edges from the vertex, with a virtual point on their other side: 4 times the mean of the
/// neighbours, less the three about the edge, less w/(1/2 + w) (4 times the mean of those across, less the four about
/// the edge). So for n = 4 it is the one opposite, and for each n the first new point of a face, by the four-point rule
/// from edge to edge, is the same along both edges.
WrittenRules kobbelt_rules(const LatticeMask& mask) {
  const Rational tension = -mask.symbol().coefficient({3, 0});
  require(tension != Rational(-1, 2), "rules at a vertex: need w other than -1/2, got kobbelt:w=-1/2");
  const char *const h = "1/2 + w", *const wh = "-w*(1/2 + w)", *const w2 = "w^2", *const across = "-w^2/(1/2 + w)";
  const LatticePoint far{2, 0}, beside{2, 1}, mirrored{1, 2}, corner{2, 2}, further{1, 3};
  const std::vector<WrittenWeights> edge{one_of(centre, 0, h),
                                         one_of(ray, 0, "1/2 + 2*w"),
                                         one_of(ray, 1, "w"),
                                         one_of(ray, -1, "w"),
                                         all_of(ray, "-4*w/n"),
                                         one_of(far, 0, "-w"),
                                         one_of(diagonal, 0, across),
                                         one_of(diagonal, -1, across),
                                         one_of(diagonal, 1, across),
                                         one_of(diagonal, -2, across),
                                         all_of(diagonal, "4*w^2/((1/2 + w)*n)")};
  const std::vector<WrittenWeights> face{one_of(centre, 0, "(1/2 + w)^2"),
                                         one_of(ray, 0, "(1/2 + w)*(1/2 + 2*w)"),
                                         one_of(ray, 1, "(1/2 + w)*(1/2 + 2*w)"),
                                         all_of(ray, "-4*w*(1/2 + w)/n"),
                                         one_of(diagonal, 0, "1/4 + w"),
                                         one_of(diagonal, 1, "-w*(1/2 + 2*w)"),
                                         one_of(diagonal, -1, "-w*(1/2 + 2*w)"),
                                         all_of(diagonal, "4*w^2/n"),
                                         one_of(far, 0, wh),
                                         one_of(far, 1, wh),
                                         one_of(beside, 0, wh),
                                         one_of(beside, 1, w2),
                                         one_of(mirrored, 0, wh),
                                         one_of(mirrored, -1, w2),
                                         one_of(corner, 0, w2)};
  // The mask, with a datum on the ray after the next one.
  std::vector<WrittenWeights> second_face;
  const auto is_inner = [](long k) { return k == 0 || k == 1; };
  for (long x = -1; x <= 2; ++x)
    for (long y = 0; y <= 3; ++y) {
      const bool is_beyond = x < 0 && y == 0;
      const SectorPoint at = is_beyond ? SectorPoint{ray, 2} : *in_sector({x, y}, SectorLattice::quads, 8);
      const bool u = is_inner(x), v = is_inner(y - 1);
      second_face.push_back(one_of(at.point, at.turn, u && v ? "(1/2 + w)^2" : u || v ? wh : w2));
    }
  WrittenRules rules = written(mask, SectorLattice::quads,
                               {{ray, edge}, {diagonal, face}, {further, std::move(second_face)}});
  rules.letters = {{'w', tension}};
  return rules.with_numbers();  // a file that changes some has letters of its own
}

/// One step of four-eight at a regular vertex: half way to the mean of its four neighbours.
SectorRule four_eight_regular(const LatticePoint& vertex, const SectorRules& at) {
  std::vector<LatticePoint> points(4, vertex);
  for (const LatticePoint& step : std::vector<LatticePoint>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
    points.push_back(vertex + step);
  return mean_of(points, at);
}

/// The first step makes middles of faces, the second those of the squares on the edges.
std::map<LatticePoint, SectorRule> four_eight_rules(const SectorRules& at) {
  const LatticePoint next{0, 1};
  const Rational quarter(1, 4), eighth(1, 8);
  const SectorRule vertex = towards_the_mean(Rational(1, 2)), middle = mean_of({centre, ray, diagonal, next}, at);
  std::map<LatticePoint, SectorRule> rules;
  add(add_ring(add_ring(rules[centre], ray, 0, Rational(1, 2)), diagonal, 0, eighth), centre, Rational(3, 8));
  for (const SectorRule& end : {vertex, four_eight_regular(ray, at)}) add(rules[ray], quarter, end, 0, at);
  for (const long turns : {-1L, 0L}) add(rules[ray], quarter, middle, turns, at);
  add(rules[diagonal], Rational(1, 2), middle, 0, at);
  for (const SectorRule& corner :
       {vertex, four_eight_regular(ray, at), four_eight_regular(next, at), four_eight_regular(diagonal, at)})
    add(rules[diagonal], eighth, corner, 0, at);
  return rules;
}

/// The mask is its own mirror image, so that its dilation may be one whose square is 2.
SectorRules two_step_four_eight_rules(const LatticeMask& mask, long n) {
  const LatticeMask step(mask.symbol(), Dilation({{1, 1}, {1, -1}}));
  SectorRules result{n, SectorLattice::quads, {two_step_symbol(step), 2}};
  result.rules = four_eight_rules(result);
  result.step = step;
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

using WrittenMaker = WrittenRules (*)(const LatticeMask& mask);

const std::map<std::string, WrittenMaker, std::less<>>& written_makers() {
  static const std::map<std::string, WrittenMaker, std::less<>> table{
      {"loop", loop_rules},           {"catmull-clark", catmull_clark_rules},
      {"doo-sabin", doo_sabin_rules}, {"midedge", midedge_rules},
      {"butterfly", butterfly_rules}, {"modified-butterfly", modified_butterfly_rules},
      {"kobbelt", kobbelt_rules}};
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
      {"four-eight", {[](const Scheme& scheme, long n) { return two_step_four_eight_rules(scheme.mask, n); }, true}},
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
