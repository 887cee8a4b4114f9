#include <subcert/cmake/catch.hpp>

#include "vertex_parts.hpp"

#include <subcert/analysis/vertex/weight_map.hpp>

#include <subcert/analysis/symbol/support/error.hpp>

using namespace subcert;
using namespace subcert::testing;

namespace {

/// Loop's scheme with a product of two letters as the part of the neighbours of a vertex.
WrittenRules loop_with_a_product() {
  WrittenRules written = *VertexScheme::named("loop").written;
  written.letters = {{'a'}, {'b'}};
  written.rules = {{{0, 0}, {{{0, 0}, 0, {"1 - a*b"}}, {{1, 0}, std::nullopt, {"a*b/n"}}}}};
  return written;
}

/// Loop's scheme with the parts a of a vertex in its edges and b of its neighbours in itself.
WrittenRules loop_with_two_weights() {
  WrittenRules written = *VertexScheme::named("loop").written;
  written.letters = {{'a'}, {'b'}};
  written.rules = {
      {{0, 0}, {{{0, 0}, 0, {"1 - b"}}, {{1, 0}, std::nullopt, {"b/n"}}}},
      {{1, 0}, {{{0, 0}, 0, {"a"}}, {{1, 0}, 0, {"3/4 - a"}}, {{1, 0}, 1, {"1/8"}}, {{1, 0}, -1, {"1/8"}}}}};
  return written;
}

}  // namespace

TEST_CASE("what is proved on cells of two weights is proved at their values") {
  const WrittenRules written = loop_with_a_product();
  const RegularPart regular = part_of("loop");
  const Box box{{Rational(1, 8), Rational(1, 8)}, {2, 1}};
  for (const WeightProperty property : {WeightProperty::c1, WeightProperty::bounded_curvature}) {
    const SectorRules rules = rules_with_letters(written, 5);
    const CellMap map = weight_map(rules, regular, property, box, {16, 2, {Deadline::in(60)}});
    CHECK(map.complete);
    Rational area = 0;
    for (const MapCell& cell : map.cells) {
      area += cell.box.volume();
      if (cell.holds == Truth::unknown) CHECK_FALSE(cell.reason.empty());
      if (cell.holds == Truth::unknown) continue;
      WrittenRules fixed = written;
      for (std::size_t v = 0; v < 2; ++v)
        fixed.letters[v].value = Rational((2 * cell.box.low[v] + cell.box.high[v]) / 3);
      const VertexSmoothness at = vertex_smoothness(rules_at(fixed, 5), regular);
      const bool holds = at.c1.is_yes() && (property == WeightProperty::c1 ||
                                            (at.curvature && *at.curvature != CurvatureLimit::unbounded));
      CHECK(holds == (cell.holds == Truth::yes));
    }
    CHECK(area == box.volume());
    CHECK(map.share(Truth::yes) > 0);
    CHECK(map.share(Truth::no) > 0);
  }
}

TEST_CASE("a map with one weight fixed is the range of the other") {
  WrittenRules written = loop_with_two_weights();
  const RegularPart regular = part_of("loop");
  written.letters[0].value = Rational(3, 8);
  const SectorRules rules = rules_with_letters(written.with_free({"b"}), 4);
  const WeightRange range = weight_range(rules, regular, WeightProperty::c1, 0, Rational(4, 5), Rational(1, 10000), 1,
                                         {Deadline::in(60)});
  REQUIRE(range.ends.size() == 1);
  CHECK(range.ends.front().value == LaurentPolynomial(Rational(1, 4)));
  // Letters that are no letters, or have no value.
  CHECK_THROWS_AS(written.with_free({"x"}), Error);
  CHECK_THROWS_AS(written.with_free({"a"}), Error);
  CHECK_THROWS_AS(written.with_free({"a", "a"}), Error);
}

TEST_CASE("powers of c stand for those of several letters") {
  for (const std::vector<long>& exponents : {std::vector<long>{0, 0, 0, 0}, {63, 31, 31, 3}, {5, 0, 7, 0}})
    CHECK(letter_exponents(letter_power(exponents), 3) == exponents);
  const WrittenRules free = loop_with_two_weights();
  const SectorRules rules = rules_with_letters(free, 7);
  CHECK(letter_degrees(rules, 2) == std::vector<long>{1, 1});
  WrittenRules fixed = free;
  fixed.letters[0].value = Rational(2, 7);
  fixed.letters[1].value = Rational(-1, 3);
  const SectorRules expected = rules_at(fixed, 7), found = with_letter_values(rules, {Rational(2, 7), Rational(-1, 3)});
  for (const auto& [point, rule] : expected.rules) {
    REQUIRE(found.rules.at(point).terms.size() == rule.terms.size());
    for (std::size_t i = 0; i < rule.terms.size(); ++i)
      CHECK(found.rules.at(point).terms[i].weight == rule.terms[i].weight);
  }
  const Box box{{0, 0}, {1, 1}};
  CHECK_THROWS_AS(weight_map(rules, part_of("loop"), WeightProperty::c1, box, {0, 1, {Deadline::in(1)}}), Error);
  CHECK_FALSE(weight_map(rules, part_of("loop"), WeightProperty::c1, box, {4, 1, {Deadline::in(0)}}).complete);
}
