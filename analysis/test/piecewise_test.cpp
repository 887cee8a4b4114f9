#include <subcert/analysis/piecewise/cone_program.hpp>
#include <subcert/analysis/piecewise/contraction.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using namespace subcert::piecewise;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

struct Found {
  std::optional<ConeBound> bound;
  std::optional<std::vector<Rational>> point;
};

Found maximum(const ConeProgram& program, const std::vector<Side>& sides, double enough) {
  ConeProgram::Corner corner = program.corner_of_box();
  if (!program.improve(corner, sides, enough)) return {};
  return {program.bound(corner, sides), program.point(corner, sides)};
}

}  // namespace

TEST_CASE("cone programs: bounds by rows, by the box, and none where a free coordinate is not held") {
  const Row both{1, 1};
  CHECK_FALSE(maximum(ConeProgram(2, 1, {}, both), {}, 0).bound);
  const ConeProgram held(2, 1, {{1, -1}}, both);
  CHECK_FALSE(maximum(held, {Side::any}, 0).bound);
  CHECK_FALSE(maximum(held, {Side::nonpositive}, 0).bound);
  for (const Side side : {Side::nonnegative, Side::zero}) {
    const Found found = maximum(held, {side}, 0);
    REQUIRE(found.bound);
    CHECK(found.bound->bound == 2);
    REQUIRE(found.bound->multipliers.size() == 1);
    CHECK(found.bound->multipliers[0].second == 1);
    CHECK(found.point == std::vector<Rational>{1, 1});
  }
  // The same row with the other sign.
  const ConeProgram turned(2, 1, {{-1, 1}}, both);
  CHECK(maximum(turned, {Side::nonpositive}, 0).bound->multipliers[0].second == -1);
  CHECK(maximum(turned, {Side::zero}, 0).bound->multipliers[0].second == -1);
  // A coordinate that is free and does not matter is 0.
  CHECK(maximum(ConeProgram(2, 1, {}, {1, 0}), {}, -1).point == std::vector<Rational>{1, 0});
  // Of equal rows the first one is used.
  CHECK(maximum(ConeProgram(2, 1, {{1, -1}, {1, -1}}, both), {Side::nonnegative, Side::nonnegative}, 0)
            .bound->multipliers.at(0)
            .first == 0);
  // Stopped early at the corner of the box, where the row is negative.
  const ConeProgram early(2, 2, {{-1, -1}}, both);
  CHECK(maximum(early, {Side::nonnegative}, 10).bound->bound == 2);
  CHECK_FALSE(maximum(early, {Side::nonnegative}, 10).point);
  CHECK(maximum(early, {Side::nonnegative}, 0).bound->bound == 0);
  // A value that is small already, but rests on a coordinate without bound.
  CHECK(maximum(ConeProgram(2, 1, {{1, -1}}, {0, {1, 100'000}}), {Side::nonnegative}, 0.5).bound->bound ==
        Rational(1, 100'000));
}

TEST_CASE("cone programs: a corner of another search is not believed") {
  const ConeProgram program(2, 2, {{-2, -1}}, {3, 1});
  ConeProgram::Corner corner = program.corner_of_box();
  REQUIRE(program.improve(corner, {Side::nonnegative}, 2));  // at (1, -2), outside of the box
  CHECK_FALSE(program.point(corner, {Side::nonnegative}));
  CHECK(program.bound(corner, {Side::nonnegative})->bound == 1);
  CHECK(program.bound(corner, {Side::zero})->bound == 1);
  CHECK_FALSE(program.bound(corner, {Side::any}));
  CHECK_FALSE(program.bound(corner, {Side::nonpositive}));
  // Of another program, whose row does not tell the coordinates.
  const ConeProgram other(2, 2, {{0, 0}}, {3, 1});
  CHECK_FALSE(other.bound(corner, {Side::nonnegative}));
  CHECK_FALSE(other.point(corner, {Side::nonnegative}));
}

TEST_CASE("cone programs: multipliers prove the bound, a point attains it, and a corner serves stricter sides") {
  Random random;
  for (const auto round : rounds(200)) {
    (void)round;
    const auto dimension = static_cast<std::size_t>(random.integer(1, 6));
    std::vector<Row> rows;
    Row form;
    for (std::size_t j = 0; j < dimension; ++j) form.emplace_back(random.integer(-3, 3));
    for (long i = random.integer(0, 9); i > 0; --i) {
      rows.emplace_back();
      for (std::size_t j = 0; j < dimension; ++j) rows.back().emplace_back(random.integer(-2, 2));
    }
    const ConeProgram program(dimension, dimension, rows, form);
    std::vector<Side> sides(rows.size(), Side::any);
    ConeProgram::Corner corner = program.corner_of_box();
    for (int stage = 0; stage < 3; ++stage) {
      REQUIRE(program.improve(corner, sides, -1));
      const auto found = program.bound(corner, sides);
      REQUIRE(found);
      Row sum = form;
      for (const auto& [row, factor] : found->multipliers) {
        CHECK((sides[row] == Side::zero || (factor > 0 ? Side::nonnegative : Side::nonpositive) == sides[row]));
        for (std::size_t j = 0; j < dimension; ++j) sum[j] += factor * rows[row][j];
      }
      Rational norm = 0;
      for (const Rational& entry : sum) norm += abs(entry);
      CHECK(norm == found->bound);
      const auto point = program.point(corner, sides);
      REQUIRE(point);
      CHECK(value_at(form, *point) == found->bound);
      CHECK(found->bound == maximum(program, sides, -1).bound->bound);
      for (Side& side : sides)
        side = static_cast<Side>(static_cast<long>(side) | random.integer(0, 1) << random.integer(0, 1));
    }
  }
}

TEST_CASE("contraction of a linear rule is the norm of its difference scheme") {
  Rule rule{2, 1, {}};  // Chaikin's
  rule.pieces.push_back({{0, 0}, 0, {}, {{Rational(3, 4), Rational(1, 4)}, {Rational(1, 4), Rational(3, 4)}}});
  for (int steps = 1; steps <= 4; ++steps) {
    const auto found = contraction(rule, {steps, 1, 0, {}, true}).proved;
    REQUIRE(found);
    CHECK(found->bound == power(Rational(1, 2), steps));
    CHECK_FALSE(found->data.empty());
    for (const ContractionTree& tree : found->trees)
      for (const ResidualFactors& leaf : tree.leaves) CHECK(leaf.bound <= found->bound);
    const auto enough = contraction(rule, {steps, 1, Rational(2, 3)}).proved;
    CHECK(enough->bound == Rational(2, 3));
    CHECK(enough->data.empty());
  }
}

TEST_CASE("a contraction without time says what was attained") {
  Rule rule{2, 1, {}};
  rule.pieces.push_back({{0, 0}, 0, {}, {{Rational(3, 4), Rational(1, 4)}, {Rational(1, 4), Rational(3, 4)}}});
  const ContractionSearch search = contraction(rule, {3, 1, 0, Deadline::in(0)});
  CHECK_FALSE(search.proved);
  CHECK(search.starts == 5);
  CHECK(search.finished == 0);
  CHECK(search.attained == 0);
}
