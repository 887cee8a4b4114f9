#include "refused.hpp"

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/file_error.hpp>
#include <subcert/proofs-checks/sweeps/scheme_grid.hpp>
#include <subcert/proofs-checks/sweeps/sweep_plan.hpp>

#include <algorithm>

using namespace subcert;
using namespace subcert::sweeps;
using Texts = std::vector<std::string>;

TEST_CASE("schemes of a grid: ranges, steps and lists, the last key first") {
  CHECK(schemes_of_grid("primal:n=1..2,d={1,3}") ==
        Texts{"primal:n=1,d=1", "primal:n=1,d=3", "primal:n=2,d=1", "primal:n=2,d=3"});
  CHECK(schemes_of_grid("four-point:w=-1/8..1/4 step 1/8") ==
        Texts{"four-point:w=-1/8", "four-point:w=0", "four-point:w=1/8", "four-point:w=1/4"});
  CHECK(schemes_of_grid(" dd:n={1, 3..4} ") == Texts{"dd:n=1", "dd:n=3", "dd:n=4"});
  CHECK(schemes_of_grid("x:w=0..0.25") == Texts{"x:w=0"});
  CHECK(schemes_of_grid("x:w={2}") == Texts{"x:w=2"});
  for (const char* text : {"mask:[1,2,1]/2@-1", "[1,2,1]/2", "(1+z)^4/8", "chaikin", "tensor:(dd:n=2)x(dd:n=1)",
                           "daubechies:n=3", "mask:[a,1-a,1-a,a],where=a^2=2", ""})
    CHECK(schemes_of_grid(text) == Texts{text});
}

TEST_CASE("schemes of a grid: what is refused, with its place") {
  testing::check_refused({{"primal:n=3..1", 10},
                          {"primal:n=1...3", 10},
                          {"primal:n=1..", 13},
                          {"dd:n=1..4 step 0", 6},
                          {"dd:n={1..x}", 10},
                          {"dd:n={1,,2}", 6},
                          {"dd:n={1,2", 6},
                          {"dd:n=1..2000000", 6},
                          {"a:x=1..2000,y=1..2000", 1},
                          {"masks:long=3", 7},
                          {"masks:length=0..3", 7},
                          {"masks:length=90,numerators=9", 7}},
                         [](const std::string& text) { schemes_of_grid(text); });
}

TEST_CASE("all small masks: sums of classes, ends that are not zero, one of two mirror images") {
  CHECK(schemes_of_grid("masks:length=3,numerators=1,denominator=2") == Texts{});
  CHECK(schemes_of_grid("masks:length=3,numerators=2,denominator=2") == Texts{"mask:[1,2,1]/2"});
  // By trying all: four numerators of -3..3 whose classes sum to 2.
  std::size_t count = 0;
  for (int a = -3; a <= 3; ++a)
    for (int b = -3; b <= 3; ++b) {
      const int c = 2 - a, d = 2 - b;
      if (std::max(std::abs(c), std::abs(d)) > 3 || a == 0 || d == 0) continue;
      count += std::vector{a, b, c, d} >= std::vector{d, c, b, a} ? 1 : 0;
    }
  CHECK(schemes_of_grid("masks:length=4,numerators=3,denominator=2").size() == count);
  const Texts ternary = schemes_of_grid("masks:length=3..5,arity=3");
  CHECK(std::ranges::find(ternary, "mask:[1,1,1],arity=3") != ternary.end());
}

TEST_CASE("conditions: three-valued, on enclosures, numbers and words") {
  const Json answer = Json::parse(
      R"({"holder": {"lower": "1.5", "upper": "1.75"}, "open": {"lower": "1", "upper": "inf"},
    "exact": true, "converges": "yes", "stable": "unknown", "none": null, "rules": 4, "x": {"y": 2.5}, "n": "3"})");
  const auto holds = [&](const std::string& text) {
    return Condition::parse("--expect", text).holds([&](const std::string& name) { return member_at(answer, name); });
  };
  for (const char* text :
       {"holder > 1.4", "holder >= 3/2", "holder < 1.76", "holder <= 1.75", "holder != 2", "open >= 1", "exact == yes",
        "converges == yes", "converges != no", "rules == 4", "x.y > 2", "n >= 3", "holder.lower == 1.5",
        "exact and converges", "holder > 1 and rules >= 4 and exact == yes"}) {
    CAPTURE(text);
    CHECK(holds(text) == Truth::yes);
  }
  for (const char* text :
       {"holder > 1.75", "holder >= 2", "holder < 1.5", "holder <= 1.4", "holder == 2", "open < 1", "exact == no",
        "rules != 4", "n > 3", "holder > 1 and rules < 4", "none > 1 and rules < 4"}) {
    CAPTURE(text);
    CHECK(holds(text) == Truth::no);
  }
  for (const char* text : {"holder > 1.6", "holder == 1.6", "open > 1", "open <= 5", "none == 1", "missing > 1",
                           "stable == yes", "stable", "missing", "converges > 1", "rules > 3 and holder > 1.6"}) {
    CAPTURE(text);
    CHECK(holds(text) == Truth::unknown);
  }
  for (const char* text : {"", "two names", "holder 1 and exact", "and exact", "holder >", "> 1", "holder > x",
                           "holder = 1", "holder > 1 and", "a > 1 > 0"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(holds(text), ParseError);
  }
}

TEST_CASE("conditions on schemes without limits: nothing is met that only limits have") {
  const auto meets = [](const char* converges, const std::string& text) {
    const Json answer = {{"converges", converges},
                         {"holder", {{"lower", "-inf"}, {"upper", "inf"}}},
                         {"formula", nullptr},
                         {"rules", 1}};
    return Condition::parse("--expect", text).meets([&](const std::string& name) { return member_at(answer, name); });
  };
  for (const char* text : {"holder > 1", "holder < 1", "holder.lower < 1", "holder != 1", "formula == 1",
                           "rules == 1 "
                           "and holder > 1"}) {
    CAPTURE(text);
    CHECK(meets("no", text) == Truth::no);
    CHECK(meets("unknown", text) == Truth::unknown);
  }
  CHECK(meets("no", "rules == 1") == Truth::yes);
  CHECK(meets("no", "missing == 1") == Truth::unknown);
}

TEST_CASE("plans of sweeps: read, refused, and their schemes") {
  const SweepPlan plan = read_sweep_plan(R"(
    schemes = ["primal:n=1..4,d=1", "dd:n=2", "primal:n=3,d=1"]
    ask = ["regularity", "variance"]
    where = "n >= 2"
    budget = 2.5
    memory = 100
  )");
  CHECK(plan.ask == Texts{"regularity", "variance"});
  CHECK(plan.budget == 2.5);
  CHECK_FALSE(plan.certificates);
  CHECK(read_sweep_plan("schemes = [\"a\"]\ncertificates = true").certificates);
  CHECK(plan.memory == 100);
  CHECK(schemes_of_plan(plan) == Texts{"primal:n=2,d=1", "primal:n=3,d=1", "primal:n=4,d=1", "dd:n=2"});
  for (const char* text :
       {"", "schemes = []", "schemes = 3", "schemes = [\"a\"]\nask = [\"jsr\"]", "schemes = [\"a\"]\nscheme = 1",
        "schemes = [\"a\"]\nbudget = 0", "schemes = [\"a\"]\nbudget = nan", "schemes = [\"a\"]\nmemory = 99.5",
        "schemes = [\"a\"]\nwhere = \"n >\"", "schemes = [\"a\"]\nexpect = \"two names\"",
        "schemes = [\"a\"]\ncertificates = 1", "schemes ="}) {
    CAPTURE(text);
    CHECK_THROWS_AS(read_sweep_plan(text), FileError);
  }
  const auto refused = [](const SweepPlan& bad) -> std::string {
    try {
      schemes_of_plan(bad);
    } catch (const Error& error) {
      return fmt::format("{} {}", error.kind() == ErrorKind::data ? "data" : "usage", error.what());
    }
    return "";
  };
  const std::string why =
      "scheme specification, position 6: '3..1'; expected A..B or A..B step S with A <= B and S > 0";
  CHECK(refused(read_sweep_plan("schemes = [\"a\",\n  \"dd:n=3..1\"]")) == "data line 2, column 3: " + why);
  SweepPlan many;
  many.schemes = {{"dd:n=3..1"}};
  CHECK(refused(many) == "usage " + why);
  many.schemes = {{"a:x=1..1000000"}, {"a:x=1000000"}};  // the same
  CHECK(schemes_of_plan(many).size() == 1'000'000);
  many.schemes.push_back({"a:x=1000001"});
  CHECK(refused(many) == "usage sweep: need at most 1000000 schemes");
}
