#include "vertex_parts.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/vertex/vertex_stencils.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <cmath>
#include <numbers>

namespace subcert::vertex_stencils_test {

using subcert::testing::part_of;
using subcert::testing::Random;

namespace {

using Data = std::map<SectorPoint, double>;

double number(const Enclosure& enclosure) { return enclosure.lower->convert_to<double>(); }

double value_of(const VertexStencils::Stencil& stencil, const Data& data) {
  double sum = 0;
  for (const StencilWeight& weight : stencil) sum += number(weight.value) * data.at(weight.at);
  return sum;
}

/// The data of one level further at the points of a stencil, from all that they need.
class Refined {
 public:
  Refined(const SectorRules& rules, Random& random) : rules_(rules), random_(random) {}
  Data old;

  double operator()(const SectorPoint& at) {
    double sum = 0;
    for (const auto& [datum, weight] : weights(at.point)) {
      const SectorPoint place = turned(datum, at.turn, rules_.lattice, rules_.valence);
      const auto [entry, is_new] = old.try_emplace(place, 0);
      if (is_new) entry->second = static_cast<double>(random_.integer(-1000, 1000)) / 1000;
      sum += number(weight) * entry->second;
    }
    return sum;
  }

 private:
  const std::vector<std::pair<SectorPoint, Enclosure>>& weights(const LatticePoint& point) {
    const auto [entry, is_new] = known_.try_emplace(point);
    if (is_new) entry->second = weights_at(rules_.rule_at(point), rules_.lattice, rules_.valence);
    return entry->second;
  }
  const SectorRules& rules_;
  Random& random_;
  std::map<LatticePoint, std::vector<std::pair<SectorPoint, Enclosure>>> known_;
};

double at_cosine(const LaurentPolynomial& p, double c) {
  double value = 0;
  for (long k = p.is_zero() ? -1 : p.highest(); k >= 0; --k) value = value * c + p.coefficient(k).convert_to<double>();
  return value;
}

}  // namespace

namespace {

void check_that_they_commute(const std::vector<long>& valences) {
  Random random;
  for (const std::string scheme :
       {"loop", "catmull-clark", "doo-sabin", "midedge", "butterfly:w=1/16", "modified-butterfly", "sqrt3"})
    for (const long n : valences) {
      CAPTURE(scheme, n);
      const SectorRules rules = vertex_rules(scheme, n);
      const VertexSmoothness at = vertex_smoothness(rules, part_of(scheme));
      const VertexStencils stencils = vertex_stencils(rules, at);
      CHECK(stencils.tangents[0].empty() == (at.frequency != 1));
      const double angle = 2 * std::numbers::pi / static_cast<double>(n);
      for (const auto* stencil : {&stencils.limit, &stencils.tangents[0], &stencils.tangents[1]}) {
        if (stencil->empty()) continue;
        Refined refined(rules, random);
        Data fresh;
        for (const StencilWeight& weight : *stencil) {
          fresh[weight.at] = refined(weight.at);
          CHECK(weight.value.is_canonical());
          CHECK_FALSE(weight.value.contains(0));
          CHECK(*weight.value.upper - *weight.value.lower < power(Rational(2), -90));
          if (!weight.exact) continue;
          const double scale = stencil == &stencils.tangents[1] ? std::sin(angle) : 1;
          if (n < 20) CHECK(std::abs(at_cosine(*weight.exact, std::cos(angle)) * scale - number(weight.value)) < 1e-9);
        }
        for (const StencilWeight& weight : *stencil) refined.old.try_emplace(weight.at, 0.375);
        const double factor = stencil == &stencils.limit ? 1 : number(at.subdominant);
        CHECK(std::abs(value_of(*stencil, fresh) - factor * value_of(*stencil, refined.old)) < 1e-9);
      }
      double sum = 0;
      for (const StencilWeight& weight : stencils.limit) sum += number(weight.value);
      CHECK(std::abs(sum - 1) < 1e-12);
    }
}

}  // namespace

TEST_CASE("stencils commute with the rules: limits stay, tangents shrink by the leader") {
  check_that_they_commute({3, 4, 5, 6, 8});
}

TEST_CASE("stencils of larger valences commute with the rules", "[long]") { check_that_they_commute({7, 13, 40}); }

TEST_CASE("stencils that are printed") {
  // Loop's limit: 1 / (1 + 3 / (8 beta n)) shares, beta n = 5/8 - (3/8 + c/4)^2; tangents: cos and sin.
  for (const long n : {3L, 5L, 6L, 7L, 12L}) {
    CAPTURE(n);
    const SectorRules rules = vertex_rules("loop", n);
    const VertexStencils stencils = vertex_stencils(rules, vertex_smoothness(rules, part_of("loop")));
    const double angle = 2 * std::numbers::pi / static_cast<double>(n), inner = 3.0 / 8 + std::cos(angle) / 4,
                 part = 5.0 / 8 - inner * inner, vertex = 1 / (1 + 8 * part / 3);
    REQUIRE(stencils.limit.size() == static_cast<std::size_t>(n) + 1);
    CHECK(stencils.limit[0].exact.has_value());
    CHECK(number(stencils.limit[0].value) == Approx(vertex).epsilon(1e-14));
    CHECK(number(stencils.limit[1].value) == Approx((1 - vertex) / static_cast<double>(n)).epsilon(1e-14));
    for (std::size_t second = 0; second < 2; ++second)
      for (const StencilWeight& weight : stencils.tangents[second]) {
        CHECK(weight.exact.has_value());
        const double turn = angle * static_cast<double>(weight.at.turn);
        CHECK(number(weight.value) == Approx((second == 1 ? std::sin(turn) : std::cos(turn))).margin(1e-14));
      }
  }
  // Catmull and Clark's limit: n^2, 4, 1 over n (n + 5). lambda is not in Q(c).
  const SectorRules rules = vertex_rules("catmull-clark", 5);
  const VertexStencils stencils = vertex_stencils(rules, vertex_smoothness(rules, part_of("catmull-clark")));
  REQUIRE(stencils.limit.size() == 11);
  CHECK(*stencils.limit[0].exact == LaurentPolynomial(Rational(1) / 2));
  CHECK(*stencils.limit[1].exact == LaurentPolynomial(Rational(2) / 25));
  CHECK(*stencils.limit[6].exact == LaurentPolynomial(Rational(1) / 50));
  CHECK_FALSE(stencils.tangents[0].front().exact.has_value());
}

TEST_CASE("stencils of other valences are refused") {
  const SectorRules rules = vertex_rules("loop", 5);
  CHECK_THROWS_AS(vertex_stencils(vertex_rules("loop", 6), vertex_smoothness(rules, part_of("loop"))), Error);
}

}  // namespace subcert::vertex_stencils_test
