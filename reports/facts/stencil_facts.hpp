#pragma once
/// The limit and tangent stencils of vertices, as text, JSON and C.

#include "fact.hpp"

#include <subcert/analysis/vertex/vertex_stencils.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <vector>

namespace subcert::facts {

/// Of vertices of one valence.
struct StencilsAt {
  long valence;
  VertexStencils stencils;
};

/// A line for each datum: its point, its sector, and what it counts. Rational numbers are exact, others rounded.
std::string stencils_table(const VertexStencils& stencils);

/// {"limit": [{"point", "sector", "weight", "exact"}, ...], "tangents": [[...], [...]]}. `exact` is a polynomial in c =
/// cos(2 pi/n), with s = sin(2 pi/n) as a factor in the second tangent, or null.
Json stencils_json(const VertexStencils& stencils);

/// The exact weight, as there. Domain: one that has it.
std::string exact_weight_text(const StencilWeight& weight, bool of_second_tangent);

/// A header of C: for each valence the data, and the weights of each as the nearest doubles, beside the exact values.
std::string stencils_header(const VertexScheme& scheme, const std::vector<StencilsAt>& valences);

}  // namespace subcert::facts
