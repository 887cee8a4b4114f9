#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("conjectures over a range, whole, split and continued") {
  const Folder folder;
  const auto seven = run_json("conjecture 7 --n 1..4 --d 1,3");
  CHECK(seven.at("conjecture") == 7);
  CHECK(seven.at("limits").size() == 2);
  CHECK(has_digits(seven.at("limits").at(0).at("constant"), "lower", "0.40443676798398528146"));
  CHECK(has_digits(seven.at("rows").at(3).at("limit_deviation"), "lower", "0.0736"));
  REQUIRE(seven.at("rows").size() == 7);
  CHECK(seven.at("rows").at(2).at("n") == 3);
  CHECK(has_digits(seven.at("rows").at(2).at("sup"), "lower", "0.1489"));
  CHECK(seven.at("rows").at(2).at("derivative_sup").at("upper").is_string());
  CHECK(seven.at("skipped").at(0).at("scheme") == "primal:n=1,d=3");
  CHECK(seven.at("verdict") == "holds");

  std::string journals;
  for (int shard = 1; shard <= 3; ++shard) {
    const std::string journal = folder / std::to_string(shard);
    const auto part = run_json("conjecture 7 --n 1..4 --d 1,3 --shard " + std::to_string(shard) + "/3 --journal " +
                               journal);
    CHECK(part.at("verdict").is_null());
    CHECK(part.at("rows").size() == (shard == 1 ? 3 : 2));
    journals += " " + journal;
  }
  const std::string whole = folder / "whole";
  CHECK(run("merge" + journals + " --out " + whole).out == whole + ": 7 cases\n");
  const std::string before = content(whole);
  CHECK(run_json("conjecture 7 --n 1..4 --d 1,3 --journal " + whole) == seven);
  CHECK(content(whole) == before);
  CHECK(run("conjecture 7 --n 1..4 --d 1,3").out ==
        run("conjecture 7 --n 1..4 --d 1,3 --jobs 1 --journal " + whole).out);

  const auto eight = run_json("conjecture 8 --n 1..4 --d 1..3");
  CHECK(eight.at("rows").size() == 8);
  CHECK(eight.at("verdict") == "holds");
}
