#pragma once
/// The rules of a surface scheme on a mesh, as weights for each valence.

#include <subcert/schemes/vertices/fan_regression.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace subcert::data {

/// How a scheme makes its faces.
enum class MeshSplit {
  triangles,  ///< each triangle in four: loop, butterfly, modified-butterfly, triangular
  polygons,   ///< each polygon with n corners in n quadrilaterals: catmull-clark
  corners,    ///< a vertex for each corner; faces for faces, edges and vertices: doo-sabin, midedge
  middles,    ///< a vertex in each triangle, the edges turned: sqrt3
};

/// Weights of a new vertex at an old one of valence n, or, in vertex_limit, of its limit: of itself, of the mean of its
/// neighbours, and, of polygons, of the mean of those across a face, or of the new points in the faces; in limits of
/// fits of those across an edge, and of those that go on straight behind the neighbours.
struct VertexWeights {
  double itself, neighbours, faces = 0, straight = 0;
};

/// Weights along an edge from c to e: of an end, of one of the two vertices opposite of it, or of the new points in the
/// two faces, and of one of the vertices behind those.
struct EdgeWeights {
  double end, opposite, wing = 0;
};

/// Of the boundary, which is a curve of its own.
struct BoundaryWeights {
  double vertex, vertex_neighbour;  ///< of a new vertex at an old one: itself, each of the two beside it
  std::array<double, 4> edge;       ///< of the first new vertex on an edge: its ends, between those beside them
  double limit, limit_neighbour;
};

/// Weights of a tangent vector: cos or sin of the angle times 1 for neighbours, times `faces` for those across a face.
struct TangentWeights {
  double radius;  ///< the eigenvalue
  double faces;
};

/// The schemes that refine meshes of any topology, as they may be written but for parameters.
std::vector<std::string> schemes_with_mesh_rules();
/// Whether meshes of any topology are refined by the scheme of this canonical specification.
bool has_mesh_rules(const std::string& specification);

/// A scheme on meshes. Every weight comes from its rules at vertices, computed once for each valence in exact numbers
/// or enclosures, and is rounded then; those that are derived from them are of its combinations: docs/meshes.md.
class MeshRules {
 public:
  /// Domain: has_mesh_rules(). Errors: as vertex_rules().
  explicit MeshRules(const std::string& specification) : MeshRules(VertexScheme::named(specification), false) {}
  /// Rules that are written down: of vertices by themselves, their neighbours and, of polygons, those across a face;
  /// of edges of triangles by the vertex and its neighbours; of corners by those of the face. Errors: throws a data
  /// Error for others, for a mask that is none of these splits, and, where a valence is first met, for one that has no
  /// rules and for rules that tell one sector from another or are not their own mirror images.
  explicit MeshRules(VertexScheme scheme) : MeshRules(std::move(scheme), true) {}

  const std::string& specification() const { return scheme_.specification; }
  MeshSplit split() const { return split_; }
  /// Whether old vertices keep their places.
  bool interpolates() const { return interpolates_; }
  /// Whether the rules of edges depend on the valence of their ends.
  bool has_edge_rules() const { return has_edge_rules_; }
  /// Whether all points are local fits, also on boundaries: triangular.
  bool fits() const { return fits_data_; }
  const EdgeWeights& edge() const { return edge_; }
  const BoundaryWeights& boundary() const { return boundary_; }

  /// Domain: n >= 3; not of splits by corners. Not for several threads at once.
  const VertexWeights& vertex(std::size_t n) { return kept(n).vertex; }
  const VertexWeights& vertex_limit(std::size_t n) { return kept(n).limit; }
  /// Of a new point on an edge at a vertex of valence n: its own weight, then those of its neighbours, from that at the
  /// other end on counter-clockwise. Domain: has_edge_rules().
  const std::vector<double>& edge_at(std::size_t n) { return kept(n).edge; }
  /// Of a new corner of a face with n corners, from that one on. Domain: splits by corners.
  const std::vector<double>& corner(std::size_t n) { return kept(n).corner; }

  /// Weights as fan_weights() orders them, of each kind of fan computed once. Domain: fits().
  const std::vector<double>& edge_fit(const MeshFan& fan) { return fit(fan, true); }
  const std::vector<double>& vertex_fit(const MeshFan& fan) { return fit(fan, false); }

  /// Of the tangents at a vertex, its neighbours at multiples of this angle; nothing where the neighbours alone do not
  /// have them. Domain: 0 < angle < pi.
  std::optional<TangentWeights> tangents(double angle) const;
  /// At a boundary vertex with so many faces, the vector across the boundary: weights of the vertex itself and of each
  /// of its two neighbours on the boundary, the others having sines of multiples of pi / faces. Domain: tangents().
  std::pair<double, double> across_boundary(std::size_t faces) const;

 private:
  struct Kept {
    bool is_made = false;
    VertexWeights vertex{}, limit{};
    std::vector<double> edge, corner;
  };
  MeshRules(VertexScheme scheme, bool is_checked);
  const Kept& kept(std::size_t n);
  void require_regular(const SectorRules& regular) const;
  void require_known_data(const SectorRules& rules) const;
  const std::vector<double>& fit(const MeshFan& fan, bool at_middle);
  void make_regular(const SectorRules& rules);
  void make_boundary();
  VertexWeights limit_of(const SectorRules& rules) const;
  VertexWeights limit_of_fits(const SectorRules& rules) const;

  VertexScheme scheme_;
  bool is_checked_;
  MeshSplit split_ = MeshSplit::triangles;
  bool interpolates_ = false, has_edge_rules_ = false, fits_data_ = false;
  EdgeWeights edge_{};
  BoundaryWeights boundary_{};
  // of the regular rule of an edge: of the vertex, the neighbour there, those beside it, those across a face
  double spoke_centre_ = 0, spoke_ = 0, spoke_beside_ = 0, spoke_face_ = 0;
  std::vector<Kept> by_valence_;
  std::map<std::pair<MeshFan, bool>, std::vector<double>> fits_;
};

}  // namespace subcert::data
