#include "vertex_parts.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/vertex/vertex_surface.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::vertex_surface_test {

using subcert::testing::part_of;

namespace {

struct Found {
  VertexSmoothness smoothness;
  std::optional<VertexSurface> surface;
};

Found found(const std::string& scheme, long valence, int size = 24) {
  const SectorRules rules = vertex_rules(scheme, valence);
  const VertexSmoothness smoothness = vertex_smoothness(rules, part_of(scheme));
  return {smoothness, vertex_surface(rules, part_of(scheme), smoothness, size)};
}

double middle(const Enclosure& enclosure) { return enclosure.lower->convert_to<double>(); }

}  // namespace

TEST_CASE("from one ring to the next curvature grows as what is proved of it") {
  for (const auto& [scheme, n] : std::vector<std::pair<std::string, long>>{
           {"loop", 3}, {"loop", 4}, {"loop", 7}, {"catmull-clark", 3}, {"catmull-clark", 5}, {"sqrt3", 3}}) {
    CAPTURE(scheme, n);
    const auto vertex = found(scheme, n, 48);
    const auto& smoothness = vertex.smoothness;
    const auto& surface = vertex.surface;
    REQUIRE(surface);
    const long m = vertex_rules(scheme, n).mask.arity();
    const double lambda = middle(smoothness.subdominant), ratio = middle(smoothness.next) / (lambda * lambda);
    // On the bisector of a sector, in its plane of points (x, y).
    const auto at = [&](long k) {
      return static_cast<std::size_t>(k) * surface->columns + static_cast<std::size_t>(k);
    };
    const long k = 12 / m;  // where slopes are small
    CHECK(surface->curvature[at(k)] / surface->curvature[at(k * m)] == Approx(ratio).epsilon(0.12));
    // The map scales by lambda, the heights by mu, but for what data differ from the surface.
    const auto &inner = surface->points[at(k)], &outer = surface->points[at(k * m)];
    CHECK(inner[0] / outer[0] == Approx(lambda).epsilon(0.03));
    CHECK(std::abs(inner[2] / outer[2]) == Approx(middle(smoothness.next)).epsilon(0.06));
  }
}

TEST_CASE("sectors follow one another around the vertex") {
  for (const char* scheme : {"loop", "catmull-clark", "doo-sabin"})
    for (const long n : {3, 5, 12}) {
      CAPTURE(scheme, n);
      const auto surface = found(scheme, n, 4).surface;
      REQUIRE(surface);
      CHECK(surface->valence == n);
      CHECK(surface->points.size() == surface->columns * surface->rows);
      CHECK(surface->curvature.size() == surface->points.size());
      CHECK(surface->columns % static_cast<std::size_t>(n) == 0);
      CHECK(surface->scale > 0);
      double radius = 0, height = 0;
      for (const auto& p : surface->points)
        if (std::isfinite(p[0])) radius = std::max(radius, std::hypot(p[0], p[1])), height = std::max(height, p[2]);
      CHECK(radius == Approx(1));
      CHECK(height <= 0.36);
      const std::size_t side = surface->columns / static_cast<std::size_t>(n);
      for (std::size_t row = 0; row < surface->rows; ++row)  // a hole between sectors
        CHECK(std::isnan(surface->points[row * surface->columns + side - 1][0]));
    }
}

TEST_CASE("no heights where what follows the leader is not one number") {
  const auto surface = found("midedge", 5).surface;
  REQUIRE(surface);
  CHECK(!surface->frequency);
  CHECK(std::ranges::all_of(surface->points, [](const auto& p) { return p[2] == 0 || std::isnan(p[2]); }));
  CHECK(std::ranges::all_of(surface->curvature, [](double value) { return value == 0 || std::isnan(value); }));
}

TEST_CASE("a Jordan block in front has a map, and no heights") {
  const auto surface = found("midedge", 3, 8).surface;
  REQUIRE(surface);
  CHECK_FALSE(surface->frequency);
}

TEST_CASE("no surface where its leader has another frequency, and what it asks for") {
  CHECK(!found("butterfly:w=1/16", 8).surface);
  const SectorRules rules = vertex_rules("loop", 5);
  const VertexSmoothness smoothness = vertex_smoothness(rules, part_of("loop"));
  CHECK_THROWS_AS(vertex_surface(rules, part_of("loop"), smoothness, 3), Error);
  CHECK_THROWS_AS(vertex_surface(vertex_rules("loop", 4), part_of("loop"), smoothness), Error);
}

}  // namespace subcert::vertex_surface_test
