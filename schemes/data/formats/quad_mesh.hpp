#pragma once
/// Surfaces as meshes of quadrilaterals in OBJ and PLY files.

#include "number_type.hpp"

#include <subcert/schemes/data/refine/grid_data.hpp>

#include <iosfwd>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

enum class MeshFormat { obj, ply };

/// A number that each vertex has, how it is written, and the limits at which it is cut off then.
struct VertexProperty {
  std::string name;
  NumberType type = {};
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// Vertices on a grid with a number for each property: x, y, z, then others. Canonical: two axes, as many numbers as
/// properties, three or more.
struct QuadMesh {
  GridData<double> data;
  std::vector<VertexProperty> properties;
  MeshFormat format = MeshFormat::obj;
  Encoding encoding = Encoding::text;
  std::vector<std::string> remarks = {};  ///< what the file has and the mesh has not, a line each
};

/// Reads the vertices `v x y z`, also with w, or red green blue, or all four, and the faces `f` of an OBJ file, or the
/// vertex and face elements of a PLY file, as text or in bytes. Numbers of a vertex beside its coordinates become
/// properties; normals, texture coordinates, what faces have beside their vertices, and vertices without faces do not.
/// The faces must make a grid with vertices numbered row by row, in any order and orientation: vertex j * columns + i
/// is joined to its neighbours in i and j, in closed directions the last to the first. Axis 0 counts the columns.
/// Errors: throws a data error. Cost: faces * log(faces).
QuadMesh parse_obj(std::string_view text, const std::string& file);
QuadMesh parse_ply(std::string_view text, const std::string& file);

/// Writes a mesh piece by piece in the format of `form`, whose data do not matter: what stands before the vertices,
/// vertices row by row, what follows them. Whole properties are rounded, coordinates are written as doubles. Domain:
/// `axes` are two. Errors: those of the stream.
void write_mesh_begin(std::ostream& stream, const QuadMesh& form, const std::vector<Axis>& axes);
void write_vertices(std::ostream& stream, const QuadMesh& form, const double* values, std::size_t vertices);
void write_mesh_end(std::ostream& stream, const QuadMesh& form, const std::vector<Axis>& axes);

/// All of it. Errors: throws a domain error for a mesh that is not canonical.
std::string to_text(const QuadMesh& mesh);

}  // namespace subcert::data
