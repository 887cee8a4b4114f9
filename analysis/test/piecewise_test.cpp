#include <subcert/analysis/piecewise/cone_program.hpp>
#include <subcert/analysis/piecewise/contraction.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using namespace subcert::piecewise;
using subcert::testing::Random;
using subcert::testing::rounds;

TEST_CASE("cone programs: bounds by rows, by the box, and none where a free coordinate is not held") {
  const Row both{1, 1}, first{1}, order{1, -1};
  ConeProgram free(2, 1);
  CHECK_FALSE(free.bound(both, 0));
  CHECK(free.unbounded_coordinate() == std::size_t{1});
  ConeProgram held(2, 1);
  held.add(order);
  const auto bound = held.bound(both, 0);
  REQUIRE(bound);
  CHECK(bound->bound == 2);
  REQUIRE(bound->multipliers.size() == 1);
  CHECK(bound->multipliers[0].second == 1);
  CHECK(held.maximiser() == std::vector<Rational>{1, 1});
  CHECK_FALSE(held.unbounded_coordinate());
  // Stopped early at the corner of the box, where the row is negative.
  const Row turned{-1, -1};
  ConeProgram early(2, 2);
  early.add(turned);
  CHECK(early.bound(both, 10)->bound == 2);
  CHECK_FALSE(early.maximiser());
  CHECK(early.bound(both, 0)->bound == 0);
}

TEST_CASE("cone programs: multipliers prove the bound, and a point attains it") {
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
    ConeProgram program(dimension, dimension);
    for (const Row& row : rows) program.add(row);
    const auto found = program.bound(form, -1);
    REQUIRE(found);
    Row sum = form;
    for (const auto& [row, factor] : found->multipliers) {
      CHECK(factor > 0);
      for (std::size_t j = 0; j < dimension; ++j) sum[j] += factor * rows[row][j];
    }
    Rational norm = 0;
    for (const Rational& entry : sum) norm += abs(entry);
    CHECK(norm == found->bound);
    const auto point = program.maximiser();
    REQUIRE(point);
    Rational value = 0;
    for (std::size_t j = 0; j < dimension; ++j) value += form[j] * (*point)[j];
    CHECK(value == found->bound);
  }
}

TEST_CASE("contraction of a linear rule is the norm of its difference scheme") {
  Rule rule{2, 0, {}};  // Chaikin's
  rule.pieces.push_back({{0, 0}, 0, {}, {{Rational(3, 4), Rational(1, 4)}, {Rational(1, 4), Rational(3, 4)}}});
  for (int steps = 1; steps <= 4; ++steps) {
    const auto found = contraction(rule, {steps, 1, {}, true});
    REQUIRE(found);
    CHECK(found->bound == power(Rational(1, 2), steps));
    for (const ContractionTree& tree : found->trees)
      for (const ResidualFactors& leaf : tree.leaves) CHECK(leaf.bound <= found->bound);
  }
}
