#pragma once
/// Meshes in OBJ, PLY, OFF and STL files.

#include "number_type.hpp"
#include "row_lines.hpp"

#include <subcert/schemes/data/mesh/polygon_mesh.hpp>

#include <iosfwd>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

enum class MeshFormat { obj, ply, off, stl };

/// A number that each vertex has, how it is written, and the limits at which it is cut off then.
struct VertexProperty {
  std::string name;
  NumberType type = {};
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// Vertices with a number for each property: x, y, z, then others. Canonical: the mesh is, and has as many coordinates
/// as there are properties, three or more.
struct MeshFile {
  PolygonMesh mesh = {};
  std::vector<VertexProperty> properties = {};
  MeshFormat format = MeshFormat::obj;
  Encoding encoding = Encoding::text;
  std::string file = {};
  RowLines lines = {};                    ///< of the faces; none in bytes
  std::vector<std::string> remarks = {};  ///< what the file has and the mesh has not, a line each

  /// `FILE, line 7`, or `FILE, face 3` in bytes.
  std::string place(std::size_t face) const;
};

/// By the ending of a file's name, in small or capital letters.
std::optional<MeshFormat> mesh_format(const std::string& path);

/// Reads the vertices `v x y z`, also with w, or red green blue, or all four, and the faces `f` of an OBJ file; the
/// vertex and face elements of a PLY file, as text or in bytes; the vertices, also with normals or colours, and faces
/// of an OFF file; the facets of an STL file, as text or in bytes, whose corners at equal places are one vertex.
/// Numbers of a vertex beside its coordinates become properties; normals, texture coordinates, what faces have beside
/// their vertices, and vertices without faces do not. Errors: throws a data error: also for a mesh without faces, a
/// face with less than three vertices or one of them twice. Cost: linear.
MeshFile parse_mesh(MeshFormat format, std::string_view text, const std::string& file);
MeshFile parse_obj(std::string_view text, const std::string& file);
MeshFile parse_ply(std::string_view text, const std::string& file);
MeshFile parse_off(std::string_view text, const std::string& file);
MeshFile parse_stl(std::string_view text, const std::string& file);

/// Makes one vertex of those all of whose numbers are equal. Errors: throws a data error where a face then has one of
/// them twice. Cost: linear.
void join_equal_vertices(MeshFile& mesh);

/// To be written in this format: what it cannot hold of the properties is left out, with a remark; text stays text, and
/// a format without bytes is text.
void change_format(MeshFile& mesh, MeshFormat format);

/// Writes a mesh piece by piece in the format of `form`, whose mesh does not matter: what stands before the vertices,
/// vertices, then faces. Whole properties are rounded, coordinates are written as doubles. Properties nx, ny, nz are
/// normals. Domain: not STL, whose facets have no vertices: write_mesh() alone writes it. Errors: those of the stream.
void write_mesh_begin(std::ostream& stream, const MeshFile& form, std::size_t vertices, std::size_t faces,
                      std::size_t most_sides);
void write_vertices(std::ostream& stream, const MeshFile& form, const double* values, std::size_t vertices);
/// `corners`: of faces with `sides` corners each, of all faces at most `most_sides`.
void write_faces(std::ostream& stream, const MeshFile& form, std::span<const std::uint32_t> corners, std::size_t sides,
                 std::size_t most_sides);

/// All of a mesh, in the form of `form`. Domain: as many numbers at a vertex as properties; triangles for STL. Errors:
/// as above.
void write_mesh(std::ostream& stream, const MeshFile& form, const PolygonMesh& mesh);
std::string to_text(const MeshFile& mesh);

}  // namespace subcert::data
