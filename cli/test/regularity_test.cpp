#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("regularity: the fields of the contract") {
  const auto regularity = run_json("regularity 'dual:n=7' --levels 16 --budget 4", -1);
  CHECK(regularity.at("sum_rules") == 3);
  CHECK(regularity.at("bound").at("levels") == 16);
  CHECK(regularity.at("bound").at("norm").is_string());
  CHECK(has_digits(regularity.at("bound").at("holder"), "lower", "2.633"));
  CHECK(regularity.at("stable") == true);
  CHECK(regularity.at("product").is_string());
  CHECK(has_digits(regularity.at("holder"), "upper", "2.994"));

  const auto closed = run_json("regularity primal:n=5");
  CHECK(closed.at("closed") == true);
  CHECK(closed.at("exact") == true);
  CHECK(closed.at("method") == "invariant polytope");
  CHECK(has_digits(closed.at("holder"), "lower", "1.99014395938"));

  const auto single = run_json("regularity 'mask:[-5,-7,35,105,105,35,-7,-5]/128'");
  CHECK(single.at("method") == "single spectral radius");
  CHECK(single.at("exact") == true);
  CHECK(has_digits(single.at("holder"), "lower", "2.830074998557"));
  CHECK(single.at("logarithm").at("at_most") == 0);
  CHECK(run_json("regularity four-point:w=1/16").at("logarithm").at("at_least") == 1);
  for (const char* command : {"regularity", "analyze"}) {
    const auto sobolev = run_json(std::string(command) + " dd:n=2").at("sobolev");
    CHECK(has_digits(sobolev.at("exponent"), "lower", "2.440765"));
    CHECK(sobolev.at("stable") == true);
    // Dependent shifts: no upper end.
    const auto unstable = run_json(std::string(command) + " 'mask:[1,2,2,2,1]/4'", -1).at("sobolev");
    CHECK(unstable.at("exponent").at("upper") == "inf");
    CHECK(unstable.at("stable") == false);
  }
}
