#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

#include <algorithm>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

TEST_CASE("intervals contain all results and no end is slack") {
  Random random;
  for (const auto i : rounds(200)) {
    const Rational p = random.rational(), q = random.rational(), r = random.rational(), s = random.rational();
    const Interval a{std::min(p, q), std::max(p, q)}, b{std::min(r, s), std::max(r, s)};
    CAPTURE(a.lower, a.upper, b.lower, b.upper);
    for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)})
      for (const Rational& u : {Rational(0), Rational(2, 5), Rational(1)}) {
        const Rational x = a.lower + t * a.width(), y = b.lower + u * b.width();
        CHECK((a + b).contains(x + y));
        CHECK((a - b).contains(x - y));
        CHECK((a * b).contains(x * y));
        CHECK((-a).contains(-x));
        if (!b.contains(0)) CHECK((a / b).contains(x / y));
      }
    CHECK((a + b).width() == a.width() + b.width());
    const Interval product = a * b;
    const auto is_attained = [&](const Rational& end) {
      return end == a.lower * b.lower || end == a.lower * b.upper || end == a.upper * b.lower ||
             end == a.upper * b.upper;
    };
    CHECK(is_attained(product.lower));
    CHECK(is_attained(product.upper));
    if (b.contains(0)) CHECK_THROWS_AS(a / b, Error);
  }
  CHECK_THROWS_AS(Interval::of(Enclosure::at_least(1)), Error);
  CHECK(*scaled(Enclosure::at_least(3), Rational(1, 2)).lower == Rational(3, 2));
  CHECK_FALSE(scaled(Enclosure::at_least(3), 2).upper);
  CHECK_THROWS_AS(scaled(Enclosure::exactly(1), 0), Error);
  CHECK(Interval::of(Enclosure::exactly(2)) == Interval::exactly(2));
}
