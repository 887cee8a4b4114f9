#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("theorems: proved, and unknown with what is missing") {
  const auto proved = run_json("theorem conjecture-8-n --d 1");
  CHECK(proved.at("theorem") == "conjecture-8-n");
  CHECK(proved.at("d").at(0) == 1);
  CHECK(proved.at("verdict") == "holds");
  CHECK(proved.at("constants").size() == 13);
  for (const auto& check : proved.at("checks")) CHECK(check.at("verdict") == "holds");
  check_fails(run("theorem conjecture-8-n --d 6"), 64,
              "--d 6: expected an odd degree; primal schemes of degree 6 are those of degree 7");
  const auto dual = run_json("theorem conjecture-7 --d 2 --family dual");
  CHECK(dual.at("verdict") == "holds");
  CHECK(dual.at("d").at(0) == 2);
  check_fails(run("theorem conjecture-7 --family bspline"), 64,
              "--family: 'bspline'; expected primal, primal-odd, dual, dual-odd; see 'subcert theorem --help'");
  const auto unknown = run_json("theorem conjecture-7 --d 31", 3);  // more time would not change it
  CHECK(unknown.at("verdict") == "unknown");
  CHECK_FALSE(unknown.at("missing").empty());
  const auto list = run_json("theorem list").at("theorems");
  CHECK(list.size() == 12);
  for (const auto& one : list) CHECK_FALSE(one.at("range").empty());
  CHECK(run_json("theorem convergence --d 41").at("verdict") == "holds");
  CHECK(run("theorem").out == run("theorem list").out);
}

TEST_CASE("theorems: where the budget ends, what was proved until then") {
  const auto none = run_json("theorem smoothness --d 1 --budget 0.001", 2);
  CHECK(none.at("verdict") == "unknown");
  CHECK(none.at("reason").get<std::string>().starts_with("the budget ran out after "));
  CHECK(run("theorem convergence --d 1 --budget 1000").code == 0);
}

TEST_CASE("theorems: where the budget ends between the large n and single schemes", "[long]") {
  const Run part = run("theorem smoothness --family dual --d 3 --budget 15");
  CHECK(part.code == 2);
  CHECK(contains(part.out, "missing: time, before the step "));
  CHECK(contains(part.out, "verdict: unknown (the budget ran out after "));
  CHECK(contains(part.out, "(V.7) holds"));
}
