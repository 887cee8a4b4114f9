#include "program.hpp"

#include <filesystem>

using namespace subcert::testing;

TEST_CASE("gallery: one page in one file") {
  const Folder folder;
  const std::string page = (folder.path / "page.html").string();
  const Run made = run("gallery primal:n=2 four-point:w=1/2 loop: --out " + page);
  CAPTURE(made.err);
  CHECK(made.code == 1);  // one diverges
  CHECK(made.out == page + ": 3 schemes\n");
  const std::string text = content(page);
  CHECK(text.find("[3,<wbr>4,<wbr>3,<wbr>4,<wbr>3,<wbr>4,<wbr>3]/12@−3") != std::string::npos);
  CHECK(text.find("id=\"primal-n-2-d-1-limit\"") != std::string::npos);
  CHECK(text.find("id=\"loop-limit\"") != std::string::npos);
  // Nothing is drawn of what does not exist, and nothing is loaded.
  CHECK(text.find("The scheme diverges") != std::string::npos);
  CHECK(text.find("four-point-w-1-2-limit") == std::string::npos);
  for (const char* loading : {"src=", "href=\"http", "@import", "url("}) {
    CAPTURE(loading);
    CHECK(text.find(loading) == std::string::npos);
  }
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 1);  // no temporary file is left
}

TEST_CASE("gallery: what is on record as divergent, and nothing else, may diverge", "[long]") {
  const Run forty = run("gallery --json");
  CHECK(forty.code == 0);
  CHECK(run("gallery four-point:w=1/2 --json").code == 1);
  for (const auto& scheme : nlohmann::json::parse(forty.out).at("schemes")) {
    CAPTURE(scheme.at("scheme"));
    CHECK((scheme.at("converges").at("verdict") == "no") == (scheme.at("scheme") == "four-point:w=1/2"));
  }
}

TEST_CASE("gallery: the data") {
  const auto data = run_json("gallery primal:n=1 bspline:degree=3 'mask:[1,1,2,2,1,1]/4' daubechies:n=2 --json")
                        .at("schemes");
  REQUIRE(data.size() == 4);
  CHECK(data[0].at("mask").at("coefficients") == nlohmann::json::array({"1/2", "1", "1/2"}));
  CHECK(data[0].at("derivatives") == 0);
  CHECK(data[1].at("holder").at("lower") == "3");
  CHECK(data[1].at("derivatives") == 2);
  CHECK(data[1].at("variance_mean") == "151/315");
  std::vector<std::string> pictures;
  for (const auto& curve : data[1].at("curves")) pictures.push_back(curve.at("picture"));
  CHECK(pictures ==
        std::vector<std::string>{"limit", "limit", "derivative-1", "derivative-2", "variance", "polygon", "polygon"});
  CHECK(data[2].at("stable").at("verdict") == "no");
  CHECK(data[2].at("holder").at("upper") == "2");
  // Of rounded coefficients neither variance nor Sobolev exponent is claimed.
  CHECK(data[3].at("variance_sup").is_null());
  CHECK(data[3].at("sobolev").is_null());
  const auto open = run_json("gallery primal:n=1 --open --json").at("schemes")[0].at("curves");
  CHECK(open.back().at("points").front() != open.back().at("points").back());
}

TEST_CASE("gallery and compare: vectors of functions") {
  const Folder folder;
  const std::string page = (folder.path / "page.html").string();
  const Run made = run("gallery ghm cl:2 'tensor:(ghm)x(ghm)' chaikin --out " + page);
  CHECK(made.code == 0);
  const std::string text = content(page);
  CHECK(text.find("id=\"ghm-limit\"") != std::string::npos);
  CHECK(text.find("id=\"cl-2-limit\"") != std::string::npos);
  CHECK(text.find("Functions of several variables are not drawn.") != std::string::npos);
  const auto data = run_json("compare merrien:lambda=-1/8,mu=1/2 chaikin --json").at("schemes");
  CHECK(data[0].at("hermite").at("order") == 1);
  CHECK(data[0].at("components").size() == 2);
  CHECK(data[0].at("convergence").at("verdict") == "yes");
  CHECK(!data[0].contains("variance_sup"));
  const Run beside = run("compare ghm chaikin");
  CHECK(beside.code == 0);
  CHECK(contains(beside.out, "components"));
  // The scheme diverges, and its functions are continuous.
  CHECK(run("compare chaikin 'vector:[[[1,0],[0,2]],[[2,0],[0,0]],[[1,0],[0,0]]]/2@-1'").code == 1);
  CHECK(run("analyze ghm --html " + page).code == 0);
  CHECK(content(page).find("id=\"ghm-limit\"") != std::string::npos);
}

TEST_CASE("gallery: vertices") {
  const Folder folder;
  const std::string page = folder / "page.html";
  const std::string examples = std::string(SUBCERT_DOCS) + "/examples/vertices/";
  const std::string open = folder / "open.toml";  // 1 twice
  std::ofstream(open) << "scheme = 'loop'\n\n[[rule]]\nweights = {vertex = '11/8', neighbours = '-3/(8*n)'}\n";
  const Run made = run("gallery --vertices loop midedge " + open + " --valence 3,5 --out " + page);
  CHECK(made.code == 3);
  CHECK(made.out == page + ": 3 schemes\n");
  const std::string text = content(page);
  for (const char* part : {"id=\"loop-3\"", "0.4523<br>curvature bounded</small>", "characteristic map, valence 5",
                           "no picture</span>", "C1: open</small>", "curvature zero", "at a vertex     n  C1"}) {
    CAPTURE(part);
    CHECK(contains(text, part));
  }
  for (const char* loading : {"src=", "href=\"http", "@import", "url("}) CHECK(!contains(text, loading));
  CHECK(run("gallery --vertices butterfly --valence 8 --out " + page).code == 1);
  CHECK(contains(content(page), "0.4690, frequency 2"));
  const auto data = run_json("gallery --vertices loop doo-sabin --valence 4 --json").at("schemes");
  REQUIRE(data.size() == 2);
  CHECK(data[1].at("valences").at(0).at("c1") == "yes");
  CHECK(data[0] == [] {
    auto alone = run_json("vertex loop --valence 4 --json");
    alone.erase("subcert");
    return alone;
  }());
  check_fails(run("gallery --vertices " + examples + "loop-weight.toml"), 64,
              examples +
                  "loop-weight.toml: the letter b has no value; gallery needs one in the file, as value = "
                  "\"3/8\"");
  check_fails(run("gallery --vertices --valence 2"), 64,
              "--valence, position 1: '2'; expected an integer from 3 to 1000 or a range A..B of such with A <= B, as "
              "in 1..5,8");
  check_fails(run("gallery --valence 4"), 64, "--valence: needs --vertices beside it");
  check_fails(run("gallery --vertices --open"), 64, "--open: polygons are not drawn with --vertices");
  check_fails(run("gallery --vertices loop --all"), 64, "--all: takes no schemes, got 'loop'");
  check_fails(run("gallery --vertices none.toml"), 66, "none.toml: no such file");
  CHECK(run("gallery --vertices primal:n=2").code == 64);
}

TEST_CASE("gallery: wrong usage") {
  check_fails(run("gallery loop: primal:n=0"), 64,
              "scheme specification, position 10: '0'; expected n as an integer from 1 to 2047");
  CHECK(run("gallery l1:points=4").code == 64);
  check_fails(run("gallery primal:n=2 --all"), 64, "--all: takes no schemes, got 'primal:n=2'");
  check_fails(run("gallery primal:n=2 --out /dev/null/page.html"), 66,
              "cannot write /dev/null/page.html: cannot make its folder: Not a directory");
}

TEST_CASE("compare: a line a fact, a column a scheme") {
  const Folder folder;
  const std::string page = (folder.path / "page.html").string();
  const Run made = run("compare primal:n=2 four-point:w=1/16 --html " + page);
  CAPTURE(made.err);
  CHECK(made.code == 0);
  CHECK(made.out.starts_with("scheme                  primal:n=2,d=1"));
  CHECK(made.out.find("\nsum rules               2                          ") != std::string::npos);
  const std::string text = content(page);
  CHECK(text.find("2 schemes side by side") != std::string::npos);
  CHECK(text.find("data-certificate=\"primal-n-2-d-1.cert\"") != std::string::npos);
  CHECK(text.find("src=") == std::string::npos);
  CHECK(run_json("compare primal:n=1 bspline:degree=3 --json").at("schemes").size() == 2);
  // What diverges has no functions.
  const std::string diverging = run("compare primal:n=1 four-point:w=1/2").out;
  const std::size_t line = diverging.find("\nHoelder exponent        1 ");
  REQUIRE(line != std::string::npos);
  CHECK(diverging.substr(line + 1, diverging.find('\n', line + 1) - line - 1).ends_with(" none"));
}

TEST_CASE("compare: functions over each other in one picture") {
  const Folder folder;
  const std::string picture = folder / "all.svg";
  CHECK(run("compare chaikin dd4 ghm loop --rows holder --plot " + picture).code == 0);
  const std::string drawn = content(picture);
  for (const char* text : {">bspline:degree=2<", ">dd:n=2<", ">The basic limit function<", ">The variance curve<"})
    CHECK(contains(drawn, text));
  check_fails(run("compare loop butterfly --plot " + picture), 2,
              "--plot " + picture + ": no two of the schemes have functions of one variable that are drawn");
  CHECK(run("compare chaikin dd4 --plot x.eps").code == 64);
}

TEST_CASE("compare: rows that are chosen, and a table that a paper's text has room for") {
  CHECK(run("compare chaikin loop --rows holder,'sum rules' --markdown").out ==
        "| scheme | bspline:degree=2 | loop |\n|---|---|---|\n| Hoelder exponent | 2 | 3 |\n"
        "| sum rules | 3 | 4; factors (1 + x)^2, (1 + y)^2 |\n");
  const Run wrong = run("compare chaikin dd4 --rows 'sum rule'");
  CHECK(wrong.code == 64);
  CHECK(
      contains(wrong.err, "--rows: no scheme has the row 'sum rule'; did you mean 'sum rules'?; the rows are mask, "));
  const std::string table = run("compare primal:n=3 dual-odd:n=10 loop ghm 'tensor:(ghm)x(ghm)' --latex").out;
  CHECK(contains(table, "\n  scheme & sum rules & H\\\"older & Sobolev & derivatives & stable \\\\\n"));
  CHECK(contains(table, "\n  primal:n=3,d=1 & 2 & 1.936309 & 1.994842 & 1 & yes \\\\\n"));
  CHECK(contains(table, "\n  loop & 4 & 3 & 7/2 & 2 & yes \\\\\n"));
  CHECK(contains(table, "\n  ghm & - & 1 & 1.500000 & 0 & - \\\\\n"));
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 75);
}

TEST_CASE("compare and pages of one scheme: wrong usage") {
  check_fails(run("compare primal:n=2"), 64, "compare: needs two schemes or more, got 'primal:n=2'");
  CHECK(run("compare").code == 64);
  CHECK(run("compare primal:n=2 primal:n=0").code == 64);
  check_fails(run("analyze primal:n=2 --html /dev/null/page.html"), 66,
              "cannot write /dev/null/page.html: cannot make its folder: Not a directory");
}

TEST_CASE("analyze: the page of a scheme holds its certificate") {
  const Folder folder;
  const std::string page = (folder.path / "page.html").string();
  const Run made = run("analyze primal:n=2 --html " + page);
  CHECK(made.code == 0);
  CHECK(made.out.starts_with("scheme "));
  const std::string text = content(page);
  CHECK(text.find("id=\"file:primal-n-2-d-1.cert\"") != std::string::npos);
  CHECK(text.find("phi(0) = ") != std::string::npos);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 1);
}
