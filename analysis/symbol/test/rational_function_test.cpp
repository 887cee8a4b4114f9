#include <subcert/analysis/symbol/polynomials/rational_function.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

RationalFunction read(const char* text) { return RationalFunction::parse(text, "w"); }

}  // namespace

TEST_CASE("expressions in a parameter") {
  CHECK(read("1/2+w").to_text('w') == "1/2+w");
  CHECK(read(" - w ^ 2 / 4 ") == RationalFunction(LaurentPolynomial({0, 0, Rational(-1, 4)}, 0)));
  CHECK(read("(1-w)^2/(2+3*w)").to_text('t') == "(1-2*t+t^2)/(2+3*t)");
  CHECK(read("(1-w^2)/(2-2*w)").to_text('w') == "1/2+1/2*w");
  CHECK(read("1/w").to_text('w') == "1/(w)");
  CHECK(read(read("1/w").to_text('w').c_str()) == read("1/w"));
  CHECK(read("1/(1/2-w/3)").to_text('w') == "6/(3-2*w)");
  CHECK(read("1/(w-1)").to_text('w') == "-1/(1-w)");
  CHECK(read("0.25*w-.5") == read("w/4-1/2"));
  CHECK(read("w-w").to_text('w') == "0");
  CHECK(read("2^3*w^0") == RationalFunction(8));
  CHECK(read("2^-3*w^-1+(1+w)^-2") == read("1/(8*w)+1/(1+w)^2"));
  // Without stars: behind a divisor only where it can be meant in one way.
  CHECK(read("2w(1-w)w^2") == read("2*w*(1-w)*w^2"));
  CHECK(read("(1+w)/2w") == read("(1+w)/(2*w)"));
  CHECK(read("3*(1+w)/2w*w") == read("3*(1+w)/2"));
  // A blank ends a fraction of numbers.
  CHECK(read("1-1/6 w") == read("1-w/6"));
  CHECK(read("3*2/(5) w^2/7") == read("6*w^2/35"));
  CHECK(read("1/2 (1+w)^2") == read("(1+w)^2/2"));
  CHECK(read("1/2 /w") == read("1/(2*w)"));
  for (const char* bad :
       {"1/2(1+w)", "(1+w)/2(1-w)", "w/2w", "w/2 w", "1/w w", "(1+w)/(2)w/w(2)", "1/2 3", "(1+w)/2 (1-w)"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(read(bad), ParseError);
  }
}

TEST_CASE("what is no expression") {
  for (const char* bad :
       {"",      " ",     "w+",  "(w",   "w)",      "w 2",           "1/2w",
        "v",     "w^--1", "w^w", "w^65", "1/(w-w)", "1/0",           "--w",
        "w^1.5", "1..5",  "1e3", "*w",   "()",      "(w^40)*(w^40)", "((99999999999999999999)^64)^64"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(read(bad), ParseError);
  }
  CHECK_THROWS_AS(read(std::string(10000, '(').c_str()), ParseError);
  CHECK(subcert::testing::error_kind([] { read("1/w")(0); }) == ErrorKind::domain);
}

TEST_CASE("rational functions are a field") {
  Random random;
  const auto polynomial = [&] {
    std::vector<Rational> coefficients;
    for (long k = random.integer(0, 3); k >= 0; --k) coefficients.emplace_back(random.integer(-3, 3));
    return LaurentPolynomial(coefficients, random.integer(0, 1));
  };
  const auto function = [&] {
    LaurentPolynomial q = polynomial();
    return RationalFunction(polynomial(), q.is_zero() ? LaurentPolynomial(1) : q);
  };
  for (const auto round : rounds(100)) {
    CAPTURE(static_cast<int>(round));
    const RationalFunction a = function(), b = function(), c = function();
    CHECK(a * (b + c) == a * b + a * c);
    CHECK(a - a == RationalFunction(0));
    if (!b.numerator().is_zero()) CHECK(a / b * b == a);
    CHECK(RationalFunction::parse(a.to_text('w'), "w") == a);
    const Rational w(random.integer(10, 20), 7);
    if (a.denominator()(w) != 0 && b.denominator()(w) != 0) {
      CHECK((a + b)(w) == a(w) + b(w));
      CHECK((a * b)(w) == a(w) * b(w));
    }
  }
}

TEST_CASE("expressions in several letters") {
  const auto both = [](const char* text) { return LetterFunction::parse(text, "vw"); };
  CHECK(both("(v+w)^2 - (v-w)^2") == both("4*v*w"));
  CHECK(both("(v^2-w^2)/(v+w)").to_text("vw") == "v-w");
  CHECK(both("(v^2-w^2)/(v+w)").is_polynomial());
  CHECK(both("1/v+1/w") == both("(v+w)/(v*w)"));
  CHECK(both("2/(4*v-6*w)").to_text("vw") == "-1/(-2*v+3*w)");
  CHECK(both("2/(4*v-6*w)") == both("-1/(3*w-2*v)"));
  CHECK(both("(1+v)/(2+2*w)").to_text("xy") == "(1/2*x+1/2)/(y+1)");
  CHECK(both("v-v").is_zero());
  CHECK(both("(1+v)/2vw") == both("(1+v)/(2*v*w)"));
  for (const char* bad : {"u", "v 2", "v/(w-w)", "v^25", "v^13*v^12", "(v+w)^25", "(1+v)/", "1/2vw"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(both(bad), ParseError);
  }
  try {
    both("v + 2*u");
    FAIL("not refused");
  } catch (const ParseError& error) {
    CHECK(error.position() == 7);
    CHECK(error.expected() == "exact numbers, the letters v and w, +, -, *, /, ^ and parentheses");
  }
}

TEST_CASE("quotients in several letters are a field") {
  Random random;
  const auto polynomial = [&] {
    std::vector<Monomial> terms;
    for (long k = random.integer(0, 3); k >= 0; --k)
      terms.push_back({random.integer(-3, 3), {random.integer(0, 2), random.integer(0, 2)}});
    return MultivariatePolynomial(2, terms);
  };
  for (const auto round : rounds(60)) {
    CAPTURE(static_cast<int>(round));
    const auto function = [&] {
      const MultivariatePolynomial q = polynomial();
      return LetterFunction(polynomial(), q.is_zero() ? MultivariatePolynomial(2, 1) : q);
    };
    const LetterFunction a = function(), b = function(), c = function();
    CHECK(a * (b + c) == a * b + a * c);
    CHECK((a - a).is_zero());
    if (!b.is_zero()) CHECK(a / b * b == a);
    CHECK(LetterFunction::parse(a.to_text("vw"), "vw") == a);
  }
}
