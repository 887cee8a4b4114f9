#include "mesh_refinement.hpp"

#include "mesh_steps.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace subcert::data {
namespace {

constexpr double most_numbers = 1e8;

void require_sides(const PolygonMesh& mesh, const std::string& scheme, std::size_t sides, const char* name,
                   const FacePlace& place) {
  for (std::size_t f = 0; f < mesh.faces(); ++f)
    if (mesh.face(f).size() != sides)
      fail(ErrorKind::data, "{}: expected {} for {}; found a face of {} vertices", place(f), name, scheme,
           mesh.face(f).size());
}

/// What the first level needs; later ones have it.
void require_fit(const PolygonMesh& mesh, const Topology& topology, const MeshRules& rules, const MeshOptions& options,
                 const FacePlace& place) {
  const std::string& scheme = rules.specification();
  if (rules.split() == MeshSplit::triangles || rules.split() == MeshSplit::middles)
    require_sides(mesh, scheme, 3, "triangles", place);
  if (rules.split() == MeshSplit::polygons && options.levels == 0 && (options.limit || options.normals))
    require_sides(mesh, scheme, 4, "quadrilaterals, or a level or more,", place);
  for (std::size_t v = 0; v < mesh.vertices(); ++v)
    if (!topology.on_boundary(v) && topology.faces_at(v) < 3)
      fail(ErrorKind::data, "{}: expected three or more faces around each vertex inside; found one with {}",
           place(static_cast<std::size_t>(std::ranges::upper_bound(mesh.first, topology.corner_at(v)) -
                                          mesh.first.begin()) -
                 1),
           topology.faces_at(v));
}

void require_options(const PolygonMesh& mesh, const Topology& topology, const MeshRules& rules,
                     const MeshOptions& options) {
  require(options.levels >= 0, "refine: need levels >= 0, got {}", options.levels);
  const std::string& scheme = rules.specification();
  if (options.keep_faces) {
    if (rules.split() == MeshSplit::corners || rules.interpolates())
      fail(ErrorKind::domain,
           "smooth: {}: need a scheme of meshes that moves their vertices, as loop and triangular: do", scheme);
    require(!options.limit && !options.normals && !options.crease,
            "smooth: need a mesh without limits, normals and creases");
  }
  if (options.crease) {
    const bool takes = rules.split() == MeshSplit::polygons ||
                       (rules.split() == MeshSplit::triangles && !rules.interpolates() && !rules.fits());
    if (!takes || options.normals || mesh.dimension < 3)
      fail(ErrorKind::domain, "crease: {}: creases are made by loop and catmull-clark, in space and without normals",
           scheme);
    require(*options.crease >= 0 && *options.crease <= 180, "crease: need an angle from 0 to 180 degrees, got {}",
            *options.crease);
  }
  if (options.normals && (mesh.dimension < 3 || (rules.split() != MeshSplit::corners && !rules.tangents(1))))
    fail(ErrorKind::domain, "normals: {}: tangents take more than the neighbours of a vertex, and are not made",
         scheme);
  if (options.limit && rules.has_edge_rules() && !rules.interpolates() && options.levels == 0)
    fail(ErrorKind::domain, "{}: limits by rules of edges need a level or more, as an edge may have two rules", scheme);
  if ((!options.limit && !options.normals) || !topology.has_boundary()) return;
  if (rules.fits() && !rules.interpolates())
    fail(ErrorKind::domain, "{}: limits are those of closed meshes; on a boundary they are not made", scheme);
  if (rules.split() == MeshSplit::corners)
    fail(ErrorKind::domain, "{}: limits and normals are those of closed meshes; the surface does not reach a boundary",
         scheme);
  if (rules.split() == MeshSplit::middles && options.levels % 2 != 0)
    fail(ErrorKind::domain, "{}: limits and normals of a mesh with a boundary need an even number of levels, got {}",
         scheme, options.levels);
}

double most_sides_growth(MeshSplit split) { return split == MeshSplit::middles ? 3 : 4; }

/// About how large the result will be.
void require_size(const PolygonMesh& mesh, const MeshRules& rules, int levels) {
  const double growth = std::pow(most_sides_growth(rules.split()), levels);
  const double numbers = std::max(static_cast<double>(mesh.values.size()), static_cast<double>(mesh.corners.size()));
  if (numbers * growth > most_numbers)
    fail(ErrorKind::size, "{} levels would make about {:.1e} numbers or corners of faces of {}; need at most {:.0e}",
         levels, numbers * growth, numbers, most_numbers);
}

PolygonMesh one_step(const PolygonMesh& mesh, const Topology& topology, const Creases& creases, MeshRules& rules,
                     int level) {
  switch (rules.split()) {
    case MeshSplit::triangles: return split_triangles(mesh, topology, creases, rules);
    case MeshSplit::polygons: return split_polygons(mesh, topology, creases, rules);
    case MeshSplit::corners: return split_corners(mesh, topology, rules);
    default: return split_by_middles(mesh, topology, rules, level % 2 == 1);
  }
}

/// The numbers of each vertex, the first ones from `limits` where there are any, then its normal.
std::vector<double> with_normals(const std::vector<double>& values, const std::vector<double>& normals,
                                 std::size_t dimension) {
  std::vector<double> result;
  result.reserve(values.size() + normals.size());
  for (std::size_t v = 0; v < normals.size() / 3; ++v) {
    result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(v * dimension),
                  values.begin() + static_cast<std::ptrdiff_t>((v + 1) * dimension));
    result.insert(result.end(), normals.begin() + static_cast<std::ptrdiff_t>(3 * v),
                  normals.begin() + static_cast<std::ptrdiff_t>(3 * v + 3));
  }
  return result;
}

PolygonMesh refined_by(MeshRules& rules, PolygonMesh mesh, const MeshOptions& options, const FacePlace& place) {
  require(mesh.is_canonical(), "refine: need a canonical mesh");
  if (mesh.faces() == 0) fail(ErrorKind::data, "refine: expected a mesh with faces; found no faces");
  require_faces(mesh, place);
  std::optional<Topology> topology(std::in_place, mesh, place);
  if (mesh.dimension >= 2) require_no_seams(mesh, *topology, std::min<std::size_t>(mesh.dimension, 3), place);
  require_options(mesh, *topology, rules, options);
  const bool one_more = options.limit && rules.fits() && !rules.interpolates();
  require_size(mesh, rules, options.keep_faces ? 1 : options.levels + (one_more ? 1 : 0));
  require_fit(mesh, *topology, rules, options, place);
  const FacePlace refined = [&](std::size_t face) { return rules.specification() + ", face " + std::to_string(face); };
  const bool at_limits = options.limit || options.normals;
  std::vector<bool> sharp;
  if (options.crease) sharp = edges_sharper_than(*options.crease, mesh, *topology);
  if (options.keep_faces) {
    const Creases boundary(*topology);
    for (int step = 0; step < options.levels; ++step) {
      std::vector<double> points = one_step(mesh, *topology, boundary, rules, 0).values;
      std::copy_n(points.begin(), mesh.values.size(), mesh.values.begin());  // those of old vertices come first
    }
    return mesh;
  }
  for (int level = 0; level < options.levels; ++level) {
    const Creases creases(mesh, *topology, std::exchange(sharp, {}));
    sharp = split_creases(mesh, *topology, creases, rules.split());
    mesh = one_step(mesh, *topology, creases, rules, level);
    topology.reset();
    if (mesh.faces() == 0)
      fail(ErrorKind::data, "{}: expected faces that are left of the mesh after {} levels", rules.specification(),
           level + 1);
    if (level + 1 < options.levels || at_limits) topology.emplace(mesh, refined);
  }
  if (!at_limits) return mesh;
  std::vector<double> normals;
  if (options.normals) normals = vertex_normals(mesh, *topology, rules);
  if (options.limit) {
    const Creases creases(mesh, *topology, std::move(sharp));
    if (creases.has_ends())
      fail(ErrorKind::domain,
           "{}: limits where a crease ends inside are not made; refine without limits, or change the angle",
           rules.specification());
    mesh.values = vertex_limits(mesh, *topology, creases, rules);
  }
  if (options.normals) {
    mesh.values = with_normals(mesh.values, normals, mesh.dimension);
    mesh.dimension += 3;
  }
  return mesh;
}

}  // namespace

PolygonMesh refine_mesh(PolygonMesh mesh, const std::string& scheme, const MeshOptions& options,
                        const FacePlace& place) {
  MeshRules rules(scheme);
  return refined_by(rules, std::move(mesh), options, place);
}

PolygonMesh refine_mesh(PolygonMesh mesh, const VertexScheme& scheme, const MeshOptions& options,
                        const FacePlace& place) {
  MeshRules rules = scheme.written ? MeshRules(scheme) : MeshRules(scheme.specification);
  return refined_by(rules, std::move(mesh), options, place);
}

}  // namespace subcert::data
