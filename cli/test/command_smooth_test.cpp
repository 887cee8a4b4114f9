#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("data are smoothed") {
  const Folder folder;
  const std::string data = folder / "data.csv", out = folder / "out.csv";
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("smooth " + data + " " + arguments);
  };
  std::string line = "t,v,w\n", wave = "t,v\n";
  for (int i = 0; i < 12; ++i) line += std::to_string(i) + "," + std::to_string(2 * i + 1) + ",1\n";
  for (int i = 0; i < 60; ++i)
    wave += std::to_string(0.1 * i) + "," + std::to_string(std::sin(0.1 * i) + 0.1 * ((i * 7919) % 13 - 6) / 6) + "\n";

  CHECK(with("0,1\n1,3\n2,5\n3,7\n4,9\n", "--scheme primal:n=1 --level 1 --quiet --bands 0").out ==
        "column 1,column 2,sd\n0,1,0\n0.5,2,0\n1,3,0\n1.5,4,0\n2,5,0\n2.5,6,0\n3,7,0\n3.5,8,0\n4,9,0\n");
  CHECK(with(wave, "--out " + out + " --plot " + out + ".svg").out.empty());
  CHECK(content(out).find("# chosen for the smallest estimated mean squared error") != std::string::npos);
  CHECK(content(out + ".svg").find("<svg") != std::string::npos);
  std::ofstream(data, std::ios::binary) << wave;
  const auto json = run_json("smooth " + data + " --level 0 --boundary mirror");
  CHECK(json.at("auto") == true);
  CHECK(json.at("spacing") == "1/10");
  CHECK(json.at("choice").at("candidates").size() == 15 + 14 + 13);
  CHECK(json.at("choice").at("chosen").at("scheme") == json.at("scheme"));
  CHECK(json.at("columns") == nlohmann::json({"t", "v", "sd", "lower", "upper"}));
  REQUIRE(json.at("rows").size() == 60);
  for (const auto& row : json.at("rows")) {
    CHECK(row[3].get<double>() < row[1].get<double>());
    CHECK(row[1].get<double>() < row[4].get<double>());
    CHECK(std::abs(row[1].get<double>() - std::sin(row[0].get<double>())) < 0.1);
  }
  std::ofstream(data, std::ios::binary) << line;
  const auto slope = run_json("smooth " + data + " --scheme primal:n=3 --derivative 1 --y v --weights w");
  for (const auto& row : slope.at("rows")) CHECK(std::abs(row[1].get<double>() - 2) < 1e-12);
  for (const char* boundary : {"interp", "mirror", "nearest", "constant", "wrap"})
    CHECK(run("smooth " + data + " --y v --weights w --scheme dual:n=2 --boundary " + boundary).code == 0);
  const auto gap = with("0,1\n1,3\n2,\n3,7\n4,9\n5,11\n",
                        "--scheme primal:n=2 --missing drop --level 0 --bands 0 --quiet");
  CHECK(gap.code == 0);
  CHECK(gap.out.find("\n2,5") != std::string::npos);
  CHECK(with(line, "--y v --scheme l1:points=6 --level 1").code == 0);

  const auto fails = [&](const std::string& content, const std::string& arguments, int code,
                         const std::string& message) {
    CAPTURE(arguments);
    check_fails(with(content, arguments), code, message);
  };
  fails("0,1\n1,2\n3,3\n4,5\n", "", 65,
        data +
            ", lines 2 and 3: expected a uniform grid, the mean spacing is 1.33333333; found the spacing 2 between 1 "
            "and 3");
  fails("0,1\n2,2\n1,3\n", "", 65, data + ", line 3, column 1: expected increasing positions; found 1 after 2");
  fails("0,1\n1,\n2,3\n", "", 65,
        data + ", line 2, column 2: expected a number; found a missing value (--missing drop leaves it out)");
  fails("0,1\n,2\n2,3\n", "--missing drop", 65,
        data + ", line 2, column 1: expected a position; found a missing value");
  fails("0,1,1\n1,2,-1\n2,3,1\n", "--weights 3", 65, data + ", line 2, column 3: expected a weight >= 0; found -1");
  fails("0,1\n1,2\n", "", 65, data + ": expected at least 4 rows to choose a scheme; found 2; name one with --scheme");
  fails(line, "--weights u", 64, "--weights u: expected a column from 1 to 3 or one of t, v, w");
  fails(line, "--y v --scheme primal:n=2 --derivative 3", 64,
        "derivative 3: primal:n=2,d=1 is not proved to have continuous "
        "derivatives of that order; the mask has only 2 sum rules");
  fails(line, "--y v --weights w --scheme bspline:degree=3", 64,
        "smoothing: prior weights and missing data need a scheme of local regressions");
  fails(line, "--y v --scheme l1:points=6 --bands 0.9", 64,
        "--bands needs a linear scheme; l1:points=6,d=1,iterations=6,delta=1e-8 is none");
  fails("", "", 65, data + ": expected rows of numbers; found none");
  CHECK(with("5\n", "--scheme primal:n=2 --quiet").out == "x,column 1\n0,5\n");
  CHECK(run("smooth " + folder / "nowhere.csv").code == 66);
  CHECK(run("smooth " + data + " --boundary other").code == 64);
  CHECK(run("smooth " + data + " --auto --scheme primal:n=2").code == 64);

  // A prediction band has the noise in it, too.
  std::ofstream(data, std::ios::binary) << wave;
  const auto predicted = run_json("smooth " + data + " --scheme primal:n=3 --bands-kind prediction");
  const auto expected = run_json("smooth " + data + " --scheme primal:n=3");
  CHECK(predicted.at("bands_kind") == "prediction");
  const double sigma = predicted.at("noise")[0].at("sigma");
  for (std::size_t i = 0; i < predicted.at("rows").size(); ++i) {
    const auto wide = predicted.at("rows")[i].get<std::vector<double>>();
    const auto narrow = expected.at("rows")[i].get<std::vector<double>>();
    CHECK(wide[1] == narrow[1]);
    CHECK((wide[4] - wide[1]) / (narrow[4] - narrow[1]) ==
          Approx(std::sqrt(wide[2] * wide[2] + sigma * sigma) / wide[2]).epsilon(1e-9));
  }
  // A simultaneous band is wider by one factor.
  const auto together = run_json("smooth " + data + " --scheme primal:n=3 --bands-kind simultaneous");
  std::vector<double> factors;
  for (std::size_t i = 0; i < together.at("rows").size(); ++i) {
    const auto wide = together.at("rows")[i].get<std::vector<double>>();
    const auto narrow = expected.at("rows")[i].get<std::vector<double>>();
    factors.push_back((wide[4] - wide[1]) / (narrow[4] - narrow[1]));
  }
  CHECK(factors.front() > 1.2);
  CHECK(factors.front() < 3);
  for (const double factor : factors) CHECK(factor == Approx(factors.front()).epsilon(1e-9));
  fails(wave, "--scheme primal:n=5 --bands-kind prediction --derivative 1", 64,
        "--bands-kind prediction: a new datum has no derivative; leave out --derivative");

  // Standard input and output, and the name of the input in errors.
  std::ofstream(data, std::ios::binary) << wave;
  const std::string plain = run("smooth " + data + " --scheme primal:n=3").out;
  CHECK(run("smooth - --scheme primal:n=3 --out - < " + data).out == plain);
  CHECK_FALSE(plain.empty());
  CHECK(run("smooth " + data + " --scheme primal:n=3 --jobs 3").out == plain);
  std::ofstream(data, std::ios::binary) << "0,1\n1,x\n";
  check_fails(run("smooth - < " + data), 65, "standard input, line 2, column 2: expected a number; found 'x'");
}
