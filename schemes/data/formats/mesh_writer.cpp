#include "mesh_parts.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <ostream>
#include <sstream>
#include <utility>

namespace subcert::data {
namespace {

constexpr std::size_t block = 1U << 16U;

/// Text on its way to a stream, a block at a time.
class Blocks {
 public:
  explicit Blocks(std::ostream& stream) : stream_(stream) {}
  ~Blocks() { stream_ << text; }
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;

  void flush_if_full() {
    if (text.size() < block) return;
    stream_ << text;
    text.clear();
  }

  std::string text;

 private:
  std::ostream& stream_;
};

template <class Number>
void append_text(Number value, std::string& text) {
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), end);
  text += ' ';
}

/// A number as the encoding has it; in text a blank follows.
void append(double value, const NumberType& type, Encoding encoding, std::string& text) {
  if (encoding == Encoding::text)
    append_text(fitted(value, type), text);
  else
    append_number(value, type, encoding, text);
}

void end_line(std::string& text) { text.back() = '\n'; }

bool has_normals(const MeshFile& form) {
  return std::ranges::any_of(form.properties, is_normal, &VertexProperty::name);
}

/// Whether a format has a place for a property.
bool holds(MeshFormat format, const std::string& name) {
  if (format == MeshFormat::ply || name == "x" || name == "y" || name == "z") return true;
  return format != MeshFormat::stl && is_normal(name);
}

constexpr NumberType count_type{1, true, false}, index_type{4, true, true}, real_type{4, false, true};

void append_facet(const MeshFile& form, const PolygonMesh& mesh, std::size_t f, std::string& text) {
  std::array<std::array<double, 3>, 4> points{};  // the normal, then the corners
  for (std::size_t k = 0; k < 3; ++k)
    std::copy_n(mesh.values.begin() + static_cast<std::ptrdiff_t>(mesh.dimension * mesh.face(f)[k]), 3,
                points[k + 1].begin());
  double square = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
    points[0][c] = (points[2][d] - points[1][d]) * (points[3][e] - points[1][e]) -
                   (points[2][e] - points[1][e]) * (points[3][d] - points[1][d]);
    square += points[0][c] * points[0][c];
  }
  for (double& coordinate : points[0]) coordinate = square > 0 ? coordinate / std::sqrt(square) : 0;
  const bool is_text = form.encoding == Encoding::text;
  constexpr const char* before[] = {"facet normal ", "outer loop\nvertex ", "vertex ", "vertex "};
  for (std::size_t k = 0; k < 4; ++k) {
    if (is_text) text += before[k];
    for (const double coordinate : points[k])
      append(coordinate, is_text ? NumberType{} : real_type, is_text ? Encoding::text : Encoding::little_endian, text);
    if (is_text) end_line(text);
  }
  if (is_text)
    text += "endloop\nendfacet\n";
  else
    text += std::string(2, '\0');
}

void write_stl(std::ostream& stream, const MeshFile& form, const PolygonMesh& mesh) {
  require(mesh.has_only(3), "an STL file: need triangles");
  const bool is_text = form.encoding == Encoding::text;
  Blocks out(stream);
  if (is_text) {
    out.text = "solid mesh\n";
  } else {
    out.text = "binary STL";
    out.text.resize(80, ' ');
    append_number(static_cast<double>(mesh.faces()), {4, true, false}, Encoding::little_endian, out.text);
  }
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    append_facet(form, mesh, f, out.text);
    out.flush_if_full();
  }
  if (is_text) out.text += "endsolid mesh\n";
}

}  // namespace

void change_format(MeshFile& form, MeshFormat format) {
  if (format == MeshFormat::obj || format == MeshFormat::off) form.encoding = Encoding::text;
  if (std::exchange(form.format, format) == format) return;
  std::vector<std::string> lost;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < form.properties.size(); ++k)
    if (holds(format, form.properties[k].name))
      kept.push_back(k);
    else
      lost.push_back(form.properties[k].name);
  if (lost.empty()) return;
  form.remarks.push_back("left out, as the file that is written has no place for it: " + joined(lost));
  std::vector<VertexProperty> properties;
  for (const std::size_t k : kept) properties.push_back(form.properties[k]);
  std::vector<double> values;
  values.reserve(form.mesh.vertices() * kept.size());
  for (std::size_t v = 0; v < form.mesh.vertices(); ++v)
    for (const std::size_t k : kept) values.push_back(form.mesh.values[v * form.properties.size() + k]);
  form.properties = std::move(properties);
  form.mesh.values = std::move(values);
  form.mesh.dimension = kept.size();
}

void write_mesh_begin(std::ostream& stream, const MeshFile& form, std::size_t vertices, std::size_t faces,
                      std::size_t most_sides) {
  if (form.format == MeshFormat::obj) return;
  if (form.format == MeshFormat::off) {
    stream << (form.properties.size() > (has_normals(form) ? 6 : 3) ? "C" : "") << (has_normals(form) ? "N" : "")
           << "OFF\n"
           << vertices << " " << faces << " 0\n";
    return;
  }
  constexpr const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  stream << "ply\nformat " << names[static_cast<std::size_t>(form.encoding)] << " 1.0\nelement vertex " << vertices
         << "\n";
  for (const VertexProperty& property : form.properties)
    stream << "property " << ply_name(property.type) << " " << property.name << "\n";
  stream << "element face " << faces << "\nproperty list " << (most_sides > 255 ? "int" : "uchar")
         << " int vertex_indices\nend_header\n";
}

void write_vertices(std::ostream& stream, const MeshFile& form, const double* values, std::size_t vertices) {
  // OFF has normals before colours, OBJ has them in a line of their own.
  std::vector<std::size_t> places(form.properties.size()), normals;
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = k;
  const auto normal = [&](std::size_t k) { return is_normal(form.properties[k].name); };
  if (form.format == MeshFormat::off)
    std::stable_partition(places.begin() + 3, places.end(), normal);
  else if (form.format == MeshFormat::obj) {
    const auto begin = std::stable_partition(places.begin(), places.end(), std::not_fn(normal));
    normals.assign(begin, places.end());
    places.erase(begin, places.end());
  }
  Blocks out(stream);
  const auto append_all = [&](const std::vector<std::size_t>& all) {
    for (const std::size_t k : all) {
      const VertexProperty& property = form.properties[k];
      append(std::clamp(values[k], property.low, property.high), property.type, form.encoding, out.text);
    }
    if (form.encoding == Encoding::text) end_line(out.text);
  };
  for (std::size_t v = 0; v < vertices; ++v, values += form.properties.size()) {
    if (form.format == MeshFormat::obj) out.text += "v ";
    append_all(places);
    if (!normals.empty()) {
      out.text += "vn ";
      append_all(normals);
    }
    out.flush_if_full();
  }
}

void write_faces(std::ostream& stream, const MeshFile& form, std::span<const std::uint32_t> corners, std::size_t sides,
                 std::size_t most_sides) {
  const bool obj = form.format == MeshFormat::obj, in_bytes = form.encoding != Encoding::text;
  const bool normals = obj && has_normals(form);
  Blocks out(stream);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (k % sides == 0) {
      if (obj)
        out.text += "f ";
      else if (in_bytes)
        append_number(static_cast<double>(sides), most_sides > 255 ? index_type : count_type, form.encoding, out.text);
      else
        append_text(sides, out.text);
    }
    if (in_bytes) {
      append_number(corners[k], index_type, form.encoding, out.text);
      out.flush_if_full();
      continue;
    }
    append_text(corners[k] + (obj ? 1 : 0), out.text);
    if (normals) {
      out.text.back() = '/';
      out.text += '/';
      append_text(corners[k] + 1, out.text);
    }
    if (k % sides + 1 == sides) {
      end_line(out.text);
      out.flush_if_full();
    }
  }
}

void write_mesh(std::ostream& stream, const MeshFile& form, const PolygonMesh& mesh) {
  require(form.properties.size() >= 3 && mesh.dimension == form.properties.size() && mesh.is_canonical(),
          "a mesh in a file: need a property for each number of a vertex, three or more");
  if (form.format == MeshFormat::stl) return write_stl(stream, form, mesh);
  std::size_t most = 0;
  for (std::size_t f = 0; f < mesh.faces(); ++f) most = std::max(most, mesh.face(f).size());
  write_mesh_begin(stream, form, mesh.vertices(), mesh.faces(), most);
  write_vertices(stream, form, mesh.values.data(), mesh.vertices());
  for (std::size_t f = 0; f < mesh.faces();) {
    const std::size_t sides = mesh.face(f).size();
    std::size_t end = f + 1;
    while (end < mesh.faces() && mesh.face(end).size() == sides) ++end;
    write_faces(stream, form, std::span(mesh.corners).subspan(mesh.first[f], (end - f) * sides), sides, most);
    f = end;
  }
}

std::string to_text(const MeshFile& mesh) {
  std::ostringstream stream;
  write_mesh(stream, mesh, mesh.mesh);
  return stream.str();
}

}  // namespace subcert::data
