#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("analyze: pictures of basic limit functions") {
  const Folder folder;
  const std::string svg = folder / "limit.svg", png = folder / "limit.png";
  for (const char* scheme : {"loop:", "quincunx:", "dd:n=2", "'mask:[1,3,3,1]/4@5'", "'box:[1,0;0,1;1,1]'"}) {
    CAPTURE(scheme);
    const Run plain = run(std::string("analyze ") + scheme),
              drawn = run(std::string("analyze ") + scheme + " --plot " + svg);
    CHECK(drawn.code == 0);
    CHECK(drawn.out == plain.out);
    CHECK(content(svg).find("<svg") != std::string::npos);
  }
  CHECK(content(svg).find("box:[1,0;0,1;1,1]") != std::string::npos);
  CHECK(run("analyze zwart-powell: --plot " + png).code == 0);
  CHECK(content(png).starts_with("\x89PNG"));
  // Nothing is drawn where there is no limit.
  const Run divergent = run("analyze 'mask:[1,1]' --plot " + folder / "none.svg");
  CHECK(divergent.code == 1);
  CHECK(divergent.err.starts_with("subcert: mask:[1,1]@-1: no limit function; convergence: no"));
  CHECK(run("analyze loop: --plot /proc/nowhere/x.svg").code == 66);
  check_fails(run("analyze loop: --plot x.eps"), 64,
              "--plot x.eps: expected a name that ends in .svg, .png, .pdf, .tex (TikZ) or .html");
  check_fails(
      run("analyze 'tensor:(dd:n=1)x(dd:n=1)x(dd:n=1)' --plot x.svg"), 64,
      "--plot x.svg: pictures are of functions of one or two variables; tensor:(dd:n=1)x(dd:n=1)x(dd:n=1) has 3");
}

TEST_CASE("analyze: a family with a parameter") {
  const Run page = run("analyze four-point:w");
  CHECK(page.code == 0);
  CHECK(page.out.find("sum rules     2 for all w; more at w = 1/16\n") != std::string::npos);
  CHECK(page.out.find("reproduces degree 1 with f_j at j + 0 for all w\n") != std::string::npos);
  const auto quotient = run_json("analyze 'regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1,weights=[w;1;w|w;1;1;w]'");
  CHECK(quotient.at("sum_rules") == 2);
  CHECK(quotient.at("reproduces") == 1);
  CHECK(quotient.at("support") == nlohmann::json::parse("[-3, 3]"));
  // The zeros of the denominator, -1 and -1/2, are no values of the parameter.
  CHECK(quotient.at("unstable") == nlohmann::json::parse(R"(["w = 0", "w = 1/2", "the real zeros of -1 + 2*w^2"])"));
  const auto dual = run_json("analyze dual-four-point:w");
  CHECK(dual.at("more_reproduction") == nlohmann::json::parse(R"(["w = 1/128"])"));
  CHECK(dual.at("parametrization") == "-1/2");
  check_fails(run("analyze four-point:w --plot p.svg"), 64,
              "--plot: pictures are of single schemes; four-point:w has a parameter, see --html");
  check_fails(run("analyze four-point:w --html p.html"), 64,
              "--html of a scheme with a parameter: expected --over w=LOW..HIGH, too");
  check_fails(run("analyze four-point:w --over w=0..1"), 64,
              "--over of a scheme with a parameter: expected --html FILE, too");
  check_fails(run("analyze dd:n=2 --over w=0..1"), 64, "--over: dd:n=2 has no parameter");
  CHECK(run("analyze 'mask:[w,v,1-w,1-v]'").code == 64);
}

namespace {

nlohmann::json moved(const std::string& arguments) {
  const Folder folder;
  const std::string page = folder / "moved.html";
  REQUIRE(run("analyze " + arguments + " --html " + page + " --quiet").code == 0);
  const std::string text = content(page), before = "<script type=\"application/json\" id=\"explorer\">";
  const std::size_t begin = text.find(before) + before.size();
  return nlohmann::json::parse(text.substr(begin, text.find("</script>", begin) - begin));
}

}  // namespace

TEST_CASE("analyze: a page on which a parameter is moved") {
  const nlohmann::json page = moved("'mask:[w,1,1-w]@-1' --over w=-1/4..5/4");
  int drawn = 0;
  for (const nlohmann::json& value : page.at("values")) {
    CAPTURE(value.at("text"));
    CHECK(value.contains("exponent") == value.contains("limit"));
    if (!value.contains("limit")) continue;
    ++drawn;
    // The scheme interpolates: phi is 1 at 0, and its shifts sum to 1.
    const nlohmann::json& limit = value.at("limit");
    const double from = limit.at("from"), step = limit.at("step");
    const auto at = [&](double x) {  // 0 outside of the support
      const long i = std::lround((x - from) / step);
      return i < 0 || i >= long(limit.at("values").size()) ? 0 : limit.at("values").at(std::size_t(i)).get<double>();
    };
    CHECK(at(0) == 1);
    double sum = 0, squares = 0;
    for (int k = 0; k < 6; ++k) {
      const double x = k - 2.5;
      sum += at(x);
      squares += at(x) * at(x);
    }
    CHECK(sum == Approx(1).margin(1e-3));
    const nlohmann::json& psi = value.at("variance");
    CHECK(psi.at(psi.size() / 2).get<double>() == Approx(squares).margin(1e-3));
  }
  CHECK(drawn == 39);  // those with 0 < w < 1
  // Exact at single values, which are among them; divergent ones are no gaps.
  const nlohmann::json odd = moved("four-point:w --over w=0..1/7 --budget 4");
  bool found = false;
  for (const nlohmann::json& value : odd.at("values")) {
    if (value.at("text") == "1/16") found = value.at("exponent") == "2";
    CHECK(value.contains("exponent") == value.contains("limit"));  // there is time for them, however long the curve
  }
  CHECK(found);
  CHECK(odd.at("values").size() == 62);
  CHECK(moved("'mask:[w,1/2,1/2-w,1/2-w,1/2,w]' --over w=2..3").at("values").at(0).at("note") == "does not converge");
}

TEST_CASE("analyze: vectors of functions, their values and a picture") {
  const Folder folder;
  const std::string picture = folder / "ghm.svg";
  const Run page = run("analyze ghm --plot " + picture);
  CHECK(page.code == 0);
  CHECK(page.out.find("phi_2(1) = 1") != std::string::npos);
  CHECK(content(picture).find("<svg") != std::string::npos);
  const auto json = run_json("analyze ghm");
  CHECK(json.at("components").size() == 2);
  CHECK(json.at("holder").at("lower") == "1");
  CHECK(run("analyze 'refinable:[[[1,0],[0,1]],[[1,0],[0,1]]]@0'").code == 1);
  // Tensor products of numbers are none.
  CHECK(run("analyze 'tensor:(primal:n=2)x(dd:n=2)' --budget 2").out.find("sum rules") != std::string::npos);
}
