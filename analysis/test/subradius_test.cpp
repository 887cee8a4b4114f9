// Joint spectral subradii: that both ends are bounds, that they meet, and that products of small radius are not missed.
#include <subcert/analysis/radii/polytope_proof/round_family.hpp>
#include <subcert/analysis/radii/subradius/antinorm_search.hpp>
#include <subcert/analysis/radii/subradius/joint_spectral_subradius.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

#include <algorithm>
#include <cmath>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

RationalMatrix matrix_of(std::size_t size, const std::vector<Rational>& entries) {
  RationalMatrix result(size, size);
  for (std::size_t i = 0; i < size * size; ++i) result(i / size, i % size) = entries[i];
  return result;
}

MatrixFamily slow_pair() { return {matrix_of(2, {7, 2, 0, 3}), matrix_of(2, {2, 0, 4, 8})}; }

/// Small integers, about so many of ten of them zero.
MatrixFamily random_family(Random& random, std::size_t count, std::size_t size, int zeros) {
  std::vector<RationalMatrix> matrices;
  for (std::size_t t = 0; t < count; ++t) {
    std::vector<Rational> entries;
    for (std::size_t i = 0; i < size * size; ++i)
      entries.emplace_back(random.integer(0, 9) < zeros ? 0 : random.integer(1, 9));
    matrices.push_back(matrix_of(size, entries));
  }
  return matrices;
}

/// Calls visit for all words of one length.
template <class Visit>
void for_all_words(int letters, std::size_t length, std::vector<int>& word, const Visit& visit) {
  if (word.size() == length) return visit(word);
  for (int t = 0; t < letters; ++t) {
    word.push_back(t);
    for_all_words(letters, length, word, visit);
    word.pop_back();
  }
}

/// The least averaged spectral radius of products of up to so many matrices.
double least_radius(const MatrixFamily& family, std::size_t longest) {
  const auto matrices = radius::to_search_family(family).matrices;
  double least = polytope::product_radius(matrices, {0});
  std::vector<int> word;
  for (std::size_t length = 1; length <= longest; ++length)
    for_all_words(static_cast<int>(family.count()), length, word,
                  [&](const std::vector<int>& w) { least = std::min(least, polytope::product_radius(matrices, w)); });
  return least;
}

/// Both inequalities of SPEC.md, Theorem 31, once more.
void check_proofs(const MatrixFamily& family, const JointSpectralSubradius& found) {
  const std::size_t n = family.size();
  const RationalMatrix product = family.product(found.product.word);
  for (std::size_t i = 0; i < n; ++i) {
    Rational sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += product(i, j) * Rational(found.product.weights[j]);
    CHECK(found.product.weights[i] > 0);
    CHECK(sum <= found.product.radius * Rational(found.product.weights[i]));
  }
  if (!found.antinorm) return;
  const AntinormProof& proof = *found.antinorm;
  const Rational unit = power(Rational(2), -proof.weight_bits);
  REQUIRE(proof.images.size() == proof.vertices.size() * family.count());
  bool holds = true;
  for (std::size_t index = 0; index < proof.images.size(); ++index) {
    const RationalMatrix& given = family[index % family.count()];
    const RationalMatrix matrix = proof.transposed ? transposed(given) : given;
    Rational weights = 0;
    std::vector<Rational> rest;
    for (const Integer& c : proof.vertices[index / family.count()]) rest.emplace_back(c);
    rest = matrix * rest;
    for (const AntinormProof::Term& term : proof.images[index]) {
      holds = holds && term.weight >= 0;
      weights += unit * Rational(term.weight);
      for (std::size_t i = 0; i < n; ++i)
        rest[i] -= unit * Rational(term.weight) * Rational(proof.vertices[term.vertex][i]);
    }
    holds = holds && weights >= proof.bound && std::ranges::all_of(rest, [](const Rational& c) { return c >= 0; });
  }
  CHECK(holds);
}

JointSpectralSubradius subradius_of(const MatrixFamily& family) {
  JointSpectralSubradius found = joint_spectral_subradius(family, {Deadline::in(20)});
  check_proofs(family, found);
  return found;
}

}  // namespace

TEST_CASE("the subradius of a pair is attained by a product of eight letters") {
  const MatrixFamily pair = slow_pair();
  const JointSpectralSubradius found = subradius_of(pair);
  CHECK(found.is_closed());
  CHECK(found.exact.is_yes());
  CHECK(found.product.word.size() == 8);
  const Rational width = *found.radius.upper - *found.radius.lower;
  CHECK(width < power(Rational(10), -40));
  CHECK(std::abs(found.radius.lower->convert_to<double>() - least_radius(pair, 8)) < 1e-12);
  // The order of products does not matter, and a factor is a factor.
  CHECK(subradius_of(transposed(pair)).radius.contains(*found.radius.lower + width / 2));
  for (const long exponent : {-400L, -3L, 5L, 400L}) {
    const Rational factor = power(Rational(2), exponent);
    const JointSpectralSubradius scaled = subradius_of(factor * pair);
    CHECK(scaled.exact.is_yes());
    CHECK(scaled.radius.contains(factor * (*found.radius.lower + width / 2)));
  }
}

TEST_CASE("subradii that are known") {
  // Each product has a power of one letter that grows like its length.
  const JointSpectralSubradius shears = subradius_of({matrix_of(2, {1, 1, 0, 1}), matrix_of(2, {1, 0, 1, 1})});
  CHECK(shears.radius.is_exact());
  CHECK(*shears.radius.lower == 1);
  CHECK(shears.exact.is_yes());
  // A product is nilpotent.
  const JointSpectralSubradius nilpotent = subradius_of({matrix_of(2, {0, 1, 0, 0}), matrix_of(2, {5, 0, 0, 0})});
  CHECK(*nilpotent.radius.upper == 0);
  CHECK(nilpotent.exact.is_yes());
  // Numbers: the least. The first vertex has a zero where the eigenvector has one.
  CHECK(*subradius_of({matrix_of(1, {3}), matrix_of(1, {Rational(2, 7)})}).radius.upper == Rational(2, 7));
  const JointSpectralSubradius lower = subradius_of(
      {matrix_of(2, {1, 1, 0, 1}), matrix_of(2, {Rational(4, 5), 0, Rational(4, 5), Rational(4, 5)})});
  CHECK(lower.radius.is_exact());
  CHECK(*lower.radius.lower == Rational(4, 5));
  // Pascal's rhombus modulo 2: an image lies on the boundary, which is explained by more vertices.
  const MatrixFamily rhombus{matrix_of(5, {0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 2, 1}),
                             matrix_of(5, {1, 0, 2, 0, 0, 0, 0, 0, 2, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0})};
  const JointSpectralSubradius found = subradius_of(rhombus);
  CHECK(found.exact.is_yes());
  CHECK(std::abs(found.radius.lower->convert_to<double>() - 1.6376300574539739) < 1e-12);
  // The image of the golden vector under the ones is above it, but not in the first coordinate.
  const JointSpectralSubradius golden = subradius_of({matrix_of(2, {1, 1, 1, 0}), matrix_of(2, {1, 1, 1, 1})});
  CHECK(golden.exact.is_yes());
  REQUIRE(golden.antinorm);
  CHECK(golden.antinorm->coincidences.size() == 1);
}

TEST_CASE("no product is slower than the subradius, and some product is as slow") {
  Random random;
  for (const auto k : rounds(40)) {
    const MatrixFamily family = random_family(random, 2, static_cast<std::size_t>(2 + k % 4), k % 6);
    const JointSpectralSubradius found = subradius_of(family);
    CAPTURE(found.radius.lower_text(), found.radius.upper_text());
    const double least = least_radius(family, 7);
    CHECK(found.radius.lower->convert_to<double>() <= least * (1 + 1e-12));
    CHECK(found.radius.upper->convert_to<double>() <= least * (1 + 1e-12));
  }
}

TEST_CASE("a subradius ends with a target or its time") {
  const MatrixFamily pair = slow_pair();
  const JointSpectralSubradius low = joint_spectral_subradius(pair, {Deadline::in(20)}, {Rational(2), {}});
  CHECK(*low.radius.lower >= 2);
  const JointSpectralSubradius high = joint_spectral_subradius(pair, {Deadline::in(20)}, {{}, Rational(7)});
  CHECK(*high.radius.upper <= 7);
  const JointSpectralSubradius none = joint_spectral_subradius(pair, {Deadline::in(0)});
  check_proofs(pair, none);
  CHECK(none.radius.is_bounded());
  CHECK_FALSE(none.exact.is_yes());
  const JointSpectralSubradius fine = joint_spectral_subradius(pair, {Deadline::in(20)}, {{}, {}, 1000});
  CHECK(*fine.radius.upper - *fine.radius.lower < power(Rational(10), -300));
  CHECK_THROWS_AS(joint_spectral_subradius({matrix_of(1, {-1})}, {Deadline::in(1)}), Error);
}

TEST_CASE("the antinorm of a point") {
  Random random;
  for ([[maybe_unused]] const auto k : rounds(200)) {
    subradius::AntinormProgram program(2);
    std::vector<polytope::Vector> vertices;
    for (int j = 0; j < 6; ++j) {
      vertices.push_back({static_cast<double>(random.integer(0, 9)), static_cast<double>(random.integer(1, 9))});
      program.add(vertices.back());
    }
    const polytope::Vector x{static_cast<double>(random.integer(0, 9)), static_cast<double>(random.integer(1, 9))};
    // The best of the combinations of one vertex, and of two that meet the point.
    double best = 0;
    for (const auto& v : vertices) {
      best = std::max(best, std::min(v[0] > 0 ? x[0] / v[0] : 1e9, x[1] / v[1]));
      for (const auto& w : vertices) {
        const double determinant = v[0] * w[1] - v[1] * w[0];
        if (determinant == 0) continue;
        const double a = (x[0] * w[1] - x[1] * w[0]) / determinant, b = (v[0] * x[1] - v[1] * x[0]) / determinant;
        if (a >= 0 && b >= 0) best = std::max(best, a + b);
      }
    }
    const subradius::Combination found = program.below(x, 1e9);
    CHECK(std::abs(found.value - best) < 1e-9);
    for (std::size_t i = 0; i < 2; ++i) {
      double sum = 0;
      for (const auto& [vertex, weight] : found.terms) sum += weight * vertices[vertex][i];
      CHECK(sum <= x[i] + 1e-9);
    }
  }
}

TEST_CASE("slow products are not missed") {
  Random random;
  for ([[maybe_unused]] const auto k : rounds(10)) {
    const MatrixFamily family = random_family(random, 2, 3, 3);
    const auto found = polytope::search_products(
        radius::to_search_family(family), {.max_length = 7, .width = 200, .budget = {Deadline::in(60)}, .least = true});
    CHECK(std::abs(found.front().radius - least_radius(family, 7)) < 1e-9);
  }
}
