#include "program.hpp"

#include <fmt/format.h>

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
        "column 1,column 2,column 2_sd\n0,1,0\n0.5,2,0\n1,3,0\n1.5,4,0\n2,5,0\n2.5,6,0\n3,7,0\n3.5,8,0\n4,9,0\n");
  CHECK(with(wave, "--out " + out + " --plot " + out + ".svg").out.empty());
  CHECK(content(out).find("# chosen for the smallest estimated mean squared error") != std::string::npos);
  const std::string picture = content(out + ".svg");
  CHECK(picture.find("<svg") != std::string::npos);
  for (const char* text : {">residual of v<", ">t<", ">95 % band<", "fill-opacity = '0.300000'"})
    CHECK(picture.find(text) != std::string::npos);
  std::ofstream(data, std::ios::binary) << "t_s,flow_rate" + wave.substr(3);
  for (const char* ending : {".png", ".pdf", ".tex", ".html"})
    CHECK(run("smooth " + data + " --quiet --out " + out + " --plot " + out + ending).code == 0);
  CHECK(
      run("smooth " + data + " --scheme primal:n=6,d=3 --derivative 2 --out " + out + " --plot " + out + ".svg").code ==
      0);
  const std::string derivative = content(out + ".svg");
  CHECK(derivative.find(">2nd derivative of flow_rate by t_s<") != std::string::npos);
  CHECK(derivative.find("residual") == std::string::npos);
  const std::string png = content(out + ".png");  // 920 x 1024 pixels, in the first chunk
  CHECK(png.substr(16, 8) == std::string("\0\0\x03\x98\0\0\x04\0", 8));
  std::ofstream(data, std::ios::binary) << wave;
  const auto json = run_json("smooth " + data + " --level 0 --boundary mirror");
  CHECK(json.at("auto") == true);
  CHECK(json.at("spacing") == "1/10");
  CHECK(json.at("choice").at("candidates").size() > 20);
  for (const auto& one : json.at("choice").at("candidates")) CHECK(one.at("bias_squared").get<double>() >= 0);
  CHECK(run_json("smooth " + data + " --select cv --derivative 1").at("choice").at("chosen").at("bias_squared") >= 0);
  CHECK(json.at("choice").at("chosen").at("scheme") == json.at("scheme"));
  CHECK(json.at("columns") == nlohmann::json({"t", "v", "v_sd", "v_lower", "v_upper"}));
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
  fails("0,1\n1,2\n3,3\n4,5\n", "--irregular raise", 65,
        data +
            ", lines 2 and 3: expected a uniform grid, the mean spacing is 1.33333333; found the spacing 2 between 1 "
            "and 3 (--irregular fit takes positions as they are)");
  fails("0,1\n1,\n2,3\n", "", 65,
        data + ", line 2, column 2: expected a number; found a missing value (--missing drop leaves it out)");
  fails("0,1\n,2\n2,3\n", "", 65,
        data + ", line 2, column 1: expected a position; found a missing value (--missing drop leaves the row out)");
  fails("0,1,1\n1,2,-1\n2,3,1\n", "--weights 3", 65, data + ", line 2, column 3: expected a weight >= 0; found -1");
  fails("0,1\n1,2\n", "", 65, data + ": expected at least 4 rows to choose a scheme; found 2; name a scheme");
  fails(line, "--weights u", 64, "--weights u: expected a column from 1 to 3 or one of t, v, w");
  fails(line, "--y v --scheme primal:n=2 --derivative 3", 1,
        "primal:n=2,d=1: derivative 3 is not continuous; the mask has only 2 sum rules, and its shifts are stable");
  fails(line, "--y v --weights w --scheme bspline:degree=3", 64,
        "smoothing: prior weights, missing data and given positions need a scheme of local regressions");
  fails(line, "--y v --scheme l1:points=6 --bands-kind prediction", 64,
        "--bands-kind prediction needs a linear scheme; l1:points=6,d=1,iterations=6,delta=1e-8 is none");
  fails(line, "--y v --scheme local:points=6,robust=1 --bands-kind prediction", 64,
        "--bands-kind prediction: a new datum may be an outlier, of which robust steps know nothing");
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

TEST_CASE("standard deviations of the noise stand for weights, and known noise") {
  const Folder folder;
  std::string table = "t,v,s,w\n";
  for (int i = 0; i < 40; ++i)
    table += fmt::format("{},{},{},{}\n", i, (i * 7919) % 13, i < 20 ? "0.5" : "2", i < 20 ? "4" : "0.25");
  const std::string data = folder.write("data.csv", table), y = "smooth " + data + " --y v --quiet ";
  const std::string by_errors = run(y + "--errors s --scheme primal:n=3").out;
  CHECK(by_errors == run(y + "--weights w --noise 1 --scheme primal:n=3").out);
  CHECK(by_errors.find("nan") == std::string::npos);
  CHECK(run(y + "--errors s --noise 3 --scheme local:d=1").out ==
        run(y + "--weights w --noise 3 --scheme local:d=1").out);
  check_fails(run(y + "--errors s --weights w"), 64, "--weights and --errors: expected one of the two");
  const std::string zero = folder.write("zero.csv", "t,v,s\n0,1,1\n1,2,0\n2,3,1\n");
  check_fails(run("smooth " + zero + " --errors s"), 65,
              zero + ", line 3, column 3: expected a standard deviation from 1e-75 to 1e75; found 0");
}

TEST_CASE("values stand where positions are named, by a list or by a table") {
  const Folder folder;
  const std::string data = folder / "data.csv", places = folder / "places.csv", picture = folder / "plot.svg";
  std::string rows = "t,v\n", days = "day,v\n";
  for (int i = 0; i < 20; ++i) {
    rows += fmt::format("{:.1f},{}\n", 0.1 * (19 - i), 2 * (19 - i));  // falling
    days += fmt::format("202401{:02},{}\n", i + 1, 3 * i);
  }
  std::ofstream(data, std::ios::binary) << rows;
  for (const char* scheme : {"primal:n=2", "local:points=7,d=1", "l1:points=4,iterations=9"}) {
    const std::string command = "smooth " + data + " --bands 0 --quiet --scheme " + scheme;
    const auto json = run_json(command + " --at 1.25,0.3,0.3 --level 5");
    CHECK(json.at("at") == "positions");
    REQUIRE(json.at("rows").size() == 3);
    const double expected[][2] = {{1.25, 25}, {0.3, 6}, {0.3, 6}};
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < 2; ++c) CHECK(std::abs(json.at("rows")[k][c].get<double>() - expected[k][c]) < 1e-9);
  }
  std::ofstream(places, std::ios::binary) << "name;t\nb;0.5\na;9\n";
  const auto listed = run("smooth " + data + " --scheme dd:n=2 --bands 0 --at-file " + places + " --plot " + picture);
  CHECK(listed.out.find("\n0.5,10,") != std::string::npos);
  CHECK(listed.out.find("\n9,nan,nan\n") != std::string::npos);
  CHECK(listed.err.find("positions not between the first datum and the last, where values are nan: 1") !=
        std::string::npos);
  CHECK(content(picture).find("<svg") != std::string::npos);
  CHECK(run_json("smooth " + data + " --bands 0 --quiet --at 9,1").at("rows")[0][1].is_null());
  for (const char* wrong : {"dat", "1,,2", "1,", "''", "2024-01-01", "data --at-file x", "1 --at-file x", "1 --keep v",
                            "1 --stream --scheme dd:n=2", "1 --grid"})
    CHECK(run("smooth " + data + " --at " + wrong).code == 64);
  CHECK(run("smooth " + data + " --at 99").err.find("between the first datum and the last, 0 and 1.9; found none") !=
        std::string::npos);
  CHECK(run("smooth " + data + " --at-file " + folder / "none").code == 66);
  std::ofstream(places, std::ios::binary) << "t\n0.5\nNA\n";
  const auto missing = run("smooth " + data + " --at-file " + places);
  CHECK(missing.code == 65);
  CHECK(missing.err.find("places.csv, line 3, column 1: expected a number") != std::string::npos);

  std::ofstream(data, std::ios::binary) << days;
  const std::string dated = "smooth " + data + " --scheme primal:n=1 --bands 0 --quiet --at ";
  CHECK(run(dated + "2024-01-03,20240105").out.find("20240103,6,0\n20240105,12,0\n") != std::string::npos);
  CHECK(run(dated + "3").err.find("each a date as those of the data; found '3'") != std::string::npos);
}

TEST_CASE("errors of data are weights alone for methods that find the noise by themselves") {
  const Folder folder;
  std::string rows = "t,v,s,w\n";
  for (int i = 0; i < 40; ++i)
    rows += fmt::format("{},{},{},{}\n", i, i + (i % 7 == 3 ? 9.0 : 0.1 * (i % 3)), i % 2 + 1, i % 2 == 0 ? 1.0 : 0.25);
  const std::string command = "smooth " + folder.write("d.csv", rows) + " --y v --quiet --scheme ";
  for (const char* scheme : {"local:points=15,d=1,robust=3", "l1:points=6,iterations=5 --bands 0"})
    CHECK(run(command + scheme + " --errors s").out == run(command + scheme + " --weights w").out);
  CHECK(run(command + "local:points=15,d=1,robust=3 --errors s --noise 1").code == 64);
}

TEST_CASE("a grid with a gap is answered on this grid") {
  const Folder folder;
  std::string table = "time,v\n";
  for (int i = 0; i < 48; ++i)
    if (i < 20 || i > 24) table += fmt::format("2024-03-{:02}T{:02}:00:30Z,{}\n", 1 + i / 24, i % 24, i);
  const Run answer = run("smooth " + folder.write("data.csv", table) + " --level 0 --bands 0 --scheme local:d=1");
  CHECK(std::ranges::count(answer.out, '\n') >= 48);
  for (int i = 0; i < 48; ++i)
    CHECK(contains(answer.out, fmt::format("\n2024-03-{:02}T{:02}:00:30Z,", 1 + i / 24, i % 24)));
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
  const auto of_scheme = smoothed("--at data --scheme primal:n=2 --spacing 1/2");
  REQUIRE(of_scheme.at("rows").size() == 7);
  for (const auto& row : of_scheme.at("rows")) CHECK(row[1].get<double>() == Approx(1 + 2 * row[0].get<double>()));
  check_fails(run(command + "--spacing 0"), 64, "--spacing 0: expected a number > 0");
  for (const std::string noise : {"-1", "0", "1e200", "1e-200"})
    check_fails(run(command + "--noise " + noise), 64,
                "--noise " + noise + ": expected a standard deviation from 1e-150 to 1e150");
  check_fails(run(command + "--scheme local:points=9"), 65,
              data + ": expected at least 9 data for local:points=9,d=1,weight=tricube; found 7");
  check_fails(run(command + "--scheme local:width=0.1"), 65,
              data +
                  ": smoothing: 1 datum counts at 0 spacings from the first, a fit of degree 1 needs 2; take a larger "
                  "width (the farthest have weight 0)");
}

TEST_CASE("the last position is not lost by rounding, and row numbers that are positions are said") {
  const Folder folder;
  const std::string tenths = folder.write("t.csv",
                                          "x,y\n1,1\n1.1,2\n1.2,3\n1.3,2\n1.4,5\n1.5,4\n1.6,3\n1.7,6\n1.9,5\n");
  CHECK(run("smooth " + tenths + " --irregular fit").out.find("\n1.9,") != std::string::npos);
  CHECK(run("smooth " + tenths + " --irregular fit --spacing 0.1").out.find("\n1.9,") != std::string::npos);
  const std::string numbered = folder.write("n.csv", "\"\",\"a\"\n1,2\n2,3\n3,5\n4,4\n5,6\n6,5\n");
  CHECK(run("smooth " + numbered).err.find("the positions are the column without a name") != std::string::npos);
  CHECK(run("smooth " + numbered + " --x 1").err.find("without a name") == std::string::npos);
  // Names of rows beside two columns: the table without them has the same answer.
  const std::string rows = folder.write("r.csv", "\"\",\"a\",\"b\"\n1,2,1\n2,3,2\n3,5,4\n4,7,5\n5,8,6\n6,11,5\n"),
                    bare = folder.write("b.csv", "a,b\n2,1\n3,2\n5,4\n7,5\n8,6\n11,5\n");
  const Run named = run("smooth " + rows);
  CHECK(named.out == run("smooth " + bare).out);
  CHECK(named.err.find("the first column has no name, counts the rows, and is left out (--x 1 takes it)") !=
        std::string::npos);
  CHECK(run("smooth " + rows + " --x 1 --scheme primal:n=1 --bands 0 --quiet").out.substr(0, 12) == "\"\",a,a_sd,b,");
  const std::string other = folder.write("o.csv", "\"\",\"a\",\"b\"\n1,2,1\n2,3,2\n4,5,4\n5,7,5\n6,8,6\n7,11,5\n");
  CHECK(run("smooth " + other).err.find("the positions are the column without a name") != std::string::npos);
  std::string tiny = "x,y\n";
  for (int i = 1; i < 20; ++i) tiny += std::to_string(i) + "e-320," + std::to_string(i % 3) + "\n";
  const Run too_large = run("smooth " + folder.write("e.csv", tiny) +
                            " --irregular fit --derivative 2 --scheme local:points=7,d=3");
  check_fails(too_large, 65,
              folder / "e.csv" + ": smoothing: values beyond the range of double precision; expected other units");
  const std::string path = folder.path.string();
  check_fails(run("smooth " + path), 66, path + ": expected a file; found a folder");
}

TEST_CASE("outliers are said, and left out by robust methods, with bands that say how they are made") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  std::string table = "x,y\n";
  for (int i = 0; i < 80; ++i)
    table += std::to_string(i + (i * 7919) % 13 / 26.0) + "," +
             std::to_string(i / 10.0 + ((i * i * 7919) % 101) / 100.0 + (i % 9 == 4 ? 50 : 0)) + "\n";
  std::ofstream(data, std::ios::binary) << table;
  const std::string command = "smooth " + data + " --irregular fit --at data ";
  const Run plain = run(command);
  CHECK(plain.code == 0);
  CHECK(plain.err.find("y: 9 outliers move this fit") != std::string::npos);
  CHECK(plain.err.find("--scheme local:d=1,robust=3") != std::string::npos);
  CHECK(run(command + "--quiet").err.empty());
  for (const auto& [scheme, method] : {std::pair{"local:d=1,robust=3", "sandwich"},
                                       {"local:points=21,robust=3", "sandwich"},
                                       {"l1:points=12,iterations=auto", "bootstrap"}}) {
    CAPTURE(scheme);
    const Run robust = run(command + "--bands 0.9 --json --scheme " + scheme);
    CHECK(robust.err.find("move this fit") == std::string::npos);
    const auto json = nlohmann::json::parse(robust.out);
    CHECK(json.at("bands_method") == method);
    for (const auto& row : json.at("rows")) {
      CHECK(std::abs(row[1].get<double>() - row[0].get<double>() / 10 - 0.5) < 0.8);
      CHECK(row[3].get<double>() < row[4].get<double>());
    }
    CHECK(run(command + "--bands 0.9 --scheme " + scheme).out.find(method) != std::string::npos);
  }
  CHECK(run_json(command + "--quiet").at("noise")[0].at("outliers") == 9);
  check_fails(run("smooth - --stream --scheme local:points=9,robust=3 < " + data), 64,
              "a stream needs a linear method; local:points=9,d=1,weight=tricube,robust=3 has robust steps");
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
  fails("--scheme primal:n=2 --json", 64,
        "--stream: expected none of --json, --plot, --at, --at-file, --irregular fit, --by, --series rows");
  fails("--scheme primal:n=2 --bands 0.9", 64, "--stream: --bands needs --noise, as its estimate needs all data");
  fails("--scheme primal:n=2 --boundary wrap", 64, "a stream has no end that its beginning could follow");
  fails("--scheme l1:points=4", 64, "a stream needs a linear method; l1:points=4,d=1,iterations=6,delta=1e-8 is none");
  fails("--scheme primal:n=2 --spacing 1", 65,
        data + ", line 3: expected 1, on the grid of spacing 1; found the position 0.25 (--spacing sets it)");
  std::ofstream(data, std::ios::binary) << "1,2\n2,3\n2,4\n";
  check_fails(run("smooth " + data + " --stream --scheme primal:n=2"), 65,
              data + ", line 3, column 1: expected increasing positions in a stream; found 2 after 2");
  check_fails(run("smooth - --stream --scheme primal:n=2 < /dev/null"), 65,
              "standard input: expected rows of numbers; found none");
}

TEST_CASE("heights and volumes are smoothed") {
  const Folder folder;
  const std::string plane = folder.write("plane.csv", "0;1;2;3\n2;3;4;5\n4;5;6;7\n6;7;8;9\n");
  const Run smoothed = run("smooth " + plane + " --grid --scheme local:points=3,d=1,weight=box --level 0 --noise 1");
  CHECK(smoothed.code == 0);
  CHECK(
      smoothed.out.starts_with("# scheme local:points=3,d=1,weight=box along each axis, boundary interp\n"
                               "# noise of value: standard deviation 1, as given\n# bands: 95 % pointwise"));
  const std::string head = "\nx;y;value;value_sd;value_lower;value_upper\n0;0;";
  REQUIRE(smoothed.out.find(head) != std::string::npos);
  CHECK(std::abs(std::stod(smoothed.out.substr(smoothed.out.find(head) + head.size()))) < 1e-14);
  const auto json = run_json("smooth " + plane +
                             " --grid --scheme 'tensor:(primal:n=1)x(primal:n=1)' --level 1 --json");
  CHECK(json.at("columns") == nlohmann::json({"x", "y", "value", "value_sd", "value_lower", "value_upper"}));
  REQUIRE(json.at("rows").size() == 49);
  for (const auto& row : json.at("rows"))
    CHECK(std::abs(row[2].get<double>() - row[0].get<double>() - 2 * row[1].get<double>()) < 1e-12);
  const std::string volume = folder.write("v.vtk",
                                          "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n"
                                          "DIMENSIONS 3 2 2\nORIGIN 1 0 0\nSPACING 0.5 1 1\nPOINT_DATA 12\n"
                                          "SCALARS d float\nLOOKUP_TABLE default\n0 1 2 1 2 3 1 2 3 2 3 4\n");
  const Run of_volume = run("smooth " + volume + " --grid --scheme primal:n=1 --level 1");
  CHECK(of_volume.out.find("DIMENSIONS 5 3 3\nORIGIN 1 0 0\nSPACING 0.25 0.5 0.5\nPOINT_DATA 45\n"
                           "SCALARS d double 1\nLOOKUP_TABLE default\n0\n0.5\n1\n1.5\n2\n") != std::string::npos);
  CHECK(of_volume.out.find("FIELD FieldData 3\nd_sd 1 45 double\n") != std::string::npos);
  CHECK(run("smooth " + plane + " --grid --scheme primal:n=1 --plot " + folder / "p.svg").code == 0);
  const auto chosen = run_json("smooth " + plane + " --grid --bands-kind simultaneous");
  CHECK(chosen.at("auto") == true);
  CHECK(chosen.at("choice").at("chosen").at("scheme") == chosen.at("scheme"));
  CHECK(run("smooth " + plane + " --grid").out.find("# chosen for the smallest estimated") != std::string::npos);
  const auto fails = [&](const std::string& arguments, int code, const std::string& message) {
    CAPTURE(arguments);
    check_fails(run("smooth " + plane + " --grid " + arguments), code, message);
  };
  fails("--select cv", 64,
        "--grid: expected none of --x, --y, --weights, --by, --keep, --irregular, --spacing, --series, "
        "--derivative, --select cv, --stream, --at-file, and of --at grid or data");
  fails("--scheme primal:n=1 --by x", 64,
        "--grid: expected none of --x, --y, --weights, --by, --keep, --irregular, --spacing, --series, "
        "--derivative, --select cv, --stream, --at-file, and of --at grid or data");
  const std::string gap = folder.write("gap.csv", "1,2\n3,NA\n4,5\n");
  check_fails(run("smooth " + gap + " --grid --scheme primal:n=1"), 65,
              gap +
                  ", line 2, column 2: expected a finite number; found 'NA' (subcert smooth --grid fills gaps, with "
                  "--missing drop)");
  check_fails(run("smooth " + gap + " --grid --missing drop --scheme primal:n=1 --bands 0"), 64,
              "missing data need local polynomials, as local:points=7,d=1; primal:n=1,d=1 is a scheme");
  check_fails(run("refine primal:n=1 " + gap), 65,
              gap +
                  ", line 2, column 2: expected a finite number; found 'NA' (subcert smooth fills gaps, with --missing "
                  "drop)");
  fails("--scheme l1:points=4 --bands 0", 64, "smoothing: l1:points=4,d=1,iterations=6,delta=1e-8 is not linear");
  check_fails(run("smooth " + folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 4\nf 1 2 4 3\n") +
                  " --grid --scheme primal:n=1"),
              64,
              folder / "m.obj" +
                  ": expected a matrix of heights or a .vtk file; found a mesh, whose places are "
                  "data, too");
}

TEST_CASE("grids with missing data: fits to what is there, holes that are filled or kept") {
  const Folder folder;
  std::string rows;
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 11; ++i)
      rows += (i == 4 && j == 3 ? "" : i == 5 && j == 3 ? "NA" : std::to_string(i + 10 * j)) + (i == 10 ? "\n" : ",");
  const std::string plane = folder.write("holes.csv", rows);
  const std::string command = "smooth " + plane + " --grid --scheme local:points=5,d=1 --at data --missing ";
  const auto drop = run_json(command + "drop"), keep = run_json(command + "keep");
  CHECK(drop.at("missing") == 2);
  for (std::size_t k = 0; k < 99; ++k) {
    CHECK(std::abs(drop.at("rows")[k][2].get<double>() - static_cast<double>(k % 11 + 10 * (k / 11))) < 1e-9);
    for (std::size_t c = 2; c < 6; ++c) CHECK(keep.at("rows")[k][c].is_null() == (k == 37 || k == 38));
  }
  CHECK(run(command + "drop").out.find("# 2 missing data, left out of the fits\n") != std::string::npos);
  CHECK(run(command + "keep").out.find("# 2 missing data, where values are nan\n") != std::string::npos);
  CHECK(run("smooth " + plane + " --grid --missing drop --plot " + folder / "p.svg").code == 0);
  check_fails(run(command + "drop --bands-kind simultaneous"), 64,
              "smoothing: bands at all positions at once need a grid without missing data");
  check_fails(run("smooth " + plane + " --missing keep"), 64,
              "--missing keep: expected --grid, or drop; of rows --at data has values where data are");

  std::string volume =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 5 4 4\nORIGIN 0 0 0\n"
      "SPACING 1 1 1\nPOINT_DATA 80\nSCALARS d float\nLOOKUP_TABLE default\n";
  for (int k = 0; k < 80; ++k) volume += (k == 31 ? "nan" : std::to_string(k)) + "\n";
  const std::string file = folder.write("holes.vtk", volume);
  CHECK(run("smooth " + file + " --grid --bands 0 --scheme local:width=3,d=1").code == 65);
  const Run filled = run("smooth " + file +
                         " --grid --bands 0 --scheme local:width=3,d=1 --level 0 --missing drop --json");
  CHECK(std::abs(nlohmann::json::parse(filled.out).at("rows")[31][3].get<double>() - 31) < 1e-9);
  CHECK(run("smooth " + file + " --grid --scheme local:width=3,d=1 --level 0 --missing keep").out.find("\nnan\n") !=
        std::string::npos);
}

TEST_CASE("values and their slopes are smoothed together") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("smooth " + data + " --quiet --bands 0 " + arguments);
  };
  // Two points and a box: cubic Hermite interpolation, here with the weights 1/2, 1/2 and 1/4, -1/4.
  const std::string cubic = "t,s,v\n0,0,0\n1,1,3\n3,27,27\n4,64,48\n";
  CHECK(with(cubic, "--hermite --scheme local:points=2,d=3,weight=box --at 2 --noise 1 --slope-noise 1").out ==
        "t,s,s_sd,v,v_sd\n2,8,0.7905694150420949,12,1.118033988749895\n");
  CHECK(with(cubic, "--hermite --scheme local:width=9,d=3 --derivative 2 --at 2 --noise 1").out.rfind("\n2,12", 20) !=
        std::string::npos);
  // Columns as for refine: of an even number none has positions.
  const std::string square = "x,y,dx,dy\n1,0,0,1\n0,1,-1,0\n-1,0,0,-1\n0,-1,1,0\n";
  const std::string each = "--hermite --scheme local:points=1,d=1,weight=box --at data ";
  const std::string counted = with(square, each).out;
  CHECK(counted.starts_with("index,x,x_sd,y,y_sd,dx,dx_sd,dy,dy_sd\n0,1,0.57735"));
  CHECK(counted == with(square, each + "--closed").out);
  CHECK(counted == with(square, each + "--x none").out);
  // A chosen window, pictures and outliers of both kinds.
  std::string wave = "t,s,v\n";
  for (int i = 0; i < 60; ++i)
    wave += fmt::format("{},{},{}\n", 0.1 * i, std::sin(0.1 * i) + 0.1 * ((i * 7919) % 13 - 6) / 6,
                        i == 30 ? 9 : std::cos(0.1 * i) + 0.1 * ((i * 104'729) % 11 - 5) / 5);
  with(wave, "--hermite");
  const auto chosen = run("smooth " + data + " --hermite --plot " + data + ".svg");
  CHECK(chosen.code == 0);
  CHECK(chosen.err.find("note: v: 2 outliers move this fit") != std::string::npos);
  CHECK(content(data + ".svg").find(">residual of v<") != std::string::npos);
  const auto json = run_json("smooth " + data + " --hermite --scheme local:points=9,d=3,robust=3 --at data");
  CHECK(json.at("bands_method") == "sandwich");
  CHECK(json.at("noise").size() == 2);
  for (const auto& row : json.at("rows")) CHECK(std::abs(row[5].get<double>() - std::cos(row[0].get<double>())) < 0.25);

  check_fails(with(cubic, "--hermite --scheme primal:n=2"), 64,
              "--hermite: expected local polynomials, as --scheme local:points=21,d=3; found primal:n=2");
  check_fails(with(cubic, "--hermite --boundary mirror"), 64,
              "--boundary mirror: expected interp or wrap with --hermite");
  check_fails(with(cubic, "--hermite --stream --scheme local:points=3"), 64,
              "--hermite: expected none of --grid, --stream, --series rows");
  check_fails(with(cubic, "--slope-noise 1"), 64, "--slope-noise needs --hermite");
  check_fails(with(cubic, "--hermite --slope-noise 0"), 64,
              "--slope-noise 0: expected a standard deviation from 1e-150 to 1e150");
  check_fails(with(cubic, "--hermite --slope-noise 1 --scheme local:points=3,robust=1"), 64,
              "--slope-noise: robust steps find the noise by themselves");
  check_fails(with(cubic, "--hermite --derivative 2 --irregular fit"), 64,
              "derivative 2: of values with slopes windows are chosen for these; name points or a width");
  check_fails(with(cubic, "--scheme local:points=2,d=3 --y s --noise 1 --irregular fit"), 64,
              "local:points=2,d=3,weight=tricube: expected points as an integer from 4; half as many need values with "
              "slopes");
}
