#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/reports/formats/comparison.hpp>

using namespace subcert;
using namespace subcert::formats;

namespace {

Rational q(const char* text) { return *parse_rational(text); }

}  // namespace

TEST_CASE("a printed value matches only a narrow enclosure within one unit") {
  CHECK(compare("1.649", Enclosure::exactly(q("1649/1000"))) == ValueVerdict::match);
  CHECK(compare("1.649", Enclosure::exactly(q("1650/1000"))) == ValueVerdict::match);
  CHECK(compare("1.649", Enclosure::exactly(q("1648/1000"))) == ValueVerdict::match);
  CHECK(compare("1.649", Enclosure::exactly(q("16501/10000"))) == ValueVerdict::mismatch);
  CHECK(compare("1.649", Enclosure::exactly(q("16479/10000"))) == ValueVerdict::mismatch);
  // As wide as the unit: an empty match, so it is none.
  CHECK(compare("1.649", {q("16485/10000"), q("16495/10000")}) == ValueVerdict::open);
  CHECK(compare("1.649", {q("16485/10000"), q("16494/10000")}) == ValueVerdict::match);
  // Reaching over the edge decides nothing; wholly beyond it decides.
  CHECK(compare("1.649", {q("16497/10000"), q("16501/10000")}) == ValueVerdict::open);
  CHECK(compare("2", Enclosure::exactly(q("5/2"))) == ValueVerdict::match);
  CHECK(compare("-0.5", Enclosure::exactly(q("-1/2"))) == ValueVerdict::match);
}

TEST_CASE("one-sided bounds refute or leave open") {
  CHECK(compare("0.0849", Enclosure::at_least(q("8549/100000"))) == ValueVerdict::mismatch);
  CHECK(compare("0.0849", Enclosure::at_least(q("850/10000"))) == ValueVerdict::open);
  CHECK(compare("0.0849", Enclosure{std::nullopt, q("847/10000")}) == ValueVerdict::mismatch);
  CHECK(compare("0.0849", Enclosure{}) == ValueVerdict::open);
}

TEST_CASE("an exponent fits a decimal, a whole number, a bound or a class") {
  const Enclosure two = Enclosure::exactly(2), near_two{q("1999999/1000000"), q("2000001/1000000")};
  CHECK(compare_exponent("2", two) == ValueVerdict::match);
  CHECK(compare_exponent("2", near_two) == ValueVerdict::open);
  CHECK(compare_exponent("2", Enclosure::exactly(q("21/10"))) == ValueVerdict::mismatch);
  CHECK(compare_exponent("2", Enclosure::at_least(2)) == ValueVerdict::open);
  CHECK(compare_exponent("2.00", near_two) == ValueVerdict::match);
  CHECK(compare_exponent("C^1", near_two) == ValueVerdict::match);
  CHECK(compare_exponent("C^1", Enclosure::at_least(q("3/2"))) == ValueVerdict::match);
  CHECK(compare_exponent("C^2", two) == ValueVerdict::open);
  CHECK(compare_exponent("C^2", Enclosure{std::nullopt, q("19/10")}) == ValueVerdict::mismatch);
  CHECK(compare_exponent("<= 2.1", two) == ValueVerdict::match);
  CHECK(compare_exponent("<= 2.0", two) == ValueVerdict::match);
  CHECK(compare_exponent("<= 1.9", two) == ValueVerdict::mismatch);  // a bound has no unit
  CHECK(compare_exponent("<= 1.8", two) == ValueVerdict::mismatch);
  CHECK(compare_exponent("<= 1.9", Enclosure::at_least(q("3/2"))) == ValueVerdict::open);
  for (const char* text : {"", "C^", "C2", "<=2", "smooth"})
    CHECK_THROWS_AS(compare_exponent(text, two), std::exception);
}

TEST_CASE("what is no decimal is refused") {
  for (const char* text : {"", ".", "1.2.3", "1/2", "1e3", "one", "1,5"})
    CHECK_THROWS_AS(compare(text, Enclosure::exactly(1)), std::exception);
}

TEST_CASE("the shown number never hides an uncertainty") {
  Comparison c{
      "r", "c", "", "1.64", Enclosure{q("16400/10000"), q("16409/10000")}, ValueVerdict::open, ValueVerdict::open, ""};
  CHECK(c.computed_text() == "1.64000 ... 1.64090");
  c.computed = Enclosure::exactly(q("1/3"));
  CHECK(c.computed_text() == "0.33333");
  c.computed = Enclosure::at_least(q("2/3"));
  CHECK(c.computed_text() == ">= 0.66666");
  c.printed = "C^0";
  CHECK(c.computed_text() == ">= 0.666666");
}
