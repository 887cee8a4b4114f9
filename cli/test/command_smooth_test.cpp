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
            "and 3 (--irregular fit takes positions as they are)");
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
        "smoothing: prior weights, missing data and given positions need a scheme of local regressions");
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

TEST_CASE("data at scattered positions are smoothed, by local polynomials and by schemes") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  std::ofstream(data, std::ios::binary) << "t,v\n0,1\n0.5,2\n2,\n2.25,5.5\n4,9\n4.5,10\n7,15\n8,17\n";
  const auto smoothed = [&](const std::string& arguments) {
    return run_json("smooth " + data + " --irregular fit --missing drop " + arguments);
  };
  for (const char* scheme : {"local:points=4", "local:width=3,weight=box", "primal:n=2", "local:d=1"}) {
    CAPTURE(scheme);
    const auto json = smoothed(std::string("--spacing 1/2 --level 1 --scheme ") + scheme);
    REQUIRE(json.at("rows").size() == 33);
    for (const auto& row : json.at("rows")) CHECK(row[1].get<double>() == Approx(1 + 2 * row[0].get<double>()));
  }
  const auto there = smoothed("--at data --scheme local:points=5,d=2,weight=biweight --noise 0.25");
  CHECK(there.at("rows").size() == 7);
  CHECK(there.at("rows")[2][0] == 2.25);
  CHECK(there.at("noise")[0].at("sigma") == 0.25);
  CHECK(there.at("noise")[0].at("degrees_of_freedom").is_null());
  CHECK(smoothed("").at("scheme").get<std::string>().substr(0, 13) == "local:points=");
  const std::string command = "smooth " + data + " --irregular fit --missing drop ";
  check_fails(run(command + "--at data --scheme primal:n=2"), 64,
              "smoothing: the limit of a scheme is known on a grid alone; at the data need local polynomials");
  check_fails(run(command + "--spacing 0"), 64, "--spacing 0: expected a number > 0");
  check_fails(run(command + "--noise -1"), 64, "--noise -1: expected a standard deviation > 0");
  check_fails(run(command + "--scheme local:points=9"), 65,
              data + ": expected at least 9 data for local:points=9,d=1,weight=tricube; found 7");
  check_fails(run(command + "--scheme local:width=0.1"), 65,
              data + ": smoothing: 1 data count at 0 spacings from the first, a fit of degree 1 needs 2");
}

TEST_CASE("a stream is smoothed as the whole is") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  std::string table = "t,v,w\n";
  for (int i = 0; i < 30000; ++i)
    table += std::to_string(i / 4) + "." + std::to_string(25 * (i % 4)) + "," + std::to_string((i * 7919) % 101) + "," +
             std::to_string(1 + i / 20000) + "\n";
  std::ofstream(data, std::ios::binary) << table;
  for (const char* arguments : {" --scheme primal:n=4 --y v", " --scheme dual:n=3 --y v --weights w --boundary mirror",
                                " --scheme local:points=9 --bands-kind prediction --level 0"}) {
    CAPTURE(arguments);
    const std::string whole = run("smooth " + data + " --noise 30" + arguments).out;
    CHECK(run("smooth - --stream --noise 30" + std::string(arguments) + " < " + data).out == whole);
    CHECK(whole.size() > 1'000'000);
  }
  const auto fails = [&](const std::string& arguments, int code, const std::string& message) {
    CAPTURE(arguments);
    check_fails(run("smooth " + data + " --stream --y v " + arguments), code, message);
  };
  fails("", 64, "--stream needs --scheme: the choice needs all data");
  fails("--scheme primal:n=2 --json", 64, "--stream: expected none of --json, --plot, --at data, --irregular fit");
  fails("--scheme primal:n=2 --bands 0.9", 64, "--stream: --bands needs --noise, as its estimate needs all data");
  fails("--scheme primal:n=2 --boundary wrap", 64, "a stream has no end that its beginning could follow");
  fails("--scheme l1:points=4", 64, "a stream needs a linear method; l1:points=4,d=1,iterations=6,delta=1e-8 is none");
  fails("--scheme primal:n=2 --spacing 1", 65,
        data + ", line 3: expected 1, on the grid of spacing 1; found the position 0.25 (--spacing sets it)");
  std::ofstream(data, std::ios::binary) << "1,2\n2,3\n2,4\n";
  check_fails(run("smooth " + data + " --stream --scheme primal:n=2"), 65,
              data + ", line 3, column 1: expected increasing positions; found 2 after 2");
  check_fails(run("smooth - --stream --scheme primal:n=2 < /dev/null"), 65,
              "standard input: expected rows of numbers; found none");
}
