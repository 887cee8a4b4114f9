#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

RationalMatrix random_matrix(Random& random, std::size_t rows, std::size_t columns) {
  RationalMatrix m(rows, columns);
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) m(i, j) = random.rational();
  return m;
}

}  // namespace

TEST_CASE("a matrix is a zero of its characteristic polynomial") {
  Random random;
  for (const auto round : rounds(20)) {
    const auto n = static_cast<std::size_t>(random.integer(1, 5));
    const RationalMatrix m = random_matrix(random, n, n);
    const LaurentPolynomial p = characteristic_polynomial(m);
    CHECK(p.highest() == static_cast<long>(n));
    CHECK(p.coefficient(p.highest()) == 1);
    RationalMatrix value(n, n), power_of_m = RationalMatrix::identity(n);
    for (long k = 0; k <= static_cast<long>(n); ++k) {
      CHECK(power_of_m == power(m, k));
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) value(i, j) += p.coefficient(k) * power_of_m(i, j);
      power_of_m = power_of_m * m;
    }
    CHECK(value == RationalMatrix(n, n));
    CHECK(value_at(p, m) == RationalMatrix(n, n));
    // Numbers of many digits: det(x - f m) = f^n det(x/f - m).
    const Rational factor = power(Rational(10), random.integer(-60, 60));
    const LaurentPolynomial scaled = characteristic_polynomial(factor * m);
    for (long k = 0; k <= static_cast<long>(n); ++k)
      CHECK(scaled.coefficient(k) == power(factor, static_cast<long>(n) - k) * p.coefficient(k));
  }
  CHECK_FALSE(characteristic_polynomial(RationalMatrix::identity(3), Deadline::in(0)).has_value());
  CHECK_THROWS_AS(characteristic_polynomial(RationalMatrix(2, 3)), Error);
  CHECK_THROWS_AS(RationalMatrix(2, 3) * RationalMatrix(2, 3), Error);
}

TEST_CASE("the kernel is a kernel, and all of it") {
  Random random;
  for (const auto round : rounds(30)) {
    const auto n = static_cast<std::size_t>(random.integer(1, 5)),
               inner = static_cast<std::size_t>(random.integer(1, 4));
    const RationalMatrix m = random_matrix(random, n, inner) * random_matrix(random, inner, n);
    const auto basis = kernel(m);
    CHECK(basis.size() + std::min(n, inner) >= n);
    for (const auto& vector : basis)
      for (std::size_t i = 0; i < n; ++i) {
        Rational sum = 0;
        for (std::size_t j = 0; j < n; ++j) sum += m(i, j) * vector[j];
        CHECK(sum == 0);
      }
  }
  CHECK(kernel(RationalMatrix::identity(3)).empty());
  CHECK(kernel(RationalMatrix(2, 2)).size() == 2);
}

TEST_CASE("Jordan blocks and sizes") {
  RationalMatrix m = RationalMatrix::identity(5);
  m(0, 1) = m(1, 2) = 7;
  m(4, 4) = -3;
  CHECK(largest_jordan_block(m, LaurentPolynomial({-1, 1}, 0)) == 3);
  CHECK(largest_jordan_block(m, LaurentPolynomial({3, 1}, 0)) == 1);
  CHECK(largest_jordan_block(m, LaurentPolynomial({-2, 1}, 0)) == 0);
  CHECK(one_norm(m) == 8);
  CHECK(binary_exponent(m) == 2);
  CHECK(binary_exponent(power(Rational(10), -400)) == -1328);
  CHECK_FALSE(binary_exponent(RationalMatrix(2, 2)).has_value());
}

TEST_CASE("balls around values of polynomials, also of multiples of z") {
  Random random;
  for (const auto round : rounds(20)) {
    const LaurentPolynomial p({random.rational(), random.rational(), 1, random.rational()}, random.integer(0, 3));
    const RationalComplex z{random.rational(), random.rational()};
    RationalComplex value;
    for (long k = p.highest(); k >= 0; --k) value = value * z + RationalComplex{p.coefficient(k), 0};
    const ComplexBall ball = value_at(p, ball_around(z, 1024));
    CHECK(overlap(ball, ball_around(value, 2048)));
    CHECK((ball - ball_around(value, 2048)).real().enclosure().contains(0));
    if (!(value == RationalComplex{}))
      CHECK_FALSE(overlap(ball, ball_around((1 + power(Rational(10), -20)) * value, 2048)));
  }
}

TEST_CASE("the largest modulus of the zeros") {
  // Golden ratio: z^2 - z - 1.
  const Enclosure golden = largest_root_modulus(LaurentPolynomial({-1, -1, 1}, 0)).largest;
  CHECK(*golden.lower * *golden.lower <= *golden.lower + 1);
  CHECK(*golden.upper * *golden.upper >= *golden.upper + 1);
  CHECK(*golden.upper - *golden.lower < power(Rational(2), -60));
  for (const char* text :
       {"5831/4*z^2 + 833*z^3 - 1071/2*z^4 + 85*z^5 - 17/4*z^6",
        "14080/3*z^-2 + 13760/3*z^-1 - 2080 - 13000/3*z - 6725/3*z^2 - 2215/4*z^3 - 815/12*z^4 - 10/3*z^5"}) {
    const Enclosure largest = largest_root_modulus(LaurentPolynomial::parse(text)).largest;
    CHECK(*largest.upper - *largest.lower < *largest.lower * power(Rational(2), -64));
  }
  // A conjugate pair of modulus 2, a double zero, factors z.
  CHECK(largest_root_modulus(LaurentPolynomial({4, 0, 1}, 3)).largest.contains(2));
  CHECK(largest_root_modulus(LaurentPolynomial({9, -6, 1}, 0)).largest.is_exact());
  CHECK(*largest_root_modulus(LaurentPolynomial({-4, 0, 9}, 0)).largest.lower == Rational(2, 3));
  // 1 and a pair of modulus 1.
  CHECK_FALSE(largest_root_modulus(LaurentPolynomial({5, 6, 5}, 0) * LaurentPolynomial({-1, 1}, 0)).largest.is_exact());
  CHECK(largest_root_modulus(LaurentPolynomial({1, 1}, 0)).has_root_plus_or_minus_one);
  CHECK(largest_root_modulus(LaurentPolynomial::monomial(5, 4)).largest.contains(0));
  CHECK_THROWS_AS(largest_root_modulus(LaurentPolynomial()), Error);
}

TEST_CASE("characteristic polynomials that can be interrupted are the same") {
  Random random;
  for (const std::size_t n : {1, 7, 40}) {
    RationalMatrix m = random_matrix(random, n, n);
    for (std::size_t i = 0; i < n; ++i) m(i, (3 * i) % n) *= power(Rational(7), 150);
    CHECK(characteristic_polynomial(m, Deadline()) == characteristic_polynomial(m));
  }
}

TEST_CASE("moduli of zeros with a deadline are the same, or none") {
  Random random;
  std::vector<LaurentPolynomial> polynomials{LaurentPolynomial({5}, 2), LaurentPolynomial({9, -6, 1}, 0),
                                             LaurentPolynomial({4, 0, 1}, 3), LaurentPolynomial({-4, 0, 9}, 0),
                                             LaurentPolynomial({1, 0, 0, 1}, 0)};
  for ([[maybe_unused]] const auto round : rounds(12))
    polynomials.push_back(characteristic_polynomial(
        power(Rational(10), random.integer(-40, 40)) *
        random_matrix(random, 3 + static_cast<std::size_t>(round) / 2, 3 + static_cast<std::size_t>(round) / 2)));
  for (const LaurentPolynomial& p : polynomials)
    for (const int bits : {20, 200}) {
      CAPTURE(p.to_text(), bits);
      const RootModulus plain = largest_root_modulus(p, bits);
      const auto timed = largest_root_modulus(p, bits, Deadline());
      REQUIRE(timed);
      CHECK(timed->has_root_plus_or_minus_one == plain.has_root_plus_or_minus_one);
      if (bits > 100) CHECK(timed->largest.is_exact() == plain.largest.is_exact());
      CHECK(*timed->largest.lower <= *plain.largest.upper);
      CHECK(*timed->largest.upper >= *plain.largest.lower);
      CHECK(*timed->largest.upper - *timed->largest.lower <= *plain.largest.upper * power(Rational(2), -bits));
      if (p.length() > 1) CHECK_FALSE(largest_root_modulus(p, bits, Deadline::in(0)));
    }
  CHECK_THROWS_AS(largest_root_modulus(LaurentPolynomial(), 64, Deadline()), Error);
  // Small zeros near each other beside a large one ask for many bits.
  LaurentPolynomial slow({-power(Rational(10), 80), 1}, 0);
  for (long k = 1; k <= 20; ++k) slow = slow * LaurentPolynomial({-power(Rational(10), -40) - k, 1}, 0);
  const Stopwatch watch;
  const auto found = largest_root_modulus(slow, 64, Deadline::in(0.02));
  CHECK((!found || found->largest.contains(power(Rational(10), 80))));
  CHECK(watch.seconds() < 1);
}
