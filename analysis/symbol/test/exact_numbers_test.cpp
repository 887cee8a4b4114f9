#include <subcert/analysis/symbol/numbers/boost_numbers.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

#include <cmath>

using namespace subcert;
using boost::multiprecision::mpq_rational;
using boost::multiprecision::mpz_int;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

Integer random_integer(Random& random) {
  const Integer small = random.integer(-40, 40);
  if (random.chance(50)) return small;
  return small * pow(Integer(random.integer(2, 99)), static_cast<unsigned long>(random.integer(0, 60)));
}

}  // namespace

TEST_CASE("integers calculate as those of Boost") {
  Random random;
  for (const auto i : rounds(300)) {
    const Integer a = random_integer(random), b = random_integer(random);
    const auto x = to_boost(a), y = to_boost(b);
    CAPTURE(a, b);
    CHECK(from_boost(x) == a);
    CHECK((a + b) == from_boost(mpz_int((x + y))));
    CHECK((a - b) == from_boost(mpz_int((x - y))));
    CHECK((a * b) == from_boost(mpz_int((x * y))));
    CHECK((-a) == from_boost(mpz_int((-x))));
    CHECK(gcd(a, b) == from_boost(mpz_int(gcd(x, y))));
    CHECK(lcm(a, b) == from_boost(mpz_int(lcm(x, y))));
    CHECK((a < b) == (x < y));
    CHECK((a == b) == (x == y));
    CHECK((a << 7) == from_boost(mpz_int((x << 7))));
    CHECK((a >> 3) == from_boost(mpz_int((x >> 3))));
    CHECK(a.convert_to<long>() == x.convert_to<long>());
    CHECK(a.convert_to<double>() == x.convert_to<double>());
    CHECK(sqrt(abs(a)) * sqrt(abs(a)) <= abs(a));
    CHECK((sqrt(abs(a)) + 1) * (sqrt(abs(a)) + 1) > abs(a));
    if (b == 0) {
      CHECK_THROWS_AS(a / b, Error);
      CHECK_THROWS_AS(a % b, Error);
      continue;
    }
    CHECK((a / b) == from_boost(mpz_int((x / y))));
    CHECK((a % b) == from_boost(mpz_int((x % y))));
    Integer same = a;
    same -= same;
    CHECK(same.is_zero());
  }
  CHECK(Integer("-00123") == -123);
  CHECK(Integer(2'000'000'000L) * 5 > 3);
  CHECK(pow(Integer(10), 30).convert_to<int>() == std::numeric_limits<int>::max());
  CHECK(Integer(-7).convert_to<unsigned>() == 0);
  for (const char* text : {"", "1.5", "0x10", "1 2 x", "--1"}) CHECK_THROWS_AS(Integer(std::string(text)), Error);
}

TEST_CASE("rationals calculate as those of Boost and are canonical") {
  Random random;
  for (const auto i : rounds(300)) {
    const Rational a(random_integer(random), random.integer(1, 60)), b = random.rational();
    const auto x = to_boost(a), y = to_boost(b);
    CAPTURE(a, b);
    CHECK(from_boost(x) == a);
    CHECK((a + b) == from_boost(mpq_rational((x + y))));
    CHECK((a - b) == from_boost(mpq_rational((x - y))));
    CHECK((a * b) == from_boost(mpq_rational((x * y))));
    CHECK((-a) == from_boost(mpq_rational((-x))));
    CHECK(abs(a) == from_boost(mpq_rational(abs(x))));
    CHECK((a < b) == (x < y));
    CHECK(Rational(numerator(a), denominator(a)) == a);
    CHECK(gcd(numerator(a), denominator(a)) == 1);
    CHECK(a.convert_to<double>() == x.convert_to<double>());
    if (b == 0)
      CHECK_THROWS_AS(a / b, Error);
    else
      CHECK((a / b) == from_boost(mpq_rational((x / y))));
    Rational same = a, moved = std::move(same);
    same = b;
    std::swap(same, moved);
    CHECK(same == a);
    CHECK(moved == b);
  }
  CHECK(Rational(6, -4) == Rational(-3, 2));
  CHECK_THROWS_AS(Rational(1, 0), Error);
  CHECK(Rational(0.375) == Rational(3, 8));
  CHECK(Rational(-7, 2).convert_to<long>() == -3);
  CHECK(3 - Rational(1, 2) == Rational(5, 2));
}

TEST_CASE("the double of a rational is the nearest one") {
  Random random;
  for (const auto i : rounds(300)) {
    const Rational value = random.nonzero() * power(Rational(random.integer(2, 7)), random.integer(-300, 300));
    const double nearest = value.convert_to<double>();
    CAPTURE(value, nearest);
    REQUIRE(std::isfinite(nearest));
    const Rational distance = abs(Rational(nearest) - value);
    for (const double toward : {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()})
      CHECK(distance <= abs(Rational(std::nextafter(nearest, toward)) - value));
  }
  CHECK(std::isinf(power(Rational(10), 400).convert_to<double>()));
  CHECK(Rational(-power(Rational(10), -400)).convert_to<double>() == 0);
}

TEST_CASE("a double that is not finite is refused, before GMP would end the program") {
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    CHECK_THROWS_AS(Rational(value), Error);
    CHECK_THROWS_AS(Integer(value), Error);
  }
  CHECK(Rational(-0.75) == Rational(-3, 4));
  CHECK(Integer(-1e30) == Integer("-1000000000000000019884624838656"));
}
