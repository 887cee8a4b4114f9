#include "vertex_parts.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/vertex/vertex_smoothness.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <cmath>
#include <numbers>

using namespace subcert;
using subcert::testing::part_of;

namespace {

VertexSmoothness smoothness(const std::string& scheme, long valence) {
  return vertex_smoothness(vertex_rules(scheme, valence), part_of(scheme));
}

bool is_about(const Enclosure& enclosure, double value, double distance = 1e-12) {
  return enclosure.is_bounded() && *enclosure.upper - *enclosure.lower < Rational(1) / 1'000'000'000 &&
         std::abs(enclosure.lower->convert_to<double>() - value) < distance;
}

double cosine(long k, long n) {
  return std::cos(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n));
}

std::string word(const VertexSmoothness& at) { return at.curvature ? to_text(*at.curvature) : "unknown"; }

}  // namespace

TEST_CASE("classical schemes are C1 at vertices of every valence that was looked at") {
  for (const std::string scheme : {"loop", "catmull-clark", "doo-sabin", "midedge", "modified-butterfly", "sqrt3"})
    for (const long n : {3L, 4L, 5L, 6L, 7L, 8L, 9L, 11L, 16L, 31L, 50L}) {
      CAPTURE(scheme, n);
      const VertexSmoothness at = smoothness(scheme, n);
      CAPTURE(at.c1.reason);
      CHECK(at.c1.is_yes());
      CHECK(at.frequency == 1);
      const double c = cosine(1, n);
      const double trace = 10 + 2 * c;
      const double expected = scheme == "loop"            ? (3 + 2 * c) / 8
                              : scheme == "catmull-clark" ? (trace + std::sqrt(trace * trace - 64)) / 32
                              : scheme == "midedge"       ? (1 + c) / 2
                              : scheme == "sqrt3"         ? 2 * (1 + c) / 9
                                                          : 0.5;
      CHECK(is_about(at.subdominant, expected));
      if (scheme == "midedge" && n == 3) continue;  // a Jordan block
      REQUIRE(at.exponent.is_bounded());
      CHECK(at.exponent.is_canonical());
      CHECK(*at.exponent.lower > 1);
    }
}

TEST_CASE("Kobbelt's scheme and four-eight are C1 at vertices") {
  // Of meshes that were refined by the faces and edges that meet, without a chart.
  const std::map<std::string, std::map<long, double>> values{
      {"kobbelt", {{3, 0.4263309}, {4, 0.5}, {5, 0.53794385970}, {7, 0.57319703809}}},
      {"four-eight", {{3, 0.4083114}, {4, 0.5}, {5, 0.55132307670}, {7, 0.60125019010}}}};
  for (const auto& [scheme, by_valence] : values)
    for (const auto& [n, lambda] : by_valence) {
      CAPTURE(scheme, n);
      const VertexSmoothness at = smoothness(scheme, n);
      CHECK(at.c1.is_yes());
      CHECK(is_about(at.subdominant, lambda, n == 3 ? 1e-7 : 1e-10));
    }
  CHECK(smoothness("four-eight", 4).exponent.contains(5));
  CHECK(smoothness("kobbelt:w=1/12", 12).c1.is_yes());
  CHECK_THROWS_AS(vertex_rules("kobbelt:w=-1/2", 5), Error);
}

TEST_CASE("curvature and exponents at vertices") {
  const VertexSmoothness loop = smoothness("loop", 3);
  CHECK(is_about(loop.exponent, 1.5));  // mu = 1/8, lambda = 1/4
  CHECK(word(loop) == "unbounded");
  for (const long n : {4L, 5L, 6L}) CHECK(word(smoothness("loop", n)) == "bounded");
  for (const long n : {7L, 12L, 30L}) CHECK(word(smoothness("loop", n)) == "unbounded");
  CHECK(smoothness("loop", 6).exponent.contains(3));
  CHECK(smoothness("catmull-clark", 4).exponent.contains(3));

  const VertexSmoothness quads = smoothness("catmull-clark", 3);
  CHECK(is_about(quads.next, 1.0 / 6));
  CHECK(word(quads) == "zero");
  CHECK(word(smoothness("catmull-clark", 4)) == "bounded");
  CHECK(word(smoothness("catmull-clark", 5)) == "unbounded");

  // That second derivatives of the butterfly scheme are bounded is not proved.
  for (const long n : {3L, 5L, 8L, 20L})
    for (const auto& [scheme, curvature] :
         {std::pair<std::string, std::string>{"doo-sabin", "bounded"}, {"modified-butterfly", "unknown"}}) {
      CAPTURE(scheme, n);
      CHECK(word(smoothness(scheme, n)) == curvature);
      CHECK(is_about(smoothness(scheme, n).next, 0.25));
    }
  CHECK(word(smoothness("midedge", 4)) == "bounded");
  CHECK(word(smoothness("midedge", 7)) == "zero");
  CHECK(word(smoothness("butterfly:w=1/16", 4)) == "unbounded");
  CHECK(word(smoothness("butterfly:w=1/16", 5)) == "unknown");
}

TEST_CASE("the butterfly scheme is C1 at vertices of valence 4 to 7 alone") {
  const std::string scheme = "butterfly:w=1/16";
  const std::map<long, double> values{{4, 0.469042}, {5, 0.506676}, {6, 0.5}, {7, 0.481911}};
  for (const auto& [n, lambda] : values) {
    CAPTURE(n);
    const VertexSmoothness at = smoothness(scheme, n);
    CHECK(at.c1.is_yes());
    CHECK(is_about(at.subdominant, lambda, 1e-6));
  }
  for (const long n : {8L, 9L, 10L, 11L, 12L, 20L}) {
    CAPTURE(n);
    const VertexSmoothness at = smoothness(scheme, n);
    CHECK(at.c1.is_no());
    CHECK(at.frequency >= 2);
    CHECK_FALSE(at.exponent.lower.has_value());
  }
  CHECK(is_about(smoothness(scheme, 8).subdominant, 0.469042, 1e-6));
}

TEST_CASE("Doo and Sabin's scheme with a free eigenvalue is C1 up to the bound of Peters and Reif") {
  WrittenRules written = *VertexScheme::named("doo-sabin").written;
  written.rules = {{{0, 0}, {{{0, 0}, 0, {"1/4"}}, {{0, 0}, std::nullopt, {"(3/4 + 2*(b - 1/4)*C)/n"}}}}};
  const auto c1_at = [&](const Rational& eigenvalue, long valence) {
    written.letters = {{'b', eigenvalue}};
    return vertex_smoothness(rules_at(written, valence), part_of("doo-sabin")).c1;
  };
  // The zero of 128 x^2 (1 - x) - 7x - 2 + 9x cos(2 pi/n) below 1.
  for (const auto& [valence, bound] :
       {std::pair{3L, 0.87729}, {4, 0.92234}, {5, 0.94783}, {6, 0.96286}, {8, 0.97861}, {12, 0.99033}}) {
    CAPTURE(valence);
    CHECK(c1_at(Rational(bound) - Rational(1) / 500, valence).is_yes());
    const Decision above = c1_at(Rational(bound) + Rational(1) / 500, valence);
    CHECK(above.is_no());
    CHECK(above.reason.find("both signs") != std::string::npos);
  }
}

TEST_CASE("an eigenvalue above 1 refutes, one that is 1 does not") {
  WrittenRules written = *VertexScheme::named("loop").written;
  std::erase_if(written.rules, [](const WrittenRule& rule) { return rule.point == LatticePoint{0, 0}; });
  written.rules.push_back({{0, 0}, {{{0, 0}, 0, {"b"}}, {{1, 0}, std::nullopt, {"(1 - b)/n"}}}});
  const auto c1_with = [&](const Rational& weight) {
    written.letters = {{'b', weight}};
    return vertex_smoothness(rules_at(written, 5), part_of("loop")).c1.truth;
  };
  // Frequency 0 has the eigenvalues 1, b - 3/8, ...
  CHECK(c1_with(Rational(3, 2)) == Truth::no);
  CHECK(c1_with(Rational(-3, 4)) == Truth::no);
  CHECK(c1_with(Rational(11, 8)) == Truth::unknown);
  CHECK(c1_with(Rational(-5, 8)) == Truth::unknown);
}

TEST_CASE("a Jordan block in front is not taken for a simple eigenvalue") {
  // 1/4 has a block of size 2 in frequency 1, and two vectors in frequency 0, of size 1.
  const VertexSmoothness midedge = smoothness("midedge", 3);
  CHECK(midedge.c1.is_yes());
  CHECK(midedge.frequency == 1);
  CHECK(midedge.subdominant.contains(Rational(1, 4)));
  CHECK_FALSE(midedge.evidence);
  CHECK_FALSE(midedge.exponent.upper);
  // (4x - 1)^3 for frequency 0, (4x - 1)^2 (16x - 1) for frequency 1: functions of frequency 0 lead.
  const VertexSmoothness butterfly = smoothness("butterfly:w=1/16", 3);
  CHECK(butterfly.c1.is_no());
  CHECK(butterfly.frequency == 0);
  CHECK(butterfly.subdominant.contains(Rational(1, 4)));
}

TEST_CASE("vertex smoothness refuses what it has no proof for") {
  SectorRules rules = vertex_rules("loop", 5);
  CHECK_THROWS_AS(vertex_smoothness(rules, part_of("catmull-clark")), Error);
  SectorRules heavy = rules;
  heavy.rules.at({0, 0}).terms.front().weight += LaurentPolynomial(1);
  CHECK_THROWS_AS(vertex_smoothness(heavy, part_of("loop")), Error);
  SectorRules skew = rules;
  skew.rules[{1, 0}] = {{{{{1, 0}, 0}, Rational(1) / 2}, {{{1, 0}, 1}, Rational(1) / 2}}};
  CHECK_THROWS_AS(vertex_smoothness(skew, part_of("loop")), Error);
  SectorRules pointing = rules;  // to the first sector
  pointing.rules.at({0, 0}) = {
      {{{{0, 0}, 0}, Rational(1) / 2}, {{{1, 0}, 0}, Rational(1) / 4}, {{{1, 0}, 1}, Rational(1) / 4}}};
  CHECK_THROWS_WITH(vertex_smoothness(pointing, part_of("loop")), Catch::Contains("turn with the sectors"));
  const SectorRules quads_as_triangles{6, SectorLattice::triangles, vertex_rules("catmull-clark", 4).mask};
  CHECK_THROWS_WITH(vertex_smoothness(quads_as_triangles, part_of("catmull-clark")),
                    Catch::Contains("turn with the sectors"));
  // A vertex that is left where it is: the mean of the ring does not come to it.
  SectorRules still = rules;
  still.rules.at({0, 0}) = {{{{{0, 0}, 0}, Rational(1)}}};
  const VertexSmoothness spike = vertex_smoothness(still, part_of("loop"));
  CHECK_FALSE(spike.c1.is_yes());
  SectorRules step = vertex_rules("sqrt3", 5);
  step.step = vertex_rules("loop", 5).mask;
  CHECK_THROWS_AS(regular_part(step, {Deadline::in(1)}), Error);
}
