#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>

using namespace subcert;

TEST_CASE("decimal numbers are read exactly") {
  const auto value = [](const char* text) { return parse_decimal(text)->value; };
  CHECK(value("0.25") == Rational(1, 4));
  CHECK(value("-.5e1") == -5);
  CHECK(value("+3.") == 3);
  CHECK(value("007") == 7);
  CHECK(value("1E+2") == 100);
  CHECK(value("-0.0") == 0);
  CHECK(parse_decimal("0.250")->unit == Rational(1, 1000));
  CHECK(parse_decimal("25.0e-2")->unit == Rational(1, 1000));
  CHECK(parse_decimal("1e3")->unit == 1000);
  for (const char* text :
       {"", ".", "-", "1e", "1e+", "e5", "1.2.3", "1,5", "0x10", "nan", "inf", " 1", "1 ", "1e401", "1e99999", "--1"})
    CHECK_FALSE(parse_decimal(text));
  CHECK_THROWS_AS(read_decimal("1.2.3"), Error);
  CHECK(read_decimal("0.250").places() == 3);
  CHECK(read_decimal("12").places() == 0);
  CHECK(parse_decimal("1e3")->places() == 0);
  CHECK_THROWS_AS(read_decimal("1e3"), Error);
  for (const Rational& number : {Rational(1, 400), Rational(7), Rational(1, 3), Rational(12000), Rational(-1, 8)}) {
    const std::string text = to_short_text(number);
    const auto decimal = parse_decimal(text);
    CHECK((decimal ? decimal->value : *parse_rational(text)) == number);
  }
}

TEST_CASE("a printed decimal agrees with a narrow enclosure within one unit") {
  const Decimal printed = read_decimal("0.25");
  const auto around = [](const Rational& centre) { return Enclosure{centre - Rational(1, 10000), centre}; };
  CHECK(agrees(printed, Enclosure::exactly(Rational(1, 4))) == Truth::yes);
  CHECK(agrees(printed, around(Rational(26, 100))) == Truth::yes);
  CHECK(agrees(printed, around(Rational(27, 100))) == Truth::no);
  CHECK(agrees(printed, Enclosure{Rational(2, 10), Rational(3, 10)}) == Truth::unknown);
  CHECK(agrees(printed, Enclosure::at_least(Rational(1, 4))) == Truth::unknown);
  CHECK(agrees(printed, Enclosure::at_least(Rational(1, 2))) == Truth::no);
}
