// Joint spectral radii whose answer is known without a search, and families on which searches once lost their footing.
#include <subcert/analysis/radii/joint/closed_orbit.hpp>
#include <subcert/analysis/radii/joint/cost.hpp>
#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/radii/joint/one_block.hpp>
#include <subcert/analysis/radii/joint/p_radius.hpp>
#include <subcert/analysis/radii/joint/rounds.hpp>
#include <subcert/analysis/radii/joint/similarity.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

#include <algorithm>
#include <array>
#include <set>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

RationalMatrix of_rows(const std::vector<std::vector<Rational>>& rows) {
  RationalMatrix result(rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j) result(i, j) = rows[i][j];
  return result;
}

RationalMatrix random_matrix(Random& random, std::size_t n, long most, long denominator = 1) {
  RationalMatrix result(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) result(i, j) = Rational(random.integer(-most, most), denominator);
  return result;
}

JointSpectralRadius radius_of(const MatrixFamily& family, double seconds = 10) {
  JointSpectralRadius result = joint_spectral_radius(family, {Deadline::in(seconds)});
  sharpen(result, family, default_bits, Deadline::in(seconds));
  return result;
}

bool contains(const Enclosure& radius, const Rational& value) {
  return *radius.lower <= value && value <= *radius.upper;
}

void check_exact(const MatrixFamily& family, const Enclosure& expected) {
  const JointSpectralRadius found = radius_of(family);
  CAPTURE(found.exact.reason, found.radius.lower->convert_to<double>(), found.radius.upper->convert_to<double>());
  CHECK(found.exact.is_yes());
  CHECK(found.is_closed());
  CHECK(*found.radius.lower <= *expected.upper);
  CHECK(*found.radius.upper >= *expected.lower);
  CHECK(found.proved_upper() >= *expected.lower);
}

/// The largest modulus of an eigenvalue.
Enclosure spectral_radius(const RationalMatrix& m) {
  return largest_root_modulus(characteristic_polynomial(m)).largest;
}

using Four = std::array<int, 4>;

Four product(const Four& a, const Four& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}
Four negative(Four a) {
  for (int& x : a) x = -x;
  return a;
}

/// One of each class of pairs of matrices of size 2 with entries -1, 0, 1, up to order, signs, transposition and
/// similarity by signed permutations.
std::vector<std::pair<Four, Four>> classes_of_pairs() {
  std::vector<Four> all;
  for (int k = 0; k < 81; ++k) all.push_back({k % 3 - 1, k / 3 % 3 - 1, k / 9 % 3 - 1, k / 27 - 1});
  std::vector<std::pair<Four, Four>> similarities;
  for (const int s : {1, -1})
    for (const int t : {1, -1}) {
      similarities.push_back({{s, 0, 0, t}, {s, 0, 0, t}});
      similarities.push_back({{0, s, t, 0}, {0, t, s, 0}});
    }
  std::set<std::pair<Four, Four>> seen;
  std::vector<std::pair<Four, Four>> classes;
  for (const Four& a : all)
    for (const Four& b : all) {
      if (seen.contains({a, b})) continue;
      classes.emplace_back(a, b);
      for (const auto& [map, inverse] : similarities) {
        Four x = product(product(map, a), inverse), y = product(product(map, b), inverse);
        for (int k = 0; k < 2; ++k) {
          for (const Four& u : {x, negative(x)})
            for (const Four& v : {y, negative(y)}) {
              seen.insert({u, v});
              seen.insert({v, u});
            }
          std::swap(x[1], x[2]);
          std::swap(y[1], y[2]);
        }
      }
    }
  return classes;
}

/// The family in a basis whose vectors have nearly the same direction: products of shears by such numbers.
MatrixFamily badly_conditioned(Random& random, const MatrixFamily& family, long shear) {
  const std::size_t n = family.size();
  RationalMatrix basis = RationalMatrix::identity(n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(random.integer(0, static_cast<long>(n) - 1));
    RationalMatrix step = RationalMatrix::identity(n);
    step((i + 1 + k % (n - 1)) % n, i) = random.integer(shear / 2, shear);
    basis = basis * step;
  }
  std::vector<RationalMatrix> moved;
  for (const RationalMatrix& m : family) moved.push_back(solve(basis, m * basis));
  return moved;
}

RationalMatrix to_matrix(const Four& a) { return of_rows({{a[0], a[1]}, {a[2], a[3]}}); }

}  // namespace

TEST_CASE("the radius of one matrix is that of its characteristic polynomial") {
  Random random;
  for (const auto round : rounds(24)) {
    const auto n = static_cast<std::size_t>(round % 12 + 1);
    RationalMatrix m = random.chance(50) ? random_matrix(random, n, 5) : random_matrix(random, n, 1000000, 1000000);
    if (random.chance(30)) m = m * transposed(m);
    check_exact({m}, spectral_radius(m));
  }
}

TEST_CASE("the radius of one matrix, of special kinds") {
  const std::vector<RationalMatrix> matrices{
      of_rows({{0, 0}, {0, 0}}),
      of_rows({{0, 1, 2}, {0, 0, 3}, {0, 0, 0}}),
      of_rows({{2, 1, 0}, {0, 2, 1}, {0, 0, 2}}),
      of_rows({{0, -1, 1, 0}, {1, 0, 0, 1}, {0, 0, 0, -1}, {0, 0, 1, 0}}),
      of_rows({{0, -1}, {1, 1}}),
      of_rows({{Rational(3, 5), Rational(-4, 5)}, {Rational(4, 5), Rational(3, 5)}}),
      of_rows({{0, 0, 0, -1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}}),
      of_rows({{0, 0, 2}, {1, 0, 0}, {0, 1, 0}}),
      of_rows({{1, 1}, {1, -1}}),
      of_rows({{2, 0, 0}, {0, 0, -2}, {0, 2, 0}}),
      of_rows({{0, 0, 0, -9}, {1, 0, 0, 1}, {0, 1, 0, -1}, {0, 0, 1, Rational(1, 3)}}),
      of_rows({{1000, 1}, {1, 1000}}),
      of_rows({{Rational(288526, 1000000), Rational(-144024, 1000000)},
               {Rational(21767, 1000000), Rational(897103, 1000000)}}),
  };
  for (const RationalMatrix& m : matrices) check_exact({m}, spectral_radius(m));
}

TEST_CASE("the radius of one matrix needs no budget") {
  Random random;
  const auto check = [&](const MatrixFamily& family) {
    const JointSpectralRadius found = joint_spectral_radius(family, {Deadline::in(0)});
    const Enclosure expected = spectral_radius(family[0]);
    CHECK(found.exact.is_yes());
    CHECK(*found.radius.lower <= *expected.upper);
    CHECK(*found.radius.upper >= *expected.lower);
    CHECK(*found.radius.upper - *found.radius.lower <= *expected.upper * power(Rational(10), -15));
  };
  for (const std::size_t n : {2, 9, 27}) {
    const RationalMatrix small = random_matrix(random, n, 9);
    RationalMatrix large = power(Rational(10), 40) * small, mixed = small;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        large(i, j) += random.integer(-99, 99);
        if (random.chance(50)) mixed(i, j) = small(i, j) * power(Rational(10), -40);
      }
    for (const RationalMatrix& m : {small, large, mixed}) {
      check({m});
      check({m, Rational(-1) * m, m});
    }
  }
  // Blocks of equal radii, turned by a matrix of determinant 1.
  const RationalMatrix blocks = of_rows({{0, -1, 2, 3}, {1, 1, 4, 5}, {0, 0, 0, 1}, {0, 0, -1, 0}}),
                       turn = of_rows({{1, 2, 0, 1}, {0, 1, 3, 0}, {0, 0, 1, 2}, {0, 0, 0, 1}});
  check({turn * blocks * solve(turn, RationalMatrix::identity(4))});
  check({of_rows({{0, 1}, {0, 0}})});
}

TEST_CASE("times of zeros grow with their number, their digits and what is between them") {
  const auto with_zeros = [](long count, const Rational& least, const Rational& most) {
    LaurentPolynomial p({-most, 1}, 0);
    for (long k = 1; k < count; ++k) p = p * LaurentPolynomial({-least * k, 1}, 0);
    return p;
  };
  const Rational large = power(Rational(10), 60);
  const Deadline second = Deadline::in(1);
  CHECK(radius::has_time_for_roots(with_zeros(15, 1, 20), second));
  CHECK_FALSE(radius::has_time_for_roots(with_zeros(150, 1, 200), second));
  // The same digits, but zeros that are all as large, and zeros that are not.
  CHECK(radius::has_time_for_roots(with_zeros(15, large, 20 * large), second));
  CHECK_FALSE(radius::has_time_for_roots(with_zeros(15, 1 / large, 20 * large), second));
  CHECK_FALSE(radius::has_time_for_roots(with_zeros(15, 1 / large, 20 * large).reversed().shifted(15), second));
  CHECK(radius::has_time_for_roots(with_zeros(15, 1 / large, 20 * large), Deadline()));
  CHECK(radius::has_time_for_roots(LaurentPolynomial({5}, 3), second));
}

TEST_CASE("what is proved of a product stays with a better bound from elsewhere") {
  const MatrixFamily family{of_rows({{2, 0}, {0, 1}}), of_rows({{0, 1}, {1, 0}})};
  JointSpectralRadius by_product, by_bound;
  by_product.product = prove_product(family, {0}, Deadline());
  by_product.radius = {*by_product.product.radius.lower, Rational(5)};
  by_product.proof = NormProof{1, 5};
  by_bound.product = prove_product(family, {1}, Deadline());
  by_bound.radius = {*by_bound.product.radius.lower, Rational(3)};
  by_bound.proof = NormProof{1, 3};
  const auto better = [&](const JointSpectralRadius& a, const JointSpectralRadius& b) {
    return radius::better_of(a, b, family, Deadline());
  };
  for (const auto& both : {better(by_product, by_bound), better(by_bound, by_product)}) {
    CHECK(both.product.word == std::vector{0});
    CHECK(both.radius.lower == by_product.radius.lower);
    CHECK(both.radius.upper == 3);
    CHECK(both.proved_upper() == 3);
  }
  by_product.exact = {Truth::yes, "known"};
  CHECK(better(by_bound, by_product).proved_upper() == 5);
  CHECK(better(by_product, by_bound).proved_upper() == 5);
}

TEST_CASE("a product that another search found is that of the block that has it") {
  // Blocks of size 2 on the diagonal: 0 1 has the largest radius in the second, 1 in the first.
  const MatrixFamily family{of_rows({{1, 1, 5, 0}, {0, 1, 0, 0}, {0, 0, 0, 2}, {0, 0, 1, 0}}),
                            of_rows({{1, 0, 0, 0}, {1, 1, 0, 7}, {0, 0, 1, 0}, {0, 0, 0, 3}})};
  BlockTriangular triangular = block_triangularise(family, Deadline());
  REQUIRE(triangular.sizes == std::vector<std::size_t>{2, 2});
  JointSpectralRadius by_blocks, by_norms;
  BlockProof proof{triangular, {}, 0};
  for (std::size_t k = 0; k < 2; ++k) {
    JointSpectralRadius block;
    block.product = prove_product(triangular.block(k), {0}, Deadline());
    block.radius = {*block.product.radius.lower, Rational(4)};
    block.proof = NormProof{1, 4};
    proof.blocks.push_back(block);
  }
  by_blocks.product = proof.blocks[0].product;
  by_blocks.radius = proof.blocks[0].radius;
  by_blocks.proof = proof;
  by_norms.proof = NormProof{1, 9};
  for (const std::vector<int>& word : {std::vector{0}, std::vector{1}, std::vector{0, 1}}) {
    by_norms.product = prove_product(family, word, Deadline());
    by_norms.radius = {*by_norms.product.radius.lower, Rational(9)};
    const JointSpectralRadius both = radius::better_of(by_norms, by_blocks, family, Deadline());
    REQUIRE(both.by_blocks());
    const JointSpectralRadius& leader = both.by_blocks()->blocks[both.by_blocks()->leading];
    CHECK(both.radius.upper == 4);
    CHECK(both.product.word == leader.product.word);
    CHECK(both.radius.lower == leader.radius.lower);
    const Rational larger = std::max(*by_norms.radius.lower, *by_blocks.radius.lower);
    CHECK(*both.radius.lower >= larger * (1 - power(Rational(2), -60)));
    // The other way round, what is proved of a block is proved of the family.
    by_norms.radius.upper = 3;
    const JointSpectralRadius whole = radius::better_of(by_norms, by_blocks, family, Deadline());
    CHECK(whole.radius.upper == 3);
    CHECK(*whole.radius.lower >= larger * (1 - power(Rational(2), -60)));
    CHECK(whole.product.radius.lower == prove_product(family, whole.product.word).radius.lower);
  }
}

TEST_CASE("families that commute have the largest of their spectral radii") {
  const RationalMatrix a = of_rows({{1, -1}, {1, 4}}), zero(2, 2);
  const Enclosure radius = spectral_radius(a);
  check_exact({a, zero}, radius);
  check_exact({a, a}, radius);
  check_exact({a, Rational(-1) * a}, radius);
  check_exact({a, Rational(1, 10) * (a * a), zero, power(a, 3)}, spectral_radius(power(a, 3)));
  check_exact({of_rows({{1, 1}, {1, 0}}), of_rows({{-1, -1}, {-1, 0}})}, spectral_radius(of_rows({{1, 1}, {1, 0}})));
  check_exact({of_rows({{0, -2}, {-1, 0}}), of_rows({{-2, 0}, {0, -2}})}, Enclosure::exactly(2));
  Random random;
  for ([[maybe_unused]] const auto round : rounds(6)) {
    const RationalMatrix m = random_matrix(random, static_cast<std::size_t>(random.integer(2, 5)), 4);
    RationalMatrix shifted = m;
    for (std::size_t i = 0; i < m.rows(); ++i) shifted(i, i) += 1;
    const Enclosure first = spectral_radius(m), second = spectral_radius(shifted);
    check_exact({m, shifted}, {std::max(*first.lower, *second.lower), std::max(*first.upper, *second.upper)});
  }
}

TEST_CASE("all classes of pairs of matrices of size 2 with entries -1, 0, 1 are exact") {
  const auto classes = classes_of_pairs();
  REQUIRE(classes.size() == 197);  // with that of two zeros
  int ones = 0;
  for (const auto& [a, b] : classes) {
    const MatrixFamily family{to_matrix(a), to_matrix(b)};
    const JointSpectralRadius found = radius_of(family, 2);
    CAPTURE(a, b, found.exact.reason);
    CHECK(found.exact.is_yes());
    CHECK(found.is_closed());
    CHECK(*found.radius.lower >= std::max(*spectral_radius(family[0]).lower, *spectral_radius(family[1]).lower));
    ones += found.radius.is_exact() && *found.radius.lower == 1 ? 1 : 0;
  }
  CHECK(ones > 50);
}

TEST_CASE("no product of random integer families has a larger radius than the family") {
  Random random;
  for ([[maybe_unused]] const auto round : rounds(12)) {
    const auto n = static_cast<std::size_t>(random.integer(2, 4));
    std::vector<RationalMatrix> matrices;
    for (long k = random.integer(1, 3); k >= 0; --k)
      matrices.push_back(random_matrix(random, n, random.chance(50) ? 1 : 3));
    const MatrixFamily family(matrices);
    const JointSpectralRadius found = radius_of(family, 0.5);
    for (int k = 0; k < 8; ++k) {
      std::vector<int> word;
      for (long letters = random.integer(1, 6); letters > 0; --letters)
        word.push_back(static_cast<int>(random.integer(0, static_cast<long>(family.count()) - 1)));
      const Rational power_of_radius = *spectral_radius(family.product(word)).lower;
      CHECK(power_of_radius <= power(*found.radius.upper, static_cast<long>(word.size())));
    }
  }
}

TEST_CASE("the radius of a multiple is the multiple of the radius, whatever its size") {
  const MatrixFamily family{of_rows({{1, 1, 0}, {-1, 0, -1}, {1, 0, 0}}), of_rows({{1, 0, -1}, {1, -1, 0}, {0, 1, 0}})};
  const JointSpectralRadius found = radius_of(family, 5);
  REQUIRE(found.exact.is_yes());
  for (const Rational& factor : {power(Rational(10), -100), power(Rational(10), 160),
                                 Rational(1, 3) * power(Rational(2), 70), power(Rational(7), -120)}) {
    const JointSpectralRadius other = radius_of(factor * family, 5);
    CHECK(other.exact.is_yes());
    CHECK(*other.radius.lower <= factor * *found.radius.upper);
    CHECK(*other.radius.upper >= factor * *found.radius.lower);
    CHECK(other.proved_upper() >= factor * *found.radius.lower);
    CHECK(other.proved_upper() <= factor * *found.radius.upper * (1 + power(Rational(10), -12)));
    // Numbers are as short as before.
    const MatrixFamily in_units = 1 / radius::unit_of(factor * family) * (factor * family);
    for (const RationalMatrix& m : in_units) CHECK(one_norm(m) <= 8);
    CHECK(common_denominator(in_units) <= 8);
  }
}

TEST_CASE("the golden ratio is found through badly conditioned coordinates") {
  // Similar to [1,1;0,1] and [1,0;1,1] by [1,1;1,1+e] for small e, nearly.
  const Enclosure golden = spectral_radius(of_rows({{1, 1}, {1, 0}}));
  for (const long digits : {6, 12}) {
    const Rational t = power(Rational(10), digits);
    const MatrixFamily family{of_rows({{1 - t, t}, {-t, 1 + t}}), of_rows({{2 + t, -t}, {t + 2 + 1 / t, -t}})};
    const JointSpectralRadius found = radius_of(family, 5);
    CAPTURE(digits, found.exact.reason);
    CHECK(*found.radius.lower <= *golden.upper);
    CHECK(*found.radius.upper >= *golden.lower);
    CHECK(found.exact.is_yes());
  }
}

TEST_CASE("badly conditioned coordinates change no radius") {
  Random random;
  for ([[maybe_unused]] const auto round : rounds(6)) {
    const auto n = static_cast<std::size_t>(random.integer(2, 4));
    const MatrixFamily family{random_matrix(random, n, 3), random_matrix(random, n, 3)};
    const JointSpectralRadius plain = radius_of(family, 3);
    if (!plain.exact.is_yes()) continue;
    const JointSpectralRadius found = radius_of(badly_conditioned(random, family, 100000000), 3);
    CAPTURE(n, found.exact.reason);
    CHECK(found.exact.is_yes());
    CHECK(*found.radius.lower <= *plain.radius.upper);
    CHECK(*found.radius.upper >= *plain.radius.lower);
    CHECK(found.proved_upper() <= *plain.radius.upper * (1 + power(Rational(10), -9)));
  }
}

TEST_CASE("opposite matrices count once") {
  Random random;
  for ([[maybe_unused]] const auto round : rounds(6)) {
    const auto n = static_cast<std::size_t>(random.integer(2, 4));
    const RationalMatrix a = random_matrix(random, n, 4), b = random_matrix(random, n, 4);
    const JointSpectralRadius plain = radius_of({a, b}, 2),
                              found = radius_of({a, Rational(-1) * b, Rational(-1) * a, b, a}, 2);
    CAPTURE(n, found.exact.reason);
    if (plain.exact.is_yes()) CHECK(found.exact.is_yes());
    CHECK(*found.radius.lower <= *plain.radius.upper);
    CHECK(*found.radius.upper >= *plain.radius.lower);
  }
}

TEST_CASE("products are told apart that doubles take for equal") {
  Random random;
  const Rational more = 1 + power(Rational(10), -60);
  for ([[maybe_unused]] const auto round : rounds(4)) {
    const RationalMatrix m = random_matrix(random, static_cast<std::size_t>(random.integer(2, 3)), 5);
    const MatrixFamily family{m, more * m, Rational(-1) * m};
    const auto evidence = [&](const std::vector<int>& word) { return prove_product(family, word); };
    if (*evidence({0}).radius.lower == 0) continue;
    const auto dominates = [&](const std::vector<int>& above, const std::vector<int>& below) {
      return radius::is_dominated(family, evidence(above), family, evidence(below), {});
    };
    CHECK(dominates({0}, {2}));
    CHECK(dominates({2}, {0, 2, 2}));
    CHECK_FALSE(dominates({0}, {1}));
    CHECK_FALSE(dominates({0, 2}, {1, 0}));
    // They commute: whatever is called exact is the largest of them.
    const JointSpectralRadius found = radius_of(family, 0.3);
    if (found.exact.is_yes()) CHECK(std::ranges::all_of(found.product.word, [](int letter) { return letter == 1; }));
  }
  // sqrt(3) exp(+-i pi/6) and +-sqrt(3): squared moduli are compared.
  const MatrixFamily turns{of_rows({{1, 1}, {-1, 2}}), of_rows({{0, 3}, {1, 0}}), more * of_rows({{0, 3}, {1, 0}})};
  const auto first = prove_product(turns, {0}), second = prove_product(turns, {1}), larger = prove_product(turns, {2});
  CHECK(radius::is_dominated(turns, first, turns, second, {}));
  CHECK(radius::is_dominated(turns, second, turns, first, {}));
  CHECK(radius::is_dominated(turns, larger, turns, first, {}));
  CHECK_FALSE(radius::is_dominated(turns, first, turns, larger, {}));
  const MatrixFamily complex{of_rows({{1, -2}, {2, 1}}), of_rows({{2, -1}, {1, 2}})};  // both of modulus sqrt(5)
  CHECK(complex.product({0, 1}) == complex.product({1, 0}));
  check_exact(complex, root_enclosure(Rational(5), 2));
  check_exact({Rational(1, 2) * complex[0], complex[0], complex[1]}, root_enclosure(Rational(5), 2));
}

TEST_CASE("a rational eigenvalue is called the radius only where it is the largest") {
  const Rational more = 1 + power(Rational(10), -30);
  for (const RationalMatrix& m :
       {of_rows({{1, 0}, {0, more}}), of_rows({{more, 0}, {0, 1}}), of_rows({{1, 0}, {0, -more}})}) {
    const auto exact = prove_product({m}, {0}).exact;
    CHECK((!exact || *exact == more));
  }
}

TEST_CASE("eigenvalues close together are told as exactly as others") {
  const RationalMatrix turn = of_rows({{2, 1, 0}, {1, 1, 0}, {0, 1, 1}}),
                       back = solve(turn, RationalMatrix::identity(3));
  for (const int digits : {15, 20, 30, 45}) {
    const Rational more = 1 + power(Rational(10), -digits);
    const RationalMatrix m = turn * of_rows({{more, 1, 0}, {0, 1, 3}, {0, 0, Rational(1, 2)}}) * back;
    const Rational near = std::min(abs(prove_product({m}, {0}).eigenvalue.re - more),
                                   abs(prove_product({m}, {0}).eigenvalue.re - 1));
    CHECK(near < power(Rational(10), -48));
    CHECK(*prove_product({m}, {0}).radius.lower > 1 - power(Rational(10), -10 - digits / 2));
  }
}

TEST_CASE("what does not commute is not taken for the largest of its matrices") {
  // No polytope closes with the radius, which is that of the product of both.
  const JointSpectralRadius found = radius_of({of_rows({{1, 1}, {0, 1}}), Rational(4, 5) * of_rows({{1, 0}, {1, 1}})},
                                              1);
  CHECK(*found.radius.lower > Rational(1447, 1000));
  CHECK(*found.radius.upper < Rational(1448, 1000));
}

TEST_CASE("orbits of rational vectors close only where the product attains the radius, and where they span") {
  const auto orbit = [](const Rational& back) {
    return radius::closed_orbit({of_rows({{1, 0}, {0, 0}}), of_rows({{0, back}, {1, 0}})}, {{0}}, {Deadline::in(5)});
  };
  const auto closed = orbit(1);
  REQUIRE(closed);
  CHECK((closed->power == 1 && closed->length == 1));
  CHECK(orbit(1 - power(Rational(10), -12)));
  // Products of two letters grow then, which doubles do not see.
  CHECK_FALSE(orbit(1 + power(Rational(10), -12)));
  // The orbit of the first product is one vector, whatever the others do.
  CHECK_FALSE(radius::closed_orbit({of_rows({{1, 0}, {0, 0}}), of_rows({{0, 0}, {0, 2}})}, {{0}}, {Deadline::in(5)}));
  // Square roots: the orbit is that of products of two letters.
  const auto root = radius::closed_orbit({of_rows({{1, 1}, {1, -1}})}, {{0}}, {Deadline::in(5)});
  REQUIRE(root);
  CHECK((root->power == 2 && root->length == 2));
  REQUIRE((root->proof && root->proof->attained));
  CHECK(root->proof->bound * root->proof->bound < 2 + power(Rational(10), -30));
  CHECK(root->proof->attained->cycles.front().letters == std::vector<int>{0, 0});
  // The eigenvalue of the first product is sqrt(3) times a root of unity, that of the second one -27.
  const std::vector<int> second{1, 1, 1, 1, 1, 0};
  const auto turned = radius::closed_orbit({of_rows({{1, 1}, {1, 0}}), of_rows({{1, 1}, {-1, 2}})}, {{1}, second},
                                           {Deadline::in(5)});
  REQUIRE((turned && turned->proof && turned->proof->attained));
  CHECK((turned->power == 3 && turned->length == 2 && turned->word == second));
  CHECK(power(turned->proof->attained->number.point.re, 2) ==
        power(Rational(3), static_cast<long>(turned->proof->attained->number.length)));
}

TEST_CASE("the p-radius of triangular families is the largest of their diagonals") {
  const MatrixFamily family{of_rows({{1, 5, 7}, {0, -2, 1}, {0, 0, Rational(1, 2)}}),
                            of_rows({{-3, 1, 0}, {0, 1, 4}, {0, 0, 2}})};
  for (const int p : {1, 2, 3, 64}) {
    REQUIRE(has_p_radius(family, p));
    const auto found = p_radius(family, p, default_bits, Deadline::in(5));
    REQUIRE(found);
    const Rational mean = (1 + power(Rational(3), p)) / 2;
    CHECK(power(*found->radius.lower, p) <= mean);
    CHECK(power(*found->radius.upper, p) >= mean);
  }
  // Whatever the basis: the same family in another one, for an even power.
  const RationalMatrix basis = of_rows({{1, 2, 0}, {1, 3, 1}, {0, 1, 2}});
  std::vector<RationalMatrix> moved;
  for (const RationalMatrix& m : family) moved.push_back(solve(basis, m * basis));
  const auto found = p_radius(MatrixFamily(moved), 40, default_bits, Deadline::in(5));
  REQUIRE(found);
  CHECK(found->size == 1);
  CHECK(contains({power(*found->radius.lower, 40), power(*found->radius.upper, 40)}, (1 + power(Rational(3), 40)) / 2));
}
