#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("limit: the fields of the contract") {
  const auto limit = run_json("limit 'primal:n=2' --level 0");
  CHECK(limit.at("first_index") == -3);
  CHECK(limit.at("values").at(3) == "9/31");
}
