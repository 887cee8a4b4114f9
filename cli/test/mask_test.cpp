#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("mask: the fields of the contract") {
  const auto mask = run_json("mask 'dual:n=2'");
  CHECK(mask.at("first_index") == -4);
  CHECK(mask.at("coefficients").size() == 8);
  CHECK(mask.at("coefficients").at(0) == "7/40");
  CHECK(mask.at("support").at("upper") == "3");
}
