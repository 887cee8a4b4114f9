#include "program.hpp"

using namespace subcert::testing;

TEST_CASE("mask: the fields of the contract") {
  const auto mask = run_json("mask 'dual:n=2'");
  CHECK(mask.at("first_index") == -4);
  CHECK(mask.at("coefficients").size() == 8);
  CHECK(mask.at("coefficients").at(0) == "7/40");
  CHECK(mask.at("support").at("upper") == "3");
}

TEST_CASE("mask: surfaces with any dilation, and what is printed reads back") {
  CHECK(run("mask loop").out == "[[1,2,1,0,0],[2,6,6,2,0],[1,6,10,6,1],[0,2,6,6,2],[0,0,1,2,1]]/16@-2,-2\n");
  const std::string sqrt3 =
      "[[0,0,0,1,0],[0,1,6,6,1],[0,6,12,6,0],[1,6,6,1,0],[0,1,0,0,0]]/18@-2,-2,dilation=[1,2;-2,-1],"
      "digits=[2,-2;1,-1;0,0]";
  CHECK(run("mask sqrt3").out == sqrt3 + "\n");
  CHECK(run("mask 'mask2:" + sqrt3 + "'").out == sqrt3 + "\n");
  const auto general = run_json("mask sqrt3");
  CHECK(general.at("scheme") == "sqrt3");
  CHECK_FALSE(general.contains("arity"));
  CHECK(general.at("dilation").dump() == "[[1,2],[-2,-1]]");
  CHECK(general.at("digits").dump() == "[[2,-2],[1,-1],[0,0]]");
  CHECK(general.at("coefficients").at(2).at(2) == "2/3");
  const auto multiple = run_json("mask 'box:[1,0;0,1;1,1],arity=3'");
  CHECK(multiple.at("arity") == 3);
  CHECK_FALSE(multiple.contains("digits"));
  CHECK(run_json("mask 'tensor:(primal:n=1)x(ary:a=3,points=2)'").at("dilation").dump() == "[[2,0],[0,3]]");
  for (const char* bad : {"mask2:[[1,1],[1]]", "mask2:[[[1,1],[1,1]],[[1,1],[1,1]]]", "mask2:[[1,1,1],[1,1,1]]",
                          "mask2:[[1,1],[1,1]],dilation=[1,0;0,2]", "mask2:[[1,1],[1,1]],digits=[0,0;1,0;0,1;2,0]",
                          "box:[1,0;2,0]", "box:[2,0;0,2]", "loop:w=1", "triangular:L=1"}) {
    const Run refused = run("mask '" + std::string(bad) + "'");
    CAPTURE(bad, refused.err);
    CHECK(refused.code == 64);
    CHECK(refused.out.empty());
    CHECK(refused.err.starts_with("subcert: scheme specification, position "));
    CHECK(std::count(refused.err.begin(), refused.err.end(), '\n') == 1);
  }
}

TEST_CASE("coefficients that were rounded: by how much their sum is off, and how to go on") {
  const std::string filter =
      "'mask:[-0.091271763114,-0.057543526229,0.591271763114,1.11508705,0.591271763114,-0.057543526229,-0.091271763114]"
      "'";
  const Run result = run("mask " + filter);
  CHECK(result.code == 64);
  CHECK(
      contains(result.err,
               "the class 0 mod 2 sums to 1 - 2.458e-9; where coefficients are rounded add that to one of the class"));
  CHECK(contains(run("mask 'mask:[1,3,3,1]'").err, "the class 0 mod 2 sums to 4, as all do: divide by that"));
  CHECK(contains(run("mask 'mask:[1/3,1,1/3]'").err, "the class 1 mod 2 sums to 2/3"));
  CHECK(contains(run("mask 'mask2:[[1,1],[1,1.001]]'").err,
                 "sums to 1 + 0.001; where coefficients are rounded take that"));
  // A minus sign that is no hyphen is read as one, and the message says so.
  CHECK(contains(run("mask 'mask:[1,\xe2\x88\x92"
                     "1]'")
                     .err,
                 "'[1,-1]'; expected coefficients that sum to 1"));
}

TEST_CASE("mask and regularity for papers") {
  CHECK(run("mask '(1+z)\xc2\xb3/4z\xc2\xb2' --latex").out ==
        "% mask:[1,3,3,1]/4@-2\n(a_{-2}, \\ldots, a_{1}) = \\frac{1}{4}(1,\\, 3,\\, 3,\\, 1)\n"
        "a(z) = \\frac{(1 + z)^{3}}{4 z^{2}}\n");
  CHECK(contains(run("mask loop: --latex").out, "\\begin{bmatrix} 0 & 0 & 1 & 2 & 1 \\\\ 0 & 2 & 6 & 6 & 2"));
  CHECK(contains(run("mask box:'[1,0,0;0,1,0;0,0,1]' --latex").err, "one or two variables"));
  CHECK(contains(run("regularity dd:n=2 --latex").out, "\n\\alpha = 2\n"));
  CHECK(contains(run("regularity primal:n=3 --latex").out, "\n\\alpha = 1.9363087904562\\ldots\n"));
  CHECK(contains(run("regularity dual:n=2 --latex").out,
                 "\n\\alpha = 3 - \\log_{2} \\frac{8}{5} = 2.3219280948873\\ldots\n"));
  CHECK(contains(run("regularity four-point:w=1/2 --latex").out, "no exponent is known; convergence: no\n"));
  CHECK(run("regularity four-point:w=1/2 --latex").code == 1);
  CHECK(contains(run("regularity dd:n=2 --markdown").out, "\n| exponent | 2  (exactly, with proof) |\n"));
  const std::string table = run("compare dd:n=2 chaikin --markdown").out;
  CHECK(table.starts_with("| scheme | dd:n=2 | bspline:degree=2 |\n|---|---|---|\n"));
  const std::string beside = run("compare dd:n=2 chaikin --latex --rows symbol,holder").out;
  CHECK(contains(beside, "\n  scheme & symbol & H\\\"older exponent \\\\\n  \\midrule\n"));
  CHECK(contains(beside, "\n  bspline:degree=2 & $\\frac{1}{4} z^{-2} + \\frac{3}{4} z^{-1}"));
  CHECK(contains(run("range four-point:mu --over mu=0..1/4 --property C1 --latex").out,
                 "$C^{1}$ for $0 < \\mu < r$, and for no other $\\mu$ from $0$ to $\\frac{1}{4}$; open on both "
                 "sides within "));
  check_fails(run("mask dd:n=2 --latex --json"), 64, "expected one of --json, --latex and --markdown");
}

TEST_CASE("mask: the rules for new points, which read back") {
  const Run rules = run("mask dd:n=2,a=3 --rules");
  CHECK(rules.out.starts_with("f_{3i} = f_i\nf_{3i+1} = -5/81 f_{i-1} + "));
  CHECK(run("mask '" + rules.out + "'").out == run("mask dd:n=2,a=3").out);
  CHECK(run("mask chaikin --rules --decimals").out ==
        "f_{2i} = 0.75 f_i + 0.25 f_{i+1}\nf_{2i+1} = 0.25 f_i + 0.75 f_{i+1}\n");
  CHECK(run("mask 'mask:[1/3,1,2/3]' --rules --decimals").out ==
        "f_{2i} = f_i\nf_{2i+1} = 0.6666666666666666 f_i + 0.3333333333333333 f_{i+1}\n");
  for (const char* refused :
       {"chaikin --decimals", "loop --rules", "ghm --rules", "chaikin --rules --json", "chaikin --rules --latex"}) {
    CAPTURE(refused);
    CHECK(run(std::string("mask ") + refused).code == 64);
  }
}
