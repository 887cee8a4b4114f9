#include "mesh_fits.hpp"

#include <cmath>
#include <numbers>

namespace subcert::data {
namespace {

/// The new points of the corners around a vertex, which the scheme joins to one face, in counter-clockwise order.
/// Domain: a split by corners, a vertex inside.
class CornersAround {
 public:
  CornersAround(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules)
      : mesh_(mesh), topology_(topology), rules_(rules) {}

  /// Adds the weight that `weight_of(t)` gives to the t-th of them.
  template <class WeightOf>
  void add(std::size_t vertex, const WeightOf& weight_of, double* sum, std::size_t coordinates) const {
    std::uint32_t corner = topology_.corner_at(vertex);
    for (std::size_t t = 0; t < topology_.faces_at(vertex); ++t, corner = topology_.turned(corner)) {
      std::size_t sides = 1;
      for (std::uint32_t h = topology_.next(corner); h != corner; h = topology_.next(h)) ++sides;
      const std::vector<double>& weights = rules_.corner(sides);
      std::uint32_t h = corner;
      for (std::size_t k = 0; k < sides; ++k, h = topology_.next(h))
        for (std::size_t c = 0; c < coordinates; ++c)
          sum[c] += weight_of(t) * weights[k] * vertex_at(mesh_, mesh_.corners[h])[c];
    }
  }

 private:
  const PolygonMesh& mesh_;
  const Topology& topology_;
  MeshRules& rules_;
};

struct Vector {
  double numbers[3] = {0, 0, 0};

  void add(double weight, const double* at) {
    for (std::size_t c = 0; c < 3; ++c) numbers[c] += weight * at[c];
  }
};

/// Two tangents, the second to the left of the first.
struct Tangents {
  Vector first = {}, second = {};

  /// The unit vector on both, or 0.
  void add_normal(std::vector<double>& normals) const {
    double normal[3], square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
      normal[c] = first.numbers[d] * second.numbers[e] - first.numbers[e] * second.numbers[d];
      square += normal[c] * normal[c];
    }
    for (const double coordinate : normal) normals.push_back(square > 0 ? coordinate / std::sqrt(square) : 0);
  }
};

/// Of a vertex whose neighbours and faces are at multiples of the angle.
Tangents tangents_of(const PolygonMesh& mesh, const Topology& topology, const MeshRules& rules, std::size_t v) {
  const std::size_t n = topology.faces_at(v);
  const bool boundary = topology.on_boundary(v);
  const double angle = (boundary ? 1 : 2) * std::numbers::pi / static_cast<double>(n);
  Tangents result;
  const TangentWeights weights = *rules.tangents(angle);
  std::uint32_t corner = topology.corner_at(v);
  for (std::size_t t = 0; t < n; ++t, corner = topology.turned(corner)) {
    const double here = static_cast<double>(t) * angle, after = here + angle;
    const double* const neighbour = vertex_at(mesh, mesh.corners[topology.next(corner)]);
    if (!boundary) result.first.add(std::cos(here), neighbour);
    result.second.add(std::sin(here), neighbour);
    if (weights.faces == 0) continue;
    const double* const across = vertex_at(mesh, mesh.corners[topology.next(topology.next(corner))]);
    if (!boundary) result.first.add(weights.faces * (std::cos(here) + std::cos(after)), across);
    result.second.add(weights.faces * (std::sin(here) + std::sin(after)), across);
  }
  if (!boundary) return result;
  std::uint32_t last = topology.corner_at(v);
  while (topology.turned(last) != Topology::none) last = topology.turned(last);
  const double* const after = vertex_at(mesh, mesh.corners[topology.next(topology.corner_at(v))]);
  const double* const before = vertex_at(mesh, mesh.corners[topology.previous(last)]);
  const auto [itself, neighbour] = rules.across_boundary(n);
  result.first.add(1, after);
  result.first.add(-1, before);
  result.second.add(itself, vertex_at(mesh, v));
  result.second.add(neighbour, after);
  result.second.add(neighbour, before);
  return result;
}

}  // namespace

std::vector<double> vertex_limits(const PolygonMesh& mesh, const Topology& topology, const Creases& creases,
                                  MeshRules& rules) {
  if (rules.interpolates()) return mesh.values;
  if (rules.fits()) return fit_limits(mesh, topology, rules);
  VertexSums points(mesh.vertices(), mesh.dimension);
  if (rules.split() == MeshSplit::corners) {
    const CornersAround around(mesh, topology, rules);
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
      const double share = 1 / static_cast<double>(topology.faces_at(v));
      around.add(
          v, [&](std::size_t) { return share; }, points.at(v), mesh.dimension);
    }
    return std::move(points.values);
  }
  const VertexSums neighbours = neighbour_sums(mesh, topology, creases);
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const double* const sum = neighbours.values.data() + v * mesh.dimension;
    if (creases.kind(v) == VertexKind::corner) {
      points.add(v, 1, vertex_at(mesh, v));
      continue;
    }
    const bool boundary = creases.kind(v) == VertexKind::crease;
    const double n = boundary ? 1 : topology.faces_at(v);
    const VertexWeights weights = boundary ? VertexWeights{rules.boundary().limit, rules.boundary().limit_neighbour}
                                           : rules.vertex_limit(topology.faces_at(v));
    points.add(v, weights.itself, vertex_at(mesh, v));
    points.add(v, weights.neighbours / n, sum);
  }
  if (rules.split() == MeshSplit::polygons)
    for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
      const std::uint32_t v = mesh.corners[h];
      if (creases.kind(v) != VertexKind::smooth) continue;
      const std::size_t n = topology.faces_at(v);
      points.add(v, rules.vertex_limit(n).faces / static_cast<double>(n),
                 vertex_at(mesh, mesh.corners[topology.next(topology.next(h))]));
    }
  return std::move(points.values);
}

std::vector<double> vertex_normals(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules) {
  std::vector<double> normals;
  normals.reserve(3 * mesh.vertices());
  const CornersAround around(mesh, topology, rules);
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    if (rules.split() != MeshSplit::corners) {
      tangents_of(mesh, topology, rules, v).add_normal(normals);
      continue;
    }
    const double angle = 2 * std::numbers::pi / static_cast<double>(topology.faces_at(v));
    Tangents tangents;
    around.add(
        v, [&](std::size_t t) { return std::cos(angle * static_cast<double>(t)); }, tangents.first.numbers, 3);
    around.add(
        v, [&](std::size_t t) { return std::sin(angle * static_cast<double>(t)); }, tangents.second.numbers, 3);
    tangents.add_normal(normals);
  }
  return normals;
}

}  // namespace subcert::data
