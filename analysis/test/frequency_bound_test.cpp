#include <subcert/analysis/regularity/frequency/frequency_bound.hpp>
#include <subcert/analysis/regularity/frequency/half_symbol.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>

using namespace subcert;

TEST_CASE(
    "a bound by frequencies lies below exponents that are proved otherwise, and more cells do not make it worse") {
  for (const char* name : {"primal:n=2", "primal:n=3,d=3", "dual:n=2", "dual-odd:n=2,d=2", "four-point:w=1/16",
                           "dd:n=3", "bspline:degree=3", "mask:[1,4,6,4,1]/8", "mask:[-1,0,9,16,9,0,-1]/16"}) {
    CAPTURE(name);
    const Mask mask = make_scheme(name).mask.curve();
    const Enclosure exponent = holder_regularity(mask, 4, {}).exponent;
    Rational before = -100;
    for (int cells : {8, 32, 128}) {
      const std::optional<FrequencyBound> bound = frequency_bound(mask, cells);
      if (!bound) continue;
      CAPTURE(cells, to_decimal(bound->exponent, 8, Rounding::down));
      CHECK(bound->exponent <= *exponent.upper);
      CHECK(bound->exponent >= before - Rational(1, 100));  // the excess has three digits
      before = bound->exponent;
    }
    CHECK(before > 0);
  }
}

TEST_CASE("random symmetric masks: the bound is below the exponent, the ratio at pi below its bound") {
  testing::Random random;
  for (const auto round : testing::rounds(12)) {
    // (1 + z)^k times a symmetric polynomial with the value that makes the coefficients sum to 2.
    const int k = static_cast<int>(random.integer(2, 4));
    const Rational a(random.integer(-3, 3), 16), b(random.integer(-3, 3), 16);
    LaurentPolynomial symbol({b, a, Rational(1 - 2 * a - 2 * b), a, b}, 0);
    for (int i = 0; i < k; ++i) symbol = symbol * LaurentPolynomial({Rational(1, 2), Rational(1, 2)}, 0);
    const Mask mask(symbol * LaurentPolynomial(2), 2);
    CAPTURE(k, to_text(a), to_text(b));
    const frequency::HalfSymbol half(mask, 128);
    CHECK(half.sum_rules() >= k);
    const double end = frequency::HalfSymbol::near_pi / half.reach();
    for (int i = 1; i <= 8; ++i) {
      const double high = end * i / 8, low = high * 0.9;
      const Ball bound = half.alias_ratio(Ball(Rational(low), 128), Ball(Rational(high), 128));
      const Ball w(Rational((low + high) / 2), 128);
      CHECK(abs(half.value(w + Ball::pi(128)))
                .is_at_most(bound * w.pow(half.sum_rules()) + Ball(Rational(1, 1'000'000'000), 128)));
    }
    const std::optional<FrequencyBound> bound = frequency_bound(mask, 32);
    const Enclosure exponent = holder_regularity(mask, 4, {Deadline::in(2)}).exponent;
    if (bound && exponent.upper) CHECK(bound->exponent <= *exponent.upper);
  }
}

TEST_CASE("what has no bound by frequencies, and what is refused") {
  CHECK_FALSE(frequency_bound(make_scheme("mask:[-2,1,6,1,-2]/2").mask.curve(), 32));  // diverges
  CHECK_FAILS(frequency_bound(make_scheme("mask:[3,4,3,2]/6").mask.curve(), 32), domain);
  CHECK_FAILS(frequency_bound(make_scheme("bspline:degree=2,a=3").mask.curve(), 32), domain);
  CHECK_FAILS(frequency_bound(make_scheme("primal:n=2").mask.curve(), 12), domain);
}
