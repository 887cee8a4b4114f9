// Upper bounds by quadratic forms: that they are bounds, that they are near the radius, and what is left out is
// nothing.
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/radii/joint/one_block.hpp>
#include <subcert/analysis/radii/polytope_proof/round_family.hpp>
#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/radii/quadratic/context_forms.hpp>
#include <subcert/analysis/radii/quadratic/product_tree.hpp>
#include <subcert/analysis/test/matrices.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <set>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::square_matrix;

namespace {

/// Whether each infinite sequence of letters begins with exactly one word from every state.
bool is_complete(const GraphProof& proof, std::size_t letters) {
  for (const GraphProof::State& first : proof.states) {
    std::vector<std::pair<std::size_t, std::size_t>> way{{static_cast<std::size_t>(&first - proof.states.data()), 0}};
    for (const char end : first.ends) {
      if (way.empty()) return false;
      auto& [state, letter] = way.back();
      const auto& steps = proof.states[state].steps;
      const auto step = std::ranges::find(steps, letter++, &GraphProof::Step::letter);
      if (end == '+') way.emplace_back(step->to, 0);
      while (!way.empty() && way.back().second == letters) way.pop_back();
    }
    if (!way.empty()) return false;
  }
  return true;
}

const Rational thousandth = power(Rational(10), -3);

}  // namespace

TEST_CASE("a quadratic form bounds the radius of the golden pair") {
  const MatrixFamily golden{square_matrix({{1, 1}, {0, 1}}), square_matrix({{1, 0}, {1, 1}})};
  // The radius is (1 + sqrt 5) / 2.
  const auto proof = prove_by_quadratic_forms(golden, Rational(1618, 1000), {Deadline::in(2)});
  REQUIRE(proof);
  CHECK(power(2 * proof->bound - 1, 2) >= 5);
  CHECK(power(2 * proof->bound - 1, 2) < 5 + thousandth);
  CHECK(proof->group.size() == 2);
  CHECK(is_complete(*proof, 2));
  // With its product, of which states have forms that it keeps.
  const Rational radius(Integer("16180339887498948482"), pow(Integer(10), 19));
  const ProductEvidence product = prove_product(golden, {0, 1});
  const auto near = prove_by_quadratic_forms(golden, radius, {Deadline::in(20)}, {product.word, product.eigenvalue});
  REQUIRE(near);
  CHECK(near->bound < radius * (1 + power(Rational(10), -10)));
  CHECK(is_complete(*near, 2));
  // The product attains the radius: each of its letters is kept by one state, and all other words contract.
  REQUIRE(near->attained);
  const AttainedGraph& attained = *near->attained;
  CHECK(attained.product == product.word);
  const auto is_golden = [](const Enclosure& ends) {
    return power(2 * *ends.lower - 1, 2) <= 5 && power(2 * *ends.upper - 1, 2) >= 5;
  };
  CHECK(is_golden(attained.radius));
  CHECK(attained.graph.bound < *attained.radius.lower);
  CHECK(is_complete(attained.graph, 2));
  std::size_t kept = 0;
  for (const GraphProof::State& state : attained.graph.states)
    kept += static_cast<std::size_t>(std::ranges::count(state.ends, '*'));
  CHECK(kept == 2);
  CHECK(attained.kept < 1);
  // Scaled exactly.
  const GraphProof half = scaled(*near, Rational(1, 2));
  CHECK(half.attained->graph.bound == attained.graph.bound / 2);
  CHECK(is_golden({2 * *half.attained->radius.lower, 2 * *half.attained->radius.upper}));
}

TEST_CASE("letters are kept only by the best product") {
  const MatrixFamily golden{square_matrix({{1, 1}, {0, 1}}), square_matrix({{1, 0}, {1, 1}})};
  // 001 has the radius 1.55..., and 0 the radius 1 with a Jordan block.
  for (const std::vector<int>& word : {std::vector<int>{0, 0, 1}, std::vector<int>{0}}) {
    const ProductEvidence product = prove_product(golden, word);
    const auto proof = prove_by_quadratic_forms(golden, *product.radius.lower, {Deadline::in(3)},
                                                {product.word, product.eigenvalue});
    REQUIRE(proof);
    CHECK_FALSE(proof->attained);
    CHECK(power(2 * proof->bound - 1, 2) >= 5);
  }
}

TEST_CASE("the search for a form ends at its target") {
  const Mask mask = make_scheme("primal:n=6,d=3").mask.curve();
  const MatrixFamily family = transition_matrices(divided_difference_scheme(mask, 4));
  const auto rough = prove_by_quadratic_forms(family, 2, {Deadline::in(60)});
  REQUIRE(rough);
  CHECK(rough->bound < 2);
  CHECK(rough->words() == 2);
  const auto fine = prove_by_quadratic_forms(family, Rational(185, 100), {Deadline::in(60)});
  REQUIRE(fine);
  CHECK(fine->bound <= Rational(185, 100));
  CHECK(fine->words() < 2000);
  CHECK(is_complete(*fine, 2));
}

TEST_CASE("quadratic forms of families at the edge") {
  const RationalMatrix shift = square_matrix({{0, 1}, {0, 0}}), zero(2, 2);
  CHECK_FALSE(prove_by_quadratic_forms({zero, zero}, 0, {Deadline::in(1)}));
  CHECK_FALSE(prove_by_quadratic_forms({shift}, 0, {Deadline::in(1)}));
  // A Jordan block: the infimum over the forms is not attained.
  const auto jordan = prove_by_quadratic_forms({square_matrix({{1, 1}, {0, 1}})}, 0, {Deadline::in(2)});
  REQUIRE(jordan);
  CHECK(jordan->bound > 1);
  CHECK(jordan->bound < 1 + 30 * thousandth);
  // Scaled far from 1, with a matrix twice.
  const Rational huge = power(Rational(10), 60);
  const RationalMatrix up = square_matrix({{huge, huge}, {0, huge}}), down = square_matrix({{huge, 0}, {huge, huge}});
  const auto twice = radius::quadratic_bound({up, down, up}, 0, {Deadline::in(1)});
  REQUIRE(twice);
  CHECK(power(2 * twice->bound / huge - 1, 2) >= 5);
  for (const GraphProof::State& state : twice->states)
    CHECK(std::ranges::all_of(state.steps, [](const GraphProof::Step& step) { return step.letter < 2; }));
}

TEST_CASE("forms that doubles do not hold") {
  // Nearly a common eigenvector, in coordinates of very different lengths: the radius is above 1 by about 10^-12.
  const Rational far = power(Rational(10), 8), near = power(Rational(10), -20), half(1, 2);
  const auto proof = prove_by_quadratic_forms(
      {square_matrix({{1, far}, {0, half}}), square_matrix({{1, 0}, {near, half}})}, 0, {Deadline::in(10)});
  REQUIRE(proof);
  CHECK(proof->bound > 1);
  CHECK(proof->bound < 1 + power(Rational(10), -8));
}

TEST_CASE("forms of contexts and of a cycle are nearer than one form") {
  const Mask mask = make_scheme("primal:n=4,d=3").mask.curve();
  const MatrixFamily family = transition_matrices(divided_difference_scheme(mask, 4));
  const polytope::SearchFamily search = radius::to_search_family(family);
  const auto one = quadratic::ellipsoidal_coordinates(search, 0, Deadline::in(60));
  quadratic::ContextForms contexts(search, one);
  for (const std::size_t states : {2, 4, 8}) {
    const double before = contexts.forms().bound;
    REQUIRE(contexts.grow({Deadline::in(60)}));
    CHECK(contexts.forms().states() == states);
    CHECK(contexts.forms().bound < before * (1 + 1e-4));
  }
  CHECK(contexts.forms().bound < one.bound);
  // The product itself keeps the forms of its cycle; all other steps are as before.
  const std::vector<int> product = joint_spectral_radius(family, {Deadline::in(60)}).product.word;
  const double radius = polytope::product_radius(search.matrices, {product.rbegin(), product.rend()});
  const auto cycle = contexts.with_cycle(product, {Deadline::in(60)});
  REQUIRE(cycle);
  REQUIRE(cycle->states() == 8 + product.size());
  for (std::size_t p = 0; p < product.size(); ++p) {
    const quadratic::Step& on = cycle->steps[2 * (8 + p) + static_cast<std::size_t>(product[p])];
    CHECK(on.to == 8 + (p + 1) % product.size());
    CHECK(std::abs(polytope::spectral_norm(on.matrix) / radius - 1) < 1e-6);
  }
}

TEST_CASE("the longest images and runs of a letter name the product") {
  const auto best = [](const MatrixFamily& family, const std::vector<int>& word) {
    const polytope::SearchFamily search = radius::to_search_family(family);
    const auto found = quadratic::long_products(search, polytope::product_radius(search.matrices, word),
                                                {Deadline::in(60)});
    REQUIRE(!found.empty());
    return found.front();
  };
  const polytope::Candidate images = best(
      {square_matrix({{-1, 1, -1}, {-1, -1, 1}, {0, 1, 1}}), square_matrix({{-1, 1, -1}, {-1, -1, 0}, {0, 1, 1}})},
      {0});
  CHECK(images.word.size() == 41);
  CHECK(images.radius > 1.684185282);
  const polytope::Candidate run = best(
      {square_matrix({{1, 1}, {0, 1}}), square_matrix({{0, 0}, {Rational(1, 100), 0}})}, {0});
  CHECK(run.word.size() == 274);
  CHECK(run.radius > 1.003672059);
}

TEST_CASE("bounds by forms are above the products") {
  Random random;
  for (int round = 0; round < 20; ++round) {
    const std::size_t size = 2 + static_cast<std::size_t>(round % 4);
    std::vector<RationalMatrix> matrices(2, RationalMatrix(size, size));
    for (RationalMatrix& m : matrices)
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j) m(i, j) = random.integer(-9, 9);
    const auto proof = prove_by_quadratic_forms(matrices, 0, {Deadline::in(0.5)});
    if (!proof) continue;
    const JointSpectralRadius radius = joint_spectral_radius(matrices, {Deadline::in(2)});
    CHECK(proof->bound >= *radius.radius.lower);
    CHECK(proof->bound <= *radius.radius.lower * Rational(3, 2));
  }
}
