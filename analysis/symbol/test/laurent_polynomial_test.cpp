#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

TEST_CASE("ring laws, canonical after every operation") {
  Random random;
  for (const auto i : rounds(200)) {
    const LaurentPolynomial p = random.polynomial(), q = random.polynomial(), r = random.polynomial();
    CAPTURE(p.to_text(), q.to_text(), r.to_text());
    for (const LaurentPolynomial& x : {p + q, p - q, p * q, -p, p.reversed(), p.derivative(), p.dilated(3),
                                       p.shifted(-4), p.coset(2, 1), p.pow(3), gcd(p, q)})
      CHECK(x.is_canonical());
    CHECK(p + q == q + p);
    CHECK(p * q == q * p);
    CHECK((p + q) * r == p * r + q * r);
    CHECK((p * q) * r == p * (q * r));
    CHECK(p - p == LaurentPolynomial());
    CHECK(p * LaurentPolynomial(1) == p);
    CHECK(p.pow(3) == p * p * p);
    const Rational z = random.nonzero();
    CHECK((p * q + r)(z) == p(z) * q(z) + r(z));
    CHECK((p * q).derivative() == p.derivative() * q + p * q.derivative());
    CHECK(p.dilated(2)(z) == p(z * z));
    CHECK(p.reversed()(z) == p(1 / z));
    CHECK(p.shifted(5)(z) == p(z) * power(z, 5));
  }
}

TEST_CASE("operands may be the same object") {
  Random random;
  for (const auto i : rounds(50)) {
    const LaurentPolynomial p = random.polynomial();
    LaurentPolynomial x = p;
    x += x;
    CHECK(x == p + p);
    x = p;
    x *= x;
    CHECK(x == p * p);
    x = p;
    x -= x;
    CHECK(x.is_zero());
    x = p;
    const LaurentPolynomial& alias = x;
    x = alias;
    CHECK(x == p);
  }
}

TEST_CASE("division, multiplicity and gcd") {
  Random random;
  for (const auto i : rounds(150)) {
    const LaurentPolynomial p = random.polynomial(10), d = random.nonzero_polynomial(5),
                            q = random.nonzero_polynomial(5);
    CAPTURE(p.to_text(), d.to_text(), q.to_text());
    const auto [quotient, remainder] = p.divided_by(d);
    CHECK(quotient.is_canonical());
    CHECK(remainder.is_canonical());
    CHECK(quotient * d + remainder == p);
    CHECK(remainder.length() < d.length());
    CHECK((p * d).exact_quotient(d) == p);
    const LaurentPolynomial g = gcd(p * d, q * d);
    CHECK((p * d).exact_quotient(g).has_value());
    CHECK(g.exact_quotient(d).has_value());
    if (!g.is_zero()) {
      CHECK(g.lowest() == 0);
      CHECK(g.coefficient(g.highest()) == 1);
    }
    const int arity = static_cast<int>(random.integer(2, 5)), power_of_ones = static_cast<int>(random.integer(0, 4));
    const LaurentPolynomial ones = LaurentPolynomial::all_ones(arity);
    CHECK((q * ones.pow(power_of_ones)).multiplicity(ones) == q.multiplicity(ones) + power_of_ones);
  }
  CHECK(gcd(LaurentPolynomial(), LaurentPolynomial()).is_zero());
  CHECK_THROWS_AS(LaurentPolynomial(1).divided_by(LaurentPolynomial()), Error);
  CHECK_THROWS_AS(LaurentPolynomial().lowest(), Error);
  CHECK_THROWS_AS(LaurentPolynomial().multiplicity(LaurentPolynomial::all_ones(2)), Error);
  CHECK_THROWS_AS(LaurentPolynomial(1).multiplicity(LaurentPolynomial(2)), Error);
  CHECK_THROWS_AS(LaurentPolynomial::monomial(1, -1)(0), Error);
  CHECK_THROWS_AS(LaurentPolynomial::all_ones(2).dilated(2'000'000'000), Error);
}

TEST_CASE("the cosets put the symbol together again") {
  Random random;
  for (const auto i : rounds(100)) {
    const LaurentPolynomial p = random.polynomial(14);
    for (int arity = 1; arity <= 5; ++arity) {
      LaurentPolynomial sum;
      for (int r = 0; r < arity; ++r) sum += p.coset(arity, r).dilated(arity).shifted(r);
      CHECK(sum == p);
      const long r = random.integer(-7, 7);
      CHECK(p.coset(arity, r + arity) == p.coset(arity, r).shifted(-1));
    }
  }
}

TEST_CASE("printing and reading") {
  Random random;
  for (const auto i : rounds(100)) {
    const LaurentPolynomial p = random.polynomial();
    CAPTURE(p.to_text());
    CHECK(LaurentPolynomial::parse(p.to_text()) == p);
    CHECK(LaurentPolynomial::parse_mask(p.to_mask_text()) == p);
  }
  const LaurentPolynomial chaikin({Rational(1, 4), Rational(3, 4), Rational(3, 4), Rational(1, 4)}, -2);
  CHECK(chaikin.to_text() == "1/4*z^-2 + 3/4*z^-1 + 3/4 + 1/4*z");
  CHECK(chaikin.to_latex() == "\\frac{1}{4} z^{-2} + \\frac{3}{4} z^{-1} + \\frac{3}{4} + \\frac{1}{4} z");
  CHECK(chaikin.to_mask_text() == "[1,3,3,1]/4@-2");
  CHECK(LaurentPolynomial::parse("z*z - 2*z^2 + z^2").is_zero());
  CHECK(LaurentPolynomial::parse("-z^-1+3/6").to_text() == "-z^-1 + 1/2");
  CHECK(LaurentPolynomial::parse("z^1/2-(1+z)^2/z").to_text() == "-z^-1 - 2 - 1/2*z");
  CHECK(LaurentPolynomial::parse("(1-z^2)/(1+z)*z^-3").to_text() == "z^-3 - z^-2");
  CHECK(LaurentPolynomial::parse("(1+z)^2(3-z)/2z^3") == LaurentPolynomial::parse("(1+z)^2*(3-z)/(2*z^3)"));
  for (const char* text :
       {"", "z^", "z+", "2**z", "x", "1/0", "z 2", "1/2z", "z^99999999", "z^1000000*z", "(z", "1,5", "1/(1+z)", "0^-1"})
    CHECK_THROWS_AS(LaurentPolynomial::parse(text), ParseError);
  for (const char* text : {"", "[", "]", "[]", "[1,]", "[1]/0", "[1]/-2", "[1]/1/2", "[1]x", "[1]@", "[1]@1/2", "[1]@a",
                           "[1]@99999999999", "1,2", "[a]", "[1][2]"})
    CHECK_THROWS_AS(LaurentPolynomial::parse_mask(text), ParseError);
  try {
    (void)LaurentPolynomial::parse("z + ?");
    FAIL("not refused");
  } catch (const ParseError& error) {
    CHECK(error.position() == 5);
    CHECK(error.token() == "?");
  }
}
