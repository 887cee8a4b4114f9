#include <subcert/analysis/symbol/parse_error.hpp>
#include <subcert/analysis/symbol/rational_function.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

RationalFunction read(const char* text) { return RationalFunction::parse(text, 'w'); }

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
}

TEST_CASE("what is no expression") {
  for (const char* bad :
       {"",      " ",    "w+",  "(w",   "w)",      "w w",           "2w",
        "v",     "w^-1", "w^w", "w^65", "1/(w-w)", "1/0",           "--w",
        "w^1.5", "1..5", "1e3", "*w",   "()",      "(w^40)*(w^40)", "((99999999999999999999)^64)^64"}) {
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
    CHECK(RationalFunction::parse(a.to_text('w'), 'w') == a);
    const Rational w(random.integer(10, 20), 7);
    if (a.denominator()(w) != 0 && b.denominator()(w) != 0) {
      CHECK((a + b)(w) == a(w) + b(w));
      CHECK((a * b)(w) == a(w) * b(w));
    }
  }
}
