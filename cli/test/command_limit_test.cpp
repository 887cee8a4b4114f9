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
}

TEST_CASE("limit: derivatives of surfaces") {
  // The slope along x of the three-directional quartic box spline at its neighbours of the centre.
  const auto slope = run_json("limit loop: --level 0 --derivative 1,0");
  CHECK(slope.at("derivative") == nlohmann::json({1, 0}));
  CHECK(slope.at("indices").front() == nlohmann::json({-1, -1}));
  CHECK(slope.at("values").front() == "1/6");
  CHECK_FALSE(run_json("limit 'tensor:(dd:n=2)x(dd:n=2)' --derivative 1,1").at("values").empty());
  const Run rough = run("limit loop: --derivative 2,1");
  CHECK(rough.code == 3);
  CHECK(rough.out.empty());
  CHECK(rough.err ==
        "subcert: loop: derivative 2,1 is not proved to be continuous; the exponent is proved to be at least "
        "3, and has to be above 3\n");
  check_fails(run("limit loop: --derivative 1"), 64,
              "--derivative: need an order for each of 2 variables, as 1,0, got '1'");
  check_fails(run("limit dd:n=2 --derivative 1,0"), 64,
              "--derivative: need one order for a scheme of one variable, got '1,0'");
  check_fails(run("limit loop: --derivative 1,x"), 64, "--derivative: expected orders from 0 to 1000, got 'x'");
}

TEST_CASE("limit: vectors of functions") {
  const auto cubic = run_json("limit merrien:lambda=-1/8,mu=-1/2 --level 1");
  CHECK(cubic.at("components") == 2);
  CHECK(cubic.at("indices") == nlohmann::json({{-1}, {0}, {1}}));
  CHECK(cubic.at("values") == nlohmann::json::parse(R"([["1/2","-1/8"],["1","0"],["1/2","1/8"]])"));
  const auto slopes = run_json("limit merrien:lambda=-1/8,mu=-1/2 --level 1 --derivative 1");
  CHECK(slopes.at("values") == nlohmann::json::parse(R"([["3/2","-1/4"],["0","1"],["-3/2","-1/4"]])"));
  CHECK(run("limit merrien:lambda=-1/8,mu=-1/2 --derivative 2").code == 2);
  CHECK(run("limit 'refinable:[[[1,0],[0,1]],[[1,0],[0,1]]]@0'").code == 1);
  // one of two
  const std::string both = "[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1";
  check_fails(run("limit 'refinable:" + both + "' --level 0"), 64,
              "refinable:" + both +
                  ": need one continuous solution up to a factor, got up to 2; their integrals are combinations of "
                  "[1,0] and [0,1], and one is chosen as by integral=[1,0]");
  CHECK(run_json("limit 'vector:" + both + ",integral=[1,-4]' --level 0").at("values") ==
        nlohmann::json::parse(R"([["1","-2"],["0","-2"]])"));
  CHECK(run("limit 'refinable:" + both + ",integral=[0,0]'").code == 64);
  // numbers of a field
  CHECK(run_json("limit cl:2 --level 1").at("values") ==
        nlohmann::json::parse(R"json([["1/2","-1/4*sqrt(7)"],["1","0"],["1/2","1/4*sqrt(7)"]])json"));
  CHECK(run("limit cl:2 --level 1").out.find("-0.661437827766148") != std::string::npos);
  CHECK(run("limit ghm --range").code == 64);
}

TEST_CASE("limit: extremes and sign") {
  const auto loop = run_json("limit loop: --range");
  CHECK(loop.at("maximum").at("lower") == "0.5");
  CHECK(loop.at("maximum").at("point") == nlohmann::json({"0", "0"}));
  CHECK(loop.at("minimum").at("upper") == "0");
  CHECK(loop.at("nonnegative").at("verdict") == "yes");
  const auto butterfly = run_json("limit butterfly:w=1/16 --range --width 1/1000 --budget 100");
  CHECK(butterfly.at("nonnegative").at("verdict") == "no");
  CHECK(has_digits(butterfly.at("maximum"), "lower", "1"));
  const auto curve = run_json("limit dd:n=2 --range");
  CHECK(curve.at("nonnegative").at("verdict") == "no");
  CHECK(has_digits(curve.at("maximum"), "lower", "1"));
  CHECK(run("limit primal:n=2 --range").out.find("nonnegative      yes: ") != std::string::npos);
  check_fails(run("limit loop: --range --level 2"), 64, "--range: takes neither --level nor --derivative");
  check_fails(run("limit loop: --range --width 0"), 64,
              "--width: expected a positive number, as 1e-9 or 1/1000, got '0'");
  CHECK(run("limit 'mask:[1,1]' --range").code == 1);
}

TEST_CASE("limit: masks that change from level to level") {
  const Folder folder;
  const std::string spline = "limit exponential-bspline:v --recurrence 'v=sqrt((1+v)/2)' --start v0=1/2 --level 0";
  const Run page = run(spline);
  CHECK(contains(page.out, "           0     0.608997781044229      0.60899778104423\n"));
  const auto enclosed = run_json(spline);
  CHECK(enclosed.at("first_index") == -2);
  CHECK(enclosed.at("order") == 2);
  CHECK(enclosed.at("values").at(2).at("lower").get<std::string>().starts_with("0.6089977810442293"));
  CHECK(contains(run(spline + " --latex").out, "at least"));
  const auto exact = run_json("limit four-point:w --values w=1/8,1/16 --level 1");
  CHECK(exact.at("scheme") == "four-point:w with w = 1/8, 1/16");
  CHECK(exact.at("values").at(5) == "5/8");
  CHECK(run("limit four-point:w --values w=1/16 --level 4").out == run("limit four-point:w=1/16 --level 4").out);
  const std::string pair = folder.write("pair.toml", "masks = [\"dd:n=2\", \"bspline:degree=3\"]\nperiod = [0, 1]\n");
  CHECK(run_json("limit lists:" + pair + " --level 0").at("values").at(3) == "82/93");
  CHECK(run_json("limit lists:" + pair).at("level") == 8);
  // Masks of matrices: one in turn with itself, the parameters of a family, and two that take turns.
  const auto of_list = [&](const std::string& name, const std::string& masks, const std::string& period) {
    return "limit lists:" + folder.write(name, "masks = [" + masks + "]\n" + period);
  };
  const std::string merrien = "merrien:lambda=-1/8,mu=", two = "\"" + merrien + "3/2\", \"" + merrien + "-1/2\"";
  CHECK(run(of_list("one.toml", "\"ghm\"", "period = [0, 0]") + " --level 2").out == run("limit ghm --level 2").out);
  const std::string turn = of_list("two.toml", two, "period = [0, 1]") + " --level ";
  const auto vectors = run_json(turn + "2");
  CHECK(vectors.at("scheme") == merrien + "3/2, " + merrien + "-1/2 again and again");
  CHECK(vectors.at("components") == 2);
  CHECK(vectors.at("dilation") == std::vector<std::vector<int>>{{2}});
  CHECK(run(turn + "2 --latex").code == 0);
  CHECK(run(of_list("any.toml", two, "") + " --level 1").code == 64);
  check_fails(run(turn + "1 --derivative 1"), 64,
              "--derivative: cannot be asked for with masks that change from level to level");
  CHECK(run(turn + "60").code == 64);
  CHECK(run(of_list("apart.toml", "\"" + merrien + "2\", \"" + merrien + "5\"", "period = [0, 1]")).code == 1);
  CHECK(run("limit merrien:lambda=-1/8,mu=w --recurrence w=w/2 --start w0=1").code == 64);
  CHECK(run("limit four-point:w --recurrence w=w/2+1/2 --start w0=0").code == 2);
  CHECK(run("limit four-point:w --values w=1/16,1").code == 1);
  check_fails(run(spline + " --range"), 64, "--range: cannot be asked for with masks that change from level to level");
  CHECK(run(spline + " --derivative 1").code == 64);
}
