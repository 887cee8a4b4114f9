#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/sweeps/growth.hpp>

#include <fmt/format.h>

using namespace subcert;
using namespace subcert::sweeps;

namespace {

Json answer(int n, int d, const std::string& value) {
  return {{"scheme", fmt::format("primal:n={},d={}", n, d)},
          {"keys", {{"n", std::to_string(n)}, {"d", std::to_string(d)}}},
          {"answers", {{"regularity", {{"holder", {{"lower", value}, {"upper", value}}}}}}}};
}

}  // namespace

TEST_CASE("growth: questions are read and printed back, or refused") {
  for (const char* text : {"holder by n", "2 - holder by n", "1/2 - a.b by w"})
    CHECK(GrowthQuestion::parse(text).text() == text);
  CHECK(GrowthQuestion::parse("0.5 - x by n").text() == "1/2 - x by n");
  for (const char* text :
       {"", "holder", "holder by", " by n", "x - holder by n", "2 - by n", "two names by n", "a by b c"})
    CHECK_THROWS_AS(GrowthQuestion::parse(text), ParseError);
}

TEST_CASE("growth: power laws are found, each family and degree for itself") {
  Growths growths(GrowthQuestion::parse("2 - holder by n"));
  for (int n = 9; n >= 1; --n) {
    growths.add(answer(n, 1, to_text(2 - Rational(3, n * n))));  // 3 n^-2
    growths.add(answer(n, 3, to_text(2 - Rational(n * n * n, 5000))));
  }
  growths.add(answer(10, 1, "2"));  // no logarithm
  growths.add(answer(11, 1, "inf"));
  growths.add(answer(1, 5, "1"));  // too few
  growths.add(answer(2, 5, "1"));
  const auto found = growths.result();
  REQUIRE(found.size() == 2);
  CHECK(found[0].schemes == "primal:d=1");
  CHECK(found[0].count == 9);
  CHECK(found[0].last == 9);
  CHECK(found[0].factor == Approx(3));
  CHECK(found[0].power == Approx(-2));
  CHECK(found[0].deviation < 1e-12);
  CHECK(found[1].power == Approx(3));
  CHECK(found[1].last_power == Approx(3));

  Growths bent(GrowthQuestion::parse("holder by n"));
  for (int n : {1, 2, 4}) bent.add(answer(n, 1, std::to_string(n == 4 ? 16 : n)));  // 1, 2, 16
  CHECK(bent.result()[0].power == Approx(2));
  CHECK(bent.result()[0].last_power == Approx(3));
  CHECK(bent.result()[0].deviation == Approx(1.0 - 1 / std::pow(2, 2.0 / 3)));
}
