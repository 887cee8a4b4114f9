#include <subcert/analysis/symbol/polynomials/quadratic_number.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

std::string text_of(const char* text, long root = 0) { return QuadraticNumber::parse(text, root).to_text(); }

}  // namespace

TEST_CASE("numbers with a square root are read, and printed back") {
  CHECK(text_of("sqrt(7)/2") == "1/2*sqrt(7)");
  CHECK(text_of("1/sqrt(7)") == "1/7*sqrt(7)");
  CHECK(text_of("(1+sqrt(7))/(3-sqrt(28))") == "-17/19-5/19*sqrt(7)");
  CHECK(text_of("-sqrt(7)") == "-sqrt(7)");
  CHECK(text_of("sqrt(7)^3") == "7*sqrt(7)");
  CHECK(text_of("sqrt(12)") == "2*sqrt(3)");
  CHECK(text_of("sqrt(700000000)") == "10000*sqrt(7)");
  CHECK(text_of("2*sqrt(9)-1/2") == "11/2");
  CHECK(text_of("sqrt(7)-sqrt(7)").find("sqrt") == std::string::npos);
  CHECK(QuadraticNumber::parse("sqrt(1)", 7) == QuadraticNumber{1});
  CHECK(text_of("0.25") == "1/4");
  CHECK(text_of("sqrt(63)", 7) == "3*sqrt(7)");
}

TEST_CASE("what is no number with one square root") {
  for (const char* bad : {"sqrt(0)", "sqrt(-7)", "sqrt(7", "sqrt(", "sqrt()", "sqrt(7/2)", "sqrt(9999999999)", "x", "",
                          "t*sqrt(7)", "sqrt(2)+sqrt(3)", "1/(sqrt(7)^2-7)", "sqrt(sqrt(7))", "sqrt(7)sqrt"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(QuadraticNumber::parse(bad), ParseError);
  }
  CHECK_THROWS_AS(QuadraticNumber::parse("sqrt(5)", 7), ParseError);
}

TEST_CASE("quotients of numbers with a square root are those of real numbers") {
  Random random;
  for (const auto round : rounds(50)) {
    CAPTURE(static_cast<int>(round));
    const auto number = [&] {
      return QuadraticNumber{Rational(random.integer(-9, 9), 4), Rational(random.integer(-9, 9), 5), 7};
    };
    const QuadraticNumber a = number(), b = number();
    if (b.is_zero()) continue;
    const QuadraticNumber c = a / b;
    // c b = a
    CHECK(c.rational * b.rational + 7 * c.multiple * b.multiple == a.rational);
    CHECK(c.rational * b.multiple + c.multiple * b.rational == a.multiple);
    CHECK(QuadraticNumber::parse(c.to_text(), 7) == c);
  }
}
