#pragma once
/// Meshes that are made for tests.

#include <subcert/schemes/data/mesh/polygon_mesh.hpp>

#include <string>
#include <vector>

namespace subcert::data::shapes {

PolygonMesh mesh_of(std::vector<double> values, const std::vector<std::vector<std::uint32_t>>& faces);
PolygonMesh tetrahedron();
PolygonMesh octahedron();
PolygonMesh icosahedron();
PolygonMesh cube();
/// A prism over a polygon, with two faces of so many sides.
PolygonMesh prism(std::size_t sides);
/// `columns` x `rows` vertices, closed in both directions, each cell in two triangles.
PolygonMesh torus_of_triangles(std::size_t columns, std::size_t rows);
/// A vertex with n triangles around it, and two more rings of triangles; open.
PolygonMesh disc(std::size_t n);
/// n triangles at a vertex and at another one, closed.
PolygonMesh bipyramid(std::size_t n);

/// `face 3`, for errors.
std::string place(std::size_t face);

/// Vertices - edges + faces.
long euler_characteristic(const PolygonMesh& mesh);

}  // namespace subcert::data::shapes
