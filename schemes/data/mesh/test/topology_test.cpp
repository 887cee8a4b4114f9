#include "shapes.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/data/mesh/mesh_refinement.hpp>

#include <numeric>
#include <random>

using namespace subcert;
using namespace subcert::data;
using namespace subcert::data::shapes;

namespace {

std::string error_of(const PolygonMesh& mesh, const std::string& scheme = "catmull-clark",
                     const MeshOptions& options = {}) {
  try {
    refine_mesh(mesh, scheme, options, place);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

const std::vector<double> square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1, 0.5, 0.5, -1};

/// Random triangles on few vertices: what they make is a surface seldom.
PolygonMesh random_triangles(std::mt19937& engine) {
  const std::uint32_t vertices = 4 + engine() % 4;
  PolygonMesh mesh{{}, 3, {}, {0}};
  for (std::uint32_t i = 0; i < 3 * vertices; ++i) mesh.values.push_back(static_cast<double>(engine() % 1000));
  for (std::size_t f = 1 + engine() % 7; f-- > 0;) {
    std::vector<std::uint32_t> all(vertices);
    std::iota(all.begin(), all.end(), 0U);
    std::shuffle(all.begin(), all.end(), engine);
    mesh.corners.insert(mesh.corners.end(), all.begin(), all.begin() + 3);
    mesh.end_face();
  }
  return mesh;
}

/// By every pair of corners: an edge in each direction once, and one fan around a vertex.
bool is_oriented_manifold(const PolygonMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t h = 0; h < mesh.corners.size(); ++h)
    if (++edges[{mesh.corners[h], mesh.corners[h % 3 == 2 ? h - 2 : h + 1]}] > 1) return false;
  for (std::uint32_t v = 0; v < mesh.vertices(); ++v) {
    // The link of a vertex: edges that must make one path or one cycle.
    std::map<std::uint32_t, std::uint32_t> link;
    for (std::size_t h = 0; h < mesh.corners.size(); ++h)
      if (mesh.corners[h] == v) {
        const std::size_t f = h - h % 3;
        link[mesh.corners[f + (h + 1) % 3]] = mesh.corners[f + (h + 2) % 3];
      }
    if (link.empty()) continue;
    std::uint32_t start = link.begin()->first;
    for (const auto& [from, to] : link)
      if (std::ranges::none_of(link, [&, from = from](const auto& one) { return one.second == from; })) start = from;
    std::size_t steps = 0;
    for (std::uint32_t at = start; link.count(at) != 0 && steps <= link.size();) {
      at = link.at(at);
      ++steps;
      if (at == start) break;
    }
    if (steps != link.size()) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("corners know their neighbours") {
  for (const PolygonMesh& mesh : {tetrahedron(), icosahedron(), cube(), prism(5), torus_of_triangles(4, 5), disc(6)}) {
    const Topology topology(mesh, place);
    std::vector<std::uint32_t> valences(mesh.vertices(), 0);
    for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
      CHECK(topology.previous(topology.next(h)) == h);
      if (topology.is_boundary(h)) continue;
      CHECK(topology.opposite(topology.opposite(h)) == h);
      CHECK(mesh.corners[topology.opposite(h)] == mesh.corners[topology.next(h)]);
      CHECK(mesh.corners[topology.next(topology.opposite(h))] == mesh.corners[h]);
      if (topology.turned(h) != Topology::none) CHECK(mesh.corners[topology.turned(h)] == mesh.corners[h]);
    }
    for (const std::uint32_t v : mesh.corners) ++valences[v];
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
      CHECK(topology.faces_at(v) == valences[v]);
      CHECK(mesh.corners[topology.corner_at(v)] == v);
    }
    const std::vector<std::uint32_t> numbers = topology.edge_numbers();
    CHECK(*std::ranges::max_element(numbers) + 1 == topology.edges());
    CHECK(euler_characteristic(mesh) ==
          static_cast<long>(mesh.vertices() + mesh.faces()) - static_cast<long>(topology.edges()));
  }
  CHECK(Topology(disc(5), place).has_boundary());
  CHECK_FALSE(Topology(cube(), place).has_boundary());
}

TEST_CASE("what is no surface is refused with its places") {
  CHECK(error_of(mesh_of(square, {{0, 1, 2}, {1, 0, 4}, {0, 1, 5}})) ==
        "face 0: expected edges in one face or two; found one in three or more; face 2 has it, too");
  CHECK(error_of(mesh_of(square, {{0, 1, 2}, {0, 2, 3}, {2, 0, 4}})).find("three or more") != std::string::npos);
  CHECK(error_of(mesh_of(square, {{0, 1, 2}, {2, 0, 3}})) ==
        "face 0: expected faces that go around alike, so that two have their edge in opposite directions; found one in "
        "the same direction; face 1 has it, too");
  CHECK(error_of(mesh_of(square, {{0, 1, 4}, {2, 3, 4}})) ==
        "face 0: expected vertices at which one fan of faces meets; found one that joins two fans; face 1 has it, too");
  // A band of five quadrilaterals that is closed with half a turn has no orientation.
  std::vector<double> values;
  std::vector<std::vector<std::uint32_t>> band;
  for (std::uint32_t i = 0; i < 5; ++i) {
    values.insert(values.end(), {double(i), 0, double(i % 2), double(i), 1, 0});
    const std::uint32_t next = (i + 1) % 5;
    band.push_back(next > 0 ? std::vector<std::uint32_t>{2 * i, 2 * next, 2 * next + 1, 2 * i + 1}
                            : std::vector<std::uint32_t>{2 * i, 1, 0, 2 * i + 1});
  }
  CHECK(error_of(mesh_of(values, band)).find("go around alike") != std::string::npos);
  // Two squares whose common edge has four vertices.
  CHECK(
      error_of(mesh_of({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0},
                       {{0, 1, 2, 3}, {4, 5, 6, 7}})) ==
      "face 0: expected each vertex once; found an edge of the boundary whose ends are at the same places as those of "
      "another one (--join makes one vertex of equal ones); face 1 has it, too");
  CHECK(error_of(mesh_of(square, {{0, 1, 2, 3}}), "loop") ==
        "face 0: expected triangles for loop; found a face of 4 vertices");
  CHECK(error_of(mesh_of(square, {{0, 1, 2, 3}}), "sqrt3").find("expected triangles") != std::string::npos);
  CHECK(error_of(mesh_of(square, {{0, 1, 2}, {2, 1, 0}}), "loop") ==
        "face 0: expected three or more faces around each vertex inside; found one with 2");
  CHECK(error_of(cube(), "doo-sabin", {2, true, true}).empty());
  CHECK(error_of(mesh_of(square, {{0, 1, 2, 3}}), "doo-sabin", {1, true, false}).find("those of closed meshes") !=
        std::string::npos);
  CHECK(error_of(disc(5), "sqrt3", {1, true, false}).find("need an even number of levels, got 1") != std::string::npos);
  CHECK(error_of(cube(), "butterfly:w=1/16", {1, false, true}).find("tangents take more") != std::string::npos);
  CHECK(error_of(prism(5), "catmull-clark", {0, true, false}).find("expected quadrilaterals, or a level or more") !=
        std::string::npos);
  CHECK(error_of(tetrahedron(), "loop", {15}).find("15 levels would make about") == 0);
  CHECK(error_of(tetrahedron(), "dd:n=2").find("rules at a vertex: need one of") == 0);
}

TEST_CASE("of random triangles those that make a surface are taken, and no others") {
  std::mt19937 engine(5);
  int surfaces = 0;
  for (int i = 0; i < 4000; ++i) {
    const PolygonMesh mesh = random_triangles(engine);
    CAPTURE(mesh.corners);
    bool taken = true;
    try {
      const Topology topology(mesh, place);
    } catch (const Error& error) {
      taken = false;
      CHECK(error.kind() == ErrorKind::data);
    }
    CHECK(taken == is_oriented_manifold(mesh));
    surfaces += taken ? 1 : 0;
  }
  CHECK(surfaces > 300);
}
