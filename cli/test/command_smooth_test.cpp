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

TEST_CASE("positions come as they are: several data at one, falling, in no order, missing") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("smooth " + data + " " + arguments);
  };
  // Straight lines are kept; of several data at one position the fit sees all.
  const std::string ties = "x,y\n1,2\n1,3\n2,3\n3,4\n4,4\n5,6\n", options = "--irregular fit --bands 0 --quiet ";
  check_fails(with(ties, "--scheme primal:n=2"), 65,
              data +
                  ", lines 2 and 3: expected one row for each position; found 1 twice (--irregular fit takes several "
                  "data at one position)");
  for (const char* scheme :
       {"local:points=6,weight=box", "local:points=5", "local:width=10", "local:points=2", "local:d=1"}) {
    CAPTURE(scheme);
    const auto at_data = with(ties, options + "--json --at data --scheme " + scheme);
    REQUIRE(at_data.code == 0);
    const auto rows = nlohmann::json::parse(at_data.out).at("rows");
    REQUIRE(rows.size() == 6);
    CHECK(rows[0] == rows[1]);
  }
  // The line through all data.
  const auto fit = nlohmann::json::parse(
      with(ties, options + "--json --at data --scheme local:width=100,weight=box").out);
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const std::vector<std::pair<double, double>> points{{1, 2}, {1, 3}, {2, 3}, {3, 4}, {4, 4}, {5, 6}};
  for (const auto& [x, y] : points) sx += x, sy += y, sxx += x * x, sxy += x * y;
  const double slope = (6 * sxy - sx * sy) / (6 * sxx - sx * sx), start = (sy - slope * sx) / 6;
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(fit.at("rows")[i][1].get<double>() == Approx(start + slope * points[i].first).epsilon(1e-12));
  CHECK(with(ties, options + "--scheme primal:n=1").code == 0);
  check_fails(with("1,2\n1,3\n1,4\n", options), 65, data + ": expected two different positions; found 1 alone");

  // Falling positions give the same limit, in their own order, with the derivative by the position.
  std::string up = "x,y\n", down = "x,y\n";
  for (int i = 0; i < 12; ++i) up += std::to_string(i) + "," + std::to_string(i * i) + "\n";
  for (int i = 12; i-- > 0;) down += std::to_string(i) + "," + std::to_string(i * i) + "\n";
  for (const char* more : {" --level 0", " --level 1 --derivative 1", " --at data"}) {
    CAPTURE(more);
    const std::string arguments = "--scheme local:points=5,d=2 --json" + std::string(more);
    auto rising = nlohmann::json::parse(with(up, arguments).out),
         falling = nlohmann::json::parse(with(down, arguments).out);
    std::reverse(falling.at("rows").begin(), falling.at("rows").end());
    CHECK(rising.at("rows") == falling.at("rows"));
  }
  // Rows without order are sorted, and it is said.
  const auto sorted = with("x,y\n3,6\n0,0\n2,4\n1,2\n", "--scheme primal:n=1 --level 0 --bands 0");
  CHECK(sorted.err.find("the rows were sorted by their positions") != std::string::npos);
  CHECK(sorted.out.find("\n0,0,0\n1,2,0\n2,4,0\n3,6,0\n") != std::string::npos);
  const auto missing = with("x,y\n0,0\n,5\n1,2\n2,4\nNA,1\n3,6\n",
                            "--scheme primal:n=1 --level 0 --bands 0 --missing drop");
  CHECK(missing.err.find("rows without a position, left out: 2") != std::string::npos);
  CHECK(missing.out.find("\n0,0,0\n1,2,0\n2,4,0\n3,6,0\n") != std::string::npos);
  // Positions at the data are those of the data.
  const auto same = with("0.000,1\n0.333,2\n0.667,3\n1.000,4\n", "--scheme primal:n=1 --at data --bands 0 --quiet");
  CHECK(same.out == "column 1,column 2,column 2_sd\n0,1,0\n0.333,2,0\n0.667,3,0\n1,4,0\n");
}

TEST_CASE("the shortest command takes data as they are, and says so") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("smooth " + data + " " + arguments);
  };
  const std::string ties = "speed,dist\n4,2\n4,10\n7,4\n7,22\n8,16\n9,10\n10,18\n10,26\n10,34\n11,17\n";
  const std::string uneven = "x,y\n0,0\n1,1\n3,3\n4,4\n6,6\n7,7\n8,8\n";
  const std::string note =
      "subcert: note: the positions are not uniform and are taken as they are (--irregular raise "
      "refuses them)\n";
  for (const std::string& content : {ties, uneven})
    for (const char* scheme : {"", "--scheme local:d=1", "--scheme local:points=5,robust=2"}) {
      CAPTURE(scheme);
      const auto plain = with(content, scheme);
      CHECK(plain.code == 0);
      CHECK(plain.err.find(note) != std::string::npos);
      const auto asked = run("smooth " + data + " --irregular fit " + scheme);
      CHECK(plain.out == asked.out);
      CHECK(asked.err.find(note) == std::string::npos);
      CHECK(run("smooth " + data + " --irregular raise " + scheme).code == 65);
    }
  CHECK(with(uneven, "--scheme primal:n=2").code == 65);
  CHECK(with(uneven, "--scheme l1:points=4").code == 65);
  CHECK(with("x,y\n0,0\n1,1\n2,2\n3,3\n4,4\n", "--quiet").err.empty());

  // Dates that are numbers, over the end of a month; a column that only looks like dates for a while.
  const auto dates = with("date,v\n20240228,1\n20240229,2\n20240301,3\n20240302,4\n", "--scheme primal:n=1 --bands 0");
  CHECK(dates.err == "subcert: note: date holds dates as YYYYMMDD, and is taken in days\n");
  CHECK(dates.out.find("\n20240229,2,0\n20240229T060000,2.25,0\n") != std::string::npos);
  CHECK(dates.out.find("\n20240301,3,0\n") != std::string::npos);
  const auto numbers = with("id,v\n20240228,1\n20240229,2\n20240230,3\n20240231,4\n", "--scheme primal:n=1 --bands 0");
  CHECK(numbers.err.empty());
  CHECK(numbers.out.find("\n20240230,3,0\n") != std::string::npos);
}

TEST_CASE("tables come as they are: text, groups, dates, marks, names of rows") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("smooth " + data + " " + arguments + " --scheme primal:n=1 --bands 0 --at data --quiet");
  };
  const std::string cars = "make,speed,dist\nVW,1,2\n\"A, B\",2,4\nBMW,3,6\nVW,4,8\n";
  CHECK(with(cars, "").out == "speed,dist,dist_sd\n1,2,0\n2,4,0\n3,6,0\n4,8,0\n");
  CHECK(with(cars, "--keep make").out == "speed,dist,dist_sd,make\n1,2,0,VW\n2,4,0,\"A, B\"\n3,6,0,BMW\n4,8,0,VW\n");
  std::ofstream(data, std::ios::binary) << cars;
  CHECK(run("smooth " + data + " --scheme primal:n=1").err.find("make holds text and is left out") !=
        std::string::npos);
  check_fails(with(cars, "--y make"), 65, data + ", line 2, column 1: expected a number; found 'VW'");
  check_fails(with("a,b\n1,2\n2,x\n3,4\n", ""), 65, data + ", line 3, column 2: expected a number; found 'x'");
  check_fails(run("smooth " + data + " --keep a"), 64,
              "--keep needs --at data: other rows have no fields of the table");

  // Groups, each by itself and in the order of their first rows.
  CHECK(with("g,t,v\nb,0,1\na,10,5\nb,1,2\na,11,6\nb,2,3\na,12,7\n", "--by g").out ==
        "g,t,v,v_sd\nb,0,1,0\nb,1,2,0\nb,2,3,0\na,10,5,0\na,11,6,0\na,12,7,0\n");
  std::ofstream(data, std::ios::binary) << "g,t,v\nb,1,1\nb,0,2\nb,2,0\na,1,1\na,0,2\na,2,0\n";
  CHECK(run("smooth " + data + " --by g --scheme primal:n=1").err ==
        "subcert: note: the rows were sorted by their positions, t (--x COLUMN takes others, --x none counts the "
        "rows)\n");
  const auto groups = nlohmann::json::parse(with("g,t,v\nb,0,1\nb,1,2\na,1,2\n", "--by g --json").out);
  CHECK(groups.at("groups")[1].at("group") == "a");
  CHECK(groups.at("groups")[0].at("columns") == groups.at("groups")[1].at("columns"));

  // Dates are kept; on a finer grid times appear.
  CHECK(with("month,v\n2001-11,1\n2001-12,2\n2002-01,3\n2002-02,4\n", "").out ==
        "month,v,v_sd\n2001-11,1,0\n2001-12,2,0\n2002-01,3,0\n2002-02,4,0\n");
  CHECK(with("q,v\n2001Q3,1\n2001Q4,2\n2002Q1,3\n2002Q2,4\n", "").out ==
        "q,v,v_sd\n2001Q3,1,0\n2001Q4,2,0\n2002Q1,3,0\n2002Q2,4,0\n");
  CHECK(with("m,v\nMay 2001,1\nJune 2001,2\nJuly 2001,3\n", "").out ==
        "m,v,v_sd\nMay 2001,1,0\nJune 2001,2,0\nJuly 2001,3,0\n");
  std::ofstream(data, std::ios::binary) << "season,v\n2001-02,1\n2002-03,2\n2003-04,4\n2004-05,3\n";
  check_fails(run("smooth " + data), 65,
              data +
                  ", line 2, column 1: expected months; found '2001-02', which may be two years (write months with "
                  "days, or take another column by --x)");
  const std::string dates = "day,v\n2024-02-28,1\n2024-02-29,2\n2024-03-01,3\n";
  CHECK(with(dates, "").out == "day,v,v_sd\n2024-02-28,1,0\n2024-02-29,2,0\n2024-03-01,3,0\n");
  std::ofstream(data, std::ios::binary) << dates;
  CHECK(run("smooth " + data + " --scheme primal:n=1 --level 1 --bands 0 --quiet")
            .out.find("\n2024-02-29T12:00:00,2.5") != std::string::npos);
  CHECK(with("t,v\n2024-01-01 23:59:59.5Z,1\n2024-01-02 00:00:00.5Z,2\n2024-01-02 00:00:01.5Z,3\n", "").out ==
        "t,v,v_sd\n2024-01-01 23:59:59.5Z,1,0\n2024-01-02 00:00:00.5Z,2,0\n2024-01-02 00:00:01.5Z,3,0\n");
  check_fails(with("day,v\n2024-02-28,1\n2024-02-30,2\n", ""), 65,
              data + ", line 3, column 1: expected a date written as those before; found '2024-02-30'");

  std::string late = "note,day,v\n";  // dates that begin below what is looked at first
  for (int i = 0; i < 3000; ++i) late += "long text,,1\n";
  late += "x,2024-02-28,1\nx,2024-02-29,2\nx,2024-03-01,3\n";
  CHECK(with(late, "--x day --missing drop").out == "day,v,v_sd\n2024-02-28,1,0\n2024-02-29,2,0\n2024-03-01,3,0\n");

  // Other marks; names of rows as R writes them; years for names; another encoding.
  CHECK(with("a;b\n0,5;1,25\n1,5;2,5\n2,5;3,75\n", "--decimal ,").out ==
        "a;b;b_sd\n0,5;1,25;0\n1,5;2,5;0\n2,5;3,75;0\n");
  check_fails(with("a;b\n0,5;1\n", ""), 65,
              data + ", line 2, column 1: expected a number; found '0,5', a number with a comma for the decimal point");
  CHECK(with("a|b\n0|1\n1|2\n2|3\n", "--delimiter '|'").out == "a|b|b_sd\n0|1|0\n1|2|0\n2|3|0\n");
  CHECK(with("\"speed\" \"dist\"\n\"1\" 4 2\n\"2\" 7 4\n\"3\" 10 6\n", "").out ==
        "speed dist dist_sd\n4 2 0\n7 4 0\n10 6 0\n");
  CHECK(with("name,1960,1961\na,0,1\nb,1,2\nc,2,3\n", "--header yes").out ==
        "1960,1961,1961_sd\n0,1,0\n1,2,0\n2,3,0\n");
  check_fails(with(std::string("\xff\xfe"
                               "1\0,\0",
                               6),
                   ""),
              65, data + ": expected text in UTF-8; found UTF-16 (save it as UTF-8, or as CSV UTF-8)");
  check_fails(with(cars, "--delimiter ,, "), 64, "--delimiter ,,: expected one character, tab or blank");
  // Counted positions do not take the name of a column.
  CHECK(with("x,y\n5,1\n6,2\n7,3\n", "--x none --level 0").out ==
        "index,x,x_sd,y,y_sd\n0,5,0,1,0\n1,6,0,2,0\n2,7,0,3,0\n");
}

TEST_CASE("what a newcomer tries is answered with what would be right") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("smooth " + data + " " + arguments);
  };
  const std::string table = "x,x,value\n0,1,2\n1,2,3\n2,3,4\n3,4,5\n";
  check_fails(with(table, "--y x"), 64,
              "--y x: expected the name of one column; columns 1 and 2 have it, and are known by number");
  check_fails(with(table, "--y valeu"), 64,
              "--y valeu: expected a column from 1 to 3 or one of x, x, value; did you mean 'value'?");
  check_fails(with(table, "--bands 95"), 64,
              "--bands: expected a share of 1; 95 % are 0.95; see 'subcert smooth --help'");
  CHECK(with(table, "--y value --bands 0.95").code == 0);
  check_fails(with("# vtk DataFile Version 3.0\n", ""), 65,
              data + ": expected a table; found a volume (--grid smooths it)");
  check_fails(with("ply\nformat ascii 1.0\n", ""), 65,
              data + ": expected a table; found a mesh (subcert refine takes it)");
  const Run spaced = with("0,1\n2,3\n4,5\n6,7\n", "--spacing 1 --level 0 --quiet");
  CHECK(spaced.out.find("\n1,") == std::string::npos);
  CHECK(with("0,1\n2,3\n4,5\n6,7\n", "--spacing 1")
            .err.find("--spacing 1 is for irregular positions; these are uniform, 2 apart") != std::string::npos);
  CHECK(with("0,1\n2,3\n4,5\n6,7\n", "--spacing 2").err.find("irregular") == std::string::npos);
  // Data that are counted stand as far apart as is said, as in a stream.
  const std::string counted = "--x none --spacing 1/2 --scheme primal:n=1 --level 0 --bands 0 --quiet";
  CHECK(with("1\n2\n3\n", counted).out == "x,column 1,column 1_sd\n0,1,0\n0.5,2,0\n1,3,0\n");
  CHECK(with("1\n2\n3\n", counted + " --noise 1").out == with("1\n2\n3\n", counted + " --noise 1 --stream").out);
  // Squares that are no numbers any more.
  check_fails(with("0,1e-170\n1,2e-170\n2,1e-170\n3,2e-170\n", ""), 65,
              data +
                  ": expected numbers whose squares are within double precision; the largest modulus is 2e-170 (take "
                  "other units)");
  CHECK(with("0,0\n1,0\n2,0\n3,0\n", "").code == 0);
}

TEST_CASE("a group that cannot be smoothed does not stop the others") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  std::ofstream(data) << "g,t,v\na,0,1\na,1,2\na,2,4\na,3,4\nb,0,1\nb,1,2\nc,0,1\nc,1,5\nd,0,2\nd,1,4\nd,5,3\n";
  const std::string command = "smooth " + data + " --by g --irregular raise --level 0";
  const Run found = run(command + " --bands 0");
  CHECK(found.code == 65);
  CHECK(found.out.find("\na,3,4") != std::string::npos);
  CHECK(found.out.find("\nb") == std::string::npos);
  CHECK(found.err.find("g b, c, left out: " + data + ": expected at least 4 rows to choose a scheme; found 2") !=
        std::string::npos);
  CHECK(found.err.find("g d, left out: " + data + ", lines 10 and 11: expected a uniform grid") != std::string::npos);
  const auto json = run_json(command + " --quiet", 65);
  CHECK(json.at("groups").size() == 1);
  REQUIRE(json.at("refused").size() == 3);
  CHECK(json.at("refused")[2].at("group") == "d");
  std::ofstream(data) << "g,t,v\nb,0,1\nb,1,2\nc,0,1\nc,1,5\n";
  check_fails(run("smooth " + data + " --by g"), 65,
              "g b: " + data +
                  ": expected at least 4 rows to choose a scheme; found 2; name a scheme; nor can other "
                  "groups be smoothed");
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
        "--stream: expected none of --json, --plot, --at data, --irregular fit, --by");
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
        "--grid: expected none of --x, --y, --weights, --by, --keep, --missing, --irregular, --spacing, --derivative, "
        "--select cv, --stream");
  fails("--scheme primal:n=1 --by x", 64,
        "--grid: expected none of --x, --y, --weights, --by, --keep, --missing, --irregular, --spacing, --derivative, "
        "--select cv, --stream");
  fails("--scheme l1:points=4 --bands 0", 64, "smoothing: l1:points=4,d=1,iterations=6,delta=1e-8 is not linear");
  check_fails(run("smooth " + folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 4\nf 1 2 4 3\n") +
                  " --grid --scheme primal:n=1"),
              64,
              folder / "m.obj" +
                  ": expected a matrix of heights or a .vtk file; found a mesh, whose places are "
                  "data, too");
}
