#pragma once
// Edges that stay sharp.

#include "topology.hpp"

#include <cstdint>
#include <vector>

namespace subcert::data {

enum class VertexKind {
  smooth,  ///< at most one sharp edge
  crease,  ///< two: it moves along them
  corner,  ///< three or more: it stays
};

/// The edges of a boundary, which are sharp, and others that are marked so. Of a mesh with the topology that was given,
/// which has to live as long.
class Creases {
 public:
  /// Of the boundary alone.
  explicit Creases(const Topology& topology) : topology_(topology) {}
  /// `sharp`: of each corner's edge, the same in both faces. Empty: as above.
  Creases(const PolygonMesh& mesh, const Topology& topology, std::vector<bool> sharp);

  bool is_sharp(std::uint32_t h) const { return topology_.is_boundary(h) || (!sharp_.empty() && sharp_[h]); }
  VertexKind kind(std::size_t vertex) const {
    if (edges_.empty()) return topology_.on_boundary(vertex) ? VertexKind::crease : VertexKind::smooth;
    return edges_[vertex] < 2 ? VertexKind::smooth : edges_[vertex] == 2 ? VertexKind::crease : VertexKind::corner;
  }
  bool has_marks() const { return !sharp_.empty(); }
  /// Whether one ends at a vertex inside.
  bool has_ends() const;

 private:
  const Topology& topology_;
  std::vector<bool> sharp_;
  std::vector<std::uint32_t> edges_;  // how many sharp ones a vertex has
};

/// The edges inside whose faces have normals, of the first three coordinates, at more than this angle in degrees; none
/// at faces without area.
std::vector<bool> edges_sharper_than(double degrees, const PolygonMesh& mesh, const Topology& topology);

}  // namespace subcert::data
