#include "mesh_fits.hpp"

#include <algorithm>

namespace subcert::data {
namespace {

/// The data of fits around one vertex after the other.
class Fans {
 public:
  Fans(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules)
      : mesh_(mesh), topology_(topology), rules_(rules) {}

  /// At a vertex on the boundary.
  void add_boundary_vertex(std::size_t v, VertexSums& points) {
    go_around(static_cast<std::uint32_t>(v), topology_.corner_at(v));
    add(rules_.vertex_fit(fan_), 1, v, points);
  }

  /// At the middle of the edge of h, from the end that is not as in the plane of the grid; from both, half of each,
  /// where none is.
  void add_edge(std::uint32_t h, std::size_t point, VertexSums& points) {
    const std::uint32_t other = topology_.opposite(h);
    const bool here = is_special(mesh_.corners[h]), there = is_special(mesh_.corners[topology_.next(h)]);
    const double share = here && there ? 0.5 : 1;
    if (here || !there) add_from(h, other, share, point, points);
    if (there) add_from(other, h, share, point, points);
  }

 private:
  bool is_special(std::uint32_t v) const { return topology_.on_boundary(v) || topology_.faces_at(v) != 6; }

  /// The vertex and its neighbours, the edge of corner `to` first, or, on the boundary, where it comes; none: the last.
  void go_around(std::uint32_t v, std::uint32_t to) {
    data_.assign(1, {v, 1});
    const auto faces = static_cast<long>(topology_.faces_at(v));
    const bool open = topology_.on_boundary(v);
    std::uint32_t corner = open ? topology_.corner_at(v) : to, last = corner;
    long at = faces;
    for (long k = 0; k < faces; ++k, corner = topology_.turned(corner)) {
      if (corner == to) at = k;
      data_.push_back({mesh_.corners[topology_.next(corner)], 1});
      last = corner;
    }
    if (open) data_.push_back({mesh_.corners[topology_.previous(last)], 1});
    // A single face is a quarter of the plane: half of it would be a line.
    fan_ = open ? MeshFan{std::max(2 * faces, 4L), -at, faces - at} : MeshFan{faces, 0, faces - 1};
  }

  std::uint32_t third_corner(std::uint32_t h) const { return mesh_.corners[topology_.previous(h)]; }

  /// Across from the end of the edge of `left`, or of its opposite `right`, at the vertex v: the vertex that goes on
  /// straight, or the two beside it; none where that is past the boundary.
  bool add_straight(std::uint32_t left, std::uint32_t right, std::uint32_t v) {
    if (!topology_.on_boundary(v)) {
      const std::uint32_t faces = topology_.faces_at(v);
      std::uint32_t corner = right;
      for (std::uint32_t k = 0; k < faces / 2; ++k) corner = topology_.turned(corner);
      data_.push_back({mesh_.corners[topology_.next(corner)], faces % 2 == 0 ? 1 : 0.5});
      if (faces % 2 != 0) data_.push_back({mesh_.corners[topology_.next(topology_.turned(corner))], 0.5});
      return true;
    }
    if ((left != Topology::none && right != Topology::none) || topology_.faces_at(v) < 2) return false;
    if (right == Topology::none) {
      data_.push_back({mesh_.corners[topology_.next(topology_.corner_at(v))], 1});
      return true;
    }
    std::uint32_t corner = right;
    while (topology_.turned(corner) != Topology::none) corner = topology_.turned(corner);
    data_.push_back({mesh_.corners[topology_.previous(corner)], 1});
    return true;
  }

  /// `left`: the edge, away from the end where the fan is; `right`: the edge, back to it. One of them may be none.
  void add_from(std::uint32_t left, std::uint32_t right, double share, std::size_t point, VertexSums& points) {
    const bool has_left = left != Topology::none, has_right = right != Topology::none;
    const std::uint32_t v = mesh_.corners[has_left ? left : topology_.next(right)];
    go_around(v, left);
    if (has_left)
      if (const std::uint32_t across = topology_.opposite(topology_.next(left)); across != Topology::none) {
        data_.push_back({third_corner(across), 1});
        fan_.left = true;
      }
    fan_.straight = add_straight(left, right, mesh_.corners[has_left ? topology_.next(left) : right]);
    if (has_right)
      if (const std::uint32_t across = topology_.opposite(topology_.previous(right)); across != Topology::none) {
        data_.push_back({third_corner(across), 1});
        fan_.right = true;
      }
    add(rules_.edge_fit(fan_), share, point, points);
  }

  /// A datum that is the mean of two vertices has one weight.
  void add(const std::vector<double>& weights, double share, std::size_t point, VertexSums& points) const {
    std::size_t i = 0;
    for (auto datum = data_.begin(); datum != data_.end(); ++datum) {
      points.add(point, share * weights[i] * datum->part, vertex_at(mesh_, datum->vertex));
      if (datum->part < 1) {
        ++datum;
        points.add(point, share * weights[i] * datum->part, vertex_at(mesh_, datum->vertex));
      }
      ++i;
    }
  }

  struct Datum {
    std::uint32_t vertex;
    double part;
  };
  const PolygonMesh& mesh_;
  const Topology& topology_;
  MeshRules& rules_;
  std::vector<Datum> data_;
  MeshFan fan_{};
};

void add_vertex_fits(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules, Fans& fans,
                     VertexSums& points) {
  const VertexSums neighbours = neighbour_sums(mesh, topology, Creases(topology));
  for (std::size_t v = 0; v < mesh.vertices(); ++v)
    if (topology.on_boundary(v))
      fans.add_boundary_vertex(v, points);
    else
      add_inner_vertex(mesh, topology, rules, v, neighbours.values.data() + v * neighbours.size, points);
}

}  // namespace

void add_fits(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules,
              const std::vector<std::uint32_t>& edge, VertexSums& points) {
  Fans fans(mesh, topology, rules);
  if (rules.interpolates())
    std::ranges::copy(mesh.values, points.values.begin());
  else
    add_vertex_fits(mesh, topology, rules, fans, points);
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h)
    if (topology.is_boundary(h) || h < topology.opposite(h)) fans.add_edge(h, mesh.vertices() + edge[h], points);
}

std::vector<double> fit_limits(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules) {
  // After one level the vertices keep their numbers, and all their neighbours have the valence 6.
  const PolygonMesh fine = split_triangles(mesh, topology, Creases(topology), rules);
  const Topology around(fine, [](std::size_t face) { return "face " + std::to_string(face); });
  VertexSums limits(mesh.vertices(), mesh.dimension);
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const double faces = around.faces_at(v);
    const VertexWeights& weights = rules.vertex_limit(around.faces_at(v));
    limits.add(v, weights.itself, vertex_at(fine, v));
    std::uint32_t corner = around.corner_at(v);
    for (std::uint32_t t = 0; t < around.faces_at(v); ++t, corner = around.turned(corner)) {
      const std::uint32_t across = around.opposite(around.next(corner));
      const std::uint32_t back = around.opposite(corner);
      const std::uint32_t straight = around.turned(around.turned(around.turned(back)));
      limits.add(v, weights.neighbours / faces, vertex_at(fine, fine.corners[around.next(corner)]));
      limits.add(v, weights.faces / faces, vertex_at(fine, fine.corners[around.previous(across)]));
      limits.add(v, weights.straight / faces, vertex_at(fine, fine.corners[around.next(straight)]));
    }
  }
  return std::move(limits.values);
}

}  // namespace subcert::data
