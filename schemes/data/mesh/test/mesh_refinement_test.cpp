#include "shapes.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/data/formats/grid_mesh.hpp>
#include <subcert/schemes/data/mesh/mesh_refinement.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>
#include <random>
#include <span>

using namespace subcert;
using namespace subcert::data;
using namespace subcert::data::shapes;

namespace {

PolygonMesh refined(const PolygonMesh& mesh, const std::string& scheme, int levels, bool limit = false,
                    bool normals = false) {
  return refine_mesh(mesh, scheme, {levels, limit, normals}, place);
}

const std::vector<std::string> triangle_schemes{"loop",
                                                "butterfly:w=1/16",
                                                "modified-butterfly",
                                                "sqrt3",
                                                "triangular:L=17/10,d=1,power=1",
                                                "triangular:L=17/10,d=2,power=1"},
    polygon_schemes{"catmull-clark", "doo-sabin", "midedge"};

/// Whole numbers, so that sums with dyadic weights are exact.
GridData<double> whole_numbers(std::size_t columns, std::size_t rows) {
  std::mt19937 engine(3);
  GridData<double> data{{}, 3, {Axis::of(columns, true), Axis::of(rows, true)}};
  for (std::size_t i = 0; i < 3 * data.points(); ++i) data.values.push_back(static_cast<double>(engine() % 1024));
  return data;
}

std::vector<std::array<double, 3>> sorted_points(const std::vector<double>& values) {
  std::vector<std::array<double, 3>> points;
  for (std::size_t i = 0; i < values.size(); i += 3) points.push_back({values[i], values[i + 1], values[i + 2]});
  std::ranges::sort(points);
  return points;
}

double distance(const double* a, const double* b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// The largest distance of a point to the nearest of others.
double farthest(const std::vector<double>& points, const std::vector<double>& others) {
  double result = 0;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    double nearest = 1e300;
    for (std::size_t j = 0; j < others.size(); j += 3) nearest = std::min(nearest, distance(&points[i], &others[j]));
    result = std::max(result, nearest);
  }
  return result;
}

/// The first vertices of both, in all their numbers.
double difference(const PolygonMesh& a, const PolygonMesh& b, std::size_t vertices) {
  double result = 0;
  for (std::size_t i = 0; i < vertices * a.dimension; ++i)
    result = std::max(result, std::abs(a.values[i] - b.values[i]));
  return result;
}

PolygonMesh deformed(PolygonMesh mesh) {
  std::mt19937 engine(9);
  for (double& value : mesh.values) value += static_cast<double>(engine() % 1000) / 4000;
  return mesh;
}

}  // namespace

TEST_CASE("closed regular meshes are refined as grids are, exactly") {
  const GridData<double> data = whole_numbers(5, 4);
  PolygonMesh triangles = torus_of_triangles(5, 4);
  triangles.values = data.values;
  for (const char* scheme : {"loop", "butterfly:w=1/16", "modified-butterfly"}) {
    CAPTURE(scheme);
    const GridData<double> grid = refine(data, make_linear_scheme(scheme).mask, RefineOptions{2});
    CHECK(sorted_points(refined(triangles, scheme, 2).values) == sorted_points(grid.values));
  }
  for (const char* scheme : {"catmull-clark", "doo-sabin"}) {
    CAPTURE(scheme);
    const GridData<double> grid = refine(data, make_linear_scheme(scheme).mask, RefineOptions{2});
    CHECK(sorted_points(refined(mesh_of_grid(data), scheme, 2).values) == sorted_points(grid.values));
  }
  const GridData<double> mid = refine(data, vertex_rules("midedge", 4).mask, RefineOptions{1});
  CHECK(sorted_points(refined(mesh_of_grid(data), "midedge", 1).values) == sorted_points(mid.values));
  // Its mask has triangles along (1, -1): the columns are turned around.
  GridData<double> mirrored = data;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 5; ++i)
      std::copy_n(data.values.begin() + static_cast<std::ptrdiff_t>(3 * (5 * j + (5 - i) % 5)), 3,
                  mirrored.values.begin() + static_cast<std::ptrdiff_t>(3 * (5 * j + i)));
  for (const char* scheme : {"triangular:L=17/10,d=1,power=2", "triangular:L=8/5,d=2"}) {
    CAPTURE(scheme);
    const GridData<double> grid = refine(mirrored, vertex_rules(scheme, 6).mask, RefineOptions{2});
    const PolygonMesh mesh = refined(triangles, scheme, 2);
    CHECK(mesh.values.size() == grid.values.size());
    CHECK(farthest(mesh.values, grid.values) < 1e-11);
    CHECK(farthest(grid.values, mesh.values) < 1e-11);
  }
  const GridData<double> root = refine(mirrored, vertex_rules("sqrt3", 6).mask, RefineOptions{1});
  const PolygonMesh two_steps = refined(triangles, "sqrt3", 2);
  CHECK(two_steps.values.size() == root.values.size());
  CHECK(farthest(two_steps.values, root.values) < 1e-11);
  CHECK(farthest(root.values, two_steps.values) < 1e-11);
}

TEST_CASE("connections are those of the classical splits, and the Euler characteristic stays") {
  for (const auto& [mesh, characteristic] : {std::pair(tetrahedron(), 2L),
                                             {octahedron(), 2},
                                             {icosahedron(), 2},
                                             {torus_of_triangles(4, 3), 0},
                                             {disc(5), 1},
                                             {bipyramid(3), 2}}) {
    CHECK(euler_characteristic(mesh) == characteristic);
    for (const std::vector<std::string>& schemes : {triangle_schemes, polygon_schemes})
      for (const std::string& scheme : schemes) {
        CAPTURE(scheme, mesh.vertices());
        const PolygonMesh fine = refined(mesh, scheme, 2);
        CHECK(fine.is_canonical());
        CHECK(euler_characteristic(fine) == characteristic);
        const Topology topology(fine, place);  // throws where it is none
        CHECK(topology.has_boundary() == (characteristic == 1));
      }
  }
  CHECK(refined(tetrahedron(), "loop", 3).faces() == 4 * 64);
  CHECK(refined(tetrahedron(), "sqrt3", 3).faces() == 4 * 27);
  CHECK(refined(prism(7), "catmull-clark", 2).faces() == 4 * (7 + 7 + 7 * 4));
  CHECK(refined(cube(), "doo-sabin", 1).faces() == 6 + 12 + 8);
  CHECK(refined(disc(6), "sqrt3", 2).faces() == 9 * disc(6).faces());
  CHECK(refined(mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0}, {{0, 1, 2}}), "sqrt3", 2).faces() == 9);
}

TEST_CASE("first steps of tetrahedron and cube are the known ones") {
  // Loop at valence 3: 7/16 and 3/16 of each neighbour. Catmull-Clark: 1/3, 1/3 and 1/3. Butterfly where each opposite
  // vertex is two wings: 1/2 of the ends and 1/8 - 2/16 of the others.
  const PolygonMesh mesh = tetrahedron();
  const PolygonMesh loop = refined(mesh, "loop", 1);
  for (std::size_t c = 0; c < 3; ++c) CHECK(loop.values[c] == Approx(7.0 / 16 - 3.0 / 16));
  const PolygonMesh clark = refined(cube(), "catmull-clark", 1);
  for (std::size_t c = 0; c < 3; ++c) CHECK(clark.values[c] == Approx((0 + 1.0 / 3 + 1.0 / 3) / 3));
  const PolygonMesh root = refined(mesh, "sqrt3", 1);  // (4 - 2 cos(2 pi/3)) / 9 = 5/9 towards the mean
  for (std::size_t c = 0; c < 3; ++c) CHECK(root.values[c] == Approx(4.0 / 9 - 5.0 / 27));
  const PolygonMesh butterfly = refined(mesh, "butterfly:w=1/16", 1);
  for (std::size_t v = 4; v < 10; ++v) {
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c) square += std::pow(butterfly.values[3 * v + c], 2);
    CHECK(std::sqrt(square) == Approx(1));
  }
  // A square: cubic B-splines along the boundary.
  const PolygonMesh square = refined(mesh_of({0, 0, 0, 8, 0, 0, 8, 8, 0, 0, 8, 0}, {{0, 1, 2, 3}}), "catmull-clark", 1);
  CHECK(std::vector<double>(square.values.begin(), square.values.begin() + 3) == std::vector<double>{1, 1, 0});
  CHECK(std::vector<double>(square.values.begin() + 12, square.values.begin() + 15) == std::vector<double>{4, 0, 0});
}

TEST_CASE("affine maps go through") {
  const auto image = [](const PolygonMesh& mesh) {
    PolygonMesh result = mesh;
    for (std::size_t i = 0; i < mesh.values.size(); i += 3) {
      const double* p = &mesh.values[i];
      result.values[i] = 2 * p[0] - p[1] + 0.5 * p[2] + 3;
      result.values[i + 1] = p[0] + p[2] - 1;
      result.values[i + 2] = p[1] - 4 * p[2] + 0.25;
    }
    return result;
  };
  for (const PolygonMesh& mesh : {tetrahedron(), icosahedron(), disc(3), disc(7), disc(50)})
    for (const std::vector<std::string>& schemes : {triangle_schemes, polygon_schemes})
      for (const std::string& scheme : schemes)
        for (const bool limit : {false, true}) {
          if (limit && (scheme == "doo-sabin" || scheme == "midedge")) continue;
          if (limit && scheme.starts_with("triangular:") && Topology(mesh, place).has_boundary()) continue;
          CAPTURE(scheme, mesh.vertices(), limit);
          const PolygonMesh a = image(refined(mesh, scheme, 2, limit)), b = refined(image(mesh), scheme, 2, limit);
          CHECK(difference(a, b, a.vertices()) < 1e-11);
        }
}

TEST_CASE("limits and normals are the same from level to level, and those of many levels") {
  const auto check = [](const PolygonMesh& mesh, const std::string& scheme, int step, bool normals) {
    CAPTURE(scheme, mesh.vertices());
    const PolygonMesh at_first = refined(mesh, scheme, 0, true, normals);
    const PolygonMesh at_second = refined(mesh, scheme, step, true, normals);
    const PolygonMesh at_third = refined(mesh, scheme, 2 * step, true, normals);
    CHECK(difference(at_first, at_second, mesh.vertices()) < 1e-11);
    CHECK(difference(at_second, at_third, at_second.vertices()) < 1e-11);
    const PolygonMesh without = refined(mesh, scheme, 0, true), many = refined(mesh, scheme, 6);
    CHECK(difference(without, many, mesh.vertices()) < 0.02);
  };
  for (const PolygonMesh& mesh : {tetrahedron(), deformed(icosahedron()), deformed(torus_of_triangles(4, 3)),
                                  deformed(disc(3)), deformed(disc(4)), deformed(disc(9)), deformed(bipyramid(12)),
                                  mesh_of({1, 2, 3, 2, 2, 4, 1, 3, 5}, {{0, 1, 2}})})
    for (const std::string& scheme : triangle_schemes) {
      const bool open = Topology(mesh, place).has_boundary();
      if (open && scheme == "triangular:L=17/10,d=1,power=1") {
        CHECK_THROWS_AS(refined(mesh, scheme, 1, true), Error);
        continue;
      }
      check(mesh, scheme, scheme == "sqrt3" && open ? 2 : 1, scheme == "loop" || (scheme == "sqrt3" && !open));
    }
  const PolygonMesh open_quads = refined(deformed(disc(5)), "catmull-clark", 1);
  for (const PolygonMesh& mesh : {deformed(cube()), refined(deformed(prism(9)), "catmull-clark", 1), open_quads,
                                  refined(deformed(tetrahedron()), "catmull-clark", 1),
                                  mesh_of({1, 2, 3, 2, 2, 4, 2, 3, 3, 1, 3, 5}, {{0, 1, 2, 3}})})
    check(mesh, "catmull-clark", 1, true);
  for (const char* scheme : {"doo-sabin", "midedge"}) {
    const PolygonMesh mesh = deformed(cube());
    const PolygonMesh limits = refined(mesh, scheme, 1, true), many = refined(mesh, scheme, 6);
    CAPTURE(scheme);
    CHECK(farthest(limits.values, many.values) < 0.02);
    CHECK(farthest(refined(mesh, scheme, 2, true).values, many.values) < 0.02);
  }
}

TEST_CASE("local fits keep polynomials up to straight boundaries, and have no mirrored points") {
  // A part of the equilateral grid, in coordinates of its directions; its corners are no straight boundaries.
  const std::size_t size = 7;
  PolygonMesh mesh{{}, 3, {}, {0}};
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t i = 0; i < size; ++i) {
      const auto x = static_cast<double>(i) - 2, y = static_cast<double>(j) - 3;
      mesh.values.insert(mesh.values.end(), {x, y, 0});
      if (i + 1 == size || j + 1 == size) continue;
      const auto here = static_cast<std::uint32_t>(j * size + i), up = here + static_cast<std::uint32_t>(size);
      for (const std::uint32_t v : {here, here + 1, up, here + 1, up + 1, up}) mesh.corners.push_back(v);
      mesh.first.push_back(mesh.first.back() + 3);
      mesh.first.push_back(mesh.first.back() + 3);
    }
  const auto height = [](double x, double y, int degree) {
    return 3 + 2 * x - y + (degree < 2 ? 0 : 0.5 * x * x - 2 * x * y + 0.25 * y * y);
  };
  const auto is_near = [&](double value, double end) { return std::abs(value - end) < 1.2; };
  for (const int degree : {1, 2}) {
    for (std::size_t v = 0; v < mesh.vertices(); ++v)
      mesh.values[3 * v + 2] = height(mesh.values[3 * v], mesh.values[3 * v + 1], degree);
    const PolygonMesh fine = refined(mesh, "triangular:L=17/10,power=1,d=" + std::to_string(degree), 1);
    std::size_t on_boundary = 0;
    for (std::size_t v = 0; v < fine.vertices(); ++v) {
      const double x = fine.values[3 * v], y = fine.values[3 * v + 1];
      if ((is_near(x, -2) || is_near(x, 4)) && (is_near(y, -3) || is_near(y, 3))) continue;
      on_boundary += x < -1.99 || x > 3.99 || y < -2.99 || y > 2.99 ? 1 : 0;
      CAPTURE(degree, x, y);
      CHECK(std::abs(2 * x - std::round(2 * x)) < 1e-12);
      CHECK(std::abs(2 * y - std::round(2 * y)) < 1e-12);
      CHECK(std::abs(fine.values[3 * v + 2] - height(x, y, degree)) < 1e-12);
    }
    CHECK(on_boundary == 4 * 7);
  }
  // The corner of a single face stays, a vertex between two faces is the mean of itself and three neighbours, ...
  const PolygonMesh two = mesh_of({0, 0, 0, 8, 0, 0, 8, 8, 4, 0, 8, 0}, {{0, 1, 2}, {0, 2, 3}});
  const PolygonMesh fine = refined(two, "triangular:L=8/5,d=1", 1);
  CHECK(fine.values[3] == Approx(8));
  CHECK(std::abs(fine.values[4]) < 1e-14);
}

TEST_CASE("an edge between vertices of other valences has the mean of the fits at both ends") {
  // What counts at the vertex after the next on the equator, from a pole of valence 5 and from the equator, valence 4.
  const std::string scheme = "triangular:L=17/10,d=1,power=1";
  PolygonMesh mesh = bipyramid(5);
  mesh.dimension = 1;
  mesh.values.assign(7, 0);
  mesh.values[4] = 1;
  const auto weight = [&](long n, const LatticePoint& point, long turn) {
    const SectorRules rules = vertex_rules(scheme, n);
    for (const auto& [at, value] : weights_at(rules.rule_at({1, 0}), rules.lattice, n))
      if (at == SectorPoint{point, turn}) return value.lower->convert_to<double>();
    return 0.0;
  };
  const double from_pole = weight(5, {1, 0}, 2), from_equator = weight(4, {1, 1}, 0) + weight(4, {2, 0}, 0) / 2;
  CHECK(refined(mesh, scheme, 1).values[7] == Approx((from_pole + from_equator) / 2).epsilon(1e-13));
}

TEST_CASE("meshes are smoothed where faces are kept") {
  const PolygonMesh mesh = deformed(icosahedron());
  for (const char* scheme : {"loop", "triangular:L=17/10,d=1,power=2", "sqrt3", "catmull-clark"}) {
    CAPTURE(scheme);
    MeshOptions options{1};
    options.keep_faces = true;
    const PolygonMesh once = refine_mesh(mesh, scheme, options, place);
    CHECK(once.corners == mesh.corners);
    CHECK(difference(once, refined(mesh, scheme, 1), mesh.vertices()) == 0);
    options.levels = 2;
    CHECK(refine_mesh(mesh, scheme, options, place).values ==
          refine_mesh(once, scheme, {1, false, false, std::nullopt, true}, place).values);
    options.limit = true;
    CHECK_THROWS_AS(refine_mesh(mesh, scheme, options, place), Error);
  }
  for (const char* scheme : {"butterfly:w=1/16", "doo-sabin", "triangular:L=17/10,d=2"})
    CHECK_THROWS_AS(refine_mesh(mesh, scheme, {1, false, false, std::nullopt, true}, place), Error);
}

TEST_CASE("creases are boundaries of both sides") {
  const auto creased = [](const PolygonMesh& mesh, const std::string& scheme, double degrees, bool limit) {
    return refine_mesh(mesh, scheme, {2, limit, false, degrees}, place);
  };
  // A prism without its two ends, and the upper half of a bipyramid.
  const PolygonMesh whole = prism(7), both = bipyramid(12);
  PolygonMesh side{whole.values, 3, {}, {0}}, half{both.values, 3, {}, {0}};
  for (std::size_t f = 2; f < whole.faces(); ++f) {
    side.corners.insert(side.corners.end(), whole.face(f).begin(), whole.face(f).end());
    side.end_face();
  }
  for (std::size_t f = 0; f < both.faces(); f += 2) {
    for (const std::uint32_t v : both.face(f)) half.corners.push_back(v == 0 ? 0 : v - 1);
    half.end_face();
  }
  half.values.erase(half.values.begin() + 3, half.values.begin() + 6);
  for (const bool limit : {false, true}) {
    CHECK(farthest(refined(side, "catmull-clark", 2, limit).values, creased(whole, "catmull-clark", 80, limit).values) <
          1e-14);
    CHECK(farthest(refined(half, "loop", 2, limit).values, creased(both, "loop", 60, limit).values) < 1e-14);
  }
  CHECK(creased(whole, "catmull-clark", 180, true).values == refined(whole, "catmull-clark", 2, true).values);
  CHECK(creased(both, "loop", 180, true).values == refined(both, "loop", 2, true).values);
  // All edges of a cube: it stays one.
  const PolygonMesh block = creased(cube(), "catmull-clark", 45, true);
  for (std::size_t v = 0; v < block.vertices(); ++v) {
    double nearest = 1;
    for (std::size_t c = 0; c < 3; ++c)
      nearest = std::min({nearest, std::abs(block.values[3 * v + c]), std::abs(1 - block.values[3 * v + c])});
    CHECK(nearest < 1e-15);
  }
  CHECK(std::ranges::equal(std::span(block.values).first(24), cube().values));
  // An edge that alone is sharp: a crease that ends at both of its vertices.
  const PolygonMesh roof = mesh_of(
      {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, .5, .25, 1, .5, .75, 1, -2, -2, -3, 3, -2, -3, -2, 3, -3, 3, 3, -3},
      {{0, 1, 4}, {2, 5, 3}, {1, 3, 5, 4}, {0, 4, 5, 2}, {6, 7, 1, 0}, {7, 9, 3, 1}, {9, 8, 2, 3}, {8, 6, 0, 2}});
  CHECK_NOTHROW(refine_mesh(roof, "catmull-clark", {2, false, false, 85.0}, place));
  for (const MeshOptions& options :
       {MeshOptions{1, false, true, 30.0}, {1, false, false, -1.0}, {1, false, false, 181.0}})
    CHECK_THROWS_AS(refine_mesh(cube(), "catmull-clark", options, place), Error);
  CHECK_THROWS_AS(refine_mesh(cube(), "doo-sabin", {1, false, false, 30.0}, place), Error);
  CHECK_THROWS_AS(refine_mesh(tetrahedron(), "butterfly:w=1/16", {1, false, false, 30.0}, place), Error);
}

TEST_CASE("normals are unit vectors that point outwards") {
  for (const char* scheme : {"loop", "sqrt3", "catmull-clark", "doo-sabin", "midedge"}) {
    CAPTURE(scheme);
    const PolygonMesh sphere = refined(icosahedron(), scheme, 2, true, true);
    CHECK(sphere.dimension == 6);
    for (std::size_t v = 0; v < sphere.vertices(); ++v) {
      const double *point = &sphere.values[6 * v], *normal = point + 3;
      CHECK(std::hypot(normal[0], normal[1], normal[2]) == Approx(1));
      CHECK((point[0] * normal[0] + point[1] * normal[1] + point[2] * normal[2]) /
                std::hypot(point[0], point[1], point[2]) >
            0.97);
    }
  }
  // At the rim of a disc that lies in a plane.
  PolygonMesh flat = disc(7);
  for (std::size_t v = 0; v < flat.vertices(); ++v) flat.values[3 * v + 2] = 0;
  for (const char* scheme : {"loop", "catmull-clark"}) {
    const PolygonMesh plane = refined(flat, scheme, 2, true, true);
    for (std::size_t v = 0; v < plane.vertices(); ++v) CHECK(plane.values[6 * v + 5] == Approx(1));
  }
}

TEST_CASE("large valences, many components, faces with many sides") {
  const PolygonMesh star = refined(bipyramid(1000), "loop", 1);
  CHECK(star.faces() == 8000);
  CHECK(refined(bipyramid(1000), "modified-butterfly", 1).faces() == 8000);
  CHECK(refined(prism(1000), "catmull-clark", 1, true, true).faces() == 6000);
  CHECK(refined(prism(1000), "doo-sabin", 1, true).faces() == 1002 + 3000 + 2000);
  PolygonMesh two = tetrahedron();
  const PolygonMesh far = icosahedron();
  for (const double value : far.values) two.values.push_back(value + 10);
  for (std::size_t f = 0; f < far.faces(); ++f) {
    for (const std::uint32_t v : far.face(f)) two.corners.push_back(v + 4);
    two.end_face();
  }
  const PolygonMesh both = refined(two, "loop", 2);
  CHECK(euler_characteristic(both) == 4);
  CHECK(both.faces() == 16 * 24);
  // One number at a vertex, and five.
  PolygonMesh heights{{1, 2, 3}, 1, {0, 1, 2}, {0, 3}};
  CHECK(refined(heights, "loop", 1).values == std::vector<double>{1.375, 2, 2.625, 1.5, 2.5, 2});
}

namespace {

/// A scheme with one rule in the place of those at the same point.
VertexScheme tuned(const std::string& scheme, WrittenRule rule) {
  VertexScheme result = VertexScheme::named(scheme);
  result.specification = "tuned " + scheme;
  std::erase_if(result.written->rules, [&](const WrittenRule& other) { return other.point == rule.point; });
  result.written->rules.push_back(std::move(rule));
  return result;
}

WrittenWeights at(const LatticePoint& point, std::optional<long> turn, const std::string& weight) {
  return {point, turn, {weight}};
}

}  // namespace

TEST_CASE("rules that are written down refine as those with names") {
  const auto same = [](const PolygonMesh& mesh, const char* name, const VertexScheme& scheme) {
    CAPTURE(name);
    const bool is_closed = euler_characteristic(mesh) != 1, dual = std::string(name) == "doo-sabin";
    const MeshOptions options{2, is_closed || !dual, is_closed || !dual};
    CHECK(refine_mesh(mesh, scheme, options, place).values == refine_mesh(mesh, name, options, place).values);
  };
  const VertexScheme loop = tuned(
      "loop", {{0, 0}, {at({0, 0}, 0, "3/8 + (3/8 + c/4)^2"), at({1, 0}, std::nullopt, "(5/8 - (3/8 + c/4)^2)/n")}});
  const VertexScheme catmull_clark = tuned(
      "catmull-clark",
      {{0, 0},
       {at({0, 0}, 0, "1 - 7/(4*n)"), at({1, 0}, std::nullopt, "3/(2*n^2)"), at({1, 1}, std::nullopt, "1/(4*n^2)")}});
  const VertexScheme doo_sabin = tuned("doo-sabin",
                                       {{0, 0}, {at({0, 0}, 0, "1/4"), at({0, 0}, std::nullopt, "(3 + 2*C)/(4*n)")}});
  for (const PolygonMesh& mesh : {tetrahedron(), icosahedron(), disc(5), disc(9), bipyramid(30)}) {
    same(mesh, "loop", loop);
    same(mesh, "catmull-clark", catmull_clark);
    same(mesh, "doo-sabin", doo_sabin);
  }
  same(prism(7), "catmull-clark", catmull_clark);
  same(prism(7), "doo-sabin", doo_sabin);
}

TEST_CASE("tuned vertices move by their weights, and keep limits") {
  // Warren's weights, 3/8 over n.
  const VertexScheme warren = tuned("loop", {{0, 0}, {at({0, 0}, 0, "5/8"), at({1, 0}, std::nullopt, "3/(8*n)")}});
  for (const std::size_t n : {4, 5, 8, 12}) {
    PolygonMesh mesh = bipyramid(n);
    const PolygonMesh once = refine_mesh(mesh, warren, {1}, place);
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
      double sum[3] = {}, count = 0;
      for (std::size_t f = 0; f < mesh.faces(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
          if (mesh.face(f)[k] == v) {
            ++count;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += mesh.values[3 * mesh.face(f)[(k + 1) % 3] + c];
          }
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(once.values[3 * v + c] == Approx(0.625 * mesh.values[3 * v + c] + 0.375 / count * sum[c]).margin(1e-15));
    }
    // The limit is the same from any level.
    const PolygonMesh now = refine_mesh(mesh, warren, {0, true, true}, place),
                      later = refine_mesh(mesh, warren, {3, true, true}, place);
    for (std::size_t i = 0; i < now.values.size(); ++i) CHECK(later.values[i] == Approx(now.values[i]).margin(1e-11));
  }
  // Of edges, by their vertex and its neighbours.
  const std::vector<WrittenWeights> weights{at({0, 0}, 0, "3/8"), at({1, 0}, std::nullopt, "(1 + C)*5/(8*n)")};
  VertexScheme edges = tuned("loop", {{1, 0}, weights, 3, 5});
  edges.written->rules.push_back({{1, 0}, weights, 7});
  const PolygonMesh star = refine_mesh(bipyramid(9), edges, {1}, place);
  const PolygonMesh limit = refine_mesh(star, edges, {1, true}, place),
                    same = refine_mesh(star, edges, {3, true}, place);
  for (std::size_t i = 0; i < star.values.size(); ++i) CHECK(same.values[i] == Approx(limit.values[i]).margin(1e-11));
}

TEST_CASE("written rules that meshes do not take have one line") {
  const auto fails = [](const VertexScheme& scheme, const PolygonMesh& mesh, const MeshOptions& options,
                        const std::string& message) {
    CHECK_THROWS_WITH(refine_mesh(mesh, scheme, options, place), Catch::Matchers::Contains(message));
  };
  const auto whole = [](const char* own) { return at({0, 0}, 0, own); };
  const WrittenWeights neighbours = at({1, 0}, std::nullopt, "3/(8*n)");
  fails(tuned("loop", {{0, 0}, {whole("5/8"), neighbours}, 6}), icosahedron(), {1},
        "no rule of the point (0,0) is for valence 5");
  fails(tuned("loop", {{0, 0}, {whole("5/8"), at({2, 0}, std::nullopt, "3/(8*n)")}}), icosahedron(), {1},
        "on meshes the rule of the point 0,0 takes no data at 2,0");
  fails(tuned("loop", {{2, 0}, {whole("5/8"), neighbours}}), icosahedron(), {1},
        "on meshes the point 2,0 has no rule of its own");
  fails(tuned("loop", {{0, 0}, {whole("5/8"), at({1, 0}, 0, "3/8")}}), icosahedron(), {1},
        "need rules that turn with the sectors");
  fails(tuned("loop", {{1, 0}, {whole("3/8"), at({1, 0}, std::nullopt, "5/(8*n)")}}), icosahedron(), {1},
        "on meshes edges have the rule of the mask at valence 6");
  fails(tuned("butterfly:w=1/16", {{0, 0}, {whole("5/8"), neighbours}}), icosahedron(), {1},
        "an interpolatory mask takes rules of edges");
  const VertexScheme edges = tuned("loop", {{1, 0}, {whole("3/8"), at({1, 0}, std::nullopt, "5/(8*n)")}, 3, 5});
  fails(edges, icosahedron(), {0, true}, "limits by rules of edges need a level or more");
  fails(edges, icosahedron(), {1, false, true}, "tangents take more than the neighbours");
  VertexScheme other = tuned("loop", {{0, 0}, {whole("5/8"), neighbours}});
  other.written->mask = mask_in_sectors(make_linear_scheme("box:[1,0;1,0;0,1;0,1;1,1;1,1;1,1;1,1]").mask,
                                        SectorLattice::triangles);
  fails(other, icosahedron(), {1}, "on meshes a mask is one as those of");
}
