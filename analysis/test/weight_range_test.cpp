#include <subcert/cmake/catch.hpp>

#include "vertex_parts.hpp"

#include <subcert/analysis/vertex/weight_range.hpp>

#include <subcert/analysis/symbol/support/error.hpp>

using namespace subcert;
using namespace subcert::testing;

namespace {

/// Weights of the vertex and of its neighbours in the letter b.
WrittenRules with_weights(const std::string& scheme, const std::string& vertex, const std::string& neighbours) {
  WrittenRules written = *VertexScheme::named(scheme).written;
  written.letters = {{'b'}};
  written.rules = {{{0, 0}, {{{0, 0}, 0, {vertex}}, {{1, 0}, std::nullopt, {neighbours}}}}};
  return written;
}

}  // namespace

TEST_CASE("what is proved for a range of weights is proved at its values") {
  const Budget budget{Deadline::in(60)};
  for (const auto& [scheme, vertex, neighbours] : {std::array<std::string, 3>{"loop", "1 - b", "b/n"},
                                                   {"loop", "1 - b^2 - c*b/8", "(b^2 + c*b/8)/n"},
                                                   {"catmull-clark", "1 - b", "b/n"}}) {
    const WrittenRules written = with_weights(scheme, vertex, neighbours);
    const RegularPart regular = part_of(scheme);
    for (const long n : {3L, 5L}) {
      CAPTURE(scheme, vertex, n);
      const SectorRules rules = rules_with_letters(written, n);
      const WeightRange c1 = weight_range(rules, regular, WeightProperty::c1, Rational(1, 10), Rational(9, 10),
                                          Rational(1, 10000), 2, budget);
      CHECK(c1.pieces.front().low == Rational(1, 10));
      CHECK(c1.pieces.back().high == Rational(9, 10));
      int proved = 0;
      for (std::size_t i = 0; i < c1.pieces.size(); ++i) {
        if (i > 0) CHECK(c1.pieces[i].low == c1.pieces[i - 1].high);
        if (c1.pieces[i].holds.truth == Truth::unknown) continue;
        WrittenRules fixed = written;
        fixed.letters.front().value = Rational((2 * c1.pieces[i].low + c1.pieces[i].high) / 3);
        const VertexSmoothness at = vertex_smoothness(rules_at(fixed, n), regular);
        proved += c1.pieces[i].holds.is_yes() ? 1 : 0;
        if (c1.pieces[i].holds.is_yes()) CHECK(at.c1.is_yes());
        if (c1.pieces[i].holds.is_no()) CHECK_FALSE(at.c1.is_yes());
      }
      CHECK(proved > 0);
    }
  }
}

TEST_CASE("rules with a letter are those of its values") {
  const WrittenRules free = with_weights("loop", "1 - b^2 - c*b/8", "(b^2 + c*b/8)/n");
  const SectorRules rules = rules_with_letters(free, 7);
  CHECK(letter_degrees(rules, 1) == std::vector<long>{2});
  for (const Rational& value : {Rational(0), Rational(1), Rational(-3, 7)}) {
    WrittenRules fixed = free;
    fixed.letters.front().value = value;
    const SectorRules expected = rules_at(fixed, 7), found = with_letter_values(rules, {LaurentPolynomial(value)});
    const LatticePoint vertex{0, 0};
    CHECK(found.rules.at(vertex).terms.front().weight == expected.rules.at(vertex).terms.front().weight);
  }
  CHECK_THROWS_AS(weight_range(rules, part_of("loop"), WeightProperty::c1, 1, 0, 1, 1, {Deadline::in(1)}), Error);
  // A sum that is 1 for single values alone.
  const SectorRules wrong = rules_with_letters(with_weights("loop", "1 - b^2", "b/n"), 7);
  CHECK_THROWS_AS(weight_range(wrong, part_of("loop"), WeightProperty::c1, 0, 1, 1, 1, {Deadline::in(1)}), Error);
}
