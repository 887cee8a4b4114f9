#include "program.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

using namespace subcert::testing;

TEST_CASE("vertex: the fields of the contract") {
  const auto answer = run_json("vertex loop --valence 3..4");
  CHECK(answer.at("scheme") == "loop");
  CHECK(answer.at("all") == "unknown");
  REQUIRE(answer.at("valences").size() == 2);
  const auto& at = answer.at("valences")[0];
  CHECK(at.at("valence") == 3);
  CHECK(at.at("c1") == "yes");
  CHECK(has_digits(at.at("subdominant"), "lower", "0.25"));
  CHECK(has_digits(at.at("exponent"), "upper", "1.5"));
  CHECK(at.at("curvature") == "unbounded");
}

TEST_CASE("vertex: one valence that is not C1 decides for all") {
  const auto answer = run_json("vertex butterfly --valence 4,8", 1);
  CHECK(answer.at("all") == "no");
  CHECK(answer.at("valences")[0].at("c1") == "yes");
  CHECK(answer.at("valences")[1].at("c1") == "no");
  CHECK(answer.at("valences")[1].at("frequency") == 2);
  CHECK(answer.at("valences")[1].at("curvature").is_null());
}

TEST_CASE("vertex: every valence") {
  const auto answer = run_json("vertex catmull-clark --all-valences");
  CHECK(answer.at("all") == "yes");
  CHECK(answer.at("valences").size() == 10);
  CHECK(answer.at("rest").at("first") == 13);
  CHECK(answer.at("rest").at("c1") == "yes");
  CHECK(answer.at("rest").at("open").empty());
  const auto open = run_json("vertex butterfly --all-valences", 1);
  CHECK(open.at("all") == "no");
  CHECK(open.at("rest").at("c1") == "unknown");
  CHECK(open.at("rest").at("open")[0].at("last").is_null());
  CHECK(run("vertex loop --all-valences --valence 4").code == 64);
}

TEST_CASE("vertex: stencils in JSON, and as a header that a compiler of C takes") {
  const Folder folder;
  const std::string header = folder / "stencils.h";
  const auto answer = run_json("vertex loop --valence 4,6 --stencils --stencils-header " + header);
  const auto& stencils = answer.at("valences")[1].at("stencils");
  REQUIRE(stencils.at("limit").size() == 7);
  CHECK(stencils.at("limit")[0].at("exact") == "1/2");
  CHECK(stencils.at("limit")[3].at("exact") == "1/12");
  CHECK(stencils.at("limit")[3].at("sector") == 2);
  CHECK(stencils.at("tangents")[0][1].at("exact") == "1/2");
  CHECK(stencils.at("tangents")[1][0].at("exact") == "s");
  std::ifstream file(header);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  CHECK(text.find("static const int loop_6_data[7][3] = {\n  {0, 0, 0},\n  {1, 0, 0},") != std::string::npos);
  CHECK(text.find("static const double loop_6_limit[7] = {\n  0.5,  /* 1/2 */") != std::string::npos);
  CHECK(text.find("0.8660254037844386,  /* s */") != std::string::npos);
  CHECK(std::system(("cc -std=c99 -Wall -Werror -Wno-unused -x c -fsyntax-only " + header).c_str()) == 0);
}

TEST_CASE("vertex: pictures and a page of the surface") {
  const Folder folder;
  const std::string page = folder / "page.html";
  CHECK(run("vertex loop --valence 3,4 --plot " + folder / "a.svg" + " --html " + page).code == 0);
  CHECK(content(folder / "a.svg").find("loop, n = 3: curvature unbounded") != std::string::npos);
  const std::string text = content(page);
  for (const char* part : {"at a vertex     n  C1", "characteristic map, valence 4",
                           "data-surface=", "curvature bounded", "Heights have frequency 0", "2; colours"})
    CHECK(text.find(part) != std::string::npos);
  CHECK(text.find("http://") == std::string::npos);
  CHECK(run("vertex doo-sabin --valence 5 --plot " + folder / "b.html").code == 0);
  CHECK(content(folder / "b.html").find("data-surface=") != std::string::npos);
  // No heights, but a map; where the leader has another frequency, neither.
  CHECK(run("vertex midedge --valence 5 --html " + page).code == 0);
  for (const char* part : {"No surface: the eigenvalue behind", "characteristic map, valence 5"})
    CHECK(contains(content(page), part));
  CHECK(run("vertex butterfly --valence 8 --html " + page).code == 1);
  CHECK(content(page).find("No picture: the subdominant eigenvalue") != std::string::npos);
  check_fails(
      run("vertex butterfly --valence 8 --plot " + folder / "c.svg"), 64,
      "--plot: butterfly:w=1/16: a surface is drawn where the subdominant eigenvalue is proved to have frequency "
      "1, and that behind it to be one real number");
  check_fails(run("vertex loop --valence 3 --plot " + folder / "c.gif"), 64,
              "--plot " + folder / "c.gif" + ": expected a name that ends in .svg, .png, .pdf, .tex (TikZ) or .html");
  CHECK(run("vertex loop --over b=0..1 --plot " + folder / "c.svg").code == 64);
}

TEST_CASE("vertex: rules that a file says") {
  const Folder folder;
  const std::string examples = std::string(SUBCERT_DOCS) + "/examples/vertices/";
  const auto warren = run_json("vertex " + examples + "warren.toml --all-valences");
  CHECK(warren.at("all") == "yes");
  CHECK(warren.at("rest").at("first") == 13);
  CHECK(has_digits(warren.at("valences")[0].at("exponent"), "lower", "1.5"));
  for (const char* name : {"doo-sabin", "catmull-clark"}) {
    const std::string place = folder / name;
    CHECK(run_json("vertex " + examples + name + ".toml --all-valences --certificate " + place).at("certificates") ==
          11);
    CHECK(run("verify " + place).code == 0);
  }
  // The scheme itself, written down.
  const std::string own = folder / "own.toml";
  std::ofstream(own)
      << "scheme = \"loop\"\nletter = \"b\"\nvalue = \"3/8\"\n[[rule]]\nweights = {vertex = \"b + (b + c/4)^2\", "
         "neighbours = \"(1 - b - (b + c/4)^2)/n\"}\n";
  CHECK(run_json("vertex " + own + " --valence 3..12 --stencils").at("valences") ==
        run_json("vertex loop --valence 3..12 --stencils").at("valences"));
  // Kept from the tensor product, whose lattice is said.
  const std::string quads = folder / "quads.toml";
  std::ofstream(quads) << "scheme = \"tensor:(bspline:degree=3)x(bspline:degree=3)\"\nlattice = \"quads\"\n[[rule]]\n"
                          "weights = {vertex = \"1-7/(4*n)\", neighbours = \"3/2/n^2\", across = \"1/4/n^2\"}\n";
  CHECK(run_json("vertex " + quads + " --valence 3..5").at("valences") ==
        run_json("vertex catmull-clark --valence 3..5").at("valences"));
}

TEST_CASE("vertex: files that are no rules get one line with file, line and key") {
  const Folder folder;
  const std::string file = folder / "rules.toml";
  const std::string weights = "weights = {vertex = \"5/8\", neighbours = \"3/(8*n)\"}";
  const std::vector<std::pair<std::string, std::string>> faults{
      {"[[rule]]\nweights = {vertex = \"1/2\", neighbours = \"1/2\"}",
       "line 3, column 11, 'weights': the weights at valence 3 sum to 2; need 1"},
      {"[[rule]]\nweights = {vertex = \"1/2\", neighbours = \"x/(2*n)\"}",
       "line 3, column 41, 'neighbours': 'x/(2*n)': 'x'; expected exact numbers, c, C, n, +, -, *, /, ^ and "
       "parentheses"},
      {"[[rule]]\nweights = {vertex = \"1/2\", neighbours = [\"1/4\", \"1/4\"]}",
       "line 3, column 41, 'neighbours': a row of 2 weights; need 3, one for each sector"},
      {"[[rule]]\nvalence = 4\n" + weights,
       "line 4, column 11, 'weights': no rule of the point (0,0) is for valence 3"},
      {"[[rule]]\nvalence = \"2..\"\n" + weights, "line 3, column 11: '2..' is no valence"},
      {"[[rule]]\n" + weights + "\n[[rule]]\nvalence = 5\n" + weights, "two rules of the point (0,0) at valence 5"},
      {"[[rule]]\nweights = {vertex = 0.5, neighbours = \"1/(2*n)\"}",
       "expected a whole number or an exact expression"},
      {"[[rule]]\nweights = {corner = \"1\"}", "line 3, column 21: 'corner' names no data"},
      {"[[rule]]\nweights = {\"-1,0\" = \"1\"}", "'-1,0' names no data"},
      {"[[rule]]\nweights = {vertex = \"1 - 1/(1+2*c)\", neighbours = \"1/(1+2*c)/n\"}",
       "a quotient by 0 at valence 3"},
      {"[[rule]]\nweights = {vertex = \"1/\"}", "'1/'"},
      {"[[rule]]\npoint = \"middle\"\n" + weights, "'middle' is no new point of a sector"},
      {"[[rule]]\nvalence = 3", "expected the table 'weights'"},
      {"", "no rules; expected tables [[rule]]"},
      {"letter = \"n\"\n[[rule]]\n" + weights, "'letter' takes one letter other than c, C and n"},
      {"letter = [\"a\", \"n\"]\n[[rule]]\n" + weights, "line 2, column 16: 'letter' takes one letter"},
      {"letter = [\"a\", \"a\"]\n[[rule]]\n" + weights, "'letter' takes up to 3 different letters"},
      {"letter = [\"a\", \"b\"]\nvalue = 1\n[[rule]]\n" + weights, "line 3, column 9: 1 values of 2 letters"},
      {"value = 1\n[[rule]]\n" + weights, "a value is that of a letter"},
      {"[[rule]]\nweigths = 1", "unknown key 'weigths'"},
      {"[[rule]", "not TOML"}};
  for (const auto& [text, expected] : faults) {
    CAPTURE(text);
    std::ofstream(file) << "scheme = \"loop\"\n" << text << "\n";
    const Run answer = run("vertex " + file + " --valence 3");
    CHECK(answer.code == 65);
    CHECK(answer.out.empty());
    CHECK(answer.err.find("subcert: " + file + ", ") == 0);
    CHECK(answer.err.find(expected) != std::string::npos);
    CHECK(std::count(answer.err.begin(), answer.err.end(), '\n') == 1);
  }
  for (const char* scheme : {"sqrt3", "quincunx", "primal:n=2", "nothing"}) {
    std::ofstream(file) << "scheme = \"" << scheme << "\"\n[[rule]]\n" << weights << "\n";
    CHECK(run("vertex " + file).code == 65);
  }
  std::ofstream(file) << "scheme = \"loop\"\n[[rule]]\nvalence = \"3..5\"\n" << weights << "\n";
  CHECK(run("vertex " + file + " --all-valences").code == 65);
  std::ofstream(file) << "scheme = \"loop\"\nletter = \"b\"\n[[rule]]\n"
                      << "weights = {vertex = \"1 - b\", neighbours = \"b/n\"}\n";
  for (const char* question : {" --valence 3", " --all-valences", " --valence 3 --stencils"}) {
    const Run answer = run("vertex " + file + question);
    CHECK(answer.code == 64);
    CHECK(answer.err.find("the letter b has no value") != std::string::npos);
  }
  CHECK(run("vertex " + (folder / "missing.toml")).code == 66);
}

TEST_CASE("vertex: for which values of a weight") {
  const std::string examples = std::string(SUBCERT_DOCS) + "/examples/vertices/";
  const std::string loop = "vertex " + examples + "loop-weight.toml --over b=0..4/5";
  // lambda is 1/4, 3/8 for n = 3, 4, and 5/8 - b the eigenvalue of the vertex.
  const auto c1 = run_json(loop + " --valence 3,4");
  for (const auto& [index, value] : {std::pair<std::size_t, const char*>{0, "3/8"}, {1, "1/4"}}) {
    const auto& at = c1.at("ranges")[index];
    CAPTURE(value);
    REQUIRE(at.at("pieces").size() == 3);
    CHECK(at.at("pieces")[0].at("verdict") == "refuted");
    CHECK(at.at("pieces")[2].at("verdict") == "proved");
    REQUIRE(at.at("ends").size() == 1);
    CHECK(at.at("ends")[0].at("value") == value);
    CHECK(at.at("ends")[0].at("verdict") == "refuted");  // frequencies 0 and 1 share it
  }
  // 3/8 + c/4 for n = 5.
  const auto five = run_json(loop + " --valence 5").at("ranges")[0];
  CHECK(five.at("ends")[0].at("value") == "1/4 - 1/4*c");
  // |5/8 - b| <= 9/64.
  const auto curved = run_json("vertex " + examples +
                               "loop-weight.toml --over b=3/10..4/5 --valence 4 --property bounded-curvature")
                          .at("ranges")[0];
  REQUIRE(curved.at("ends").size() == 2);
  CHECK(curved.at("ends")[0].at("value") == "31/64");
  CHECK(curved.at("ends")[1].at("value") == "49/64");
  CHECK(curved.at("ends")[0].at("verdict") == "proved");
  CHECK(curved.at("pieces")[2].at("verdict") == "proved");
  const auto dual = run_json("vertex " + examples +
                             "doo-sabin-eigenvalue.toml --over b=2/5..4/5 --valence 5 --property bounded-curvature");
  CHECK(dual.at("ranges")[0].at("ends")[0].at("value") == "1/2");
  for (const std::string& words : std::vector<std::string>{
           "loop --over b=0..1", loop.substr(7) + " --all-valences", loop.substr(7) + " --property C2",
           loop.substr(7) + " --width 0", examples + "loop-weight.toml --over w=0..1",
           examples + "loop-weight.toml --over b=1..0", examples + "loop-weight.toml",
           examples + "warren.toml --over b=0..1"}) {
    CAPTURE(words);
    CHECK(run("vertex " + words).code == 64);
  }
}

TEST_CASE("vertex: what is open for good, and wrong words") {
  const Folder folder;
  std::ofstream(folder / "one.toml")
      << "scheme = 'loop'\n\n[[rule]]\nweights = {vertex = '11/8', neighbours = '-3/(8*n)'}\n";
  CHECK(run_json("vertex " + folder / "one.toml" + " --valence 5", 3).at("valences")[0].at("c1") == "unknown");
  for (const std::string words : {"loop --valence 2", "loop --valence 1001", "loop --valence 5..3", "loop --valence x",
                                  "primal:n=3", "quincunx", "nothing", ""}) {
    CAPTURE(words);
    CHECK(run("vertex " + words).code == 64);
  }
}

TEST_CASE("vertex: certificates of what is proved are written and verified") {
  const Folder folder;
  const std::string place = folder / "proofs";
  const Run page = run("vertex midedge --valence 3..5 --certificate " + place);
  CHECK(page.code == 0);
  CHECK(joined(page.out).find("certificates 2 in " + place + ", verified: ") != std::string::npos);
  const Run verified = run("verify " + place);
  CHECK(verified.code == 0);
  CHECK(joined(verified.out).find("0005-vertex.cert: VERIFIED ") != std::string::npos);
  CHECK(joined(verified.out).find("C^1 limits of almost all data around dual:5;0,0=1/2@0,0,0") != std::string::npos);
  // Of all valences: one more file.
  CHECK(run_json("vertex doo-sabin --all-valences --certificate " + place).at("certificates") == 11);
  const Run of_all = run("verify " + place);
  CHECK(of_all.code == 0);
  CHECK(joined(of_all.out).find("C^1 limits of almost all data around dual:13+;0,0=1/4@0,0,0") != std::string::npos);
  // Those of a run before that are not written again go.
  // Refuted where no single eigenvalue leads: no file tells that.
  const Run refuted = run("vertex butterfly --valence 3 --certificate " + place + " --json");
  CHECK(nlohmann::json::parse(joined(refuted.out)).at("certificates") == 0);
  CHECK(run("verify " + place).code != 0);
}

TEST_CASE("vertex: certificates by affine fits, where the mask has signs, and of what is refuted") {
  const Folder folder;
  const std::string place = folder / "proofs";
  const Run page = run("vertex butterfly --valence 7..8 --certificate " + place);
  CHECK(page.code == 1);
  CHECK(joined(page.out).find("certificates 2 in " + place + ", verified: ") != std::string::npos);
  const Run verified = run("verify " + place);
  CHECK(verified.code == 0);
  CHECK(joined(verified.out).find(" C^1 limits of almost all data around triangles:7") != std::string::npos);
  CHECK(joined(verified.out).find("no C^1 limits of almost all data around triangles:8") != std::string::npos);
}

TEST_CASE("vertex: the table of valences for papers") {
  const Run latex = run("vertex loop --valence 3,7 --latex");
  CHECK(latex.code == 0);
  CHECK(latex.out.starts_with("% loop, at vertices of valence n\n% needs \\usepackage{booktabs}\n"));
  CHECK(latex.out.find("3 & yes & 0.25 & 0.125 & 1.5 & unbounded") != std::string::npos);
  const Run markdown = run("vertex catmull-clark --valence 3 --all-valences --markdown");
  CHECK(markdown.code == 64);
  const Run all = run("vertex catmull-clark --all-valences --markdown");
  CHECK(all.code == 0);
  CHECK(all.out.starts_with("| n | C1 | subdominant | next modulus | exponent | curvature |\n"));
  CHECK(all.out.find("| 13 and above | yes |") != std::string::npos);
  CHECK(run("vertex loop --latex --json").code == 64);
  CHECK(run("vertex loop --latex --stencils").code == 64);
}

TEST_CASE("vertex: a file of rules is one input") {
  const Folder folder;
  const std::string file = folder.write("own.toml",
                                        "scheme = \"loop\"\n[[rule]]\nvalence = 5\n"
                                        "weights = {vertex = \"3/5\", neighbours = \"2/25\"}\n");
  const nlohmann::json inputs = run_json("vertex " + file + " --valence 5").at("subcert").at("inputs");
  REQUIRE(inputs.size() == 1);
  CHECK(inputs[0].at("sha256") == run_command("sha256sum " + file).out.substr(0, 64));
}
