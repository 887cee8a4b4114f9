#pragma once
/// The rules of the classical surface schemes at vertices of any valence.

#include <subcert/schemes/specification.hpp>
#include <subcert/schemes/vertices/written_rules.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert {

/// The rules of a scheme at a vertex of valence n, those of a dual one at a face with n corners, c = cos(2 pi/n):
///   loop                the vertex moves by 5/8 - (3/8 + c/4)^2 towards the mean of its neighbours [Loo87]
///   catmull-clark       the vertex is 1 - 7/(4n) times itself, 3/2 and 1/4 over n^2 times its neighbours and those
///                       across a face [CC78]
///   doo-sabin           (3 + 2 cos(2 pi t/n)) / (4n), and 1/4 more for t = 0 [DS78]
///   midedge             1/2, and 1/4 on both sides: two steps, each to the midpoints of the edges [PR97]
///   butterfly           the mask along the edges as they are [DLG90]
///   modified-butterfly  (1/4 + cos(2 pi t/n) + cos(4 pi t/n)/2) / n at the edges of vertices with n != 6 [ZSS96]
///   kobbelt:w           the four-point rule from edge to edge, along edges at the vertex with a virtual point [Kob96]
///   four-eight          two steps, each with the vertex moved half way to the mean of its neighbours [VZ01]
///   sqrt3               two steps, each with the vertex moved by (4 - 2c)/9 towards the mean [Kob00]
///   triangular          the vertex and its edges by the fits of the mask, to the data in the flat fan: an equilateral
///                       grid, 9/4 < L^2 <= 3, d <= 2, no weights but a power; regression_rules.hpp
/// Two steps of the dilations that turn the lattice are one of 2 or 3 times the identity. Domain: valence >= 3. Errors:
/// throws a SpecificationError for what is no scheme, a domain Error for one that has no rules here.
SectorRules vertex_rules(std::string_view specification, long valence);
inline constexpr int smallest_valence = 3, largest_valence = 1000;  ///< of what is answered one by one
bool has_vertex_rules(const Scheme& scheme);

/// A surface scheme with rules at vertices of any valence: one of those, or one that is written down.
struct VertexScheme {
  std::string specification;
  std::string title;
  std::optional<WrittenRules> written;
  std::function<SectorRules(long valence)> computed;  ///< where they are not written
  bool of_all_valences = true;                        ///< whether they are the same polynomials for all valences

  /// Errors: as vertex_rules().
  static VertexScheme named(std::string_view specification);
  /// Domain: valence >= 3. Errors: as rules_at().
  SectorRules at(long valence) const;
  /// The same for several valences, in their order.
  std::vector<SectorRules> at(const std::vector<int>& valences) const;
  /// Those of all valences from a least one on, where no rule is one of a single valence any more. Errors: as
  /// rule_family().
  SectorRuleFamily family() const;
};

/// The same of all valences from a least one on, where no rule is one of a single valence any more.
SectorRuleFamily vertex_rule_family(std::string_view specification);

/// The rule of one step of sqrt3 at a vertex of any valence; its other points are the middles of triangles.
SectorRule sqrt3_vertex_rule();

/// The schemes with such rules, as they may be written.
std::vector<std::string> schemes_with_vertex_rules();

}  // namespace subcert
