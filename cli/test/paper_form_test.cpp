// Tables of LaTeX and Markdown of all commands that have them, and what each answer says of its inputs.

#include "program.hpp"

#include <vector>

using namespace subcert::testing;

namespace {

/// Each line of a tabular has as many cells as its head, each brace and each formula is closed, and no sign that means
/// something to LaTeX stands for itself.
void check_latex(const std::string& text) {
  std::istringstream lines(text);
  std::size_t cells = 0;
  bool in_table = false;
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    if (line.starts_with("%")) continue;
    if (line.starts_with("\\begin{tabular}{l")) in_table = true;
    long depth = 0, dollars = 0;
    std::size_t separators = 1;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool escaped = i > 0 && line[i - 1] == '\\';
      if (escaped) continue;
      depth += line[i] == '{' ? 1 : line[i] == '}' ? -1 : 0;
      dollars += line[i] == '$';
      separators += line[i] == '&';
      const bool formula = dollars % 2 == 1 || !in_table;
      CHECK((formula || std::string("^_#<>|").find(line[i]) == std::string::npos));
    }
    CHECK(depth == 0);
    if (!in_table || !line.ends_with(" \\\\")) continue;
    if (separators > 1) CHECK((cells == 0 || separators == cells));
    if (separators > 1) cells = separators;
  }
  CHECK(in_table);
  CHECK(cells > 1);
}

void check_markdown(const std::string& text) {
  std::istringstream lines(text);
  std::size_t cells = 0;
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    CHECK(line.starts_with("|"));
    CHECK(line.ends_with("|"));
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
    CHECK((cells == 0 || bars == cells));
    cells = bars;
  }
  CHECK(cells > 1);
}

std::string sha256(const std::string& file) { return run_command("sha256sum " + file).out.substr(0, 64); }

}  // namespace

TEST_CASE("for papers: every command that answers by a table") {
  const Folder folder;
  const std::string matrices = folder.write("m.json",
                                            R"({"matrices": [[["1","1"],["0","1"]], [["1","0"],["1","1"]]]})");
  for (const std::string& command :
       {std::string("analyze primal:n=2"), std::string("analyze loop"), std::string("analyze 'mask:[1,1]'"),
        std::string("analyze four-point:w"), std::string("analyze l1:points=4,d=1"),
        std::string("analyze 'box:[1,0,0;0,1,0;0,0,1;1,1,1]'"), std::string("limit dd:n=2 --level 1"),
        std::string("limit loop --level 1"), std::string("limit chaikin --range"), std::string("variance dd:n=2"),
        std::string("curve four-point:w --over w=-1..1 --pieces 3"),
        std::string("map 'mask:[v,w,1-v,1-w]' --over v=0..1 --over w=0..1 --property convergent --resolution 4"),
        std::string("levels four-point:w --over w=1/20..1/10 --property C1"),
        std::string("levels four-point:w --over w=1/20..1/10 --property C1 --boxes 2"), "jsr " + matrices,
        "jsr --p 2 " + matrices, "jsr --subradius " + matrices, std::string("l1 l1:points=4,d=1"),
        std::string("compare chaikin dd4")}) {
    CAPTURE(command);
    const Run plain = run(command + " --quiet"), latex = run(command + " --latex --quiet"),
              markdown = run(command + " --markdown --quiet");
    CHECK(latex.code == plain.code);
    CHECK(markdown.code == plain.code);
    check_latex(latex.out);
    check_markdown(markdown.out);
    for (const char* two : {" --latex --markdown", " --latex --json", " --markdown --json"})
      CHECK(run(command + two).code == 64);
  }
}

TEST_CASE("for papers: what is printed") {
  const std::string chaikin = run("analyze chaikin --latex").out;
  CHECK(
      chaikin.starts_with("% bspline:degree=2\n(a_{-2}, \\ldots, a_{1}) = \\frac{1}{4}(1,\\, 3,\\, 3,\\, 1)\n"
                          "a(z) = \\frac{(1 + z)^{3}}{4 z^{2}}\n\\alpha = 2\n"));
  CHECK(contains(run("analyze dual:n=2 --latex").out,
                 "\n\\alpha = 3 - \\log_{2} \\frac{8}{5} = 2.3219280948873\\ldots\n"));
  CHECK_FALSE(contains(run("analyze 'mask:[1,1]' --latex").out, "\\alpha"));
  CHECK(
      contains(run("limit dd:n=2 --level 1 --latex").out, "\n  $-\\frac{3}{2}$ & $-\\frac{1}{16}$ & $-0.0625$ \\\\\n"));
  CHECK(contains(run("curve four-point:w --over w=0..1/4 --pieces 20 --latex").out,
                 "\n  $w = \\frac{1}{16}$ & special &  & more sum rules; exponent 2 \\\\\n"));
  CHECK(contains(run("variance chaikin --markdown").out, "\n| mean | 0.55  = 11/20 |\n"));
}

TEST_CASE("the exponent in closed form is the one that is enclosed") {
  for (const char* scheme : {"dual:n=2", "'[-1,3,14,14,3,-1]/16'", "'mask:[1,2,1,0,1,1]/3'", "ary:a=3,points=4,d=1",
                             "primal:n=2", "four-point:w=1/10", "dual-four-point:w=1/64"}) {
    CAPTURE(scheme);
    const auto found = run_json(std::string("regularity ") + scheme);
    if (found.at("formula").is_null()) continue;
    const auto formula = found.at("formula").get<std::string>();
    int rules = 0, arity = 0;
    REQUIRE(std::sscanf(formula.c_str(), "%d - log_%d(", &rules, &arity) == 2);
    const auto& number = found.at("radius_number");
    const double zero = std::stod(number.at("zero").get<std::string>());  // 13 digits
    const double value = rules - std::log(zero) / number.at("root").get<double>() / std::log(arity);
    CHECK(std::abs(value - std::stod(found.at("holder").at("lower").get<std::string>())) < 1e-12);
    CHECK(run_json(std::string("analyze ") + scheme + " --budget 100").at("formula") == formula);
  }
  CHECK(run_json("regularity dual:n=2").at("formula") == "3 - log_2(8/5)");
  CHECK(run_json("regularity chaikin").at("formula").is_null());     // 2, as it stands
  CHECK(run_json("regularity primal:n=5").at("formula").is_null());  // of a long polynomial
  CHECK(run_json("regularity 'mask:[1,1]'", 1).at("formula").is_null());
  // Of algebraic numbers.
  CHECK(run_json("regularity daubechies:n=2").at("formula") == "2 - log_2(1+sqrt(3))");
  CHECK(contains(run("regularity daubechies:n=2 --latex").out, "\\alpha = 2 - \\log_{2} \\left(1+\\sqrt{3}\\right) "));
  CHECK(run_json("regularity daubechies:n=4").at("formula").is_null());  // of which no field is known
  const auto cubic = run_json("regularity daubechies:n=3");
  CHECK(cubic.at("formula") == "3 - log_2(r), 4*r^4-8*r^3-24*r^2-12*r+9 = 0, r = 3.763737662273");
  CHECK(cubic.at("radius_number").at("polynomial").dump() == "[\"9\",\"-12\",\"-24\",\"-8\",\"4\"]");
  CHECK(cubic.at("radius_number").at("zero") == "3.763737662273");
  CHECK(cubic.at("radius_number").at("root") == 1);
  CHECK(contains(run("regularity daubechies:n=3 --latex").out, "r^{4}-8 r^{3}-24 r^{2}-12 r+9 = 0"));
}

TEST_CASE("answers name their inputs by digests that any machine computes") {
  const Folder folder;
  const std::string line = folder.write("line", "bspline:degree=2\n");
  const std::string data = folder.write("data.csv", "x,y\n0,1\n1,2\n2,3\n3,5\n4,4\n");
  const auto inputs = [](const std::string& arguments, int code = 0) {
    return run_json(arguments, code).at("subcert").at("inputs");
  };
  const nlohmann::json chaikin{{"name", "bspline:degree=2"}, {"sha256", sha256(line)}};
  CHECK(inputs("variance chaikin") == nlohmann::json::array({chaikin}));
  CHECK(inputs("compare chaikin cubic-bspline").size() == 2);
  const nlohmann::json file{{"name", "data.csv"}, {"sha256", sha256(data)}};
  CHECK(inputs("smooth " + data + " --scheme chaikin") == nlohmann::json::array({chaikin, file}));
  CHECK(inputs("refine chaikin " + data) == nlohmann::json::array({chaikin, file}));
  CHECK(inputs("refine chaikin - <" + data).at(1).at("sha256") == sha256(data));
  CHECK(inputs("range four-point:w --over w=0..1/2 --property C1").at(0).at("name") == "four-point:w");
  CHECK(inputs("theorem list").empty());
  // A page says the same.
  const std::string page = folder / "page.html";
  CHECK(run("analyze chaikin --html " + page + " --quiet").code == 0);
  CHECK(contains(content(page), ", from <code>bspline:degree=2</code> (SHA-256 of that line <code>" + sha256(line)));
}
