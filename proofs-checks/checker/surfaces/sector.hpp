// Rules of a scheme around a vertex where n sectors of the lattice meet: sections 1 and 5.11 of
// ../../certificates/SPEC.md.
#pragma once

#include "../scheme.hpp"
#include "dilation.hpp"

#include <map>
#include <optional>
#include <vector>

namespace subcert_check {

enum class SectorLattice { triangles, quads, dual };

/// A point of sector 0, turned by so many sectors.
struct SectorPoint {
  Point point{};
  long turn = 0;
};

/// One datum of a rule; its weight is a polynomial in c = cos(2 pi/n). With a frequency: the data at the point in all
/// sectors that turn by it.
struct SectorTerm {
  SectorPoint at;
  std::optional<std::size_t> frequency;
  Rationals weight;
  bool over_valence = false;  // the weight is that polynomial over n
};

using SectorRule = std::vector<SectorTerm>;

/// What differs from the mask around a vertex of valence n, or around those of valence n and above.
struct SectorRules {
  SectorLattice lattice = SectorLattice::quads;
  std::size_t valence = 4;
  bool and_above = false;
  std::map<Point, SectorRule> rules;

  bool is_vertex(const Point& point) const;
  /// Whether it is the vertex or a point of sector 0.
  bool is_canonical(const Point& point) const;
  /// A point of the plane around sector 0. Rejects one that is opposite of it.
  SectorPoint in_sector(Point point) const;
  /// The image under the turn by one sector of an index of a mask with this arity.
  Point turned_index(const Point& k, std::int64_t arity) const;
};

/// LATTICE:N;X,Y=WEIGHT@X,Y,TURN|WEIGHT@X,Y~FREQUENCY|...;..., with N+ for N and above
SectorRules parse_sector_rules(std::string_view text);

/// Rejects unless the rules around the vertex have weights of sum 1 and that of the vertex itself turns with the rest.
void check_own_rules(const SectorRules& rules);

/// The line of the points, at most so many, of sector 0 and perhaps the vertex, of which not all are the vertex.
std::vector<Point> read_points(Reader& reader, const SectorRules& rules, std::size_t most);

/// Those that are not the vertex.
std::vector<Point> turning(std::vector<Point> points, const SectorRules& rules);

}  // namespace subcert_check
