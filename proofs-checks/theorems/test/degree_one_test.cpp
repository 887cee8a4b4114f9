#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/proofs-checks/theorems/degree_one.hpp>
#include <subcert/proofs-checks/theorems/proofs.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>

using namespace subcert;
using namespace subcert::theorems;

namespace {

Mask scheme(int n) { return make_scheme("primal:n=" + std::to_string(n)).mask.curve(); }
Rational absolute(const Rational& x) { return x < 0 ? Rational(-x) : x; }

double symbol_half(int n, double w) {
  double sum = 1.0 / (2 * n - 1);
  for (int j = 1; j <= 2 * n - 1; ++j) sum += 2 * std::cos(j * w) / (j % 2 == 0 ? 2 * n - 1 : 2 * n);
  return sum / 2;
}

double transform(int n, double xi) {
  double result = 1;
  for (int j = 1; j <= 40; ++j) result *= symbol_half(n, std::ldexp(xi, -j));
  return std::abs(result);
}

/// By the closed form, fast.
double symbol_half_closed(int n, double w) {
  const double sine = std::sin(w);
  if (std::abs(sine) < 1e-12) return std::cos(w) > 0 ? 1 : 0;
  return (std::sin(2 * n * w) / (2 * n) + std::sin((2 * n - 1) * w) / (2 * n - 1)) / (2 * sine);
}

double transform_closed(int n, double xi) {
  double result = 1;
  for (int j = 1; j <= 45; ++j) result *= symbol_half_closed(n, std::ldexp(xi, -j));
  return result;
}

double to_double(const Rational& x) { return x.convert_to<double>(); }

}  // namespace

TEST_CASE("the supremum of |cos x - sinc x|") {
  const Enclosure kappa = cosine_minus_sinc_supremum();
  CHECK(*kappa.upper - *kappa.lower < power(Rational(10), -20));
  double largest = 0;
  for (int i = 1; i <= 200000; ++i) {
    const double x = i * 1e-4;
    largest = std::max(largest, std::abs(std::cos(x) - std::sin(x) / x));
  }
  CHECK(largest <= to_double(*kappa.upper) + 1e-12);
  CHECK(largest >= to_double(*kappa.lower) - 1e-7);
}

TEST_CASE("the shells bound the transform of phi_n and its aliases") {
  testing::Random random;
  for (int n : {2, 3, 5, 9}) {
    const DegreeOneBounds bounds = degree_one_bounds(n);
    REQUIRE(bounds.u0.upper);
    const double u0 = to_double(*bounds.u0.upper);
    for (std::size_t j = 0; j < 7; ++j)
      for (const auto round : testing::rounds(6)) {
        const double xi = std::ldexp(M_PI, -static_cast<int>(j)) *
                          (0.5 + 0.5e-3 * static_cast<double>(random.integer(1, 1000)));
        CAPTURE(n, j, xi);
        CHECK(std::abs(symbol_half(n, xi / 2)) <= to_double(*bounds.x[j].upper) + 1e-12);
        CHECK(std::abs(symbol_half(n, xi / 2 + M_PI)) <= to_double(*bounds.e[j].upper) + 1e-12);
        CHECK(transform(n, xi) <= to_double(*bounds.big_x[j].upper) + 1e-12);
        double aliases = 0, weighted = 0;
        for (int k = 1; k <= 300; ++k)
          for (const double frequency : {xi + 2 * M_PI * k, xi - 2 * M_PI * k}) {
            aliases += transform(n, frequency);
            weighted += std::abs(frequency) * transform(n, frequency);
          }
        CHECK(aliases <= u0 * to_double(*bounds.big_y[j].upper) + 1e-9);
        if (bounds.v0.upper)
          CHECK(weighted <= to_double(*bounds.v0.upper) * to_double(*bounds.big_z[j].upper) *
                                    std::ldexp(M_PI, -static_cast<int>(j)) +
                                1e-9);
      }
  }
}

TEST_CASE("exact values of psi_n and its slope lie within the ripple and slope bounds") {
  for (int n : {2, 3, 4, 5, 6, 8, 12, 16}) {
    CAPTURE(n);
    const DegreeOneBounds bounds = degree_one_bounds(n);
    const VarianceGrid grid = variance_grid(scheme(n), 5, true);
    const Rational mean = squared_l2_norm(scheme(n));
    REQUIRE(bounds.ripple.is_bounded());
    CHECK(bounds.slope.is_bounded() == (n >= 3));
    for (const Rational& value : grid.values) CHECK(absolute(value - mean) <= *bounds.ripple.lower);
    if (bounds.slope.upper) {
      for (const Rational& slope : grid.slopes) CHECK(absolute(slope) <= *bounds.slope.lower);
      CHECK(grid.steepest() <= *bounds.slope.lower);
    }
    const Enclosure maximum = degree_one_maximum(n);
    CHECK(maximum.contains(grid.largest()));
  }
}

TEST_CASE("exact means lie within the expansion with its proved remainder") {
  CHECK(degree_one_second_coefficient() == Rational(13, 36));
  for (int n = 2; n <= 44; ++n) {
    CAPTURE(n);
    const DegreeOneMean mean = degree_one_mean(n);
    const Rational exact = squared_l2_norm(scheme(n));
    CHECK(mean.mean.contains(exact));
    // What the two terms leave is about a quarter of the leading term over N^4.
    const Rational N(4 * n - 1, 2);
    const Rational rest = (exact - *mean.leading.lower - *mean.next.lower) * power(N, 4) / *mean.leading.lower;
    CHECK(rest > Rational(6, 25));
    CHECK(rest < Rational(3, 10));
  }
}

TEST_CASE("the proved remainder excludes a second coefficient that is wrong by one part in a hundred") {
  const int n = 132;
  const DegreeOneMean mean = degree_one_mean(n);
  const Rational exact = squared_l2_norm(scheme(n));
  CHECK(mean.mean.contains(exact));
  for (int sign : {-1, 1}) {
    const Rational shift = *mean.next.upper * sign / 100;
    CHECK_FALSE(mean.mean.contains(exact + shift));
  }
}

TEST_CASE("the first Fourier coefficient of psi_n, scaled, tends to its limit for n = 3, 11, 43, ...") {
  const double limit = first_harmonic().middle();
  double before = 1;
  for (int n : {3, 11, 43, 171}) {
    const double N = 2 * n - 0.5;
    const int steps = static_cast<int>(20 * N);
    const double step = M_PI / steps;
    double sum = 0;
    for (int i = -steps; i <= steps; ++i)
      sum += (std::abs(i) == steps ? 0.5 : 1) * transform_closed(n, i * step) *
             transform_closed(n, 2 * M_PI - i * step);
    const double error = std::abs(N * N * std::abs(sum * step / transform_closed(n, M_PI)) - limit);
    CAPTURE(n, error);
    CHECK(error < 0.6 * std::log2(N) / N);
    CHECK(error < before);
    before = error;
  }
}

TEST_CASE("sizes outside the domain are refused") {
  CHECK_FAILS(degree_one_bounds(1), domain);
  CHECK_FAILS(degree_one_mean(1'000'001), domain);
}
