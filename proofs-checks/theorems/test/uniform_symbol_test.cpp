#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/proofs-checks/theorems/limit_constant.hpp>
#include <subcert/proofs-checks/theorems/uniform_curve.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>

using namespace subcert;
using namespace subcert::theorems;

namespace {

double number(const Rational& x) { return x.convert_to<double>(); }
double upper(const Ball& x) { return number(*x.enclosure().upper); }

/// A symmetric mask in floating point, from its exact coefficients with indices >= 0.
std::vector<double> half_of(const Mask& mask) {
  std::vector<double> result;
  for (long i = 0; i <= mask.symbol().highest(); ++i) result.push_back(number(mask.symbol().coefficient(i)));
  return result;
}

/// Half the symbol.
double symbol_half(const std::vector<double>& half, double w) {
  double sum = half[0] / 2;
  for (std::size_t i = 1; i < half.size(); ++i) sum += half[i] * std::cos(static_cast<double>(i) * w);
  return sum;
}

double limit_half(int degree, double v) { return number(*kernel_transform(degree, Rational(v), 15).lower); }

Mask scheme(int degree, int n) {
  return make_scheme("primal:n=" + std::to_string(n) + ",d=" + std::to_string(degree)).mask;
}

}  // namespace

TEST_CASE("coefficients of the kernels against exact masks") {
  for (int degree : {1, 3, 5}) {
    const int first = 24;
    const KernelCoefficients kappa = kernel_coefficients(degree, Rational(1, (2 * first - 1) * (2 * first - 1)), 128);
    for (int n : {24, 31}) {
      const Mask mask = scheme(degree, n);
      const int M = 2 * n - 1;  // even rule: a_x = sum of kappa_q x^2q / M^(2q+1)
      for (int x : {0, 2, 8, 2 * n - 2}) {
        Ball sum(128);
        for (std::size_t q = 0; q < kappa.value.size(); ++q)
          sum += kappa.value[q] * Ball(Rational(power(Rational(x), 2 * static_cast<long>(q)) /
                                                power(Rational(M), 2 * static_cast<long>(q) + 1)),
                                       128);
        CAPTURE(degree, n, x);
        CHECK(sum.enclosure().contains(mask.symbol().coefficient(x)));
      }
    }
  }
}

TEST_CASE("uniform bounds hold for single schemes at random frequencies") {
  testing::Random random;
  for (int degree : {1, 3, 5}) {
    const int first = degree == 5 ? 40 : 24;
    const UniformSymbol symbol(degree, first, 128);
    const double slope = upper(symbol.slope()), near = upper(symbol.disc_slope()),
                 disc = upper(symbol.disc_difference());
    for (int n : {first, first + 13, 3 * first}) {
      const std::vector<double> mask = half_of(scheme(degree, n));
      const double N = 2 * n - 0.5;
      for (const auto round : testing::rounds(20)) {
        const int octave = static_cast<int>(random.integer(0, 8)), part = static_cast<int>(random.integer(0, 15));
        const double v = std::ldexp(1 + (part + 1e-3 * static_cast<double>(random.integer(0, 1000))) / 16, octave);
        const double w = v / N;
        if (w > M_PI / 2) continue;
        CAPTURE(degree, n, v);
        const UniformSymbol::Cell cell = symbol.cell(octave, part);
        const double value = symbol_half(mask, w), limit = limit_half(degree, v);
        CHECK(std::abs(limit) <= upper(cell.transform) + 1e-9);
        CHECK(std::abs(value) <= upper(cell.factor) + 1e-9);
        CHECK(N * N * std::abs(value - limit) <= upper(cell.difference) + 1e-6);
        CHECK(std::abs(symbol_half(mask, M_PI - w)) <= w / std::sin(w) * slope / (2 * (2 * n - 1)) + 1e-9);

        const double small = 1e-3 * static_cast<double>(random.integer(100, 1000));
        const double power = std::pow(small, degree + 1), x = small / (2 * n);
        CHECK(std::abs(symbol_half(mask, M_PI - x)) <= near * power / (2 * (2 * n - 1)) + 1e-12);
        CHECK(N * N * std::abs(symbol_half(mask, small / N) - limit_half(degree, small)) <= disc * power + 1e-6);
      }
      // The decay of the symbol on the first shells.
      for (double w : {0.3, 0.7, 1.1, 1.5})
        CHECK(std::abs(symbol_half(mask, w)) * std::sin(w) * (2 * n - 1) <=
              upper(symbol.decay(Rational(static_cast<long>(w * (2 * first - 1))))) + 1e-9);
    }
  }
}

TEST_CASE("exact means lie within the uniform remainder") {
  for (int degree : {1, 3, 5}) {
    const int first = degree == 5 ? 40 : 24;
    const Rational remainder = *uniform_numbers(degree, first).mean.enclosure().upper;
    const Enclosure limit = limit_constant(degree, 30);
    for (int n : {first, first + 5}) {
      CAPTURE(degree, n);
      const Rational N(4 * n - 1, 2), mean = squared_l2_norm(scheme(degree, n));
      CHECK(mean - 2 * *limit.lower / N <= remainder / power(N, 3));
      CHECK(2 * *limit.upper / N - mean <= remainder / power(N, 3));
    }
  }
}

TEST_CASE("bounds of sums of derivatives of sinc") {
  const slong bits = 160;
  testing::Random random;
  for (const auto round : testing::rounds(20)) {
    std::vector<Ball> c;
    std::vector<double> plain;
    for (int k = 0; k < 5; ++k) {
      const Rational value(random.integer(-20, 20), random.integer(1, 9));
      c.emplace_back(value, bits);
      plain.push_back(number(value));
    }
    const SincSum sum(c);
    const Rational middle(random.integer(100, 6000), 100), width(random.integer(0, 30), 100);
    const SincTable table(Ball(middle, bits), sum.needs());
    const Rational point = middle + width * Rational(random.integer(-100, 100), 100);
    if (point < 1) continue;
    const SincTable exact(Ball(point, bits), 5);
    double value = 0;
    for (std::size_t k = 0; k < 5; ++k) value += plain[k] * number(*exact[k].enclosure().lower);
    CAPTURE(middle, width, point);
    const Enclosure over = sum.over(table, Ball(width, bits)).enclosure();
    CHECK(value >= number(*over.lower) - 1e-9);
    CHECK(value <= number(*over.upper) + 1e-9);
    CHECK(std::abs(value) * number(point) <= upper(sum.decay(Ball(point, bits))) + 1e-9);
    CHECK(std::abs(value) <= upper(sum.on_disc(Ball(8, bits))) + (point <= 8 ? 1e-9 : 1e9));
  }
}
