#pragma once
/// Whether the limits of a scheme are smooth at a vertex, proved for one valence.

#include <subcert/analysis/symbol/masks/sector_rules.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace subcert {

namespace vertex {
struct CellForms;
}

/// What the surface is away from vertices, found once for a mask.
struct RegularPart {
  LatticeMask mask;
  Decision c1;         ///< whether all limits have continuous first derivatives, the limits of divided differences
  Enclosure exponent;  ///< of Hoelder, as regularity_of()
  bool curved;         ///< whether second derivatives are proved to exist almost everywhere, bounded
  std::shared_ptr<const vertex::CellForms> forms;  ///< where c1 is yes
};

/// Of the mask of rules, by their `step` where they have one. Errors: throws Error for a step that is none. Cost: that
/// of regularity_of().
RegularPart regular_part(const SectorRules& rules, const Budget& budget);

/// Of the curvature at the points x/m^k, x fixed, for k -> infinity: |mu| below, equal to or above lambda^2.
enum class CurvatureLimit { zero, bounded, unbounded };
std::string to_text(CurvatureLimit limit);

/// What tells a checker of certificates the map of an eigenvalue, rounded: the leading one, or one above 1 in modulus.
/// Proof: SPEC.md, sections 5.11 and 5.14.
struct VertexEvidence {
  using Pair = std::array<Rational, 2>;  // x + y w, w = exp(2 pi i k/n); y = 0 where w is real

  long frequency = 1;    ///< k
  bool by_hulls = true;  ///< whether derivatives lie in hulls of differences; else they are near affine fits
  std::vector<LatticePoint> points;  ///< of a closed set; the vertex, if it is one of them, stands first for k > 0
  Rational lambda;
  std::vector<Pair> values;                ///< of the map's data at the points, for k > 0 but the vertex
  std::vector<std::vector<Pair>> inverse;  ///< of the derivative of (A - lambda) z by lambda and by z but at the first
  /// Where it is refuted: the largest coordinate of the corners of squares around the vertex without a zero; or the
  /// corners of two on which the Jacobian is above 0, and below. Neither for an eigenvalue above 1.
  std::optional<long> around = {};
  std::vector<LatticePoint> folds = {};
};

/// Of the surfaces of all initial data but a set of measure zero.
struct VertexSmoothness {
  long valence = 0;
  /// Whether such a surface is C1 at the vertex: near it a graph, without overlap, over its tangent plane.
  Decision c1;
  long frequency = 0;                              ///< that of the subdominant eigenvalue
  Enclosure subdominant;                           ///< lambda, where it is one number, real and positive
  Enclosure next;                                  ///< |mu|, the largest of the other moduli
  Enclosure exponent;                              ///< of Hoelder at the vertex, where c1 is yes
  std::optional<CurvatureLimit> curvature;         ///< where c1 is yes; 0 or bounded, where curved
  int levels = 0;                                  ///< how often squares were cut
  long squares = 0;                                ///< that the proofs looked at
  std::shared_ptr<const VertexEvidence> evidence;  ///< where c1 is known, not all
};

/// Domain: rules with the mask of the regular part. Errors: throws Error for rules that are not the same in all
/// sectors, are not their own mirror images, or whose weights do not sum to 1. Proof: docs/vertices.md. Ref: [Rei95].
VertexSmoothness vertex_smoothness(const SectorRules& rules, const RegularPart& regular);
/// The same at several vertices, in their order.
std::vector<VertexSmoothness> vertex_smoothness(const std::vector<SectorRules>& rules, const RegularPart& regular,
                                                int threads);

}  // namespace subcert
