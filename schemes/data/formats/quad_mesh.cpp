#include "quad_mesh.hpp"

#include "text_lines.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace subcert::data {
namespace {

using Quad = std::array<std::size_t, 4>;

constexpr std::size_t most_vertices = 100'000'000;

/// The quadrilaterals of a grid, vertices counted from 0, all with the same orientation.
std::vector<Quad> grid_quads(std::size_t columns, std::size_t rows, bool closed_x, bool closed_y) {
  std::vector<Quad> quads;
  for (std::size_t j = 0; j < rows - (closed_y ? 0 : 1); ++j)
    for (std::size_t i = 0; i < columns - (closed_x ? 0 : 1); ++i) {
      const std::size_t right = (i + 1) % columns, up = (j + 1) % rows;
      quads.push_back({j * columns + i, j * columns + right, up * columns + right, up * columns + i});
    }
  return quads;
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
      if (rows * columns != vertices || (columns - (closed_x ? 0 : 1)) * (rows - (closed_y ? 0 : 1)) != faces.size() ||
          (closed_x && columns < 3) || (closed_y && rows < 3))
        continue;
      if (sorted(grid_quads(columns, rows, closed_x, closed_y)) == given)
        return std::vector<Axis>{Axis::of(columns, closed_x), Axis::of(rows, closed_y)};
    }
  return std::nullopt;
}

GridData<double> surface(std::vector<double> coordinates, const std::vector<Quad>& faces, const TextLines& lines) {
  const std::size_t vertices = coordinates.size() / 3;
  if (vertices < 4 || faces.empty())
    lines.fail_file("vertices and four-sided faces that make a grid; found " + std::to_string(vertices) +
                    " vertices and " + std::to_string(faces.size()) + " faces");
  const auto axes = find_axes(vertices, faces);
  if (!axes)
    lines.fail_file("faces that make a grid of columns and rows with vertices numbered row by row; the " +
                    std::to_string(faces.size()) + " faces on " + std::to_string(vertices) + " vertices do not");
  return {std::move(coordinates), 3, *axes};
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

void require_surface(const GridData<double>& data) {
  if (data.axes.size() != 2 || data.dimension != 3 || !data.is_canonical())
    fail(ErrorKind::domain, "quad mesh: need two axes and three coordinates");
}

std::string point_lines(const GridData<double>& data, const std::string& begin) {
  std::string text;
  for (std::size_t i = 0; i < data.points(); ++i) {
    text += begin;
    for (std::size_t c = 0; c < 3; ++c) text += (c ? " " : "") + shortest_text(data.values[3 * i + c]);
    text += '\n';
  }
  return text;
}

std::string face_lines(const GridData<double>& data, const std::string& begin, std::size_t first) {
  std::string text;
  for (const Quad& quad :
       grid_quads(data.axes[0].count, data.axes[1].count, data.axes[0].closed, data.axes[1].closed)) {
    text += begin;
    for (const std::size_t vertex : quad) text += " " + std::to_string(vertex + first);
    text += '\n';
  }
  return text;
}

/// What the header of a PLY file says.
struct PlyHeader {
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

PlyHeader read_ply_header(TextLines& lines) {
  PlyHeader header;
  if (!lines.next() || !lines.is(0, "ply")) lines.fail_file("a PLY file, which begins with the line 'ply'");
  std::string element;
  std::size_t properties = 0;
  while (lines.next()) {
    if (lines.is(0, "comment") || lines.is(0, "obj_info")) continue;
    if (lines.is(0, "end_header")) {
      if (header.vertices == 0 || header.faces == 0 || element != "face")
        lines.fail(0, "the elements vertex and face, in this order, before the end of the header");
      return header;
    }
    if (lines.is(0, "format")) {
      lines.need(lines.is(1, "ascii"), 1, "ascii (binary files are not read)");
    } else if (lines.is(0, "element")) {
      lines.need(element == "vertex" ? properties == 3 : true, 0, "the properties x, y, z of the vertices first");
      element = lines.word(1);
      properties = 0;
      lines.need(element == "vertex" || (element == "face" && header.vertices > 0), 1, "vertex, then face");
      (element == "vertex" ? header.vertices : header.faces) = lines.count(2, 1, most_vertices, "a number of elements");
    } else if (lines.is(0, "property")) {
      constexpr const char* names[] = {"x", "y", "z"};
      if (element == "vertex")
        lines.need(properties < 3 && lines.is(2, names[std::min<std::size_t>(properties, 2)]), 2,
                   "the properties x, y, z of the vertices and no others");
      else
        lines.need(element == "face" && properties == 0 && lines.is(1, "list") &&
                       (lines.is(4, "vertex_indices") || lines.is(4, "vertex_index")),
                   1, "the property list vertex_indices of the faces and no others");
      ++properties;
    } else {
      lines.fail(0, "format, element, property, comment or end_header");
    }
  }
  lines.fail_file("the line end_header");
}

}  // namespace

GridData<double> parse_obj(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  std::vector<double> coordinates;
  std::vector<Quad> faces;
  while (lines.next()) {
    if (lines.is(0, "v")) {
      lines.need(lines.words().size() == 4, lines.words().size() < 4 ? lines.words().size() : 4,
                 "v and three coordinates");
      for (std::size_t c = 1; c <= 3; ++c) coordinates.push_back(lines.number(c));
    } else if (lines.is(0, "f")) {
      lines.need(lines.words().size() == 5, lines.words().size() < 5 ? lines.words().size() : 5, "f and four vertices");
      Quad face;
      for (std::size_t k = 0; k < 4; ++k) face[k] = obj_vertex(lines, k + 1, coordinates.size() / 3);
      faces.push_back(face);
    } else {
      static constexpr std::string_view others[] = {"vn", "vt", "o", "g", "s", "usemtl", "mtllib"};
      lines.need(std::find(std::begin(others), std::end(others), lines.word(0)) != std::end(others), 0,
                 "v, f, vn, vt, o, g, s, usemtl or mtllib");
    }
  }
  return surface(std::move(coordinates), faces, lines);
}

GridData<double> parse_ply(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  const PlyHeader header = read_ply_header(lines);
  std::vector<double> coordinates;
  std::vector<Quad> faces;
  while (coordinates.size() < 3 * header.vertices) {
    if (!lines.next())
      lines.fail_file(std::to_string(header.vertices) + " vertices; found " + std::to_string(coordinates.size() / 3));
    lines.need(lines.words().size() == 3, std::min<std::size_t>(lines.words().size(), 3), "three coordinates");
    for (std::size_t c = 0; c < 3; ++c) coordinates.push_back(lines.number(c));
  }
  while (faces.size() < header.faces) {
    if (!lines.next()) lines.fail_file(std::to_string(header.faces) + " faces; found " + std::to_string(faces.size()));
    lines.need(lines.is(0, "4") && lines.words().size() == 5,
               std::min<std::size_t>(lines.words().size(), lines.is(0, "4") ? 5 : 0), "4 and four vertices");
    Quad face;
    for (std::size_t k = 0; k < 4; ++k) face[k] = lines.count(k + 1, 0, header.vertices - 1, "the number of a vertex");
    faces.push_back(face);
  }
  if (lines.next()) lines.fail(0, "the end of the file after the faces");
  return surface(std::move(coordinates), faces, lines);
}

std::string to_obj(const GridData<double>& data) {
  require_surface(data);
  return point_lines(data, "v ") + face_lines(data, "f", 1);
}

std::string to_ply(const GridData<double>& data) {
  require_surface(data);
  const std::string faces = face_lines(data, "4", 0);
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(data.points()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(std::count(faces.begin(), faces.end(), '\n')) +
         "\nproperty list uchar int vertex_indices\nend_header\n" + point_lines(data, "") + faces;
}

}  // namespace subcert::data
