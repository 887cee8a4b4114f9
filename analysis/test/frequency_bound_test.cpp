#include <subcert/analysis/regularity/frequency/frequency_bound.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;

TEST_CASE(
    "a bound by frequencies lies below exponents that are proved otherwise, and more cells do not make it worse") {
  for (const char* name : {"primal:n=2", "primal:n=3,d=3", "dual:n=2", "dual-odd:n=2,d=2", "four-point:w=1/16",
                           "dd:n=3", "bspline:degree=3", "bspline:degree=2,a=3", "mask:[-1,0,9,16,9,0,-1]/16"}) {
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

TEST_CASE("random masks of any arity and symmetry: the bound is below the exponent") {
  testing::Random random;
  for (const auto round : testing::rounds(24)) {
    // sigma^k times a polynomial with the value that makes the coefficients sum to the arity.
    const int k = static_cast<int>(random.integer(1, 4)), arity = static_cast<int>(random.integer(2, 4));
    const Rational a(random.integer(-3, 3), 16), b(random.integer(-3, 3), 16), c(random.integer(-3, 3), 16);
    LaurentPolynomial symbol({b, a, Rational(1 - a - b - c), c}, 0);
    for (int i = 0; i < k; ++i)
      symbol = symbol *
               LaurentPolynomial(std::vector<Rational>(static_cast<std::size_t>(arity), Rational(1, arity)), 0);
    const Mask mask(symbol * LaurentPolynomial(arity), arity);
    CAPTURE(round, k, arity, to_text(a), to_text(b), to_text(c));
    const std::optional<FrequencyBound> bound = frequency_bound(mask, static_cast<int>(random.integer(1, 20)));
    const Enclosure exponent = holder_regularity(mask, 4, {Deadline::in(2)}).exponent;
    REQUIRE(bound);
    if (exponent.upper) CHECK(bound->exponent <= *exponent.upper);
    CHECK(bound->proof.bound > 1);
  }
}

TEST_CASE("one coefficient, and a difference scheme of few or of large ones") {
  const auto bound_of = [](const LaurentPolynomial& symbol, int arity) {
    return frequency_proof(Mask(symbol, arity), 4)->bound;
  };
  // The radius of A is A.
  CHECK(bound_of(LaurentPolynomial({2}, 0), 2) < Rational(2002, 1000));
  CHECK(bound_of(LaurentPolynomial({5}, 3), 5) < Rational(5005, 1000));
  CHECK(bound_of(LaurentPolynomial({1'000'000}, 0), 2) < 1'001'000);
  // That of 1 + z is 1.
  CHECK(bound_of(LaurentPolynomial({1, 1}, 0), 2) < Rational(11, 10));
}

TEST_CASE("without time there is no bound") {
  CHECK_FALSE(frequency_proof(make_scheme("primal:n=40").mask.curve(), 32, Deadline::in(0)));
}

TEST_CASE("what stays open gets its lower end from frequencies") {
  const HolderRegularity found = holder_regularity(make_scheme("primal:n=30").mask.curve(), 4, {Deadline::in(1)});
  CHECK(found.radius.method() == JsrMethod::frequencies);
  CHECK(*found.exponent.lower > Rational(1'999'990, 1'000'000));
  CHECK(*found.exponent.lower <= *found.exponent.upper);
  CHECK(found.radius.proved_upper() == *found.radius.radius.upper);
}

TEST_CASE("what has no bound by frequencies, and what is refused") {
  CHECK(frequency_bound(make_scheme("mask:[-2,1,6,1,-2]/2").mask.curve(), 32)->exponent < 0);  // diverges
  CHECK_FAILS(frequency_bound(make_scheme("primal:n=2").mask.curve(), 0), domain);
}
