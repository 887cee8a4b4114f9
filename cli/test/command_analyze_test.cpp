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
  CHECK(divergent.err.starts_with("subcert: mask:[1,1]: no limit function to draw; convergence: no"));
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
  CHECK(run("analyze four-point:w --plot p.svg").code == 64);
  CHECK(run("analyze 'mask:[w,v,1-w,1-v]'").code == 64);
}
