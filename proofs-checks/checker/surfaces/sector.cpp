#include "sector.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

constexpr std::int64_t max_place = 16;  // of a point with a rule of its own, and of its data
constexpr std::size_t max_rules = 64, max_terms = 1000;
constexpr std::size_t max_turn = 3;  // of a rule of all valences from 7 on or above

Point parse_canonical(const SectorRules& rules, std::string_view text) {
  const Point point = parse_point(text, 2, max_place);
  require(rules.is_canonical(point), "a point of a rule is not one of sector 0");
  return point;
}

/// WEIGHT@X,Y,TURN or WEIGHT@X,Y~FREQUENCY
SectorTerm parse_term(const SectorRules& rules, std::string_view text) {
  const Fields parts = split(text, "@");
  require(parts.size() == 2, "a term of a rule is WEIGHT@X,Y,TURN or WEIGHT@X,Y~FREQUENCY");
  const bool over_valence = rules.and_above && parts[0].ends_with("/n");
  SectorTerm term{
      {}, {}, parse_polynomial(parts[0].substr(0, parts[0].size() - (over_valence ? 2 : 0)), 'c'), over_valence};
  const Fields ring = split(parts[1], "~");
  if (ring.size() == 2) {
    term.at.point = parse_canonical(rules, ring[0]);
    require(!rules.is_vertex(term.at.point), "the vertex is no ring of data");
    term.frequency = parse_size(ring[1], 0, rules.valence / 2);
    return term;
  }
  const std::size_t comma = std::min(parts[1].rfind(','), parts[1].size() - 1);
  term.at.point = parse_canonical(rules, parts[1].substr(0, comma));
  std::string_view turn = parts[1].substr(comma + 1);
  const bool back = rules.and_above && turn.starts_with('-');
  if (back) turn.remove_prefix(1);
  const std::size_t most = rules.and_above ? max_turn : rules.valence - 1;
  term.at.turn = static_cast<long>(parse_size(turn, back ? 1 : 0, most)) * (back ? -1 : 1);
  require(term.at.turn == 0 || !rules.is_vertex(term.at.point), "the vertex is in no sector");
  return term;
}

Point turned_back(const Point& p, SectorLattice lattice) {
  if (lattice == SectorLattice::triangles) return {p[0] + p[1], -p[0]};
  return {p[1], -p[0] - (lattice == SectorLattice::dual ? 1 : 0)};
}

}  // namespace

bool SectorRules::is_vertex(const Point& point) const { return lattice != SectorLattice::dual && point == Point{}; }

bool SectorRules::is_canonical(const Point& point) const {
  return is_vertex(point) || (point[0] >= (lattice == SectorLattice::dual ? 0 : 1) && point[1] >= 0);
}

SectorPoint SectorRules::in_sector(Point point) const {
  if (is_vertex(point)) return {};
  const long all = lattice == SectorLattice::triangles ? 6 : 4;
  long turns = 0;
  for (; !is_canonical(point); ++turns) point = turned_back(point, lattice);
  require(2 * turns != all || static_cast<long>(valence) == all, "a rule needs data opposite of its sector");
  return {point, 2 * turns > all ? turns - all : turns};
}

Point SectorRules::turned_index(const Point& k, std::int64_t arity) const {
  if (lattice == SectorLattice::triangles) return {-k[1], k[0] + k[1]};
  return {(lattice == SectorLattice::dual ? arity - 1 : 0) - k[1], k[0]};
}

SectorRules parse_sector_rules(std::string_view text) {
  const Fields parts = split(text, ";"), head = split(parts[0], ":");
  SectorRules result;
  require(head.size() == 2 && (head[0] == "triangles" || head[0] == "quads" || head[0] == "dual"),
          "rules around a vertex are triangles:N;..., quads:N;... or dual:N;...");
  result.lattice = head[0] == "triangles" ? SectorLattice::triangles
                   : head[0] == "quads"   ? SectorLattice::quads
                                          : SectorLattice::dual;
  result.and_above = head[1].ends_with('+');
  result.valence = parse_size(head[1].substr(0, head[1].size() - (result.and_above ? 1 : 0)), result.and_above ? 7 : 3,
                              1000);
  require(parts.size() <= max_rules + 1, "more rules than the checker allows");
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Fields sides = split(parts[i], "=");
    require(sides.size() == 2, "a rule is X,Y=TERM|TERM|...");
    const Point point = parse_canonical(result, sides[0]);
    require(!result.rules.contains(point), "two rules for one point");
    SectorRule& rule = result.rules[point];
    const Fields terms = split(sides[1], "|");
    require(terms.size() <= max_terms, "more data than the checker allows");
    for (const std::string_view term : terms) rule.push_back(parse_term(result, term));
  }
  return result;
}

void check_own_rules(const SectorRules& rules) {
  for (const auto& [point, rule] : rules.rules) {
    Rationals sum{-1}, over_valence;
    for (const SectorTerm& term : rule) {
      const bool of_all = term.frequency && *term.frequency == 0;
      require(!rules.is_vertex(point) || of_all || (!term.frequency && rules.is_vertex(term.at.point)),
              "the rule of the vertex does not turn");
      if (term.frequency && !of_all) continue;
      Rationals& part = term.over_valence ? over_valence : sum;
      part.resize(std::max(part.size(), term.weight.size()));
      for (std::size_t k = 0; k < term.weight.size(); ++k) part[k] += term.weight[k];
    }
    const auto is_zero = [](const mpq_class& x) { return x == 0; };
    require(std::ranges::all_of(sum, is_zero) && std::ranges::all_of(over_valence, is_zero),
            "the weights of a rule do not sum to 1");
  }
}

std::vector<Point> turning(std::vector<Point> points, const SectorRules& rules) {
  std::erase_if(points, [&](const Point& point) { return rules.is_vertex(point); });
  return points;
}

std::vector<Point> read_points(Reader& reader, const SectorRules& rules, std::size_t most) {
  std::vector<Point> points;
  for (const std::string_view field : reader.take("points", 1, most)) {
    const Point point = parse_point(field, 2);
    require(std::ranges::find(points, point) == points.end(), "a point occurs twice");
    require(rules.is_canonical(point), "a point is not one of sector 0");
    points.push_back(point);
  }
  require(!turning(points, rules).empty(), "no point of a sector is given");
  return points;
}

}  // namespace subcert_check
