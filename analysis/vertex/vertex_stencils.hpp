#pragma once
/// What single data count in the limit at a vertex and in its tangent plane.

#include "vertex_smoothness.hpp"

#include <string>
#include <vector>

namespace subcert {

/// The weight of one datum. Where `exact` is there, it is a polynomial in c = cos(2 pi/n), in the second tangent times
/// sin(2 pi/n).
struct StencilWeight {
  SectorPoint at;
  Enclosure value;
  std::optional<LaurentPolynomial> exact;
};

/// Canonical: weights in the order of their points and turns, none of them exactly 0.
struct VertexStencils {
  using Stencil = std::vector<StencilWeight>;

  /// The point of the surface at the vertex, of dual schemes in the middle of the face. The weights sum to 1.
  Stencil limit;
  /// Two vectors t, u: the data are limit + lambda^k (t Re z + u Im z) + o(lambda^k) on level k, z the data of the
  /// characteristic map, in some scale; with a Jordan block in front a power of k more. For almost all initial data
  /// they span the tangent plane, t x u the normal on the side from which the sectors turn counter-clockwise. Empty
  /// where the leader is not proved to be one of frequency 1.
  std::array<Stencil, 2> tangents;
};

/// Domain: rules that vertex_smoothness() takes, and what it says. Error: weights enclosed to about `bits` bits. Exact
/// ones are given for fields Q(c) of degree up to 24; in tangents where lambda is proved to be in Q(c). Cost: linear
/// systems of the size of the smallest closed set. Proof: docs/stencils.md.
VertexStencils vertex_stencils(const SectorRules& rules, const VertexSmoothness& smoothness, int bits = 100);

}  // namespace subcert
