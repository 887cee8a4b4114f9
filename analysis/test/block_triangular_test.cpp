#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/block_triangular.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <numeric>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

using Family = std::vector<RationalMatrix>;

/// A product of elementary integer matrices, and its inverse.
std::pair<RationalMatrix, RationalMatrix> random_unimodular(Random& random, std::size_t n) {
  RationalMatrix forward = RationalMatrix::identity(n), backward = forward;
  for (std::size_t k = 0; n > 1 && k < 3 * n; ++k) {
    const auto i = static_cast<std::size_t>(random.integer(0, static_cast<long>(n) - 1));
    const auto j = (i + static_cast<std::size_t>(random.integer(1, static_cast<long>(n) - 1))) % n;
    RationalMatrix step = RationalMatrix::identity(n), back = step;
    step(i, j) = random.integer(-2, 2);
    back(i, j) = -step(i, j);
    forward = forward * step;
    backward = back * backward;
  }
  return {forward, backward};
}

Family random_triangular(Random& random, const std::vector<std::size_t>& sizes, std::size_t count,
                         const Rational& scale = 1) {
  const std::size_t n = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  const auto [forward, backward] = random_unimodular(random, n);
  Family result;
  for (std::size_t t = 0; t < count; ++t) {
    RationalMatrix matrix(n, n);
    std::size_t start = 0;
    for (const std::size_t size : sizes) {
      for (std::size_t i = 0; i < start + size; ++i)
        for (std::size_t j = start; j < start + size; ++j)
          matrix(i, j) = scale * Rational(random.integer(-3, 3), random.integer(1, 2));
      start += size;
    }
    result.push_back(forward * matrix * backward);
  }
  return result;
}

void check_triangular(const Family& family, const BlockTriangular& blocks) {
  CHECK(std::accumulate(blocks.sizes.begin(), blocks.sizes.end(), std::size_t{0}) == family.front().rows());
  CHECK(kernel(blocks.basis).empty());
  for (std::size_t t = 0; t < family.size(); ++t) {
    CHECK(family[t] * blocks.basis == blocks.basis * blocks.triangular[t]);
    std::size_t start = 0;
    for (const std::size_t size : blocks.sizes) {
      for (std::size_t i = start + size; i < family.front().rows(); ++i)
        for (std::size_t j = start; j < start + size; ++j) CHECK(blocks.triangular[t](i, j) == 0);
      start += size;
    }
  }
}

std::vector<std::size_t> sorted(std::vector<std::size_t> sizes) {
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

}  // namespace

TEST_CASE("hidden blocks are found") {
  Random random;
  for (const auto i : rounds(40)) {
    std::vector<std::size_t> sizes;
    for (long k = random.integer(1, 4); k > 0; --k) sizes.push_back(static_cast<std::size_t>(random.integer(1, 4)));
    const Family family = random_triangular(random, sizes, static_cast<std::size_t>(random.integer(2, 3)));
    const BlockTriangular blocks = block_triangularise(family, Deadline::in(20));
    check_triangular(family, blocks);
    // Random blocks may be reducible themselves, so there may be more.
    CHECK(blocks.sizes.size() >= sizes.size());
    for (const Decision& decision : blocks.irreducible) CHECK(decision.is_yes());
  }
}

TEST_CASE("equal blocks, nilpotent families and what is reducible over the reals only") {
  Random random;
  for (const auto i : rounds(10)) {
    // Strictly triangular: all blocks are zeros of size 1.
    const auto [forward, backward] = random_unimodular(random, 5);
    Family nilpotent;
    for (int t = 0; t < 2; ++t) {
      RationalMatrix matrix(5, 5);
      for (std::size_t r = 0; r < 5; ++r)
        for (std::size_t c = r + 1; c < 5; ++c) matrix(r, c) = random.integer(-2, 2);
      nilpotent.push_back(forward * matrix * backward);
    }
    const BlockTriangular zeros = block_triangularise(nilpotent, Deadline::in(20));
    check_triangular(nilpotent, zeros);
    CHECK(zeros.sizes == std::vector<std::size_t>(5, 1));
    for (std::size_t k = 0; k < 5; ++k)
      for (const RationalMatrix& matrix : zeros.block(k)) CHECK(matrix(0, 0) == 0);
  }
  // One matrix: the blocks are those of its rational canonical form.
  RationalMatrix companion(4, 4);
  companion(0, 1) = companion(2, 3) = companion(0, 2) = 1;
  companion(1, 0) = companion(3, 2) = 2;
  const BlockTriangular twice = block_triangularise({companion}, Deadline::in(20));
  check_triangular({companion}, twice);
  CHECK(twice.sizes == std::vector<std::size_t>{2, 2});
  // sqrt(2) is not rational: irreducible over Q.
  CHECK(twice.irreducible[0].is_yes());
  CHECK(block_triangularise({RationalMatrix(3, 3)}, Deadline::in(5)).sizes == std::vector<std::size_t>(3, 1));
  CHECK(block_triangularise({RationalMatrix::identity(4)}, Deadline::in(5)).sizes == std::vector<std::size_t>(4, 1));
  CHECK_THROWS_AS(block_triangularise({}, Deadline::in(5)), Error);
  CHECK_THROWS_AS(block_triangularise({RationalMatrix(2, 3)}, Deadline::in(5)), Error);
}

TEST_CASE("transition matrices: irreducible ones, and masks with further factors") {
  const auto blocks_of = [](const std::string& text) {
    const Mask mask = make_scheme(text).mask.curve();
    const Family family = transition_matrices(divided_difference_scheme(mask, sum_rules(mask)));
    const BlockTriangular blocks = block_triangularise(family, Deadline::in(20));
    check_triangular(family, blocks);
    return blocks;
  };
  for (const char* text :
       {"primal:n=3", "primal:n=6", "dual:n=4", "dd:n=3", "four-point:w=1/20", "ary:a=3,points=4,d=3"}) {
    CAPTURE(text);
    const BlockTriangular blocks = blocks_of(text);
    CHECK(blocks.sizes.size() == 1);
    CHECK(blocks.irreducible[0].is_yes());
  }
  // Where p(z^a)/p(z) divides the symbol the multiples of p are an invariant subspace. Here p = (1 - z^4)/(1 - z):
  CHECK(blocks_of("mask:[1,0,0,0,1,0,0,0,1],arity=3").sizes.size() > 1);
  // and here p = 1 + z + z^2, of codimension 2.
  const LaurentPolynomial factor({1, -1, 1}, 0), rest({3, 5, 7, 5, 3}, 0);
  const Mask mask(
      LaurentPolynomial({1, 1}, 0).pow(2) * factor * rest * LaurentPolynomial(Rational(2) / (4 * factor(1) * rest(1))),
      2);
  const Family family = transition_matrices(divided_difference_scheme(mask, 2));
  const BlockTriangular blocks = block_triangularise(family, Deadline::in(20));
  check_triangular(family, blocks);
  CHECK(sorted(blocks.sizes) == std::vector<std::size_t>{2, 4});
}
