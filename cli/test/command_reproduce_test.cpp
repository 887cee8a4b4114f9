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

TEST_CASE("reproduce: a collection gives each value its source, within a budget") {
  const Run result = run("reproduce bivariate --budget 1 --json");
  CHECK(result.code <= 1);  // what is decided in a second depends on the machine
  const auto bivariate = nlohmann::json::parse(result.out);
  REQUIRE(bivariate.at("comparisons").size() > 25);
  for (const auto& comparison : bivariate.at("comparisons")) {
    CHECK(comparison.at("verdict") != "mismatch");
    CHECK(comparison.at("source").get<std::string>().front() == '[');
  }
  CHECK(bivariate.at("tables").at(0).at("table") == "schemes");
  for (const char* wrong : {"reproduce bivariate --budget 0", "reproduce bivariate --only table1"})
    CHECK(run(wrong).code == 64);
}
