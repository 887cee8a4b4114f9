#include "grid_mesh.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace subcert::data {
namespace {

using Quad = std::array<std::uint32_t, 4>;

/// Calls work(quad) for the quadrilaterals of a grid, vertices counted from 0, all with the same orientation.
template <class Work>
void for_quads(const std::vector<Axis>& axes, const Work& work) {
  const auto columns = static_cast<std::uint32_t>(axes[0].count), rows = static_cast<std::uint32_t>(axes[1].count);
  for (std::uint32_t j = 0; j < rows - (axes[1].closed ? 0 : 1); ++j)
    for (std::uint32_t i = 0; i < columns - (axes[0].closed ? 0 : 1); ++i) {
      const std::uint32_t right = (i + 1) % columns, up = (j + 1) % rows;
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

}  // namespace

GridData<double> take_grid(MeshFile& file) {
  PolygonMesh& mesh = file.mesh;
  std::vector<Quad> faces(mesh.faces());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (mesh.face(f).size() != 4)
      fail(ErrorKind::data, "{}: expected a face of 4 vertices, as in a grid; found {}", file.place(f),
           mesh.face(f).size());
    std::ranges::copy(mesh.face(f), faces[f].begin());
  }
  const auto axes = find_axes(mesh.vertices(), faces);
  if (!axes)
    fail(
        ErrorKind::data,
        "{}: expected faces that make a grid of columns and rows with vertices numbered row by row; the {} faces on {} "
        "vertices do not",
        file.file, faces.size(), mesh.vertices());
  GridData<double> data{std::move(mesh.values), mesh.dimension, *axes};
  mesh = {};
  return data;
}

void write_grid_begin(std::ostream& stream, const MeshFile& form, const std::vector<Axis>& axes) {
  write_mesh_begin(stream, form, axes[0].count * axes[1].count, count_quads(axes), 4);
}

void write_grid_end(std::ostream& stream, const MeshFile& form, const std::vector<Axis>& axes) {
  std::vector<std::uint32_t> row;
  for_quads(axes, [&](const Quad& quad) {
    row.insert(row.end(), quad.begin(), quad.end());
    if (row.size() < 4096) return;
    write_faces(stream, form, row, 4, 4);
    row.clear();
  });
  write_faces(stream, form, row, 4, 4);
}

PolygonMesh mesh_of_grid(GridData<double> data) {
  require(data.axes.size() == 2 && data.is_canonical(), "mesh of a grid: need two axes");
  PolygonMesh mesh{std::move(data.values), data.dimension, {}, {0}};
  for_quads(data.axes, [&](const Quad& quad) {
    mesh.corners.insert(mesh.corners.end(), quad.begin(), quad.end());
    mesh.end_face();
  });
  return mesh;
}

}  // namespace subcert::data
