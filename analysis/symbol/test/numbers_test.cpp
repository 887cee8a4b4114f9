#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

/// The exact value of what to_decimal prints.
Rational read_decimal(std::string text) {
  long exponent = 0;
  if (const auto e = text.find('e'); e != std::string::npos) {
    exponent = std::stol(text.substr(e + 1));
    text.resize(e);
  }
  if (const auto point = text.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(text.size() - point - 1);
    text.erase(point, 1);
  }
  const auto digits = parse_rational(text);
  REQUIRE(digits);
  return *digits * power(Rational(10), exponent);
}

}  // namespace

TEST_CASE("rationals are read strictly") {
  CHECK(*parse_rational("3/4") == Rational(3, 4));
  CHECK(*parse_rational("-6/8") == Rational(-3, 4));
  CHECK(*parse_rational("+5") == 5);
  CHECK(*parse_rational("007/010") == Rational(7, 10));
  CHECK(*parse_rational("0/5") == 0);
  for (const char* text : {"",   "+",  "-",   "/",    "1/",   "/2",   "1/0", "1/00", "1.5",   "1e3",
                           " 1", "1 ", "--1", "1/-2", "1//2", "0x10", "inf", "nan",  "1/2/3", "\xff"})
    CHECK_FALSE(parse_rational(text));
  CHECK_FALSE(parse_rational(std::string(20'000, '1')));
}

TEST_CASE("decimals are rounded outward") {
  Random random;
  for (const auto i : rounds(300)) {
    const Rational value = random.rational();
    const int digits = static_cast<int>(random.integer(1, 25));
    const Rational low = read_decimal(to_decimal(value, digits, Rounding::down));
    const Rational high = read_decimal(to_decimal(value, digits, Rounding::up));
    CAPTURE(to_text(value), digits);
    CHECK(low <= value);
    CHECK(value <= high);
    CHECK(high - low <= abs(value) * power(Rational(10), 1 - digits));
    const int places = static_cast<int>(random.integer(0, 12));
    CHECK(read_decimal(to_fixed(value, places, Rounding::down)) <= value);
    CHECK(read_decimal(to_fixed(value, places, Rounding::up)) >= value);
    CHECK(abs(read_decimal(to_fixed(value, places, Rounding::nearest)) - value) * 2 <= power(Rational(10), -places));
  }
  CHECK(to_decimal(Rational(1, 8), 20, Rounding::down) == "0.125");
  CHECK(to_decimal(Rational(-1, 3), 3, Rounding::down) == "-0.334");
  CHECK(to_decimal(Rational(-1, 3), 3, Rounding::up) == "-0.333");
  CHECK(to_decimal(power(Rational(10), 30), 3, Rounding::down) == "1e30");
  CHECK(to_decimal(power(Rational(10), -9), 3, Rounding::up) == "1e-9");
  CHECK(to_fixed(Rational(-5, 1000), 2, Rounding::nearest) == "-0.01");
  CHECK(to_decimal(Rational(999) * power(Rational(10), -10), 2, Rounding::up) == "0.0000001");
  CHECK(to_decimal(Rational(999) * power(Rational(10), -20), 2, Rounding::up) == "1e-17");
  CHECK(to_decimal(Rational(999, 1000), 2, Rounding::nearest) == "1");
  CHECK_THROWS_AS(to_decimal(1, 0, Rounding::up), Error);
}

TEST_CASE("logarithms are enclosed") {
  Random random;
  for (const auto i : rounds(50)) {
    const Rational argument = abs(random.nonzero());
    const int base = static_cast<int>(random.integer(2, 9));
    const Enclosure value = log_ratio(argument, base);
    REQUIRE(value.is_bounded());
    CHECK(value.is_canonical());
    CHECK(*value.upper - *value.lower < power(Rational(2), -100) * (1 + abs(*value.lower)));
    // base^floor(1000 lower) <= argument^1000 <= base^ceil(1000 upper), the exact meaning at three decimals.
    const auto floor_of = [](const Rational& x) { return std::stol(to_fixed(x, 0, Rounding::down)); };
    const Rational thousandth = power(argument, 1000);
    CHECK(power(Rational(base), floor_of(1000 * *value.lower)) <= thousandth);
    CHECK(power(Rational(base), floor_of(1000 * *value.upper) + 1) >= thousandth);
  }
  CHECK(log_ratio(Rational(1, 8), 2).is_exact());
  CHECK(*log_ratio(Rational(1, 8), 2).lower == -3);
  CHECK(*log_ratio(Rational(81), 3).upper == 4);
  CHECK(*log_ratio(Rational(1, 8), 4).lower == Rational(-3, 2));
  CHECK(log_ratio(Rational(2), 4).is_exact());
  const Enclosure fine = log_ratio(3, 2, 1000);
  CHECK(*fine.upper - *fine.lower < power(Rational(2), -1000));
  const Enclosure root = root_enclosure(2, 2, 1000);
  CHECK(power(*root.lower, 2) <= 2);
  CHECK(power(*root.upper, 2) >= 2);
  CHECK(*root.upper - *root.lower < power(Rational(2), -999));
  CHECK_THROWS_AS(log_ratio(0, 2), Error);
  CHECK_THROWS_AS(log_ratio(2, 1), Error);
}

TEST_CASE("the simplest number between two") {
  CHECK(simplest_between(Rational(1, 3), Rational(3, 5)) == Rational(1, 2));
  CHECK(simplest_between(Rational(-7, 3), Rational(-7, 3)) == Rational(-7, 3));
}

TEST_CASE("an enclosure prints a set that contains it") {
  const Enclosure third = Enclosure::exactly(Rational(1, 3));
  CHECK(read_decimal(third.lower_text(5)) < Rational(1, 3));
  CHECK(read_decimal(third.upper_text(5)) > Rational(1, 3));
  CHECK(Enclosure::at_least(2).upper_text() == "inf");
  CHECK(Enclosure{}.lower_text() == "-inf");
  CHECK(Enclosure::at_least(2).contains(5));
  CHECK_FALSE(Enclosure::at_least(2).contains(1));
  // What is above 1 is not printed as 1.
  const Rational above = 1 + power(Rational(10), -40);
  CHECK(Enclosure::exactly(above).telling_digits(20) == 42);
  CHECK(Enclosure::at_least(above).lower_text(42) == "1." + std::string(39, '0') + "1");
  CHECK(Enclosure{1 - power(Rational(10), -30), 1}.telling_digits(20) == 20);
  CHECK(Enclosure{Rational(1, 3), Rational(3, 5)}.telling_digits(5) == 5);
  CHECK(Enclosure::exactly(0).telling_digits(3) == 3);
  CHECK(Enclosure{}.telling_digits(3) == 3);
}
