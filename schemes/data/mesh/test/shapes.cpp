#include "shapes.hpp"

#include <cmath>
#include <numbers>
#include <set>

namespace subcert::data::shapes {
namespace {

std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

double turn(std::size_t i, std::size_t n) {
  return 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
}

}  // namespace

PolygonMesh mesh_of(std::vector<double> values, const std::vector<std::vector<std::uint32_t>>& faces) {
  PolygonMesh mesh{std::move(values), 3, {}, {0}};
  for (const auto& face : faces) {
    mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    mesh.end_face();
  }
  return mesh;
}

PolygonMesh tetrahedron() {
  return mesh_of({1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
}

PolygonMesh octahedron() { return bipyramid(4); }

PolygonMesh icosahedron() {
  const double g = std::numbers::phi;
  std::vector<double> values;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-g, g}) values.insert(values.end(), {0, a, b, a, b, 0, b, 0, a});
  PolygonMesh mesh{values, 3, {}, {0}};
  const auto near = [&](std::size_t i, std::size_t j) {
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c) square += std::pow(values[3 * i + c] - values[3 * j + c], 2);
    return std::abs(square - 4) < 1e-9;
  };
  const auto volume = [&](std::size_t i, std::size_t j, std::size_t k) {
    const double *a = &values[3 * i], *b = &values[3 * j], *c = &values[3 * k];
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k) {
        if (!near(i, j) || !near(j, k) || !near(i, k)) continue;
        const bool outwards = volume(i, j, k) > 0;
        mesh.corners.insert(mesh.corners.end(), {index(i), index(outwards ? j : k), index(outwards ? k : j)});
        mesh.end_face();
      }
  return mesh;
}

PolygonMesh cube() {
  return mesh_of({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1},
                 {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

PolygonMesh prism(std::size_t sides) {
  std::vector<double> values;
  std::vector<std::vector<std::uint32_t>> faces(2);
  for (std::size_t i = 0; i < sides; ++i) {
    const double x = std::cos(turn(i, sides)), y = std::sin(turn(i, sides));
    values.insert(values.end(), {x, y, 0, x, y, 1});
    const std::uint32_t here = index(2 * i), next = index(2 * ((i + 1) % sides));
    faces.push_back({here, next, next + 1, here + 1});
    faces[0].push_back(index(2 * (sides - 1 - i)));
    faces[1].push_back(here + 1);
  }
  return mesh_of(values, faces);
}

PolygonMesh torus_of_triangles(std::size_t columns, std::size_t rows) {
  std::vector<double> values;
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const double u = turn(i, columns), v = turn(j, rows), radius = 3 + std::cos(v);
      values.insert(values.end(), {radius * std::cos(u), radius * std::sin(u), std::sin(v)});
      const std::size_t right = (i + 1) % columns, up = (j + 1) % rows;
      faces.push_back({index(j * columns + i), index(j * columns + right), index(up * columns + right)});
      faces.push_back({index(j * columns + i), index(up * columns + right), index(up * columns + i)});
    }
  return mesh_of(values, faces);
}

PolygonMesh disc(std::size_t n) {
  std::vector<double> values{0, 0, 1};
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t ring = 1; ring <= 3; ++ring)
    for (std::size_t i = 0; i < n; ++i) {
      const double radius = static_cast<double>(ring);
      values.insert(values.end(), {radius * std::cos(turn(i, n)), radius * std::sin(turn(i, n)), 1 / radius});
      const std::uint32_t outer = index(1 + (ring - 1) * n + i), next = index(1 + (ring - 1) * n + (i + 1) % n);
      if (ring == 1) {
        faces.push_back({0, outer, next});
      } else {
        const auto less = index(n);
        faces.push_back({outer - less, outer, next});
        faces.push_back({outer - less, next, next - less});
      }
    }
  return mesh_of(values, faces);
}

PolygonMesh bipyramid(std::size_t n) {
  std::vector<double> values{0, 0, 1, 0, 0, -1};
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t i = 0; i < n; ++i) {
    values.insert(values.end(), {std::cos(turn(i, n)), std::sin(turn(i, n)), 0});
    const std::uint32_t here = index(2 + i), next = index(2 + (i + 1) % n);
    faces.push_back({0, here, next});
    faces.push_back({1, next, here});
  }
  return mesh_of(values, faces);
}

std::string place(std::size_t face) { return "face " + std::to_string(face); }

long euler_characteristic(const PolygonMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) edges.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
  }
  return static_cast<long>(mesh.vertices()) - static_cast<long>(edges.size()) + static_cast<long>(mesh.faces());
}

}  // namespace subcert::data::shapes
