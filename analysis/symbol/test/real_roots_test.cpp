#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/polynomials/root_cycles.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

/// z + 1/z - 2x: zero at z = e^{it} with cos t = x.
LaurentPolynomial pair_at(const Rational& cosine) { return LaurentPolynomial({1, -2 * cosine, 1}, -1); }

}  // namespace

TEST_CASE("real zeros are counted once each") {
  CHECK(count_real_roots(LaurentPolynomial({-2, 0, 1}, 0)) == 2);
  CHECK(count_real_roots(LaurentPolynomial({1, 0, 1}, 0)) == 0);
  CHECK(count_real_roots(LaurentPolynomial({1, -2, 1}, 1)) == 2);  // a double 1, and 0
  CHECK(count_real_roots(LaurentPolynomial(7)) == 0);
}

TEST_CASE("zeros between two numbers are those that were put there") {
  Random random;
  for (const auto i : rounds(200)) {
    const Rational low(random.integer(-20, 0), random.integer(1, 4)),
        high = low + Rational(random.integer(1, 40), random.integer(1, 4));
    LaurentPolynomial p(Rational(2 * random.integer(-3, 3) + 1));
    std::set<Rational> zeros;
    for (long k = random.integer(0, 5); k > 0; --k) {
      // At the ends, several times, and side by side too.
      const Rational zero = random.chance(10)                     ? low
                            : random.chance(10)                   ? high
                            : random.chance(30) && !zeros.empty() ? Rational(*zeros.begin() + Rational(1, 1000000))
                                                                  : Rational(random.integer(-30, 30), 8);
      zeros.insert(zero);
      p = p * LaurentPolynomial({-zero, 1}, 0).pow(static_cast<int>(random.integer(1, 3)));
    }
    // Two that are not real, near to the line.
    const Rational near(random.integer(-30, 30), 8);
    if (random.chance(50)) p = p * LaurentPolynomial({near * near + Rational(1, 1000000000), -2 * near, 1}, 0);
    const auto inside = std::ranges::count_if(zeros, [&](const Rational& z) { return low < z && z < high; });
    CAPTURE(i, low, high);
    CHECK(count_real_roots(p, low, high) == inside);
    CHECK(count_real_roots(p, low, high, Deadline()) == static_cast<int>(inside));
    CHECK(has_no_real_root(p, low, high) == (inside == 0 && !zeros.contains(low) && !zeros.contains(high)));
  }
  const LaurentPolynomial twice = LaurentPolynomial({-1, 3}, 0).pow(2);
  CHECK_FALSE(count_real_roots(twice, 0, 1, Deadline::in(0)));
  CHECK_FALSE(has_no_real_root(twice + LaurentPolynomial(Rational(1, 1000)), 0, 1, Deadline::in(0)));
  CHECK(has_no_real_root(twice + LaurentPolynomial(Rational(1, 1000)), 0, 1));
}

TEST_CASE("the largest real zero and its multiplicity") {
  Random random;
  for (const auto i : rounds(60)) {
    // (z - r)^k (z^2 - s)^l (z^2 + 1): r = +-s^(1/2) is avoided by s = 2, 3, 5.
    const Rational r(random.integer(-9, 9), random.integer(1, 3));
    const long square = random.chance(50) ? 2 : random.chance(50) ? 3 : 5;
    const int k = static_cast<int>(random.integer(1, 3)), l = static_cast<int>(random.integer(1, 3));
    const LaurentPolynomial p = LaurentPolynomial({-r, 1}, 0).pow(k) * LaurentPolynomial({-square, 0, 1}, 0).pow(l) *
                                LaurentPolynomial({1, 0, 1}, 0);
    const auto root = largest_real_root(p, 100);
    REQUIRE(root);
    if (r > 0 && r * r > square) {
      CHECK((root->value.is_exact() && *root->value.lower == r));
      CHECK(root->multiplicity == k);
    } else {
      CHECK(*root->value.lower * *root->value.lower < square);
      CHECK(*root->value.upper * *root->value.upper > square);
      CHECK(*root->value.upper - *root->value.lower < power(Rational(2), -98));
      CHECK(root->multiplicity == l);
    }
  }
  // Two zeros 10^-40 apart; no zero; zero itself.
  const LaurentPolynomial near = LaurentPolynomial({-2, 0, 1}, 0) *
                                 LaurentPolynomial({-2 - power(Rational(10), -40), 0, 1}, 0).pow(2);
  CHECK(largest_real_root(near, 20)->multiplicity == 2);
  CHECK_FALSE(largest_real_root(LaurentPolynomial({1, 0, 1}, 0)));
  CHECK(largest_real_root(LaurentPolynomial({1, 1}, 3))->multiplicity == 3);
  CHECK_THROWS_AS(largest_real_root(LaurentPolynomial()), Error);
}

TEST_CASE("zeros on the unit circle are decided, not sampled") {
  Random random;
  for (const auto i : rounds(60)) {
    // Off the circle: (z - r) and reciprocal pairs with |x| > 1.
    LaurentPolynomial p({-Rational(random.integer(2, 9)), 1}, random.integer(-3, 3));
    p *= pair_at(Rational(random.integer(4, 9), 3));
    CHECK_FALSE(has_root_on_unit_circle(p));
    CHECK(has_root_on_unit_circle(p * pair_at(Rational(random.integer(-5, 5), 6))));
    CHECK(has_root_on_unit_circle(p * LaurentPolynomial({1, random.chance(50) ? 1 : -1}, 0)));
  }
  // Zeros at a distance of 10^-9 from the circle are not on it.
  CHECK_FALSE(has_root_on_unit_circle(pair_at(1 + power(Rational(10), -18))));
  for (long order : {1, 2, 3, 7, 12, 105}) CHECK(has_root_on_unit_circle(cyclotomic(order)));
}

TEST_CASE("non-negativity on the unit circle") {
  Random random;
  for (const auto i : rounds(60)) {
    const LaurentPolynomial q = random.nonzero_polynomial(5);
    const LaurentPolynomial square = q * q.reversed();
    CHECK(is_nonnegative_on_unit_circle(square));
    CHECK_FALSE(is_nonnegative_on_unit_circle(-square));
    const LaurentPolynomial crossing = -pair_at(Rational(random.integer(-5, 5), 6));
    CHECK_FALSE(is_nonnegative_on_unit_circle(square * crossing));
    CHECK(is_nonnegative_on_unit_circle(square * crossing * crossing));
  }
  CHECK(is_nonnegative_on_unit_circle(LaurentPolynomial({1, 2, 1}, -1)));  // touches 0 at -1
  CHECK_FALSE(is_nonnegative_on_unit_circle(LaurentPolynomial({1, 2 - power(Rational(10), -20), 1}, -1)));
  CHECK(is_nonnegative_on_unit_circle(LaurentPolynomial()));
  CHECK_THROWS_AS(is_nonnegative_on_unit_circle(LaurentPolynomial({1, 2}, 0)), Error);
}

TEST_CASE("cyclotomic polynomials") {
  LaurentPolynomial product(1);
  for (long d : {1, 2, 3, 4, 6, 12}) product *= cyclotomic(d);
  CHECK(product == LaurentPolynomial::monomial(1, 12) - LaurentPolynomial(1));
  for (long n = 1; n <= 60; ++n) CHECK(cyclotomic(n).highest() == totient(n));
  CHECK_THROWS_AS(cyclotomic(0), Error);
  CHECK_THROWS_AS(totient(0), Error);
}

TEST_CASE("cycles of roots of unity are all that powers and conjugation lead to") {
  for (long a = 2; a <= 6; ++a)
    for (long most = 0; most <= 6; ++most) {
      CAPTURE(a, most);
      const auto cycles = root_cycles(a, most);
      REQUIRE(cycles);
      std::set<std::set<Rational>> found, expected;
      for (const RootCycle& cycle : *cycles) {
        std::set<Rational> turns;
        for (const long e : cycle.half)
          turns.insert({Rational(e, cycle.order), Rational(cycle.order - e, cycle.order)});
        CHECK(static_cast<long>(turns.size()) == cycle.size);
        CHECK(found.insert(turns).second);
      }
      for (long k = 2; k <= static_cast<long>(std::pow(a, 3)) + 1; ++k)
        for (long e = 1; e < k; ++e) {
          if (std::gcd(k, a) != 1 || std::gcd(k, e) != 1) continue;
          std::set<Rational> turns;
          for (long x = e; turns.insert(Rational(x, k)).second; x = a * x % k) turns.insert(Rational(k - x, k));
          if (static_cast<long>(turns.size()) <= most) expected.insert(turns);
        }
      CHECK(found == expected);
    }
  CHECK_FALSE(root_cycles(2, 44));
  CHECK_THROWS_AS(root_cycles(1, 2), Error);
}
