#include "program.hpp"

#include <algorithm>
#include <fstream>

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

TEST_CASE("reproduce: against an earlier run") {
  const Folder folder;
  const std::string earlier = (folder.path / "earlier").string(), results = earlier + "/results.json";
  REQUIRE(run("reproduce dyn-2015 --only table1,supports --out " + earlier).code == 0);
  const Run same = run("reproduce dyn-2015 --only table1 --baseline " + earlier);
  CHECK(same.code == 0);
  CHECK(same.out.ends_with("Against " + earlier + ": 9 results, 0 changed, 0 of them so that it matters.\n"));

  auto changed = nlohmann::json::parse(content(results));
  auto& list = changed["results"];
  REQUIRE(list.at(0).at("key").get<std::string>().starts_with("dyn-2015-supports-primal-2n-point"));
  const auto table1 = std::find_if(list.begin(), list.end(), [](const auto& one) { return one["item"] == "table1"; });
  (*table1)["verdict"] = "mismatch";
  table1[1]["enclosure"] = {{"lower", "3"}, {"upper", "3"}};
  table1[2]["computed"] = "1.8";
  table1[3]["key"] = "dyn-2015-table1-other";
  std::ofstream(results) << changed.dump();
  const Run other = run("reproduce dyn-2015 --only table1 --json --baseline " + earlier);
  CHECK(other.code == 1);
  const auto changes = nlohmann::json::parse(other.out).at("changes");
  std::vector<bool> matters;
  for (const auto& change : changes) matters.push_back(change.at("matters"));
  CHECK(matters == std::vector{true, true, false, false, true});  // verdict, excluded, text, new, gone
  CHECK(changes.at(0).at("change").get<std::string>().starts_with("match, was mismatch"));
  CHECK(changes.at(4).at("key") == "dyn-2015-table1-other");

  std::ofstream(results) << "{}";
  check_fails(run("reproduce dyn-2015 --only table1 --baseline " + earlier), 65,
              results + ": expected {\"results\": [...]} as 'subcert reproduce --out' writes it");
  std::ofstream(results) << R"({"results": [{"key": 1}]})";
  check_fails(run("reproduce dyn-2015 --only table1 --baseline " + earlier), 65,
              results + ": result 1: expected the text 'key'");
  CHECK(run("reproduce dyn-2015 --only table1 --baseline " + earlier + "/none").code == 66);
}
