#include "mesh_parts.hpp"

#include <algorithm>
#include <charconv>

namespace subcert::data {
namespace {

/// For one vertex more.
void need_room(const MeshFile& mesh, const TextLines& lines) {
  if (mesh.mesh.vertices() >= most_vertices) lines.fail_file("at most " + std::to_string(most_vertices) + " vertices");
}

/// The vertex of `7`, `7/1`, `7//3` or, counted from the end, `-1`.
std::uint32_t obj_vertex(const TextLines& lines, std::size_t word, std::size_t vertices) {
  const std::string_view text = lines.word(word).substr(0, lines.word(word).find('/'));
  long index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  const long count = static_cast<long>(vertices);
  lines.need(!text.empty() && end == text.data() + text.size() && error == std::errc() && index != 0 &&
                 index >= -count && index <= count,
             word, "the number of one of the " + std::to_string(vertices) + " vertices above");
  return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
}

/// Of vertices with so many numbers; empty for a number that OBJ does not have.
std::vector<VertexProperty> obj_properties(std::size_t numbers) {
  std::vector<VertexProperty> properties{{"x"}, {"y"}, {"z"}};
  if (numbers == 4 || numbers == 7) properties.push_back({"w"});
  if (numbers >= 6)
    for (const char* name : {"red", "green", "blue"}) properties.push_back({name, {}, 0, 1});
  return properties.size() == numbers ? properties : std::vector<VertexProperty>{};
}

void read_obj_vertex(const TextLines& lines, MeshFile& mesh) {
  const std::size_t numbers = lines.words().size() - 1;
  if (mesh.properties.empty()) {
    mesh.properties = obj_properties(numbers);
    lines.need(!mesh.properties.empty(), std::min<std::size_t>(lines.words().size(), 4),
               "v and x y z, with w, red green blue or both behind them");
  }
  const std::size_t expected = mesh.properties.size();
  mesh.mesh.dimension = expected;
  lines.need(numbers == expected, std::min(lines.words().size(), expected + 1),
             "v and " + std::to_string(expected) + " numbers as in the first vertex");
  need_room(mesh, lines);
  for (std::size_t c = 1; c <= numbers; ++c) mesh.mesh.values.push_back(lines.number(c));
}

/// What OFF writes before and behind the places of vertices.
struct OffForm {
  bool normals;
  bool colours;
};

OffForm off_form(TextLines& lines) {
  constexpr const char* expected = "an OFF file, which begins with OFF, COFF, NOFF or CNOFF";
  if (!lines.next()) lines.fail_file(expected);
  for (const auto& [name, form] : {std::pair<const char*, OffForm>{"OFF", {false, false}},
                                   {"COFF", {false, true}},
                                   {"NOFF", {true, false}},
                                   {"CNOFF", {true, true}}})
    if (lines.is(0, name)) return form;
  lines.fail(0, expected);
}

void read_off_vertices(TextLines& lines, std::size_t count, const OffForm& form, MeshFile& mesh) {
  const std::size_t colour = form.normals ? 6 : 3;
  mesh.properties = obj_properties(3);
  for (std::size_t v = 0; v < count; ++v) {
    if (!lines.next()) lines.fail_file(std::to_string(count) + " vertices; found " + std::to_string(v));
    const std::size_t numbers = lines.words().size();
    if (v == 0 && numbers > colour) {
      lines.need(form.colours && numbers - colour >= 3 && numbers - colour <= 4, colour,
                 form.colours ? "a colour of three or four numbers" : "three numbers for a vertex");
      for (const char* name : {"red", "green", "blue"}) mesh.properties.push_back({name});
      if (numbers - colour == 4) mesh.properties.push_back({"alpha"});
    }
    mesh.mesh.dimension = mesh.properties.size();
    const std::size_t needed = colour + mesh.properties.size() - 3;
    lines.need(numbers == needed, std::min(numbers, needed), std::to_string(needed) + " numbers for a vertex");
    for (std::size_t i = 0; i < needed; ++i) {
      const double value = lines.number(i);
      if (i < 3 || i >= colour) mesh.mesh.values.push_back(value);
    }
  }
}

/// Whether faces have colours, which are left out.
bool read_off_faces(TextLines& lines, std::size_t count, MeshFile& mesh) {
  const std::size_t vertices = mesh.mesh.vertices();
  bool colours = false;
  for (std::size_t f = 0; f < count; ++f) {
    if (!lines.next()) lines.fail_file(std::to_string(count) + " faces; found " + std::to_string(f));
    const std::size_t sides = lines.count(0, 0, most_vertices, "the number of vertices of a face");
    for (std::size_t i = 1; i <= sides; ++i)
      mesh.mesh.corners.push_back(
          static_cast<std::uint32_t>(lines.count(i, 0, vertices == 0 ? 0 : vertices - 1, "the number of a vertex")));
    colours = colours || lines.words().size() > sides + 1;
    end_face(mesh, lines.line());
  }
  return colours;
}

}  // namespace

MeshFile parse_obj(std::string_view text, const std::string& file) {
  TextLines lines(text, file, true);
  MeshFile mesh{.file = file};
  bool other = false, shapes = false;
  while (lines.next()) {
    if (lines.is(0, "v")) {
      read_obj_vertex(lines, mesh);
    } else if (lines.is(0, "f")) {
      const std::size_t vertices = mesh.mesh.vertices();
      for (std::size_t k = 1; k < lines.words().size(); ++k)
        mesh.mesh.corners.push_back(obj_vertex(lines, k, vertices));
      end_face(mesh, lines.line());
    } else {
      static constexpr std::string_view others[] = {"vn", "vt", "l", "p", "o", "g", "s", "usemtl", "mtllib"};
      const auto found = std::ranges::find(others, lines.word(0));
      lines.need(found != std::end(others), 0, "v, f, vn, vt, l, p, o, g, s, usemtl or mtllib");
      other = other || found - std::begin(others) < 2;
      shapes = shapes || lines.is(0, "l") || lines.is(0, "p");
    }
  }
  std::vector<std::string> left_out;
  if (other) left_out.emplace_back("normals and texture coordinates");
  if (shapes) left_out.emplace_back("lines and points");
  return finished(std::move(mesh), std::move(left_out), lines);
}

MeshFile parse_off(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  const OffForm form = off_form(lines);
  std::size_t word = 1;
  if (lines.words().size() == 1) {
    if (!lines.next()) lines.fail_file("the numbers of vertices, faces and edges");
    word = 0;
  }
  const std::size_t vertices = lines.count(word, 0, most_vertices, "the number of vertices"),
                    faces = lines.count(word + 1, 0, most_vertices, "the number of faces");
  lines.need(lines.words().size() <= word + 3, word + 3, "the numbers of vertices, faces and edges");
  MeshFile mesh{.format = MeshFormat::off, .file = file};
  read_off_vertices(lines, vertices, form, mesh);
  std::vector<std::string> left_out;
  if (form.normals) left_out.emplace_back("normals");
  if (read_off_faces(lines, faces, mesh)) left_out.emplace_back("what faces have beside their vertices");
  if (lines.next()) lines.fail(0, "the end of the file after the faces");
  return finished(std::move(mesh), std::move(left_out), lines);
}

}  // namespace subcert::data
