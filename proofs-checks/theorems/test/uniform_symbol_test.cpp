#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/proofs-checks/theorems/limit_constant.hpp>
#include <subcert/proofs-checks/theorems/scheme_family.hpp>
#include <subcert/proofs-checks/theorems/uniform_curve.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>

using namespace subcert;
using namespace subcert::theorems;

namespace {

double number(const Rational& x) { return x.convert_to<double>(); }
double upper(const Ball& x) { return number(*x.enclosure().upper); }

Mask scheme_of(const char* family, int n, int degree) {
  return make_scheme(scheme_family(family).scheme(n, degree)).mask.curve();
}

/// Half the symbol without its phase, from the centre of a symmetric mask.
double symbol_half(const Mask& mask, double w, bool alias) {
  const double centre = static_cast<double>(mask.symbol().lowest() + mask.symbol().highest()) / 2;
  double real = 0, imaginary = 0;
  for (long i = mask.symbol().lowest(); i <= mask.symbol().highest(); ++i) {
    const double a = number(mask.symbol().coefficient(i)) / 2, angle = (static_cast<double>(i) - centre) * w;
    const double sign = alias && i % 2 != 0 ? -1 : 1;
    real += sign * a * std::cos(angle);
    imaginary += sign * a * std::sin(angle);
  }
  return alias ? std::hypot(real, imaginary) : real;
}

double limit_half(int degree, double v) { return number(*kernel_transform(degree, Rational(v), 15).lower); }

struct Case {
  const char* family;
  int degree, first;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> list{{"primal", 1, 24}, {"primal", 3, 28},     {"primal", 5, 40},
                                      {"primal", 9, 96}, {"primal-odd", 3, 24}, {"dual", 1, 48},
                                      {"dual", 2, 40},   {"dual", 3, 40},       {"dual-odd", 4, 64}};
  return list;
}

}  // namespace

TEST_CASE("coefficients of the kernels against exact masks") {
  for (int degree : {1, 3, 5, 9}) {
    const int first = 24;
    const KernelCoefficients kernel = kernel_parts(degree, 0, Rational(1, (2 * first - 1) * (2 * first - 1)), 128).even;
    for (int n : {24, 31}) {
      const Mask mask = scheme_of("primal", n, degree);
      const int M = 2 * n - 1;  // even rule: a_x = the sum of omega_l P_l(x/M), divided by M
      for (int x : {0, 2, 8, 2 * n - 2}) {
        Rational before = 1, now(x, M);
        Ball sum = kernel.value[0] + Ball(now, 128) * kernel.value[1];
        for (std::size_t l = 2; l < kernel.value.size(); ++l) {
          const auto k = static_cast<long>(l);
          const Rational next = (Rational(2 * k - 1, k) * Rational(x, M)) * now - Rational(k - 1, k) * before;
          before = now;
          now = next;
          sum += kernel.value[l] * Ball(now, 128);
        }
        CAPTURE(degree, n, x);
        CHECK((sum / M).enclosure().contains(mask.symbol().coefficient(x)));
      }
    }
  }
}

TEST_CASE("uniform bounds hold for single schemes at random frequencies") {
  testing::Random random;
  for (const Case& one : cases()) {
    const SchemeFamily& family = scheme_family(one.family);
    const bool dual = family.evaluation == Evaluation::dual;
    const int degree = one.degree, first = one.first;
    const UniformSymbol symbol(family.evaluation, degree, family.size(first), 128);
    const double slope = upper(symbol.slope());
    const UniformSymbol::Disc near = symbol.disc_slope(degree + 1), disc = symbol.disc_difference();
    for (int n : {first, first + 13, 3 * first}) {
      const Mask mask = scheme_of(one.family, n, degree);
      const double N = number(family.size(n)), fewest = dual ? N : N - 0.5, most = dual ? N : N + 0.5;
      for (const auto round : testing::rounds(20)) {
        const int octave = static_cast<int>(random.integer(0, 8)), part = static_cast<int>(random.integer(0, 15));
        const double v = std::ldexp(1 + (part + 1e-3 * static_cast<double>(random.integer(0, 1000))) / 16, octave);
        const double w = v / N;
        if (w > M_PI / 2) continue;
        CAPTURE(one.family, degree, n, v);
        const UniformSymbol::Cell cell = symbol.cell(octave, part);
        const double value = symbol_half(mask, w, false), limit = limit_half(degree, v);
        CHECK(std::abs(limit) <= upper(cell.transform) + 1e-9);
        CHECK(std::abs(value) <=
              std::max(upper(cell.factor), upper(cell.transform + cell.difference / Ball(Rational(N * N), 128))) +
                  1e-9);
        CHECK(N * N * std::abs(value - limit) <= upper(cell.difference) + 1e-6);
        CHECK(symbol_half(mask, w, true) <= w / std::sin(w) * slope / (2 * fewest) + 1e-9);

        const double small = 1e-3 * static_cast<double>(random.integer(100, 1000));
        const double power = std::pow(small, degree + 1);
        CHECK(symbol_half(mask, small / most, true) <= upper(near.bound) * power / (2 * fewest) + 1e-12);
        const double wide = small * static_cast<double>(disc.radius);
        CHECK(N * N * std::abs(symbol_half(mask, wide / N, false) - limit_half(degree, wide)) <=
              upper(disc.bound) * std::pow(wide, degree + 1) + 1e-6);
      }
      // The decay of the symbol on the first shells.
      for (double w : {0.3, 0.7, 1.1, 1.5})
        CHECK(std::abs(symbol_half(mask, w, false)) * std::sin(w) * fewest <=
              upper(symbol.decay(Rational(static_cast<long>(w * (2 * first - 1))))) + 1e-9);
    }
  }
}

TEST_CASE("exact means lie within the uniform remainder") {
  for (const Case& one : cases()) {
    if (one.first > 48) continue;
    const SchemeFamily& family = scheme_family(one.family);
    const UniformNumbers& numbers = uniform_numbers(family.evaluation, one.degree, family.size(one.first));
    const Rational remainder = *numbers.mean(numbers.difference_disc.bound).enclosure().upper;
    const Enclosure limit = limit_constant(one.degree, 30);
    for (int n : {one.first, one.first + 5}) {
      CAPTURE(one.family, one.degree, n);
      const Rational N = family.size(n), mean = squared_l2_norm(scheme_of(one.family, n, one.degree));
      CHECK(mean - 2 * *limit.lower / N <= remainder / power(N, 3));
      CHECK(2 * *limit.upper / N - mean <= remainder / power(N, 3));
      // A bound a quarter as large would be wrong.
      CHECK(abs(Rational(mean - 2 * *limit.lower / N)) > remainder / power(N, 3) / 8);
    }
  }
}

TEST_CASE("bounds of sums of spherical Bessel functions") {
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
    const BesselSum sum(c);
    const Rational middle(random.integer(100, 6000), 100), width(random.integer(0, 30), 100);
    const BesselTable table(Ball(middle, bits), sum.needs());
    const Rational point = middle + width * Rational(random.integer(-100, 100), 100);
    if (point < 1) continue;
    const BesselTable exact(Ball(point, bits), 6);
    double value = 0, derivative = 0;
    const auto j = [&](std::size_t l) { return number(*exact[l].enclosure().lower); };
    for (std::size_t k = 0; k < 5; ++k) {
      const double l = static_cast<double>(k);
      value += plain[k] * j(k);
      derivative += plain[k] * ((k > 0 ? j(k - 1) : -j(1)) - (k > 0 ? (l + 1) / number(point) * j(k) : 0));
    }
    CAPTURE(middle, width, point);
    const Enclosure over = sum.over(table, Ball(width, bits)).enclosure();
    CHECK(value >= number(*over.lower) - 1e-9);
    CHECK(value <= number(*over.upper) + 1e-9);
    const BesselSum steep = sum.derivative();
    const Enclosure slope = steep.over(BesselTable(Ball(middle, bits), steep.needs()), Ball(width, bits)).enclosure();
    CHECK(derivative >= number(*slope.lower) - 1e-9);
    CHECK(derivative <= number(*slope.upper) + 1e-9);
    CHECK(std::abs(value) * number(point) <= upper(sum.decay(Ball(point, bits))) + 1e-9);
    CHECK(std::abs(value) <= upper(sum.on_disc(Ball(64, bits))) + 1e-9);
  }
}
