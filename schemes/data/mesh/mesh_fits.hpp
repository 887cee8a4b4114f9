#pragma once
// Local regression on triangle meshes, in the flat fans of vertices.

#include "mesh_steps.hpp"

namespace subcert::data {

/// The new points of a `triangular:` scheme: vertices keep their numbers, edges follow as `edge` numbers them. Domain:
/// rules.fits(), triangles. Cost: linear; one exact fit for each kind of fan.
void add_fits(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules,
              const std::vector<std::uint32_t>& edge, VertexSums& points);

/// The limits of vertices. Domain: rules.fits(), not interpolating; a closed mesh. Cost: one level more.
std::vector<double> fit_limits(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules);

}  // namespace subcert::data
