#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("reproduce: the fields of the contract") {
  const auto reproduce = run_json("reproduce dyn-2015 --only table1,table2");
  CHECK(reproduce.at("comparisons").size() == 18);
  for (const auto& comparison : reproduce.at("comparisons")) CHECK(comparison.at("verdict") == "match");
  const auto star = run_json("reproduce dyn-2015 --only fig17");
  CHECK(star.at("comparisons").empty());
  REQUIRE(star.at("experiments").size() == 1);
  CHECK(star.at("experiments").at(0).at("runs") == 50);
  for (const auto& claim : star.at("experiments").at(0).at("claims"))
    CHECK(claim.at("finding") == claim.at("recorded"));
}
