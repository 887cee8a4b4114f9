#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("l1: the fields of the contract, and a certificate that is verified and refused when one factor is changed") {
  const Folder folder;
  const std::string file = folder / "l1.cert";
  const auto six = run_json("l1 l1:points=6,d=1 --certificate " + file);
  CHECK(six.at("unique") == true);
  CHECK(six.at("pieces") == 38);
  CHECK(six.at("contraction").at("steps") == 1);
  CHECK(six.at("contraction").at("order") == 1);
  CHECK(six.at("contraction").at("bound") == "3/5");
  CHECK(six.at("contraction").at("data").size() == 7);
  CHECK(six.at("converges") == "yes");
  CHECK(six.at("lipschitz") == "9/2");
  CHECK(has_digits(six.at("exponent"), "lower", "0.736965"));
  CHECK(has_digits(six.at("exponent"), "upper", "1.263034"));
  CHECK(six.at("edge").at("factor") == "5/12");
  CHECK(six.at("certificate").at("upper").is_string());
  CHECK(six.at("stays_in_range") == true);
  CHECK(run("verify " + file).code == 0);
  std::string text = content(file);
  const std::size_t leaf = text.find("leaf ");
  REQUIRE(leaf != std::string::npos);
  const std::size_t digit = text.find_first_of("123456789", leaf);
  text[digit] = text[digit] == '1' ? '2' : '1';
  folder.write("l1.cert", text);
  CHECK(run("verify " + file).code == 1);
}

TEST_CASE("l1: rules of several minimisers, linear ones, and those that do not converge") {
  CHECK(contains(run("l1 l1:points=6,d=1").out, "minimiser    unique for every datum"));
  const Run four = run("l1 l1:points=4,d=1");
  CHECK(four.code == 0);
  CHECK(contains(four.out, "not unique"));
  CHECK(contains(four.out, "|D S^2 f| <= 11/12 |D f|"));
  const Run median = run("l1 l1:points=5,d=0 --steps 1");
  CHECK(median.code == 1);
  CHECK(contains(median.out, "does not converge"));
  const auto linear = run_json("l1 l1:points=5,d=3 --steps 1");
  CHECK(linear.at("mask") == "[-35,-45,126,210,0,0,210,126,-45,-35]/256@-4");
  CHECK(has_digits(linear.at("exponent"), "lower", "0.86723298807198"));
  CHECK(run_json("l1 l1:points=5,d=2").at("contraction").at("order") == 2);
  const Folder folder;
  const std::string file = folder / "l1.cert";
  CHECK(contains(run("l1 l1:points=2,d=1 --certificate " + file).out, "not written: the fit interpolates its data"));
  CHECK(run_json("l1 l1:points=30 --budget 1", 2).at("converges") == "unknown");
  const Run late = run("l1 l1:points=8 --steps 2 --order 1 --budget 0.2");
  CHECK(late.code == 2);
  CHECK(contains(late.out, "none proved"));
  CHECK(contains(late.out, "of 3 differences bounded"));
  CHECK(run_json("l1 l1:points=6 --bound 9/10").at("contraction").at("bound") == "9/10");
  CHECK(run("analyze l1:points=6 --budget 5").out.starts_with("scheme"));
}

TEST_CASE("l1: other arities, with certificates") {
  const Folder folder;
  const std::string file = folder / "ternary.cert";
  const auto ternary = run_json("l1 l1:points=6,a=3 --certificate " + file);
  CHECK(ternary.at("contraction").at("bound") == "2/3");
  CHECK(ternary.at("converges") == "yes");
  CHECK(ternary.at("edge").is_null());
  CHECK(run("verify " + file).code == 0);
  CHECK(run("verify " + file + " --claim 'contraction 1,1 of l1:points=6,a=3 <= 2/3'").code == 0);
  CHECK(run("verify " + file + " --claim '1/3 <= l1:points=6,a=3'").code == 0);
  CHECK(run("verify " + file + " --claim '1/2 <= l1:points=6,a=3'").code == 1);
  CHECK(run("verify " + file + " --claim '1/3 <= l1:points=6'").code == 1);
  CHECK(run_json("l1 l1:points=5,d=3,a=3 --steps 1").at("mask") ==
        "[-20,-27,-28,70,108,140,0,0,0,140,108,70,-28,-27,-20]/162@-6");
  check_fails(run("l1 l1:points=6,a=3 --steps 6"), 64, "--steps: need at most 5 for arity 3, got 6");
  CHECK(run("l1 l1:points=6,a=1").code == 64);
}

TEST_CASE("l1: the rule itself, with delta and a number of fits") {
  const auto four = run_json("l1 l1:points=4,iterations=7,delta=1e-6");
  CHECK(four.at("rule").at("bound") == "19/20");
  CHECK(four.at("rule").at("fits") == 7);
  const auto six = run_json("l1 l1:points=6");
  CHECK(six.at("rule").is_null());
  CHECK(contains(run("l1 l1:points=6").out, "130000 boxes do not suffice; --rule"));
  CHECK(run_json("l1 l1:points=6,iterations=3 --rule").at("rule").at("fits") == 3);
  CHECK(six.at("impulse_level") == 7);
  CHECK(six.at("keeps_monotone") == false);
  CHECK_FALSE(run_json("l1 l1:points=4,exact").contains("rule"));
  CHECK(contains(run("l1 l1:points=5,iterations=2").out, "so that it converges for all data"));
  for (const char* open : {"points=6,a=3", "points=6,d=2", "points=14", "points=5,tolerance=1/100"})
    CHECK(contains(run(std::string("l1 --steps 1 --budget 1 l1:") + open).out,
                   "unknown whether it converges for all data"));
  CHECK_FALSE(run_json("l1 l1:points=6,iterations=0").contains("rule"));
}

TEST_CASE("l1: the budget is of the rule itself, too") {
  const auto late = run_json("l1 l1:points=5,iterations=10 --budget 0.01", 2);
  CHECK(late.at("rule").is_null());
  CHECK(late.at("impulse_level").is_null());
  const Run text = run("l1 l1:points=5,iterations=10 --budget 0.01");
  CHECK(contains(text.out, "unknown whether it converges for all data  (the budget does not suffice)"));
  CHECK(contains(text.out, "unknown whether 1 among zeros has a limit  (the budget does not suffice)"));
}

TEST_CASE("l1: bad input") {
  check_fails(run("l1 dd:n=2"), 64, "dd:n=2: need a scheme of the family l1, as l1:points=6,d=1");
  CHECK(run("l1 l1:points=6x6").code == 64);
  CHECK(run("l1 l1:points=6,residuals=joint").code == 64);
  CHECK(run("l1 l1:points=6 --order 3").code == 64);
  CHECK(run("l1 l1:points=6 --steps 9").code == 64);
  check_fails(run("l1 l1:points=6 --bound=-1"), 64, "--bound: expected a number that is not negative, got '-1'");
  CHECK(run("l1 l1:points=6 --bound x").code == 64);
  CHECK(run("l1 l1:points=6 --certificate /nowhere/at/all.cert").code == 66);
}
