#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("tables of other programs: the line sep=, empty lines below a header, units below names") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("smooth " + data + " --quiet --bands 0 --scheme primal:n=1 " + arguments);
  };
  const Run plain = with("x;y\n0;1,5\n1;2,5\n2;3,5\n", "--decimal ,");
  REQUIRE(plain.code == 0);
  CHECK(with("sep=;\r\nx;y\r\n0;1,5\r\n1;2,5\r\n2;3,5\r\n", "--decimal ,").out == plain.out);
  CHECK(with("\xef\xbb\xbfsep=;\nx;y\n\n0;1,5\n1;2,5\n2;3,5\n", "--decimal ,").out == plain.out);
  // The separator of the first line is taken where another would be guessed; an option is over it.
  CHECK(with("sep=|\nx|y\n0|1\n1|2\n2|3\n", "").code == 0);
  CHECK(with("sep=,\nx;y\n0;1,5\n1;2,5\n2;3,5\n", "--delimiter ';' --decimal ,").out == plain.out);
  check_fails(with("t;y\n;mm\n2024-01-01;1,5\n2024-01-02;2,5\n2024-01-03;3,5\n", "--missing drop"), 65,
              data + ": expected a column of values; found none (" + data +
                  ", line 2, column 2: expected a number; found 'mm')");
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
  std::ofstream(data, std::ios::binary) << "land,code,1960,1961\nA,a,1,2\nB,b,2,3\nC,c,3,4\n";
  const std::string unnamed = run("smooth " + data + " --scheme primal:n=1 --irregular fit").err;
  CHECK(unnamed.find("column 1, column 2 hold text and are left out (--by 1 smooths its groups one by one); "
                     "line 1 counts as data") != std::string::npos);
  CHECK(unnamed.find("--header yes takes it") != std::string::npos);
  CHECK(run("smooth " + data + " --scheme primal:n=1 --level 0 --quiet --bands 0 --header yes").out ==
        "1960,1961,1961_sd\n1,2,0\n2,3,0\n3,4,0\n");
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
  // Dates in a form that is not read are not left out: the rest would be the answer to another question.
  for (const char* date : {"1/2/2023", "02-Jan-2023", "2023/01/02 10:00", "10:00:01", "01.01.2023", "5. Mai 2023"}) {
    const std::string text = std::string("date,t,v\n") + date + ",1,5\n" + date + ",2,6\n" + date + ",3,5\n" + date +
                             ",4,7\n";
    std::ofstream(data, std::ios::binary) << text;
    const Run refused = run("smooth " + data);
    const bool known = std::string(date) != "5. Mai 2023";
    CHECK(refused.code == (known ? 65 : 0));
    // With two points it begins as a number does.
    if (known && std::string(date) != "01.01.2023")
      CHECK(refused.err.find("(--x none counts the rows)") != std::string::npos);
    if (std::string(date) != "01.01.2023") CHECK(run("smooth " + data + " --x t").code == 0);
  }
  for (const char* text : {"a 1 b 2 c 3", "v1.2.3", "1/2", "Q 1 to 3"}) {
    std::ofstream(data, std::ios::binary) << "group,t,v\n"
                                          << text << ",1,5\n"
                                          << text << ",2,6\n"
                                          << text << ",3,5\n"
                                          << text << ",4,7\n";
    CHECK(run("smooth " + data).code == 0);
  }
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
              data +
                  ", line 2, column 1: expected a number; found '0,5', a number with a comma for the decimal point "
                  "(--decimal , takes it)");
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

TEST_CASE("names of other programs, and columns of text, come with what is meant here") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  std::ofstream(data) << "station,hour,temp\nA,0,1\nA,1,2\nA,2,2\nA,3,1\nA,4,2\nA,5,3\nA,6,2\n";
  CHECK(contains(run("smooth " + data).err, "station holds text and is left out (--by station smooths its groups"));
  CHECK(contains(run("smooth " + data + " --scheme savgol:21").err, "as local:points=21,d=2,weight=box"));
  CHECK(contains(run("smooth " + data + " --scheme lcal:points=5").err, "as local:points=21,d=1"));
  CHECK(contains(run("verify " + data + " --claim '1 < holder'").err, "a claim names its scheme, as 3/2 < primal:n=5"));
}

TEST_CASE("each row may be a series, whose positions are the names of the columns") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  const auto with = [&](const std::string& content, const std::string& arguments) {
    std::ofstream(data, std::ios::binary) << content;
    return run("smooth " + data + " --series rows " + arguments);
  };
  const std::string exact = "--scheme primal:n=1 --bands 0 --at data --quiet --by ";
  const std::string lands = "land,code,1960,1961,1962,\nA,a,1,2,3,\n\"B, b\",b,2,,6,\nC,c,5,4,3,\n";
  CHECK(with("land,code,1960,1961,1962,\nA,a,1,2,3,\n\"B, b\",b,2,4,6,\n", exact + "land").out ==
        "land,x,value,value_sd\nA,1960,1,0\nA,1961,2,0\nA,1962,3,0\n\"B, b\",1960,2,0\n\"B, b\",1961,4,0\n"
        "\"B, b\",1962,6,0\n");
  CHECK(with(lands, "--by land --missing drop --scheme local:points=3,weight=box")
            .err.find("columns whose names are no positions, left out: code") != std::string::npos);
  // A gap is an error at its place, of its series alone, or left out; so is text, and a number that is too large.
  const auto gap = with(lands, "--scheme primal:n=1 --by land");
  CHECK(gap.code == 65);
  CHECK(gap.err.find("land B, b, left out: " + data +
                     ", line 3, column 4: expected a number; found a missing value (--missing drop leaves it out)") !=
        std::string::npos);
  const auto dropped = with("n,1,2,3,4\na,2,,6,8\n",
                            "--by n --missing drop --scheme local:points=3,weight=box --bands 0 --quiet --level 0");
  CHECK(dropped.code == 0);
  check_fails(with("n,1,2,3\na,1,x,3\n", exact + "n"), 65, data + ", line 2, column 3: expected a number; found 'x'");
  check_fails(with("n,1,2,3\na,1,2,3e200\n", exact + "n"), 65,
              "n a: " + data + ", line 2, column 4: expected at most 1e150 in modulus; found 3e+200");
  // The same as groups of a long table; rows of one name are one series.
  std::string wide = "g;0;0,25;1,5;2;3\n", tall = "g;x;value\n";
  const std::vector<std::string> at{"0", "0,25", "1,5", "2", "3"};
  for (const std::string name : {"b", "a", "b"}) {
    wide += name;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const std::string value = std::to_string((7 * wide.size() + i * i) % 11);
      tall += name + ";" + at[i] + ";" + value + "\n";
      wide += ";" + value;
    }
    wide += "\n";
  }
  const std::string how = "--by g --decimal , --scheme local:points=4 --level 1 --noise 1 --quiet";
  const std::string rows = with(wide, how).out;
  std::ofstream(data, std::ios::binary) << tall;
  CHECK(rows == run("smooth " + data + " " + how).out);
  CHECK(rows.size() > 300);
  CHECK(with("4 5 6\na 1 2 3\nb 2 4 6\n", exact + "1").out ==
        "1 x value value_sd\na 4 1 0\na 5 2 0\na 6 3 0\nb 4 2 0\nb 5 4 0\nb 6 6 0\n");
  // The column of names is none of the positions, whatever its name.
  CHECK(with("7,1,2,3\na,1,2,3\n", exact + "7").out == "7,x,value,value_sd\na,1,1,0\na,2,2,0\na,3,3,0\n");
  // Notes on data are told once for all series.
  std::string waves = "n";
  for (int i = 0; i < 60; ++i) waves += "," + std::to_string(i);
  for (const std::string name : {"a", "b", "c"}) {
    waves += "\n" + name;
    for (int i = 0; i < 60; ++i)
      waves += "," + std::to_string(name == "b" ? 7919 * i * i % 101 : (i % 12 - 6) * (i % 12 - 6));
  }
  const std::string notes = with(waves + "\n", "--by n --scheme primal:n=2").err;
  CHECK(notes.find("note: value of a (-0.0725), value of c (-0.0725): neighbouring second differences have these "
                   "correlations, beyond that of independent noise") != std::string::npos);
  CHECK(std::count(notes.begin(), notes.end(), '\n') == 1);
  // Closed series keep their positions.
  CHECK(
      with("n,1,2,3,4\na,1,2,3,2\n", "--closed --quiet --scheme primal:n=1 --bands 0 --level 0 --noise 2 --by n").out ==
      "n,x,value,value_sd\na,1,1,2\na,2,2,2\na,3,3,2\na,4,2,2\n");
  // Dates; falling positions; a number for the column of names.
  CHECK(with("n,2001-11,2001-12,2002-01\na,1,2,3\n", exact + "1").out ==
        "1,x,value,value_sd\na,2001-11,1,0\na,2001-12,2,0\na,2002-01,3,0\n");
  CHECK(with("n,1,2001-11,2,2001-12\na,1,5,2,6\n", exact + "n").out == "n,x,value,value_sd\na,1,1,nan\na,2,2,nan\n");
  CHECK(with("n,20010228,20010301,20010302\na,1,2,3\n", exact + "n").out ==
        "n,x,value,value_sd\na,20010228,1,0\na,20010301,2,0\na,20010302,3,0\n");
  CHECK(with("n,3,2,1\na,1,2,3\n", exact + "n").out == "n,x,value,value_sd\na,3,1,0\na,2,2,0\na,1,3,0\n");
  check_fails(with("n,3,v,w\na,1,2,3\n", exact + "n"), 65,
              data + ": expected two columns or more whose names are positions, numbers or dates; found '3' alone");
  check_fails(with("n,3,1e999,-1e400\na,1,2,3\n", exact + "n"), 65,
              data + ": expected two columns or more whose names are positions, numbers or dates; found '3' alone");
  check_fails(with("n,u,v,w\na,1,2,3\n", exact + "n"), 65,
              data + ": expected two columns or more whose names are positions, numbers or dates; found none");
  // What columns alone have.
  check_fails(with(lands, ""), 64, "--series rows needs --by: the column of the names of the series");
  for (const char* option : {"--x 1", "--y 2", "--weights 3", "--keep code", "--header no"})
    check_fails(with(lands, exact + "land " + option), 64,
                "--series rows: expected none of --x, --y, --weights, --keep, --header no; the first row has the "
                "positions");
  check_fails(with(lands, "--by land --stream --scheme primal:n=1"), 64,
              "--stream: expected none of --json, --plot, --at, --at-file, --irregular fit, --by, --series rows");
}

TEST_CASE("a misspelt scheme is named before faults of the data, and words of other programs have their method") {
  const Folder folder;
  const std::string data = folder / "data.csv";
  std::ofstream(data) << "1,2\n1,3\n2,x\n";
  const auto fails = [&](const std::string& scheme, const std::string& expected) {
    CAPTURE(scheme);
    check_fails(
        run("smooth " + data + " --scheme " + scheme), 64,
        "scheme specification, position 1: '" + scheme + "'; expected a scheme, or local polynomials, as " + expected);
  };
  // loess() makes four fits with family = "symmetric": three robust steps.
  fails("loess", "local:points=75,d=2 for three quarters of 100 data (family = \"symmetric\": and robust=3)");
  fails("lowess", "local:points=67,d=1,robust=3 for two thirds of 100 data");
  fails("savgol", "local:points=21,d=2,weight=box");
}
