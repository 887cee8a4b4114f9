// Enclosures of eigenpairs by balls, and products that are proved by them, next to what exact algebra says.
#include <subcert/analysis/radii/joint/cost.hpp>
#include <subcert/analysis/radii/joint/product.hpp>
#include <subcert/analysis/symbol/matrices/ball_matrix.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

#include <algorithm>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

RationalMatrix diagonal(const std::vector<Rational>& entries) {
  RationalMatrix result(entries.size(), entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) result(i, i) = entries[i];
  return result;
}

/// The same matrix in other coordinates, by shears.
RationalMatrix sheared(RationalMatrix matrix, Random& random, long most) {
  const std::size_t n = matrix.rows();
  for (std::size_t k = 0; k + 1 < n; ++k)
    for (const bool up : {true, false}) {
      RationalMatrix there = RationalMatrix::identity(n), back = there;
      const std::size_t i = up ? k : k + 1, j = up ? k + 1 : k;
      const Rational factor = random.integer(-most, most);
      there(i, j) = factor;
      back(i, j) = -factor;
      matrix = there * matrix * back;
    }
  return matrix;
}

Rational upper(const Ball& ball) { return *ball.enclosure().upper; }

/// Of the image less the multiple.
bool may_be_eigenvector(const RationalMatrix& matrix, const EigenpairEnclosure& pair) {
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    ComplexBall sum = pair.value * pair.vector[i] * Ball(-1L, 320);
    for (std::size_t j = 0; j < matrix.rows(); ++j) sum += pair.vector[j] * Ball(matrix(i, j), 320);
    if (!contains_zero(sum)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a simple eigenpair is enclosed, next to any approximation of it") {
  Random random;
  for (const auto round : rounds(30)) {
    const std::size_t n = 1 + static_cast<std::size_t>(round) % 9;
    const Rational scale = power(Rational(10), random.integer(-60, 60));
    std::vector<Rational> eigenvalues;
    for (std::size_t i = 0; i < n; ++i)
      eigenvalues.push_back(scale * (Rational(3 * static_cast<long>(i)) + Rational(random.integer(0, 6), 7)));
    // Eigenvalues of very skew coordinates are so small beside the entries that another one may be as near, or
    // none is reached.
    const bool skew = round % 4 == 3;
    const RationalMatrix matrix = sheared(diagonal(eigenvalues), random, skew ? 20 : 2);
    const Rational& meant = eigenvalues[static_cast<std::size_t>(random.integer(0, static_cast<long>(n) - 1))];
    for (const Rational& off : {Rational(0), power(Rational(2), -100), Rational(1, 1000)}) {
      const auto pair = enclose_eigenpair(matrix, RationalComplex{meant + scale * off, 0}, 320);
      if (skew && !pair) continue;
      REQUIRE(pair);
      CHECK(may_be_eigenvector(matrix, *pair));
      CHECK(acb_is_real(pair->value.get()) != 0);
      CHECK(upper(abs(pair->value - pair->value)) <= scale * power(Rational(2), -150));
      CHECK(std::ranges::count_if(eigenvalues, [&](const Rational& x) {
              return (skew || x == meant) && pair->value.real().enclosure().contains(x);
            }) == 1);
    }
  }
}

TEST_CASE("eigenpairs that are not real, and vectors as approximations") {
  // (x^2 - 2x + 5)(x - 1): 1 + 2i.
  Random random;
  RationalMatrix turn(3, 3);
  turn(0, 0) = turn(1, 1) = turn(2, 2) = 1;
  turn(0, 1) = -2;
  turn(1, 0) = 2;
  const RationalMatrix matrix = sheared(turn, random, 5);
  const auto pair = enclose_eigenpair(matrix, RationalComplex{Rational(9, 10), Rational(21, 10)}, 320);
  REQUIRE(pair);
  CHECK(may_be_eigenvector(matrix, *pair));
  CHECK(pair->value.real().enclosure().contains(1));
  CHECK(imaginary_part(pair->value).enclosure().contains(2));
  ComplexVector near;
  for (const ComplexBall& entry : pair->vector) {
    near.push_back(exact_middle(entry));
    near.back().re += Rational(1, 1'000'000);
  }
  const auto again = enclose_eigenpair(matrix, near, 320);
  REQUIRE(again);
  CHECK(overlap(again->value, pair->value));
  CHECK(upper(abs(again->value - pair->value)) < power(Rational(2), -200));
}

TEST_CASE("a multiple eigenvalue isolates no eigenpair") {
  Random random;
  RationalMatrix jordan = diagonal({2, 2, 1});
  CHECK_FALSE(enclose_eigenpair(sheared(jordan, random, 3), RationalComplex{Rational(2001, 1000), 0}, 320));
  jordan(0, 1) = 1;
  CHECK_FALSE(enclose_eigenpair(sheared(jordan, random, 3), RationalComplex{Rational(2001, 1000), 0}, 320));
  CHECK_FALSE(enclose_eigenpair(jordan, RationalComplex{2, 0}, 320));
  CHECK_FALSE(enclose_eigenpair(RationalMatrix(2, 2), RationalComplex{0, 0}, 320));
}

TEST_CASE("products with long polynomials have the radius that their eigenvalues say") {
  // Small shears of 40 numbers, over a long denominator.
  Random random;
  const std::size_t n = 40;
  const Rational unit = 1 / (power(Rational(7), 120) + 2);
  for (const bool rational : {false, true}) {
    CAPTURE(rational);
    std::vector<Rational> eigenvalues;
    for (std::size_t i = 0; i < n; ++i) eigenvalues.push_back(Rational(static_cast<long>(i), 40) + unit);
    RationalMatrix m = diagonal(eigenvalues);
    if (rational) {
      m(n - 1, n - 1) = Rational(3, 2);
    } else {
      // x^2 - 2.
      m(n - 1, n - 1) = m(n - 2, n - 2) = 0;
      m(n - 1, n - 2) = 2;
      m(n - 2, n - 1) = 1;
      m(0, 0) = 0;
    }
    m = sheared(std::move(m), random, 2);
    REQUIRE(radius::has_long_characteristic(m));
    const ProductEvidence found = prove_product({m}, {0});
    if (rational) {
      CHECK(found.exact == Rational(3, 2));
    } else {
      CHECK(found.radius.lower);
      CHECK(*found.radius.lower * *found.radius.lower <= 2);
      CHECK(*found.radius.upper * *found.radius.upper >= 2);
      CHECK(*found.radius.upper - *found.radius.lower < power(Rational(2), -150));
      CHECK_FALSE(found.exact);
    }
  }
}

TEST_CASE("two eigenvalues that are one in doubles are told apart") {
  for (const int digits : {3, 39, 60, 100}) {
    CAPTURE(digits);
    // 1 +- 10^-digits sqrt 2, about a zero of the derivative.
    RationalMatrix m = RationalMatrix::identity(2);
    m(0, 1) = 2;
    m(1, 0) = power(Rational(10), -2 * digits);
    const ProductEvidence found = prove_product({m}, {0});
    const Rational more = *found.radius.lower - 1;
    CHECK(more > (digits < 60 ? Rational(0) : -power(Rational(2), -190)));
    CHECK((more < 0 || more * more <= 2 * m(1, 0)));
    CHECK(found.eigenvalue.re != 1);
  }
}
