#include "../deciding.hpp"

#include <subcert/cmake/catch.hpp>

#include <tuple>
#include <vector>

using namespace subcert;
using namespace subcert::properties;

namespace {

constexpr Truth yes = Truth::yes, no = Truth::no, unknown = Truth::unknown;

Expectation expected(const std::string& relation, const Rational& number) {
  Expectation result{"holder", relation + " x", {1, 1}, relation, number, false, "", std::nullopt, ""};
  return result;
}

Truth truth(const Enclosure& value, const std::string& relation, const Rational& number) {
  return compare(value, expected(relation, number), "it").truth;
}

}  // namespace

TEST_CASE("a comparison holds for all numbers of an enclosure, or for none, or is not decided") {
  const Enclosure open_above = Enclosure::at_least(2), open_below{std::nullopt, Rational(2)}, all{},
                  wide{Rational(1), Rational(3)}, two = Enclosure::exactly(2);
  for (const auto& [value, number, at_least, above, at_most, below] :
       std::vector<std::tuple<Enclosure, Rational, Truth, Truth, Truth, Truth>>{
           {wide, 0, yes, yes, no, no},
           {wide, 1, yes, unknown, unknown, no},
           {wide, 2, unknown, unknown, unknown, unknown},
           {wide, 3, unknown, no, yes, unknown},
           {wide, 4, no, no, yes, yes},
           {two, 2, yes, no, yes, no},
           {two, Rational(3, 2), yes, yes, no, no},
           {two, Rational(5, 2), no, no, yes, yes},
           {open_above, 1, yes, yes, no, no},
           {open_above, 2, yes, unknown, unknown, no},
           {open_above, 3, unknown, unknown, unknown, unknown},
           {open_below, 3, no, no, yes, yes},
           {open_below, 2, unknown, no, yes, unknown},
           {open_below, 1, unknown, unknown, unknown, unknown},
           {all, 0, unknown, unknown, unknown, unknown}}) {
    CAPTURE(value.lower_text(), value.upper_text(), number);
    CHECK(truth(value, ">=", number) == at_least);
    CHECK(truth(value, ">", number) == above);
    CHECK(truth(value, "<=", number) == at_most);
    CHECK(truth(value, "<", number) == below);
  }
  CHECK(truth(two, "=", 2) == yes);
  CHECK(truth(two, "=", 3) == no);
  CHECK(truth(wide, "=", 2) == unknown);
  CHECK(truth(wide, "=", 4) == no);
  CHECK(compare(wide, expected(">=", 2), "the exponent").reason == "the exponent lies in [1, 3]");
  // As many digits as tell the ends from the number.
  const Rational near = 2 - power(Rational(10), -12);
  CHECK(compare(Enclosure{1, near}, expected(">=", 2), "it").reason == "it lies in [1, 1.999999999999]");
  CHECK(compare(Enclosure{near, 3}, expected(">=", near), "it").reason == "it lies in [1.999999999999, 3]");
  CHECK(compare(Enclosure{Rational(1, 3), 2}, expected(">", 2), "it").reason == "it lies in [0.33333333, 2]");
  CHECK(compare(Enclosure{2, 2}, expected(">", 2), "it").reason == "it is 2");
}

TEST_CASE("numbers that are known are compared as they are") {
  CHECK((compare(2, "=", 2) && !compare(2, "=", 3) && compare(2, ">=", 2) && !compare(2, ">=", 3)));
  CHECK((compare(2, "<=", 2) && !compare(2, "<=", 1) && compare(2, ">", 1) && !compare(2, ">", 2)));
  CHECK((compare(2, "<", 3) && !compare(2, "<", 2)));
}

TEST_CASE("a surface is C^k where its exponent is above k, and not where it is below") {
  MultivariateRegularity regularity;
  const auto smooth = [&](const Enclosure& exponent, long k) {
    regularity.exponent = exponent;
    return smoothness(regularity, expected(">=", k)).truth;
  };
  regularity.converges = {yes, "it contracts"};
  CHECK(smooth(Enclosure::exactly(2), 1) == yes);
  CHECK(smooth(Enclosure::exactly(2), 2) == unknown);  // a whole exponent may be attained by derivatives with jumps
  CHECK(smooth(Enclosure::exactly(2), 3) == no);
  CHECK(smooth({Rational(3, 2), Rational(5, 2)}, 1) == yes);
  CHECK(smooth({Rational(3, 2), Rational(5, 2)}, 2) == unknown);
  CHECK(smooth({Rational(3, 2), Rational(5, 2)}, 3) == no);
  CHECK(smooth({Rational(2), Rational(5, 2)}, 2) == unknown);
  CHECK(smooth({Rational(1), Rational(2)}, 2) == unknown);
  CHECK(smooth(Enclosure{}, 1) == unknown);
  CHECK(smooth(Enclosure{}, 0) == yes);
  regularity.converges = {unknown, ""};
  CHECK(smooth(Enclosure{}, 0) == unknown);
  regularity.converges = {no, "a coset sum"};
  CHECK(smooth(Enclosure{}, 0) == no);
}
