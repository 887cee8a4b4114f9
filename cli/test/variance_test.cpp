#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("variance: the fields of the contract") {
  const auto variance = run_json("variance primal:n=1");
  CHECK(variance.at("mean") == "2/3");
  CHECK(variance.at("sup").at("lower") == "1");
  CHECK(variance.at("sup").at("upper") == "1");
  CHECK(variance.at("inf").at("upper") == "0.5");
  CHECK(has_digits(variance.at("derivative_sup"), "upper", "2.00000000"));
  const auto smooth = run_json("variance dd:n=2");
  CHECK(smooth.at("sup").at("lower") == "1");
  CHECK(smooth.at("complete") == true);
  CHECK(has_digits(smooth.at("derivative_sup"), "lower", "1.09267"));
  CHECK(run_json("variance four-point:w=1/5").at("derivative_sup").is_null());
  CHECK(run_json("variance primal:n=10 --budget 0.000001", 2).at("complete") == false);
}
