// Schemes as their papers write them, on meshes that know nothing but their faces: what shrinks at a vertex, and how
// fast, against the eigenvalues that are proved.

#include <subcert/analysis/vertex/vertex_stencils.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace subcert;
using subcert::testing::Random;

namespace {

using Number = boost::multiprecision::cpp_bin_float_100;
const Number pi = boost::math::constants::pi<Number>();

using Face = std::vector<std::size_t>;
using Edge = std::pair<std::size_t, std::size_t>;

Edge edge(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

/// A number at each vertex, the one that matters first.
struct Mesh {
  std::vector<Number> values;
  std::vector<Face> faces;

  std::vector<std::set<std::size_t>> neighbours() const {
    std::vector<std::set<std::size_t>> result(values.size());
    for (const Face& face : faces)
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::size_t next = face[(i + 1) % face.size()];
        result[face[i]].insert(next);
        result[next].insert(face[i]);
      }
    return result;
  }
  /// The faces on both sides, or on one.
  std::map<Edge, std::vector<std::size_t>> sides() const {
    std::map<Edge, std::vector<std::size_t>> result;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t i = 0; i < faces[f].size(); ++i)
        result[edge(faces[f][i], faces[f][(i + 1) % faces[f].size()])].push_back(f);
    return result;
  }
  /// What is so many edges or fewer away from the first vertex.
  Mesh cropped(int distance) const {
    const auto next_to = neighbours();
    std::vector<int> away(values.size(), distance + 1);
    std::vector<std::size_t> front{0};
    away[0] = 0;
    for (int d = 1; d <= distance; ++d) {
      std::vector<std::size_t> next;
      for (const std::size_t at : front)
        for (const std::size_t other : next_to[at])
          if (away[other] > d) {
            away[other] = d;
            next.push_back(other);
          }
      front = next;
    }
    Mesh result;
    std::map<std::size_t, std::size_t> number;
    const auto kept = [&](std::size_t at) {
      const auto [entry, is_new] = number.try_emplace(at, result.values.size());
      if (is_new) result.values.push_back(values[at]);
      return entry->second;
    };
    kept(0);
    for (const Face& face : faces) {
      if (std::any_of(face.begin(), face.end(), [&](std::size_t at) { return away[at] > distance; })) continue;
      result.faces.emplace_back();
      for (const std::size_t at : face) result.faces.back().push_back(kept(at));
    }
    return result;
  }
};

Number share(Random& random) { return Number(random.integer(-1000, 1000)) / 1000; }

/// n sectors of triangles or quads with random data of this frequency.
Mesh fan(long n, bool triangles, long frequency, Random& random) {
  constexpr long size = 6;
  Mesh mesh;
  std::map<SectorPoint, std::size_t> number;
  std::map<LatticePoint, std::pair<Number, Number>> waves;
  const SectorLattice lattice = triangles ? SectorLattice::triangles : SectorLattice::quads;
  const auto vertex = [&](long x, long y, long turn) {
    SectorPoint at = *in_sector({x, y}, lattice, n);
    at = turned(at, turn, lattice, n);
    const auto [entry, is_new] = number.try_emplace(at, mesh.values.size());
    if (is_new) {
      const auto [wave, unknown] = waves.try_emplace(at.point, share(random), share(random));
      const Number angle = 2 * pi * Number(frequency * at.turn) / n;
      const bool constant = at.point == LatticePoint{0, 0} && frequency != 0;
      const Number value = wave->second.first * cos(angle) + wave->second.second * sin(angle);
      mesh.values.push_back(constant ? Number(0) : value);
    }
    return entry->second;
  };
  vertex(0, 0, 0);
  for (long t = 0; t < n; ++t)
    for (long x = 0; x < size; ++x)
      for (long y = 0; y < size; ++y) {
        const std::size_t a = vertex(x, y, t), b = vertex(x + 1, y, t), c = vertex(x + 1, y + 1, t),
                          d = vertex(x, y + 1, t);
        if (!triangles) {
          mesh.faces.push_back({a, b, c, d});
          continue;
        }
        mesh.faces.push_back({a, b, d});
        mesh.faces.push_back({b, c, d});
      }
  return mesh.cropped(5);
}

Mesh loop_step(const Mesh& mesh) {
  Mesh result;
  const auto next_to = mesh.neighbours();
  for (std::size_t v = 0; v < mesh.values.size(); ++v) {
    const Number n = next_to[v].size();
    const Number inner = 3.0 / 8 + cos(2 * pi / n) / 4, part = 5.0 / 8 - inner * inner;
    Number sum = 0;
    for (const std::size_t other : next_to[v]) sum += mesh.values[other];
    result.values.push_back((1 - part) * mesh.values[v] + part * sum / n);
  }
  std::map<Edge, std::size_t> middle;
  for (const auto& [ends, faces] : mesh.sides()) {
    middle[ends] = result.values.size();
    Number value = 3.0 / 8 * (mesh.values[ends.first] + mesh.values[ends.second]);
    for (const std::size_t f : faces)
      for (const std::size_t at : mesh.faces[f])
        if (at != ends.first && at != ends.second) value += mesh.values[at] / 8;
    result.values.push_back(value);
  }
  for (const Face& face : mesh.faces) {
    const std::size_t ab = middle[edge(face[0], face[1])], bc = middle[edge(face[1], face[2])],
                      ca = middle[edge(face[2], face[0])];
    for (const Face& part : {Face{face[0], ab, ca}, Face{face[1], bc, ab}, Face{face[2], ca, bc}, Face{ab, bc, ca}})
      result.faces.push_back(part);
  }
  return result;
}

Mesh sqrt3_step(const Mesh& mesh) {
  Mesh result;
  const auto next_to = mesh.neighbours();
  for (std::size_t v = 0; v < mesh.values.size(); ++v) {
    const Number n = next_to[v].size();
    const Number part = (4 - 2 * cos(2 * pi / n)) / 9;
    Number sum = 0;
    for (const std::size_t other : next_to[v]) sum += mesh.values[other];
    result.values.push_back((1 - part) * mesh.values[v] + part * sum / n);
  }
  const std::size_t first = result.values.size();
  for (const Face& face : mesh.faces)
    result.values.push_back((mesh.values[face[0]] + mesh.values[face[1]] + mesh.values[face[2]]) / 3);
  for (const auto& [ends, faces] : mesh.sides())
    if (faces.size() == 2)
      for (const std::size_t at : {ends.first, ends.second})
        result.faces.push_back({at, first + faces[0], first + faces[1]});
  return result;
}

Mesh catmull_clark_step(const Mesh& mesh) {
  Mesh result;
  const auto next_to = mesh.neighbours();
  const auto sides = mesh.sides();
  std::vector<Number> centre;
  std::vector<std::vector<std::size_t>> around(mesh.values.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    Number sum = 0;
    for (const std::size_t at : mesh.faces[f]) {
      sum += mesh.values[at];
      around[at].push_back(f);
    }
    centre.push_back(sum / mesh.faces[f].size());
  }
  for (std::size_t v = 0; v < mesh.values.size(); ++v) {
    const Number n = next_to[v].size();
    Number faces = 0, middles = 0;
    for (const std::size_t f : around[v]) faces += centre[f];
    for (const std::size_t other : next_to[v]) middles += (mesh.values[v] + mesh.values[other]) / 2;
    result.values.push_back((faces / n + 2 * middles / n + (n - 3) * mesh.values[v]) / n);
  }
  const std::size_t first = result.values.size();
  result.values.insert(result.values.end(), centre.begin(), centre.end());
  std::map<Edge, std::size_t> middle;
  for (const auto& [ends, faces] : sides) {
    middle[ends] = result.values.size();
    Number value = mesh.values[ends.first] + mesh.values[ends.second];
    for (const std::size_t f : faces) value += centre[f];
    result.values.push_back(value / (2 + faces.size()));
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::size_t last = face[(i + face.size() - 1) % face.size()], next = face[(i + 1) % face.size()];
      result.faces.push_back({face[i], middle[edge(face[i], next)], first + f, middle[edge(last, face[i])]});
    }
  }
  return result;
}

/// By how much differences to the vertex shrink in the end, the mean of the last levels. The data are scaled up again
/// after each. Rounding errors of frequency 1 grow beside data of another one, as the digits allow for.
double rate(Mesh mesh, Mesh (*step)(const Mesh&), int steps_in_one) {
  Number product = 1;
  constexpr int levels = 60, averaged = 4;
  for (int level = 0; level < levels; ++level) {
    for (int i = 0; i < steps_in_one; ++i) mesh = step(mesh);
    mesh = mesh.cropped(4);
    Number largest = 0;
    const Number at_vertex = mesh.values[0];
    for (const Number& value : mesh.values) largest = std::max(largest, Number(abs(value - at_vertex)));
    for (Number& value : mesh.values) value = (value - at_vertex) / largest;
    if (level >= levels - averaged) product *= largest;
  }
  return std::pow(product.convert_to<double>(), 1.0 / averaged);
}

void check_rates(const std::string& scheme, Mesh (*step)(const Mesh&), int steps_in_one) {
  Random random;
  const RegularPart part = regular_part(vertex_rules(scheme, 3), {Deadline::in(20)});
  for (const long n : {3L, 4L, 5L, 7L, 8L}) {
    const SectorRules rules = vertex_rules(scheme, n);
    const VertexSmoothness at = vertex_smoothness(rules, part);
    REQUIRE(at.c1.is_yes());
    const double lambda = at.subdominant.lower->convert_to<double>(), mu = at.next.lower->convert_to<double>();
    double largest = 0;
    for (long k = 0; 2 * k <= n; ++k) {
      CAPTURE(scheme, n, k, lambda, mu);
      const double found = rate(fan(n, rules.lattice == SectorLattice::triangles, k, random), step, steps_in_one);
      if (k == 1) {
        CHECK(std::abs(found - lambda) < 1e-6);
        continue;
      }
      CHECK(found < mu + 1e-3);
      largest = std::max(largest, found);
    }
    // Nothing but the second of frequency 1 can be larger than those found.
    CAPTURE(scheme, n, mu, largest);
    if (!(scheme == "loop" && n == 3) && !(scheme == "catmull-clark" && n == 3)) CHECK(std::abs(largest - mu) < 1e-3);
  }
}

/// The neighbours of the first vertex in their order, one way or the other, and the vertices across the faces between.
struct Ring {
  std::vector<std::size_t> neighbours, across;

  explicit Ring(const Mesh& mesh) {
    std::map<std::size_t, std::map<std::size_t, std::size_t>> beside;  // of two neighbours: what is across their face
    for (const Face& face : mesh.faces) {
      const std::size_t at = static_cast<std::size_t>(std::find(face.begin(), face.end(), 0U) - face.begin());
      const std::size_t sides = face.size();
      if (at == sides) continue;
      const std::size_t next = face[(at + 1) % sides], last = face[(at + sides - 1) % sides];
      beside[next][last] = beside[last][next] = face[(at + 2) % sides];
    }
    for (std::size_t at = beside.begin()->first, last = beside[at].begin()->first; neighbours.size() < beside.size();) {
      const auto& [next, opposite] = beside[at].begin()->first == last ? *beside[at].rbegin() : *beside[at].begin();
      neighbours.push_back(at);
      across.push_back(opposite);
      last = std::exchange(at, next);
    }
  }
};

Number value_of(const VertexStencils::Stencil& stencil, const Mesh& mesh) {
  const Ring ring(mesh);
  Number sum = 0;
  for (const StencilWeight& weight : stencil) {
    const auto t = static_cast<std::size_t>(weight.at.turn);
    const LatticePoint& point = weight.at.point;
    REQUIRE((point == LatticePoint{0, 0} || point == LatticePoint{1, 0} || point == LatticePoint{1, 1}));
    const std::size_t at = point[0] == 0 ? 0 : point[1] == 0 ? ring.neighbours[t] : ring.across[t];
    sum += Number(weight.value.lower->convert_to<double>()) * mesh.values[at];
  }
  return sum;
}

void check_stencils(const std::string& scheme, Mesh (*step)(const Mesh&), int steps_in_one) {
  Random random;
  const RegularPart part = regular_part(vertex_rules(scheme, 3), {Deadline::in(20)});
  for (const long n : {3L, 5L, 6L, 9L}) {
    CAPTURE(scheme, n);
    const SectorRules rules = vertex_rules(scheme, n);
    const VertexSmoothness at = vertex_smoothness(rules, part);
    const VertexStencils stencils = vertex_stencils(rules, at);
    // Of any data: waves of three frequencies.
    Mesh mesh = fan(n, rules.lattice == SectorLattice::triangles, 0, random);
    for (const long k : {1L, n / 2}) {
      const Mesh more = fan(n, rules.lattice == SectorLattice::triangles, k, random);
      for (std::size_t i = 0; i < mesh.values.size(); ++i) mesh.values[i] += more.values[i];
    }
    const auto size = [&] {
      const Number x = value_of(stencils.tangents[0], mesh), y = value_of(stencils.tangents[1], mesh);
      return Number(sqrt(x * x + y * y));
    };
    const Number limit = value_of(stencils.limit, mesh), before = size();
    REQUIRE(before > 1e-4);
    for (int level = 0; level < 40; ++level) {
      for (int i = 0; i < steps_in_one; ++i) mesh = step(mesh);
      mesh = mesh.cropped(4);
      if (level < 3) CHECK(abs(value_of(stencils.limit, mesh) - limit) < 1e-12);
      if (level == 0) CHECK(abs(size() / before - Number(at.subdominant.lower->convert_to<double>())) < 1e-10);
    }
    CHECK(abs(mesh.values[0] - limit) < 1e-6);
  }
}

}  // namespace

TEST_CASE("stencils keep limits and scale tangents of meshes that know their faces alone") {
  check_stencils("loop", loop_step, 1);
  check_stencils("catmull-clark", catmull_clark_step, 1);
  check_stencils("sqrt3", sqrt3_step, 2);
}

TEST_CASE("meshes that know their faces alone shrink at vertices by the proved eigenvalues") {
  check_rates("loop", loop_step, 1);
  check_rates("catmull-clark", catmull_clark_step, 1);
  check_rates("sqrt3", sqrt3_step, 2);
}
