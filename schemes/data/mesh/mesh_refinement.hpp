#pragma once
/// Refinement of meshes of any topology, with boundaries.

#include "mesh_rules.hpp"
#include "topology.hpp"

#include <optional>

namespace subcert::data {

struct MeshOptions {
  int levels = 1;
  bool limit = false;    ///< vertices are moved to their limits
  bool normals = false;  ///< nx, ny, nz of the limit surface follow the numbers of each vertex
  /// Degrees: edges inside stay sharp where the normals of their faces differ by more.
  std::optional<double> crease = std::nullopt;
  /// Each level gives the new points of old vertices alone, and leaves the faces as they are: the mesh is smoothed.
  bool keep_faces = false;
};

/// Applies a scheme `levels` times; docs/meshes.md has its rules, also those of boundaries. Vertices come first that
/// stand at old ones, then those on edges, then those in faces; of splits by corners one for each corner. All numbers
/// of a vertex are refined alike. The first level of a sqrt3 scheme keeps the edges of boundaries, the second cuts
/// each in three, and so on. Domain: a mesh with a manifold topology, triangles for splits by triangles and middles,
/// no vertex inside with two edges; to keep faces a scheme that moves vertices, without other options; quadrilaterals
/// for limits of splits by polygons without levels; normals: three coordinates first, and a scheme whose tangents take
/// the neighbours alone. Errors: throws a data error that names the place of a face, a domain error for options that
/// the scheme has not, a size error for a result of more than 10^8 numbers or corners. Cost: linear. Memory: about
/// three times the result.
PolygonMesh refine_mesh(PolygonMesh mesh, const std::string& scheme, const MeshOptions& options,
                        const FacePlace& place);
/// The same by rules that are written down. Errors: also those of MeshRules.
PolygonMesh refine_mesh(PolygonMesh mesh, const VertexScheme& scheme, const MeshOptions& options,
                        const FacePlace& place);

}  // namespace subcert::data
