#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/proofs-checks/theorems/limit_constant.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using namespace subcert::theorems;

namespace {

/// Coefficients of the Legendre polynomial P_l, by Bonnet's recurrence.
std::vector<Rational> legendre(int l) {
  std::vector<Rational> before{1}, now{0, 1};
  if (l == 0) return before;
  for (int k = 1; k < l; ++k) {
    std::vector<Rational> next(now.size() + 1, 0);
    for (std::size_t i = 0; i < now.size(); ++i) next[i + 1] += Rational(2 * k + 1, k + 1) * now[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= Rational(k, k + 1) * before[i];
    before = now;
    now = next;
  }
  return now;
}

Rational width(const Enclosure& e) { return *e.upper - *e.lower; }
bool overlap(const Enclosure& a, const Enclosure& b) { return *a.lower <= *b.upper && *b.lower <= *a.upper; }
bool lies_in(const Enclosure& inner, const Enclosure& outer) {
  return *outer.lower <= *inner.lower && *inner.upper <= *outer.upper;
}
Enclosure product(const Enclosure& a, const Enclosure& b) { return (Interval::of(a) * Interval::of(b)).enclosure(); }

/// The sum of (-1)^q moment(2q) s^2q / (2q)! with a bound of its remainder.
Enclosure transform_by_moments(int degree, const Rational& s, int terms) {
  Rational sum = 0, factor = 1;
  for (int q = 0; q < terms; ++q) {
    sum += factor * kernel_moment(degree, 2 * q);
    factor *= -s * s / ((2 * q + 1) * (2 * q + 2));
  }
  // |moment| <= sqrt(2 k_d(0)) <= 100 for these degrees; the terms left out are at most twice the first of them.
  const Rational rest = 200 * (factor < 0 ? Rational(-factor) : factor);
  return {sum - rest, sum + rest};
}

}  // namespace

TEST_CASE("moments of the Legendre kernel") {
  for (int degree : {0, 1, 2, 3, 4, 5, 7, 9, 12}) {
    CAPTURE(degree);
    for (int order = 0; order <= 2 * degree + 4; ++order) {
      Rational expected = 0;
      for (int l = 0; l <= degree; ++l) {
        const std::vector<Rational> p = legendre(l);
        Rational moment = 0;
        for (std::size_t i = 0; i < p.size(); ++i)
          if ((i + static_cast<std::size_t>(order)) % 2 == 0)
            moment += p[i] * Rational(2, static_cast<long>(i) + order + 1);
        expected += Rational(2 * l + 1, 2) * p.front() * moment;
      }
      CHECK(kernel_moment(degree, order) == expected);
      if (order <= degree) CHECK(kernel_moment(degree, order) == (order == 0 ? 1 : 0));
    }
  }
  CHECK(kernel_moment(1, 2) == Rational(1, 3));
  CHECK(kernel_moment(3, 4) == Rational(-3, 35));
}

TEST_CASE("the transform of the kernel agrees with its moments") {
  testing::Random random;
  for (int degree : {1, 3, 5, 9, 15})
    for (const auto round : testing::rounds(12)) {
      const Rational s = Rational(random.integer(-4000, 4000), random.integer(150, 300));
      CAPTURE(degree, s);
      const Enclosure direct = kernel_transform(degree, s, 25), series = transform_by_moments(degree, s, 90);
      REQUIRE(width(series) < power(Rational(10), -20));
      CHECK(overlap(direct, series));
      CHECK(width(direct) <= power(Rational(10), -25));
    }
  CHECK(kernel_transform(3, 0, 20).contains(1));
}

TEST_CASE("the limit function refines itself") {
  testing::Random random;
  for (int degree : {1, 3, 7})
    for (const auto round : testing::rounds(8)) {
      const Rational s = Rational(random.integer(1, 30000), random.integer(100, 900));
      CAPTURE(degree, s);
      CHECK(overlap(limit_transform(degree, 2 * s, 25),
                    product(kernel_transform(degree, s, 25), limit_transform(degree, s, 25))));
    }
  CHECK(limit_transform(5, 0, 20).contains(1));
}

TEST_CASE("the limit constants are nested with growing precision, and quadrature gives the same") {
  for (int degree : {1, 3, 5, 7, 9}) {
    CAPTURE(degree);
    std::optional<Enclosure> coarse;
    for (int digits : {3, 8, 15, 22, 30, 38}) {
      const Enclosure fine = limit_constant(degree, digits);
      CHECK(width(fine) <= power(Rational(10), -digits));
      if (coarse) CHECK(lies_in(fine, *coarse));
      coarse = fine;
    }
    for (int digits : {4, 14}) CHECK(overlap(limit_constant_by_quadrature(degree, digits), *coarse));
  }
}

TEST_CASE("even degrees have the constant of the next odd degree, and the constants grow with the degree") {
  CHECK(overlap(limit_constant(2, 20), limit_constant(3, 25)));
  CHECK(overlap(limit_constant(0, 20), limit_constant(1, 25)));
  for (int degree = 1; degree <= 19; degree += 2)
    CHECK(*limit_constant(degree, 8).upper < *limit_constant(degree + 2, 8).lower);
}

TEST_CASE("N times the exact mean tends to twice the constant like 1/N^2") {
  for (int degree : {1, 3, 5}) {
    const Rational twice = 2 * *limit_constant(degree, 25).lower;
    std::optional<Rational> before;
    for (int n : {10, 20, 40}) {
      CAPTURE(degree, n);
      const Rational mean = squared_l2_norm(
          make_scheme("primal:n=" + std::to_string(n) + ",d=" + std::to_string(degree)).mask.curve());
      const Rational N(4 * n - 1, 2), distance = N * mean - twice;
      CHECK(distance > 0);
      if (before) CHECK(distance < *before * Rational(3, 10));
      before = distance;
    }
  }
}

TEST_CASE("arguments outside the domain are refused") {
  CHECK_FAILS(limit_constant(-1, 10), domain);
  CHECK_FAILS(limit_constant(100, 10), domain);
  CHECK_FAILS(limit_constant(1, 0), domain);
  CHECK_FAILS(limit_constant(1, 101), domain);
  CHECK_FAILS(limit_constant_by_quadrature(1, 61), domain);
  CHECK_FAILS(kernel_transform(1, 1'000'001, 10), domain);
  CHECK_FAILS(kernel_moment(1, -1), domain);
}
