#include "mesh_fits.hpp"

#include <algorithm>
#include <array>

namespace subcert::data {
namespace {

/// The corner on the boundary whose edge ends at the vertex of h. Domain: h is on the boundary.
std::uint32_t boundary_before(const Topology& topology, std::uint32_t h) {
  std::uint32_t corner = h;
  while (topology.turned(corner) != Topology::none) corner = topology.turned(corner);
  return topology.previous(corner);
}

/// The one that begins where the edge of h ends.
std::uint32_t boundary_after(const PolygonMesh& mesh, const Topology& topology, std::uint32_t h) {
  return topology.corner_at(mesh.corners[topology.next(h)]);
}

/// New points of the old vertices: by their valence, on creases by their rule.
void move_vertices(const PolygonMesh& mesh, const Topology& topology, const Creases& creases, MeshRules& rules,
                   bool keep_boundary, VertexSums& points) {
  const BoundaryWeights& boundary = rules.boundary();
  const VertexSums neighbours = neighbour_sums(mesh, topology, creases);
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const double* const sum = neighbours.values.data() + v * neighbours.size;
    if (const VertexKind kind = creases.kind(v); kind != VertexKind::smooth) {
      const bool stays = keep_boundary || kind == VertexKind::corner;
      points.add(v, stays ? 1 : boundary.vertex, vertex_at(mesh, v));
      if (!stays) points.add(v, boundary.vertex_neighbour, sum);
      continue;
    }
    add_inner_vertex(mesh, topology, rules, v, sum, points);
  }
}

/// The rule of an edge at the vertex of corner h, where its valence has one of its own.
bool add_edge_rule(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules, std::uint32_t h, double weight,
                   std::size_t point, VertexSums& points) {
  const std::uint32_t v = mesh.corners[h];
  if (topology.on_boundary(v) || topology.faces_at(v) == 6) return false;
  const std::vector<double>& weights = rules.edge_at(topology.faces_at(v));
  points.add(point, weight * weights[0], vertex_at(mesh, v));
  std::uint32_t corner = h;
  for (std::size_t t = 1; t < weights.size(); ++t, corner = topology.turned(corner))
    points.add(point, weight * weights[t], vertex_at(mesh, mesh.corners[topology.next(corner)]));
  return true;
}

/// A wing behind the edge of corner k: the vertex across it, or, past the boundary, the one that makes a parallelogram.
void add_wing(const PolygonMesh& mesh, const Topology& topology, std::uint32_t k, double weight, std::size_t point,
              VertexSums& points) {
  if (!topology.is_boundary(k)) {
    points.add(point, weight, vertex_at(mesh, mesh.corners[topology.previous(topology.opposite(k))]));
    return;
  }
  points.add(point, weight, vertex_at(mesh, mesh.corners[k]));
  points.add(point, weight, vertex_at(mesh, mesh.corners[topology.next(k)]));
  points.add(point, -weight, vertex_at(mesh, mesh.corners[topology.previous(k)]));
}

void add_inner_edge(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules, std::uint32_t h,
                    std::size_t point, VertexSums& points) {
  const std::uint32_t other = topology.opposite(h);
  if (rules.has_edge_rules()) {
    const auto is_special = [&](std::uint32_t corner) {
      const std::uint32_t v = mesh.corners[corner];
      return !topology.on_boundary(v) && topology.faces_at(v) != 6;
    };
    const double share = is_special(h) && is_special(other) ? 0.5 : 1;
    const bool here = add_edge_rule(mesh, topology, rules, h, share, point, points);
    if (add_edge_rule(mesh, topology, rules, other, share, point, points) || here) return;
  }
  const EdgeWeights& edge = rules.edge();
  for (const std::uint32_t side : {h, other}) {
    const std::uint32_t next = topology.next(side), previous = topology.previous(side);
    points.add(point, edge.end, vertex_at(mesh, mesh.corners[side]));
    points.add(point, edge.opposite, vertex_at(mesh, mesh.corners[previous]));
    if (edge.wing == 0) continue;
    add_wing(mesh, topology, next, edge.wing, point, points);
    add_wing(mesh, topology, previous, edge.wing, point, points);
  }
}

/// A new point on the boundary edge of h; `mirrored`: the weights are those of the way back.
void add_boundary_edge(const PolygonMesh& mesh, const Topology& topology, const MeshRules& rules, std::uint32_t h,
                       bool mirrored, std::size_t point, VertexSums& points) {
  const std::array<std::uint32_t, 4> corners{boundary_before(topology, h), h, topology.next(h),
                                             topology.next(boundary_after(mesh, topology, h))};
  for (std::size_t k = 0; k < 4; ++k)
    if (const double weight = rules.boundary().edge[mirrored ? 3 - k : k]; weight != 0)
      points.add(point, weight, vertex_at(mesh, mesh.corners[corners[k]]));
}

/// The same inside, where the rule takes the two ends alone.
void add_crease_edge(const PolygonMesh& mesh, const Topology& topology, const MeshRules& rules, std::uint32_t h,
                     std::size_t point, VertexSums& points) {
  points.add(point, rules.boundary().edge[1], vertex_at(mesh, mesh.corners[h]));
  points.add(point, rules.boundary().edge[2], vertex_at(mesh, mesh.corners[topology.next(h)]));
}

void add_mean(const PolygonMesh& mesh, std::size_t f, std::size_t point, VertexSums& points) {
  const auto face = mesh.face(f);
  for (const std::uint32_t v : face) points.add(point, 1 / static_cast<double>(face.size()), vertex_at(mesh, v));
}

void add_face(PolygonMesh& mesh, std::initializer_list<std::uint32_t> corners) {
  mesh.corners.insert(mesh.corners.end(), corners);
  mesh.end_face();
}

}  // namespace

VertexSums neighbour_sums(const PolygonMesh& mesh, const Topology& topology, const Creases& creases) {
  VertexSums sums(mesh.vertices(), mesh.dimension);
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    const std::uint32_t v = mesh.corners[h], w = mesh.corners[topology.next(h)];
    if (creases.is_sharp(h) || creases.kind(v) == VertexKind::smooth) sums.add(v, 1, vertex_at(mesh, w));
    if (topology.is_boundary(h)) sums.add(w, 1, vertex_at(mesh, v));
  }
  return sums;
}

void add_inner_vertex(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules, std::size_t v,
                      const double* neighbours, VertexSums& points) {
  const std::size_t n = topology.faces_at(v);
  const VertexWeights& weights = rules.vertex(n);
  points.add(v, weights.itself, vertex_at(mesh, v));
  points.add(v, weights.neighbours / static_cast<double>(n), neighbours);
}

namespace {

/// New points of the vertices, and of the edges by their numbers, by the rules of a scheme that are no fits.
void add_by_rules(const PolygonMesh& mesh, const Topology& topology, const Creases& creases, MeshRules& rules,
                  const std::vector<std::uint32_t>& edge, VertexSums& points) {
  const std::size_t vertices = mesh.vertices();
  if (rules.interpolates())
    std::ranges::copy(mesh.values, points.values.begin());
  else
    move_vertices(mesh, topology, creases, rules, false, points);
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h)
    if (topology.is_boundary(h))
      add_boundary_edge(mesh, topology, rules, h, false, vertices + edge[h], points);
    else if (h > topology.opposite(h))
      continue;
    else if (creases.is_sharp(h))
      add_crease_edge(mesh, topology, rules, h, vertices + edge[h], points);
    else
      add_inner_edge(mesh, topology, rules, h, vertices + edge[h], points);
}

}  // namespace

PolygonMesh split_triangles(const PolygonMesh& mesh, const Topology& topology, const Creases& creases,
                            MeshRules& rules) {
  const auto vertices = static_cast<std::uint32_t>(mesh.vertices());
  const std::vector<std::uint32_t> edge = topology.edge_numbers();
  VertexSums points(vertices + topology.edges(), mesh.dimension);
  if (rules.fits())
    add_fits(mesh, topology, rules, edge, points);
  else
    add_by_rules(mesh, topology, creases, rules, edge, points);
  PolygonMesh result{std::move(points.values), mesh.dimension, {}, {0}};
  result.corners.reserve(4 * mesh.corners.size());
  result.first.reserve(4 * mesh.faces() + 1);
  for (std::uint32_t h = 0; h < mesh.corners.size(); h += 3) {
    const std::uint32_t a = vertices + edge[h], b = vertices + edge[h + 1], c = vertices + edge[h + 2];
    add_face(result, {mesh.corners[h], a, c});
    add_face(result, {mesh.corners[h + 1], b, a});
    add_face(result, {mesh.corners[h + 2], c, b});
    add_face(result, {a, b, c});
  }
  return result;
}

PolygonMesh split_polygons(const PolygonMesh& mesh, const Topology& topology, const Creases& creases,
                           MeshRules& rules) {
  const auto vertices = static_cast<std::uint32_t>(mesh.vertices());
  const auto in_faces = static_cast<std::uint32_t>(vertices + topology.edges());
  const std::vector<std::uint32_t> edge = topology.edge_numbers();
  VertexSums points(in_faces + mesh.faces(), mesh.dimension);
  for (std::size_t f = 0; f < mesh.faces(); ++f) add_mean(mesh, f, in_faces + f, points);
  move_vertices(mesh, topology, creases, rules, false, points);
  const EdgeWeights& weights = rules.edge();
  for (std::size_t f = 0; f < mesh.faces(); ++f)
    for (std::uint32_t h = mesh.first[f]; h < mesh.first[f + 1]; ++h) {
      const std::uint32_t v = mesh.corners[h], point = vertices + edge[h];
      const double* const in_face = points.at(in_faces + f);
      if (topology.is_boundary(h)) {
        add_boundary_edge(mesh, topology, rules, h, false, point, points);
      } else if (creases.is_sharp(h)) {
        if (h < topology.opposite(h)) add_crease_edge(mesh, topology, rules, h, point, points);
      } else {  // one end and one face here, the others from the opposite corner
        points.add(point, weights.end, vertex_at(mesh, v));
        points.add(point, weights.opposite, in_face);
      }
      if (creases.kind(v) == VertexKind::smooth)
        points.add(v, rules.vertex(topology.faces_at(v)).faces / static_cast<double>(topology.faces_at(v)), in_face);
    }
  PolygonMesh result{std::move(points.values), mesh.dimension, {}, {0}};
  result.corners.reserve(4 * mesh.corners.size());
  result.first.reserve(mesh.corners.size() + 1);
  for (std::size_t f = 0; f < mesh.faces(); ++f)
    for (std::uint32_t h = mesh.first[f]; h < mesh.first[f + 1]; ++h)
      add_face(result, {mesh.corners[h], vertices + edge[h], static_cast<std::uint32_t>(in_faces + f),
                        vertices + edge[topology.previous(h)]});
  return result;
}

std::vector<bool> split_creases(const PolygonMesh& mesh, const Topology& topology, const Creases& creases,
                                MeshSplit split) {
  if (!creases.has_marks()) return {};
  // The halves of an edge of each corner, as split_triangles() and split_polygons() number their corners.
  std::vector<bool> sharp(4 * mesh.corners.size(), false);
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    const std::uint32_t next = topology.next(h);
    const bool triangles = split == MeshSplit::triangles;
    const std::uint32_t face = h - h % 3;
    sharp[triangles ? 4 * face + 3 * (h % 3) : 4 * h] = creases.is_sharp(h);
    sharp[triangles ? 4 * face + 3 * (next % 3) + 2 : 4 * next + 3] = creases.is_sharp(h);
  }
  return sharp;
}

PolygonMesh split_corners(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules) {
  VertexSums points(mesh.corners.size(), mesh.dimension);
  PolygonMesh result{{}, mesh.dimension, {}, {0}};
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto face = mesh.face(f);
    const std::vector<double>& weights = rules.corner(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      for (std::size_t t = 0; t < face.size(); ++t)
        if (weights[t] != 0) points.add(mesh.first[f] + k, weights[t], vertex_at(mesh, face[(k + t) % face.size()]));
      result.corners.push_back(static_cast<std::uint32_t>(mesh.first[f] + k));
    }
    result.end_face();
  }
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    const std::uint32_t other = topology.opposite(h);
    if (other == Topology::none || other < h) continue;
    add_face(result, {topology.next(h), h, topology.next(other), other});
  }
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    if (topology.on_boundary(v)) continue;
    const std::uint32_t first = topology.corner_at(v);
    std::uint32_t corner = first;
    do {
      result.corners.push_back(corner);
      corner = topology.turned(corner);
    } while (corner != first);
    result.end_face();
  }
  result.values = std::move(points.values);
  return result;
}

namespace {

/// The new points of triangles: of each, as its edges see them.
class Middles {
 public:
  Middles(const PolygonMesh& mesh, const Topology& topology, bool trisected)
      : topology_(topology),
        first_(static_cast<std::uint32_t>(mesh.vertices())),
        count_(first_ + static_cast<std::uint32_t>(mesh.faces())) {
    if (!trisected || !topology.has_boundary()) return;
    cut_.assign(mesh.faces(), Topology::none);
    second_.assign(mesh.faces(), 0);
    for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
      if (!topology.is_boundary(h)) continue;
      cut_[h / 3] = h;
      second_[h / 3] = count_++;
    }
  }
  /// Of all points, the old ones, too.
  std::uint32_t count() const { return count_; }
  /// Whether the triangle has two points on its edge on the boundary, this and second().
  bool is_cut(std::uint32_t face) const { return !cut_.empty() && cut_[face] != Topology::none; }
  std::uint32_t first(std::uint32_t face) const { return first_ + face; }
  std::uint32_t second(std::uint32_t face) const { return second_[face]; }
  std::uint32_t boundary_corner(std::uint32_t face) const { return cut_[face]; }
  /// The point next to the edge of h.
  std::uint32_t beside(std::uint32_t h) const {
    const std::uint32_t face = h / 3;
    return is_cut(face) && topology_.next(cut_[face]) == h ? second(face) : first(face);
  }

 private:
  const Topology& topology_;
  std::uint32_t first_, count_;
  std::vector<std::uint32_t> cut_;
  std::vector<std::uint32_t> second_;
};

}  // namespace

PolygonMesh split_by_middles(const PolygonMesh& mesh, const Topology& topology, MeshRules& rules, bool trisected) {
  const Middles middles(mesh, topology, trisected);
  VertexSums points(middles.count(), mesh.dimension);
  move_vertices(mesh, topology, Creases(topology), rules, !trisected, points);
  for (std::uint32_t f = 0; f < mesh.faces(); ++f) {
    if (middles.is_cut(f)) {
      const std::uint32_t h = middles.boundary_corner(f);
      add_boundary_edge(mesh, topology, rules, h, false, middles.first(f), points);
      add_boundary_edge(mesh, topology, rules, h, true, middles.second(f), points);
    } else {
      add_mean(mesh, f, middles.first(f), points);
    }
  }
  PolygonMesh result{{}, mesh.dimension, {}, {0}};
  result.corners.reserve(3 * mesh.corners.size());
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    const std::uint32_t u = mesh.corners[h], v = mesh.corners[topology.next(h)], other = topology.opposite(h);
    if (other != Topology::none) {
      if (other < h) continue;
      add_face(result, {u, middles.beside(other), middles.beside(h)});
      add_face(result, {v, middles.beside(h), middles.beside(other)});
    } else if (middles.is_cut(h / 3)) {
      add_face(result, {middles.first(h / 3), middles.second(h / 3), mesh.corners[topology.previous(h)]});
    } else {
      add_face(result, {u, v, middles.first(h / 3)});
    }
  }
  result.values = std::move(points.values);
  return result;
}

}  // namespace subcert::data
