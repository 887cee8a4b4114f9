#pragma once
// One step of each split, and the limits of vertices.

#include "creases.hpp"
#include "mesh_rules.hpp"
#include "topology.hpp"

namespace subcert::data {

/// Numbers of vertices, `size` for each.
struct VertexSums {
  std::vector<double> values;
  std::size_t size;

  VertexSums(std::size_t vertices, std::size_t numbers) : values(vertices * numbers, 0.0), size(numbers) {}
  double* at(std::size_t vertex) { return values.data() + vertex * size; }
  void add(std::size_t vertex, double weight, const double* numbers) {
    double* const sum = at(vertex);
    for (std::size_t c = 0; c < size; ++c) sum[c] += weight * numbers[c];
  }
};

inline const double* vertex_at(const PolygonMesh& mesh, std::size_t vertex) {
  return mesh.values.data() + vertex * mesh.dimension;
}

/// Sums over the neighbours of each vertex; on creases over the two neighbours there.
VertexSums neighbour_sums(const PolygonMesh& mesh, const Topology& topology, const Creases& creases);

/// The rule of the scheme at a vertex inside, with its neighbour_sums().
void add_inner_vertex(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules, std::size_t v,
                      const double* neighbours, VertexSums& points);

PolygonMesh split_triangles(const PolygonMesh& mesh, const Topology& topology, const Creases& creases,
                            MeshRules& rules);
PolygonMesh split_polygons(const PolygonMesh& mesh, const Topology& topology, const Creases& creases, MeshRules& rules);
/// The sharp edges after these; none where only the boundary is.
std::vector<bool> split_creases(const PolygonMesh& mesh, const Topology& topology, const Creases& creases,
                                MeshSplit split);
PolygonMesh split_corners(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules);
/// `trisected`: edges on the boundary are cut in three, as in every second step. Domain: then at most one of them in a
/// triangle, opposite of a vertex inside, as the step before leaves it.
PolygonMesh split_by_middles(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules, bool trisected);

/// The limits of all vertices. Domain: of splits by corners no boundary.
std::vector<double> vertex_limits(const PolygonMesh& mesh, const Topology& topology, const Creases& creases,
                                  MeshRules& rules);
/// Three coordinates for each vertex: the unit normal of the limit surface there, 0 where the tangents are parallel.
std::vector<double> vertex_normals(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules);

}  // namespace subcert::data
