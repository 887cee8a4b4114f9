#include "quad_mesh.hpp"

#include "text_lines.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <ostream>
#include <sstream>

namespace subcert::data {
namespace {

using Quad = std::array<std::size_t, 4>;

constexpr std::size_t most_vertices = 100'000'000;

/// Calls work(quad) for the quadrilaterals of a grid, vertices counted from 0, all with the same orientation.
template <class Work>
void for_quads(const std::vector<Axis>& axes, const Work& work) {
  const std::size_t columns = axes[0].count, rows = axes[1].count;
  for (std::size_t j = 0; j < rows - (axes[1].closed ? 0 : 1); ++j)
    for (std::size_t i = 0; i < columns - (axes[0].closed ? 0 : 1); ++i) {
      const std::size_t right = (i + 1) % columns, up = (j + 1) % rows;
      work(Quad{j * columns + i, j * columns + right, up * columns + right, up * columns + i});
    }
}

std::size_t count_quads(const std::vector<Axis>& axes) {
  return (axes[0].count - (axes[0].closed ? 0 : 1)) * (axes[1].count - (axes[1].closed ? 0 : 1));
}

std::vector<Quad> sorted(std::vector<Quad> quads) {
  for (Quad& quad : quads) std::sort(quad.begin(), quad.end());
  std::sort(quads.begin(), quads.end());
  return quads;
}

/// The axes of the grid that these faces make. Where several fit, the one with fewer closed directions is taken.
std::optional<std::vector<Axis>> find_axes(std::size_t vertices, const std::vector<Quad>& faces) {
  const std::vector<Quad> given = sorted(faces);
  for (const auto& [closed_x, closed_y] : {std::pair(false, false), {true, false}, {false, true}, {true, true}})
    for (std::size_t columns = 2; columns <= vertices / 2; ++columns) {
      const std::size_t rows = vertices / columns;
      if (rows * columns != vertices || (closed_x && columns < 3) || (closed_y && rows < 3)) continue;
      std::vector<Axis> axes{Axis::of(columns, closed_x), Axis::of(rows, closed_y)};
      if (count_quads(axes) != faces.size()) continue;
      std::vector<Quad> quads;
      for_quads(axes, [&](const Quad& quad) { quads.push_back(quad); });
      if (sorted(std::move(quads)) == given) return axes;
    }
  return std::nullopt;
}

/// What a file was read to. Canonical: values.size() is a multiple of the number of properties.
struct Parts {
  std::vector<VertexProperty> properties;
  std::vector<double> values;
  std::vector<Quad> faces;
  std::vector<std::string> left_out = {};  ///< what was not kept
};

/// Takes away the vertices that no face has.
void drop_unused(Parts& parts) {
  const std::size_t size = parts.properties.size(), vertices = parts.values.size() / size;
  std::vector<std::size_t> number(vertices, 0);
  for (const Quad& face : parts.faces)
    for (const std::size_t vertex : face) number[vertex] = 1;
  std::size_t used = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    if (number[v] == 0) continue;
    std::copy_n(parts.values.begin() + static_cast<std::ptrdiff_t>(v * size), size,
                parts.values.begin() + static_cast<std::ptrdiff_t>(used * size));
    number[v] = used++;
  }
  if (used == vertices) return;
  parts.values.resize(used * size);
  for (Quad& face : parts.faces)
    for (std::size_t& vertex : face) vertex = number[vertex];
  parts.left_out.push_back("vertices without faces (" + std::to_string(vertices - used) + ")");
}

std::string joined(const std::vector<std::string>& texts) {
  std::string text;
  for (const std::string& one : texts) text += (text.empty() ? "" : ", ") + one;
  return text;
}

QuadMesh mesh_of(Parts parts, const TextLines& lines, MeshFormat format, Encoding encoding) {
  const std::size_t given = parts.values.size() / parts.properties.size();
  if (given < 4 || parts.faces.empty())
    lines.fail_file("vertices and four-sided faces that make a grid; found " + std::to_string(given) +
                    " vertices and " + std::to_string(parts.faces.size()) + " faces");
  drop_unused(parts);
  const std::size_t vertices = parts.values.size() / parts.properties.size();
  const auto axes = find_axes(vertices, parts.faces);
  if (!axes)
    lines.fail_file("faces that make a grid of columns and rows with vertices numbered row by row; the " +
                    std::to_string(parts.faces.size()) + " faces on " + std::to_string(vertices) + " vertices do not");
  QuadMesh mesh{{std::move(parts.values), parts.properties.size(), *axes}, parts.properties, format, encoding};
  std::vector<std::string> beside;
  for (std::size_t k = 3; k < mesh.properties.size(); ++k) beside.push_back(mesh.properties[k].name);
  if (!beside.empty()) mesh.remarks.push_back("refined as x, y, z are: " + joined(beside));
  if (!parts.left_out.empty()) mesh.remarks.push_back("left out: " + joined(parts.left_out));
  return mesh;
}

/// The vertex of `7`, `7/1`, `7//3` or, counted from the end, `-1`.
std::size_t obj_vertex(const TextLines& lines, std::size_t word, std::size_t vertices) {
  const std::string_view text = lines.word(word).substr(0, lines.word(word).find('/'));
  long index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  const long count = static_cast<long>(vertices);
  lines.need(!text.empty() && end == text.data() + text.size() && error == std::errc() && index != 0 &&
                 index >= -count && index <= count,
             word, "the number of one of the " + std::to_string(vertices) + " vertices above");
  return static_cast<std::size_t>(index > 0 ? index - 1 : count + index);
}

/// Of vertices with so many numbers; empty for a number that OBJ does not have.
std::vector<VertexProperty> obj_properties(std::size_t numbers) {
  std::vector<VertexProperty> properties{{"x"}, {"y"}, {"z"}};
  if (numbers == 4 || numbers == 7) properties.push_back({"w"});
  if (numbers >= 6)
    for (const char* name : {"red", "green", "blue"}) properties.push_back({name, {}, 0, 1});
  return properties.size() == numbers ? properties : std::vector<VertexProperty>{};
}

void read_obj_vertex(const TextLines& lines, Parts& parts) {
  const std::size_t numbers = lines.words().size() - 1;
  if (parts.properties.empty()) {
    parts.properties = obj_properties(numbers);
    lines.need(!parts.properties.empty(), std::min<std::size_t>(lines.words().size(), 4),
               "v and x y z, with w, red green blue or both behind them");
  }
  const std::size_t expected = parts.properties.size();
  lines.need(numbers == expected, std::min(lines.words().size(), expected + 1),
             "v and " + std::to_string(expected) + " numbers as in the first vertex");
  for (std::size_t c = 1; c <= numbers; ++c) parts.values.push_back(lines.number(c));
}

/// A property of PLY elements; a list where it has a type of its length.
struct PlyProperty {
  std::string name;
  NumberType type;
  std::optional<NumberType> length = {};
};

struct PlyElement {
  std::string name;
  std::size_t count;
  std::vector<PlyProperty> properties = {};
};

struct PlyType {
  const char* name;
  const char* other;
  NumberType type;
};

constexpr PlyType ply_types[] = {{"char", "int8", {1, true, true}},      {"uchar", "uint8", {1, true, false}},
                                 {"short", "int16", {2, true, true}},    {"ushort", "uint16", {2, true, false}},
                                 {"int", "int32", {4, true, true}},      {"uint", "uint32", {4, true, false}},
                                 {"float", "float32", {4, false, true}}, {"double", "float64", {8, false, true}}};

NumberType ply_type(const TextLines& lines, std::size_t word) {
  for (const PlyType& one : ply_types)
    if (lines.is(word, one.name) || lines.is(word, one.other)) return one.type;
  lines.fail(word, "char, uchar, short, ushort, int, uint, float or double");
}

std::string ply_name(const NumberType& type) {
  for (const PlyType& one : ply_types)
    if (one.type.size == type.size && one.type.whole == type.whole && one.type.with_sign == type.with_sign)
      return one.name;
  return "double";
}

Encoding ply_encoding(const TextLines& lines) {
  if (lines.is(1, "ascii")) return Encoding::text;
  if (lines.is(1, "binary_little_endian")) return Encoding::little_endian;
  lines.need(lines.is(1, "binary_big_endian"), 1, "ascii, binary_little_endian or binary_big_endian");
  return Encoding::big_endian;
}

PlyProperty ply_property(const TextLines& lines) {
  if (!lines.is(1, "list")) return {std::string(lines.word(2)), ply_type(lines, 1)};
  PlyProperty list{std::string(lines.word(4)), ply_type(lines, 3), ply_type(lines, 2)};
  lines.need(list.length->whole, 2, "a whole type for the length of a list");
  return list;
}

/// What the header of a PLY file says.
struct PlyHeader {
  Encoding encoding = Encoding::text;
  std::vector<PlyElement> elements = {};
};

PlyHeader read_ply_header(TextLines& lines) {
  PlyHeader header;
  if (!lines.next() || !lines.is(0, "ply")) lines.fail_file("a PLY file, which begins with the line 'ply'");
  while (lines.next()) {
    if (lines.is(0, "comment") || lines.is(0, "obj_info")) continue;
    if (lines.is(0, "end_header")) return header;
    if (lines.is(0, "format")) {
      header.encoding = ply_encoding(lines);
    } else if (lines.is(0, "element")) {
      header.elements.push_back({std::string(lines.word(1)), lines.count(2, 0, most_vertices, "a number of elements")});
    } else {
      lines.need(lines.is(0, "property"), 0, "format, element, property, comment or end_header");
      lines.need(!header.elements.empty(), 0, "an element before its properties");
      header.elements.back().properties.push_back(ply_property(lines));
      lines.need(!header.elements.back().properties.back().name.empty(), lines.words().size(),
                 "the name of the property");
    }
  }
  lines.fail_file("the line end_header");
}

/// The numbers of PLY elements, one after another.
class PlyNumbers {
 public:
  PlyNumbers(TextLines& lines, Encoding encoding) : lines_(lines), encoding_(encoding) {}

  /// Elements of text stand in a line each.
  void begin(const PlyElement& element, std::size_t number) {
    where_ = element.name + " " + std::to_string(number);
    if (encoding_ != Encoding::text) return;
    if (!lines_.next())
      lines_.fail_file(std::to_string(element.count) + " elements " + element.name + "; found " +
                       std::to_string(number));
    word_ = 0;
  }
  double take(const NumberType& type) {
    if (encoding_ == Encoding::text) return lines_.number(word_++);
    const double value = read_number(lines_.take_bytes(type.size, where_), type, encoding_);
    if (!std::isfinite(value)) fail("finite numbers", value);
    return value;
  }
  /// A whole number from `low` to `high`.
  std::size_t take(const NumberType& type, double low, double high, const std::string& expected) {
    const double value = take(type);
    if (!(value >= low && value <= high) || value != std::floor(value)) fail(expected, value);
    return static_cast<std::size_t>(value);
  }
  void end(const std::string& expected) {
    if (encoding_ == Encoding::text) lines_.need(word_ == lines_.words().size(), word_, expected);
  }

 private:
  [[noreturn]] void fail(const std::string& expected, double value) const {
    if (encoding_ == Encoding::text) lines_.fail(word_ - 1, expected);
    lines_.fail_file(expected + " in " + where_ + "; found " + shortest_text(value));
  }

  TextLines& lines_;
  Encoding encoding_;
  std::string where_;
  std::size_t word_ = 0;
};

/// Passes over a list.
void pass(PlyNumbers& numbers, const PlyProperty& list) {
  const std::size_t length = numbers.take(*list.length, 0, 4e9, "the length of a list");
  for (std::size_t i = 0; i < length; ++i) numbers.take(list.type);
}

bool is_normal(const std::string& name) { return name == "nx" || name == "ny" || name == "nz"; }

/// Where the property of each place goes; nothing for what is left out. x, y, z go first.
std::vector<std::optional<std::size_t>> ply_places(const PlyElement& vertex, const TextLines& lines, Parts& parts) {
  std::vector<std::optional<std::size_t>> places(vertex.properties.size());
  const auto keep = [&](std::size_t at, const NumberType& type) {
    places[at] = parts.properties.size();
    parts.properties.push_back({vertex.properties[at].name, type});
  };
  for (const char* name : {"x", "y", "z"}) {
    const auto found = std::ranges::find(vertex.properties, name, &PlyProperty::name);
    if (found == vertex.properties.end() || found->length)
      lines.fail_file(std::string("the properties x, y and z of the vertices; found no ") + name);
    keep(static_cast<std::size_t>(found - vertex.properties.begin()), {});
  }
  std::vector<std::string> left_out;
  for (std::size_t k = 0; k < vertex.properties.size(); ++k) {
    const PlyProperty& property = vertex.properties[k];
    if (places[k]) continue;
    if (property.length || is_normal(property.name))
      left_out.push_back(property.name);
    else
      keep(k, property.type.whole ? property.type : NumberType{});
  }
  if (!left_out.empty()) parts.left_out.push_back(joined(left_out) + " of the vertices");
  return places;
}

void read_ply_vertices(PlyNumbers& numbers, const PlyElement& vertex,
                       const std::vector<std::optional<std::size_t>>& places, Parts& parts) {
  const std::size_t size = parts.properties.size();
  for (std::size_t v = 0; v < vertex.count; ++v) {
    numbers.begin(vertex, v);
    parts.values.resize(parts.values.size() + size);
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (vertex.properties[k].length)
        pass(numbers, vertex.properties[k]);
      else if (const double value = numbers.take(vertex.properties[k].type); places[k])
        parts.values[v * size + *places[k]] = value;
    }
    numbers.end(std::to_string(vertex.properties.size()) + " numbers for a vertex");
  }
}

bool is_vertex_list(const PlyProperty& property) {
  return property.length && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void read_ply_faces(PlyNumbers& numbers, const PlyElement& face, std::size_t vertices, Parts& parts) {
  for (std::size_t f = 0; f < face.count; ++f) {
    numbers.begin(face, f);
    for (const PlyProperty& property : face.properties) {
      if (is_vertex_list(property)) {
        numbers.take(*property.length, 4, 4, "faces of 4 vertices, as meshes are grids of quadrilaterals");
        Quad& quad = parts.faces.emplace_back();
        for (std::size_t& vertex : quad)
          vertex = numbers.take(property.type, 0, static_cast<double>(vertices) - 1,
                                "the number of a vertex from 0 to " + std::to_string(vertices - 1));
      } else if (property.length) {
        pass(numbers, property);
      } else {
        numbers.take(property.type);
      }
    }
    numbers.end("4 and four vertices");
  }
}

void pass(PlyNumbers& numbers, const PlyElement& element) {
  if (element.properties.empty()) return;
  for (std::size_t i = 0; i < element.count; ++i) {
    numbers.begin(element, i);
    for (const PlyProperty& property : element.properties)
      if (property.length)
        pass(numbers, property);
      else
        numbers.take(property.type);
  }
}

/// A number as the encoding has it; in text a blank follows.
void append(double value, const NumberType& type, Encoding encoding, std::string& text) {
  if (encoding == Encoding::text)
    text += shortest_text(fitted(value, type)) + " ";
  else
    append_number(value, type, encoding, text);
}

constexpr NumberType count_type{1, true, false}, index_type{4, true, true};

}  // namespace

QuadMesh parse_obj(std::string_view text, const std::string& file) {
  TextLines lines(text, file, true);
  Parts parts;
  bool other = false;
  while (lines.next()) {
    if (lines.is(0, "v")) {
      read_obj_vertex(lines, parts);
    } else if (lines.is(0, "f")) {
      lines.need(lines.words().size() == 5, std::min<std::size_t>(lines.words().size(), 5),
                 "f and four vertices, as meshes are grids of quadrilaterals");
      const std::size_t vertices = parts.properties.empty() ? 0 : parts.values.size() / parts.properties.size();
      Quad face;
      for (std::size_t k = 0; k < 4; ++k) face[k] = obj_vertex(lines, k + 1, vertices);
      parts.faces.push_back(face);
    } else {
      static constexpr std::string_view others[] = {"vn", "vt", "o", "g", "s", "usemtl", "mtllib"};
      const auto found = std::ranges::find(others, lines.word(0));
      lines.need(found != std::end(others), 0, "v, f, vn, vt, o, g, s, usemtl or mtllib");
      if (found - std::begin(others) < 2) other = true;
    }
  }
  if (other) parts.left_out.emplace_back("normals and texture coordinates");
  if (parts.properties.empty()) parts.properties = obj_properties(3);
  return mesh_of(std::move(parts), lines, MeshFormat::obj, Encoding::text);
}

QuadMesh parse_ply(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  const PlyHeader header = read_ply_header(lines);
  Parts parts;
  PlyNumbers numbers(lines, header.encoding);
  std::optional<std::size_t> vertices;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex" && !vertices) {
      vertices = element.count;
      read_ply_vertices(numbers, element, ply_places(element, lines, parts), parts);
    } else if (element.name == "face" && parts.faces.empty()) {
      if (!vertices || *vertices == 0 || std::ranges::count_if(element.properties, is_vertex_list) != 1)
        lines.fail_file("vertices, then faces with one list vertex_indices");
      if (element.properties.size() > 1) parts.left_out.emplace_back("what faces have beside their vertices");
      read_ply_faces(numbers, element, *vertices, parts);
    } else {
      parts.left_out.push_back("elements " + element.name);
      pass(numbers, element);
    }
  }
  if (!vertices) lines.fail_file("the element vertex");
  if (header.encoding == Encoding::text && lines.next()) lines.fail(0, "the end of the file after the elements");
  return mesh_of(std::move(parts), lines, MeshFormat::ply, header.encoding);
}

void write_mesh_begin(std::ostream& stream, const QuadMesh& form, const std::vector<Axis>& axes) {
  if (form.format == MeshFormat::obj) return;
  constexpr const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  stream << "ply\nformat " << names[static_cast<std::size_t>(form.encoding)] << " 1.0\nelement vertex "
         << axes[0].count * axes[1].count << "\n";
  for (const VertexProperty& property : form.properties)
    stream << "property " << ply_name(property.type) << " " << property.name << "\n";
  stream << "element face " << count_quads(axes) << "\nproperty list uchar int vertex_indices\nend_header\n";
}

void write_vertices(std::ostream& stream, const QuadMesh& form, const double* values, std::size_t vertices) {
  std::string text;
  for (std::size_t v = 0; v < vertices; ++v, values += form.properties.size()) {
    text.clear();
    if (form.format == MeshFormat::obj) text += "v ";
    for (std::size_t k = 0; k < form.properties.size(); ++k) {
      const VertexProperty& property = form.properties[k];
      append(std::clamp(values[k], property.low, property.high), property.type, form.encoding, text);
    }
    if (form.encoding == Encoding::text) text.back() = '\n';
    stream << text;
  }
}

void write_mesh_end(std::ostream& stream, const QuadMesh& form, const std::vector<Axis>& axes) {
  const bool obj = form.format == MeshFormat::obj;
  std::string text;
  for_quads(axes, [&](const Quad& quad) {
    text.clear();
    if (obj)
      text += "f ";
    else
      append(4, count_type, form.encoding, text);
    for (const std::size_t vertex : quad)
      append(static_cast<double>(vertex + (obj ? 1 : 0)), index_type, form.encoding, text);
    if (form.encoding == Encoding::text) text.back() = '\n';
    stream << text;
  });
}

std::string to_text(const QuadMesh& mesh) {
  require(mesh.data.axes.size() == 2 && mesh.data.dimension >= 3 && mesh.properties.size() == mesh.data.dimension &&
              mesh.data.is_canonical(),
          "quad mesh: need two axes and a property for each number, three or more");
  std::ostringstream stream;
  write_mesh_begin(stream, mesh, mesh.data.axes);
  write_vertices(stream, mesh, mesh.data.values.data(), mesh.data.points());
  write_mesh_end(stream, mesh, mesh.data.axes);
  return stream.str();
}

}  // namespace subcert::data
