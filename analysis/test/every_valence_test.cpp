#include "vertex_parts.hpp"

#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/vertex/every_valence.hpp>
#include <subcert/analysis/vertex/family_spectrum.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <string>
#include <vector>

namespace subcert::every_valence_test {

using namespace subcert::vertex;
using subcert::testing::part_of;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

constexpr slong bits = 64;
const LatticePoint centre{0, 0}, edge{1, 0};

EveryValence proof(const SectorRuleFamily& family, const std::string& scheme, long first) {
  return every_valence(family, part_of(scheme), first, {Deadline::in(100)});
}

Rational over(long numerator, long denominator) { return {Integer(numerator), Integer(denominator)}; }

std::vector<Ball> in_balls(const std::vector<Rational>& p, const Ball& width) {
  std::vector<Ball> result;
  for (const Rational& coefficient : p) result.push_back(Ball(coefficient, bits).widened(width));
  return result;
}

bool holds(const Ball& ball, const Enclosure& value) {
  const Enclosure own = ball.enclosure();
  return *own.lower <= *value.lower && *value.upper <= *own.upper;
}

}  // namespace

TEST_CASE("schemes are C1 at vertices of every valence") {
  for (const std::string scheme : {"loop", "catmull-clark", "doo-sabin", "midedge"}) {
    CAPTURE(scheme);
    const EveryValence all = proof(vertex_rule_family(scheme), scheme, 7);
    CAPTURE(all.c1.reason);
    CHECK(all.c1.is_yes());
    CHECK(all.open.empty());
  }
}

TEST_CASE("schemes of larger masks are C1 at vertices of every valence", "[long]") {
  for (const std::string scheme : {"modified-butterfly", "sqrt3"}) {
    CAPTURE(scheme);
    CHECK(proof(vertex_rule_family(scheme), scheme, 600).c1.is_yes());
  }
}

TEST_CASE("butterfly has no tangent planes from valence 8 on", "[long]") {  // frequency 2 leads
  const EveryValence butterfly = proof(vertex_rule_family("butterfly:w=1/16"), "butterfly:w=1/16", 7);
  CHECK(butterfly.c1.truth == Truth::unknown);
  REQUIRE(butterfly.open.size() == 1);
  CHECK(butterfly.open[0].first <= 8);
  CHECK_FALSE(butterfly.open[0].last.has_value());
}

TEST_CASE("what is not so at every valence is not proved") {
  // Frequency 1 alone shrinks faster, by 1/1000 at the edges: others lead where cos(2 pi/n) - cos(4 pi/n) < 1/250.
  SectorRuleFamily slow = vertex_rule_family("loop");
  slow.rules.rules[edge] = slow.rules.rule_at(edge);
  slow.rules.rules[edge].rings.push_back({edge, 1, over(-1, 1000)});
  const EveryValence loop = proof(slow, "loop", 13);
  CHECK(loop.c1.truth == Truth::unknown);
  REQUIRE(loop.open.size() == 1);
  CHECK(loop.open[0].first > 100);
  CHECK(loop.open[0].first < 130);
  CHECK_FALSE(loop.open[0].last.has_value());

  // Of frequency 0 the eigenvalue behind 1 comes to the leader from above, and from below ever more slowly.
  for (const Rational& factor : {Rational(-1), Rational(0), over(1, 100)}) {
    CAPTURE(factor);
    SectorRuleFamily near = vertex_rule_family("catmull-clark");
    for (SectorTerm& term : near.over_vertex.terms) term.weight *= factor;
    for (RingTerm& ring : near.over_vertex.rings) ring.weight *= factor;
    const EveryValence all = proof(near, "catmull-clark", 13);
    CHECK(all.c1.truth == Truth::unknown);
    REQUIRE(all.open.size() == 1);
    CHECK(all.open[0].first == 13);
    CHECK(all.open[0].last.has_value() == (factor > 0));
  }
}

namespace {

void check_leaders(const std::vector<std::string>& schemes) {
  for (const std::string& scheme : schemes) {
    const SectorRuleFamily family = vertex_rule_family(scheme);
    FamilySpectrum spectrum(family, smallest_closed_set(family.at(SectorRuleFamily::many)));
    Rational low = 0;
    for (const long n : {500L, 250L, 125L, 100L, 80L, 64L, 50L}) {
      CAPTURE(scheme, n);
      const Rational high = over(1, n);
      const auto leader = spectrum.leader_on(low, high, bits);
      REQUIRE(leader);
      CHECK(leader->decay.has_value() == (scheme == "midedge" && low == 0));
      for (const long valence : {n, n + 1, n == 500 ? 1000 : n + 5})
        CHECK(holds(leader->value, vertex_smoothness(vertex_rules(scheme, valence), part_of(scheme)).subdominant));
      low = high;
    }
  }
}

}  // namespace

TEST_CASE("eigenvalues of all valences hold those of each") { check_leaders({"loop", "midedge"}); }

TEST_CASE("eigenvalues of all valences hold those of each, of larger masks", "[long]") {
  check_leaders({"catmull-clark", "doo-sabin", "modified-butterfly", "sqrt3"});
}

TEST_CASE("a leader of frequency 1 is told where eigenvalues grow with the cosine, and not where they fall") {
  // Edges at the vertex have the eigenvalue 1/2 - 2 beside + 2 beside cos(2 pi k/n).
  for (const long sign : {1L, -1L}) {
    CAPTURE(sign);
    SectorRuleFamily family = vertex_rule_family("loop");
    const Rational beside = over(sign, 16), itself = over(1, 2) - 2 * beside;
    family.rules.rules[edge] = {{{{centre, 0}, over(1, 2)},
                                 {{edge, 0}, itself},
                                 {{edge, 1}, beside},
                                 {{edge, SectorRuleFamily::many - 1}, beside}}};
    FamilySpectrum spectrum(family, smallest_closed_set(family.at(SectorRuleFamily::many)));
    CHECK(spectrum.leader_on(0, over(1, 100), bits).has_value() == (sign > 0));
  }
}

TEST_CASE("rules of all valences are refused as those of one are") {
  const SectorRuleFamily good = vertex_rule_family("catmull-clark");
  CHECK_THROWS_AS(proof(good, "catmull-clark", 6), Error);
  CHECK_THROWS_AS(proof(good, "loop", 13), Error);
  SectorRuleFamily heavy = good;
  heavy.over_vertex.terms[0].weight += LaurentPolynomial(1);
  CHECK_THROWS_WITH(proof(heavy, "catmull-clark", 13), Catch::Contains("sum 1"));
  SectorRuleFamily turning = good;
  turning.over_vertex.rings[0].frequency = 2;
  CHECK_THROWS_AS(proof(turning, "catmull-clark", 13), Error);
  SectorRuleFamily still = good;
  still.over_vertex = {};
  CHECK(proof(still, "catmull-clark", 13).c1.truth == Truth::unknown);
}

TEST_CASE("Schur's test agrees with zeros") {
  Random random;
  for (const auto round : rounds(400)) {
    std::vector<Rational> p;
    for (long i = 0, degree = random.integer(1, 6); i <= degree; ++i) p.push_back(over(random.integer(-9, 9), 4));
    if (round % 5 == 0) p.front() = 0;
    p.back() = round % 3 == 0 ? 1 : 3;
    const auto found = complex_roots(in_balls(p, Ball(0, bits)));
    if (!found) continue;
    const Ball radius(over(random.integer(1, 12), 6), bits);
    bool all = true, some = false;
    for (const ComplexBall& zero : *found) {
      all = all && abs(zero).is_less(radius);
      some = some || radius.is_less(abs(zero));
    }
    CHECK(has_zeros_below(in_balls(p, Ball(0, bits)), radius) == all);
    if (some) CHECK_FALSE(has_zeros_below(in_balls(p, Ball(over(1, 100), bits)), radius));
  }
}

TEST_CASE("one zero for all coefficients in balls, and what is left without it") {
  Random random;
  int found_some = 0;
  for (const auto round : rounds(300)) {
    CAPTURE(static_cast<int>(round));
    const Rational zero = over(random.integer(1, 30), 10);
    std::vector<Rational> rest{over(random.integer(-5, 5), 10), over(random.integer(-5, 5), 10), 1}, p(4, 0);
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] -= zero * rest[i];
      p[i + 1] += rest[i];
    }
    const Ball width(over(1, 1000), bits);
    const auto wide = in_balls(p, width);
    const auto ball = zero_near(wide, Ball(zero + over(1, 500), bits));
    if (!ball) continue;
    ++found_some;
    CHECK(holds(*ball, Enclosure::exactly(zero)));
    const std::vector<Ball> left = deflated(wide, *ball);
    for (std::size_t i = 0; i < 3; ++i) CHECK(holds(left[i], Enclosure::exactly(rest[i])));
  }
  CHECK(found_some > 100);
}

}  // namespace subcert::every_valence_test
