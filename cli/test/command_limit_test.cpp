#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("limit: the fields of the contract") {
  const auto limit = run_json("limit 'primal:n=2' --level 0");
  CHECK(limit.at("first_index") == -3);
  CHECK(limit.at("values").at(3) == "9/31");
}

TEST_CASE("limit: surfaces") {
  const auto loop = run_json("limit loop: --level 0");
  CHECK(loop.at("indices").size() == 7);
  CHECK(loop.at("values").at(3) == "1/2");
  const auto finer = run_json("limit quincunx: --level 3");
  CHECK(finer.at("indices").size() == finer.at("values").size());
  check_fails(run("limit loop: --derivative 1"), 64, "--derivative: need a scheme of one variable, got loop");
}
