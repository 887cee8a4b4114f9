#include "mesh_parts.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::data {
namespace {

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

/// Where the property of each place goes; nothing for what is left out. x, y, z go first.
std::vector<std::optional<std::size_t>> ply_places(const PlyElement& vertex, const TextLines& lines, MeshFile& mesh,
                                                   std::vector<std::string>& all_left_out) {
  std::vector<std::optional<std::size_t>> places(vertex.properties.size());
  const auto keep = [&](std::size_t at, const NumberType& type) {
    places[at] = mesh.properties.size();
    mesh.properties.push_back({vertex.properties[at].name, type});
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
  if (!left_out.empty()) all_left_out.push_back(joined(left_out) + " of the vertices");
  return places;
}

void read_ply_vertices(PlyNumbers& numbers, const PlyElement& vertex,
                       const std::vector<std::optional<std::size_t>>& places, MeshFile& mesh) {
  const std::size_t size = mesh.properties.size();
  for (std::size_t v = 0; v < vertex.count; ++v) {
    numbers.begin(vertex, v);
    mesh.mesh.values.resize(mesh.mesh.values.size() + size);
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (vertex.properties[k].length)
        pass(numbers, vertex.properties[k]);
      else if (const double value = numbers.take(vertex.properties[k].type); places[k])
        mesh.mesh.values[v * size + *places[k]] = value;
    }
    numbers.end(std::to_string(vertex.properties.size()) + " numbers for a vertex");
  }
}

bool is_vertex_list(const PlyProperty& property) {
  return property.length && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void read_ply_faces(PlyNumbers& numbers, const PlyElement& face, std::size_t vertices, const TextLines& lines,
                    MeshFile& mesh) {
  const std::string expected = "the number of a vertex from 0 to " + std::to_string(vertices - 1);
  for (std::size_t f = 0; f < face.count; ++f) {
    numbers.begin(face, f);
    for (const PlyProperty& property : face.properties) {
      if (is_vertex_list(property)) {
        const std::size_t sides = numbers.take(*property.length, 0, static_cast<double>(most_vertices),
                                               "the number of vertices of a face");
        for (std::size_t i = 0; i < sides; ++i)
          mesh.mesh.corners.push_back(
              static_cast<std::uint32_t>(numbers.take(property.type, 0, static_cast<double>(vertices) - 1, expected)));
      } else if (property.length) {
        pass(numbers, property);
      } else {
        numbers.take(property.type);
      }
    }
    numbers.end("no more numbers for a face");
    end_face(mesh, mesh.encoding == Encoding::text ? lines.line() : 0);
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

}  // namespace

std::string ply_name(const NumberType& type) {
  for (const PlyType& one : ply_types)
    if (one.type.size == type.size && one.type.whole == type.whole && one.type.with_sign == type.with_sign)
      return one.name;
  return "double";
}

MeshFile parse_ply(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  const PlyHeader header = read_ply_header(lines);
  MeshFile mesh{.format = MeshFormat::ply, .encoding = header.encoding, .file = file};
  std::vector<std::string> left_out;
  PlyNumbers numbers(lines, header.encoding);
  std::optional<std::size_t> vertices;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex" && !vertices) {
      vertices = element.count;
      const auto places = ply_places(element, lines, mesh, left_out);
      mesh.mesh.dimension = mesh.properties.size();
      read_ply_vertices(numbers, element, places, mesh);
    } else if (element.name == "face" && mesh.mesh.faces() == 0) {
      if (!vertices || *vertices == 0 || std::ranges::count_if(element.properties, is_vertex_list) != 1)
        lines.fail_file("vertices, then faces with one list vertex_indices");
      if (element.properties.size() > 1) left_out.emplace_back("what faces have beside their vertices");
      read_ply_faces(numbers, element, *vertices, lines, mesh);
    } else {
      left_out.push_back("elements " + element.name);
      pass(numbers, element);
    }
  }
  if (!vertices) lines.fail_file("the element vertex");
  if (header.encoding == Encoding::text && lines.next()) lines.fail(0, "the end of the file after the elements");
  return finished(std::move(mesh), std::move(left_out), lines);
}

}  // namespace subcert::data
