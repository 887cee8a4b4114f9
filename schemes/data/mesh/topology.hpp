#pragma once
/// Which faces meet in the edges and vertices of a mesh.

#include "polygon_mesh.hpp"

namespace subcert::data {

/// The corners of a mesh as half-edges: corner h is the edge from its vertex to that of next(h), with its face on the
/// left. Canonical: an edge is in one face, on the boundary, or in two, which have it in opposite directions; the faces
/// at a vertex follow each other around it. Memory: three numbers of 32 bits for a corner at most while it is made, one
/// or two after that, and two for a vertex.
class Topology {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// Errors: throws a data error for an edge in three faces or more, for one that two faces have in the same
  /// direction, for a vertex at which two fans of faces meet. Cost: linear, times the logarithm of the valences.
  Topology(const PolygonMesh& mesh, const FacePlace& place);

  /// Around the face.
  std::uint32_t next(std::uint32_t h) const {
    if (sides_ == 0) return next_[h];
    return (h + 1) % sides_ == 0 ? h + 1 - sides_ : h + 1;
  }
  std::uint32_t previous(std::uint32_t h) const {
    if (sides_ == 0) return previous_of(h);
    return h % sides_ == 0 ? h + sides_ - 1 : h - 1;
  }
  /// The same edge in the other face; none on the boundary.
  std::uint32_t opposite(std::uint32_t h) const { return opposite_[h]; }
  bool is_boundary(std::uint32_t h) const { return opposite_[h] == none; }
  /// Of the corners at the vertex of h, counter-clockwise; none at the end of a boundary.
  std::uint32_t turned(std::uint32_t h) const { return opposite_[previous(h)]; }

  /// A corner at a vertex: on the boundary the first one counter-clockwise, whose edge is on the boundary.
  std::uint32_t corner_at(std::size_t vertex) const { return corner_[vertex]; }
  bool on_boundary(std::size_t vertex) const { return is_boundary(corner_[vertex]); }
  std::uint32_t faces_at(std::size_t vertex) const { return faces_[vertex]; }
  /// The number of its edges.
  std::size_t valence(std::size_t vertex) const { return faces_[vertex] + (on_boundary(vertex) ? 1U : 0U); }
  std::size_t edges() const { return edges_; }
  bool has_boundary() const { return 2 * edges_ > opposite_.size(); }

  /// The number of each corner's edge, counted from 0 in the order of the first corner on it.
  std::vector<std::uint32_t> edge_numbers() const;

 private:
  void join_opposites(const PolygonMesh& mesh, const FacePlace& place);
  void find_corners(const PolygonMesh& mesh, const FacePlace& place);
  std::uint32_t previous_of(std::uint32_t h) const;

  std::uint32_t sides_ = 0;  // of all faces; 0 where they differ
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> opposite_;
  std::vector<std::uint32_t> corner_;
  std::vector<std::uint32_t> faces_;
  std::size_t edges_ = 0;
};

/// Throws a data error where two edges on the boundary lie at the same place, the first `coordinates` numbers of their
/// ends being equal: vertices that a file has twice, so that the surface would open there. Cost: linear in the
/// boundary.
void require_no_seams(const PolygonMesh& mesh, const Topology& topology, std::size_t coordinates,
                      const FacePlace& place);

}  // namespace subcert::data
