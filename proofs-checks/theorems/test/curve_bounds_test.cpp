#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/frequency/cell_recursion.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/proofs-checks/theorems/curve_bounds.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>

using namespace subcert;
using namespace subcert::theorems;
using subcert::frequency::HalfSymbol;

namespace {

double plain_number(const Rational& x) { return x.convert_to<double>(); }

/// |half the symbol| by its definition.
double modulus(const Mask& mask, double w) {
  double real = 0, imaginary = 0;
  for (long i = mask.symbol().lowest(); i <= mask.symbol().highest(); ++i) {
    const double a = plain_number(mask.symbol().coefficient(i)) / 2, angle = static_cast<double>(i) * w;
    real += a * std::cos(angle);
    imaginary += a * std::sin(angle);
  }
  return std::hypot(real, imaginary);
}

}  // namespace

TEST_CASE("suprema of a symbol hold at random frequencies and are near") {
  testing::Random random;
  for (const char* name : {"primal:n=3,d=3", "primal-odd:n=9,d=5", "dual:n=12,d=4", "dual-odd:n=2,d=1"}) {
    const Mask mask = make_scheme(name).mask.curve();
    const HalfSymbol symbol(mask, 128);
    for (const auto round : testing::rounds(10)) {
      const double low = 1e-3 * static_cast<double>(random.integer(0, 2000)), width = 0.4;
      const int count = 4;
      const auto suprema = symbol.suprema(Ball(Rational(low), 128), Ball(Rational(low + width), 128), count);
      REQUIRE(suprema.size() == count);
      for (int part = 0; part < count; ++part) {
        double plain = 0, alias = 0;
        for (int i = 0; i <= 400; ++i) {
          const double w = low + width * (part + i / 400.0) / count;
          plain = std::max(plain, modulus(mask, w));
          alias = std::max(alias, modulus(mask, w + M_PI));
        }
        CAPTURE(name, low, part);
        const auto& one = suprema[static_cast<std::size_t>(part)];
        CHECK(plain <= one.plain.middle() + 1e-12);
        CHECK(alias <= one.alias.middle() + 1e-12);
        CHECK(one.plain.middle() <= plain * 1.01 + 0.01);
        CHECK(one.alias.middle() <= alias * 1.01 + 0.01);
      }
    }
  }
}

TEST_CASE("values of a symbol next to 0 and elsewhere") {
  testing::Random random;
  for (const char* name : {"primal:n=1", "primal:n=3,d=3", "primal-odd:n=9,d=5", "dual:n=1", "dual:n=2,d=2",
                           "dual:n=12,d=4", "dual-odd:n=2,d=1", "primal:n=60,d=3", "dual:n=59,d=1"}) {
    const Mask mask = make_scheme(name).mask.curve();
    const HalfSymbol symbol(mask, 128);
    const LaurentPolynomial& all = mask.symbol();
    const Rational centre(all.lowest() + all.highest(), 2);
    for (const auto round : testing::rounds(10)) {
      // Angles times the reach on both sides of 4, where another formula takes over, and larger ones.
      const Rational w = Rational(random.integer(0, 2400), 100) / Rational(1 + symbol.reach());
      Ball sum(256);
      for (long i = all.lowest(); i <= all.highest(); ++i) {
        Ball cosine(256);
        arb_cos(cosine.get(), Ball(Rational((i - centre) * w), 256).get(), 256);
        sum += Ball(Rational(all.coefficient(i) / 2), 256) * cosine;
      }
      CAPTURE(name, to_text(w));
      const Enclosure value = symbol.value(Ball(w, 128)).enclosure(), exact = sum.enclosure();
      CHECK(*value.lower <= *exact.lower);
      CHECK(*value.upper >= *exact.upper);
      CHECK(*value.upper - *value.lower < power(Rational(2), -100));
    }
  }
}

TEST_CASE("exact means, values and slopes lie within the bounds of a scheme") {
  for (const char* name : {"primal:n=2,d=3", "primal:n=4,d=7", "primal:n=9,d=5", "primal-odd:n=2,d=3", "dual:n=1",
                           "dual:n=5,d=2", "dual-odd:n=3,d=4", "primal:n=18,d=5", "dual:n=17,d=3"}) {
    CAPTURE(name);
    const Mask mask = make_scheme(name).mask.curve();
    const VarianceGrid grid = variance_grid(mask, 4, true);
    const Rational mean = squared_l2_norm(mask);
    Rational before = -1;
    for (int cells : {1, 8, 32}) {
      CAPTURE(cells);
      const CurveBounds bounds = curve_bounds(mask, cells);
      if (!bounds.ripple.upper) continue;
      CHECK(bounds.mean.contains(mean));
      for (const Rational& value : grid.values) CHECK(abs(Rational(value - mean)) <= *bounds.ripple.upper);
      if (bounds.slope.upper) CHECK(grid.steepest() <= *bounds.slope.upper);
      // More cells are better.
      if (before >= 0) CHECK(*bounds.ripple.upper <= before);
      before = *bounds.ripple.upper;
    }
    CHECK(before > 0);
  }
}

TEST_CASE("schemes without the hypothesis have no bounds, and wrong masks are refused") {
  CHECK_FALSE(curve_bounds(make_scheme("primal:n=1").mask.curve(), 16).slope.upper);
  CHECK_FAILS(curve_bounds(make_scheme("mask:[3,4,3,2]/6").mask.curve(), 16), domain);
  CHECK_FAILS(curve_bounds(make_scheme("bspline:degree=2,a=3").mask.curve(), 16), domain);
  CHECK_FAILS(curve_bounds(make_scheme("primal:n=2").mask.curve(), 12), domain);
}
