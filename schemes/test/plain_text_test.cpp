#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/as_written.hpp>
#include <subcert/schemes/plain_text.hpp>
#include <subcert/schemes/specification.hpp>

#include <utility>
#include <vector>

using namespace subcert;

namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

/// What the reader makes of a text, or `POSITION TOKEN: EXPECTED`.
template <class Reader>
std::string outcome(Reader read, const std::string& text) {
  try {
    return read(text);
  } catch (const SpecificationError& error) {
    return std::to_string(error.position()) + " " + error.token() + ": " + error.expected();
  }
}

std::string plain(const std::string& text) {
  return outcome([](const std::string& one) { return plain_text(one); }, text);
}
std::string written(const std::string& text) {
  return outcome([](const std::string& one) { return specification_as_written(one); }, text);
}

}  // namespace

TEST_CASE("plain text: fractions of one character, raised and lowered digits") {
  const Pairs one_character{{"¼", "1/4"}, {"½", "1/2"}, {"¾", "3/4"},   //
                            {"⅐", "1/7"}, {"⅑", "1/9"}, {"⅒", "1/10"},  //
                            {"⅓", "1/3"}, {"⅔", "2/3"}, {"⅕", "1/5"},   //
                            {"⅖", "2/5"}, {"⅗", "3/5"}, {"⅘", "4/5"},   //
                            {"⅙", "1/6"}, {"⅚", "5/6"}, {"⅛", "1/8"},   //
                            {"⅜", "3/8"}, {"⅝", "5/8"}, {"⅞", "7/8"}};
  for (const auto& [text, value] : one_character) CHECK(plain(text) == "(" + value + ")");
  const Pairs texts{{"¹⁄₁₆·[1,2]", "(1/16)*[1,2]"},
                    {"¹/₁₆[1,2]", "(1/16)[1,2]"},
                    {"⁻³⁄₂", "(-3/2)"},
                    {"⁺¹⁰⁄₉", "(+10/9)"},
                    {"w+¹⁄₂", "w+(1/2)"},
                    {"[w,¹⁄₂]", "[w,(1/2)]"},
                    {"z²", "z^2"},
                    {"z⁻¹⁰", "z^-10"},
                    {"(1+z)⁴z", "(1+z)^4z"},
                    {"2⁷ z", "2^7 z"},
                    {"z²+z³", "z^2+z^3"},
                    {"0..½", "0..(1/2)"},
                    {"[1 ½]", "[1 (1/2)]"},
                    {"1..w½", "1..w(1/2)"}};
  for (const auto& [text, meaning] : texts) {
    CAPTURE(text);
    CHECK(plain(text) == meaning);
  }
  using Catch::StartsWith;
  CHECK_THAT(plain("¹/16"), StartsWith("1 ¹: a base before the power"));
  CHECK_THAT(plain("[1,¹⁄]"), StartsWith("4 ¹⁄: a fraction of whole numbers"));
  CHECK_THAT(plain("[1,⁻⁄₂]"), StartsWith("4 ⁻⁄₂: a fraction of whole numbers"));
  CHECK_THAT(plain("z⁻"), StartsWith("2 ⁻: a base before the power"));
  CHECK_THAT(plain("+²"), StartsWith("2 ²: a base before the power"));
  CHECK_THAT(plain("z²⁄₃"), StartsWith("2 ²⁄₃: a + or * before a fraction") || StartsWith("z("));
  CHECK_THAT(plain("3½"), StartsWith("2 ½: a + or * before a fraction that follows a number"));
  CHECK_THAT(plain("3 ½"), StartsWith("3 ½: a + or * before a fraction that follows a number"));
  CHECK_THAT(plain("3.½"), StartsWith("3 ½: a + or * before a fraction that follows a number"));
  CHECK_THAT(plain(".½"), StartsWith("2 ½: a + or * before a fraction that follows a number"));
  CHECK_THAT(plain("[3½ 1]"), StartsWith("3 ½: a + or * before a fraction that follows a number"));
  CHECK_THAT(plain("z²3"), StartsWith("3 3: a * behind the power"));
  CHECK_THAT(plain("z².5"), StartsWith("3 .: a * behind the power"));
}

TEST_CASE("plain text: signs and blanks that look like others") {
  for (const char* blank : {" ", "\u2002", "\u2003", "\u2004", "\u2005", "\u2006", "\u2007", "\u2008", "\u2009",
                            "\u200A", "\u202F", "\u205F", "~", "\\ ", "\\,", "\\;", "\\:", "\\quad", "\\qquad"})
    CHECK(plain(std::string("[1") + blank + "2]") == "[1 2]");
  for (const char* minus : {"\u2010", "\u2011", "\u2012", "–", "−", "\uFE63", "－"})
    CHECK(plain(std::string("1") + minus + "2") == "1-2");
  for (const char* times : {"·", "×", "\u2062", "∗", "∙", "⋅", "＊", "\\cdot", "\\times", "\\ast"})
    CHECK(plain(std::string("1") + times + "2") == "1*2");
  for (const char* over : {"÷", "⁄", "∕", "／"}) CHECK(plain(std::string("1") + over + "2") == "1/2");
  for (const char* nothing : {"\u2061", "\\left", "\\right", "\\big", "\\Big", "\\bigl", "\\bigr", "\\Bigl", "\\Bigr",
                              "\\biggl", "\\biggr", "\\!", "\\displaystyle"})
    CHECK(plain(std::string(nothing) + "(1)") == "(1)");
  CHECK(plain("（1＋2）［3，4］mask：＝；\u2064∶") == "(1+2)[3,4]mask:=;+:");
  CHECK(plain("{1,2}") == "[1,2]");
  CHECK(plain("\\{1,2\\}") == "[1,2]");
  CHECK(plain("z**2") == "z^2");
  CHECK(plain("z*2") == "z*2");
  CHECK(plain("1&2") == "1&2");  // outside of a list
  CHECK(plain("\\begin{pmatrix}1&-2\\\\3&4\\end{pmatrix}") == "[1,-2;3,4]");
  CHECK(plain("2*\\begin{matrix}1\\end{matrix}/4") == "2*[1]/4");
  CHECK(plain("$1/4$") == "1/4");
  CHECK(plain("$") == "$");
}

TEST_CASE("plain text: names of letters") {
  const Pairs names{{"α", "alpha"},   {"β", "beta"},    {"γ", "gamma"},  //
                    {"δ", "delta"},   {"ε", "epsilon"}, {"ζ", "zeta"},   //
                    {"η", "eta"},     {"θ", "theta"},   {"ι", "iota"},   //
                    {"κ", "kappa"},   {"λ", "lambda"},  {"μ", "mu"},     //
                    {"ν", "nu"},      {"ξ", "xi"},      {"ρ", "rho"},    //
                    {"ς", "sigma"},   {"σ", "sigma"},   {"τ", "tau"},    //
                    {"υ", "upsilon"}, {"φ", "phi"},     {"χ", "chi"},    //
                    {"ψ", "psi"},     {"ω", "omega"},   {"µ", "mu"},     //
                    {"ϑ", "theta"},   {"ϕ", "phi"},     {"ϵ", "epsilon"}};
  for (const auto& [letter, name] : names) {
    CHECK(plain(letter) == name);
    CHECK(plain("2" + letter + "z") == "2" + name + " z");
    CHECK(plain("z" + letter) == "z " + name);
    CHECK(is_greek(name));
    CHECK(plain("\\" + name + "/2") == name + "/2");
    CHECK_THAT(plain("[" + letter + "w,1]"), Catch::StartsWith("3 w: a * between the names of two parameters"));
  }
  CHECK(plain("\\varepsilon+\\Gamma") == "epsilon+Gamma");
  CHECK(plain("π") == "π");
  CHECK(plain("ο") == "ο");
  CHECK_FALSE(is_greek(""));
  CHECK_FALSE(is_greek("pi"));
}

TEST_CASE("plain text: fractions and powers of LaTeX") {
  const Pairs texts{{"\\frac{1}{16}", "(1/16)"},
                    {"\\frac  {1}  {16}", "(1/16)"},
                    {"\\frac 1 2", "(1/2)"},
                    {"\\tfrac12+\\dfrac34", "(1/2)+(3/4)"},
                    {"\\frac{-1}{2}", "(-1/2)"},
                    {"\\frac{1}{-2}", "((1)/(-2))"},
                    {"\\frac{w}{2}", "((w)/(2))"},
                    {"\\frac w2", "((w)/(2))"},
                    {"\\frac{1+\\frac12}{ z }", "((1+(1/2))/(z))"},
                    {"z^{-2}", "z^-2"},
                    {"z^{ 12 }", "z^12"},
                    {"z^{2}z", "z^2z"}};
  for (const auto& [text, meaning] : texts) {
    CAPTURE(text);
    CHECK(plain(text) == meaning);
  }
  using Catch::StartsWith;
  CHECK_THAT(plain("1+\\frac"), StartsWith("3 \\frac: \\frac with two arguments"));
  CHECK_THAT(plain("1+\\frac1 "), StartsWith("3 \\frac1 : \\frac with two arguments"));
  CHECK_THAT(plain("1+\\frac1+2"), StartsWith("3 \\frac1: \\frac with its arguments in braces"));
  CHECK_THAT(plain("1+z^{2+1}"), StartsWith("5 {2+1}: a whole number as power"));
  CHECK_THAT(plain("1+z^{²}"), StartsWith("6 ²: a base before the power"));
  CHECK_THAT(plain("[1,1]\\foo/2"), StartsWith("6 \\foo: LaTeX of"));
  CHECK_THAT(plain("[1,1]\\@/2"), StartsWith("6 \\@: LaTeX of"));
  CHECK_THAT(plain("12\\"), StartsWith("3 \\: LaTeX of"));
  CHECK_THAT(plain("12\\begin"), StartsWith("3 \\begin: the name of a matrix in braces"));
  CHECK_THAT(plain("12\\begin+{pmatrix}"), StartsWith("3 \\begin: the name of a matrix in braces"));
  CHECK_THAT(plain("12\\begin{array}1"), StartsWith("3 \\begin{array}: a matrix, as"));
  CHECK(plain("\\frac{1}{\\}}") == "((1)/(]))");  // a brace that is printed does not close
  CHECK_THAT(plain("½^{2"), StartsWith("3 {2: a brace that closes"));
  std::string deep = "1";
  for (int k = 0; k < 20; ++k) deep = "\\frac{" + deep + "}{2}";
  CHECK(plain(deep).starts_with("((("));
  CHECK_THAT(plain("\\frac{" + deep + "}{2}"), Catch::Contains("fractions at most 20 deep"));
}

TEST_CASE("as written: lists") {
  const Pairs texts{{"[1,3,3,1]/4", "mask:[1,3,3,1]/4"},
                    {"[ 1 , 3 , 3 , 1 ] / 4", "mask:[1,3,3,1]/4"},
                    {"[1 3 3 1]/4", "mask:[1,3,3,1]/4"},
                    {"[1\t3 3  1]/4 @-1", "mask:[1,3,3,1]/4@-1"},
                    {"[1 -3 + 4]", "mask:[1,-3+4]"},
                    {"[1 - 3]", "mask:[1-3]"},
                    {"[1 +3]", "mask:[1,+3]"},
                    {"[1 (2) .5 (3) 4.]", "mask:[1,(2),.5,(3),4.]"},
                    {"[1, -3, 2 3]", "mask:[1,-3,2 3]"},
                    {"[1 2;3 4]", "mask2:[[1,2],[3,4]]"},
                    {"[[1 2] [3 4]]", "mask2:[[1,2],[3,4]]"},
                    {"[[1,2],[3,4]]/4@-1,-1", "mask2:[[1,2],[3,4]]/4@-1,-1"},
                    {"[[[1,1]]]", "mask3:[[[1,1]]]"},
                    {"mask2:[1,2;3,4]", "mask2:[[1,2],[3,4]]"},
                    {"(1,3,3,1)/4", "mask:[1,3,3,1]/4"},
                    {"1/4 ((1+0),3,3,1)", "mask:[(1+0),3,3,1]/4"},
                    {"(1/4)(1,3,3,1)", "mask:[1,3,3,1]/4"},
                    {"3/4 [1,1/3,w]", "mask:[3,1,3*(w)]/4"},
                    {"-1/4[-1,-3,-3,-1]", "mask:[1,3,3,1]/4"},
                    {"2[1,1]/4", "mask:[1,1]/2"},
                    {"[1,3,3,1]*1/4", "mask:[1,3,3,1]/4"},
                    {"[1,3,3,1] * (1/4) @3,arity=2", "mask:[1,3,3,1]/4@3,arity=2"},
                    {"[1,3,3,1]/(2*2)", "mask:[1,3,3,1]/4"},
                    {"[1,3,3,1]/2^2", "mask:[1,3,3,1]/4"},
                    {"[w,1-w,1-w,w]/n", "mask:[w,1-w,1-w,w]/n"},
                    {"w[1,1]", "w[1,1]"},
                    {"0[1,1]", "0[1,1]"},
                    {"1+1[1,1]", "1+1[1,1]"},
                    {"[1,1]+2", "mask:[1,1]+2"},
                    {"[1,1]/2/2", "mask:[1,1]/2/2"}};
  for (const auto& [text, meaning] : texts) {
    CAPTURE(text);
    CHECK(written(text) == meaning);
  }
}

TEST_CASE("as written: symbols and names") {
  const Pairs texts{{"(1+z)^2/2", "symbol:(1+z)^2/2"},
                    {"-(1+z)", "symbol:-(1+z)"},
                    {".5(1+z)", "symbol:.5(1+z)"},
                    {"(1+x)(1+y)", "symbol2:(1+x)(1+y)"},
                    {"(1+z1)(1+z2)^2/4", "symbol2:(1+x)(1+y)^2/4"},
                    {"(1+z_1)^2*(1+z_2)^2/4", "symbol2:(1+x)^2*(1+y)^2/4"},
                    {"(1+z1)z_2", "symbol2:(1+x)y"},
                    {"(1+z1)(1+z2)z", "symbol:(1+z1)(1+z2)z"},
                    {"symbol:(1+z1)(1+z2)(1+z3)/4", "symbol3:(1+x)(1+y)(1+z)/4"},
                    {"array([1., 3., 3., 1.])/4", "mask:[1.,3.,3.,1.]/4"},
                    {"(1+x)(1+z)", "symbol3:(1+x)(1+z)"},
                    {"(1+y)(1+z)", "symbol3:(1+y)(1+z)"},
                    {"symbol: (1+x)(1+y),arity=3", "symbol2:(1+x)(1+y),arity=3"},
                    {"symbol:(1+z),xy=3", "symbol:(1+z),xy=3"},
                    {"1+z", "1+z"},  // no parentheses: a name
                    {"w(1+z)", "w(1+z)"},
                    {"(1+w)", "(1+w)"},
                    {" Primal : n=3 ", "primal:n=3"},
                    {"Catmull_Clark", "catmull-clark"},
                    {"four-point", "four-point:w=1/16"},
                    {"four-point:w=1/8", "four-point:w=1/8"},
                    {"DD4:", "dd:n=2"},
                    {"nosuch", "nosuch"}};
  for (const auto& [text, meaning] : texts) {
    CAPTURE(text);
    CHECK(written(text) == meaning);
  }
  CHECK(other_names().size() == 26);
  for (const std::string& name : other_names()) {
    CAPTURE(name);
    CHECK_NOTHROW(static_cast<void>(make_linear_scheme(name)));
  }
  const auto same = [](const char* name, const char* as) {
    return make_linear_scheme(name).specification == make_linear_scheme(as).specification;
  };
  CHECK((same("chaikin", "bspline:degree=2") && same("cubic-bspline", "bspline:degree=3") &&
         same("cubic", "bspline:degree=3") && same("quintic_spline", "bspline:degree=5")));
  CHECK((same("dd4", "dd:n=2") && same("dd6", "dd:n=3") && same("dd8", "dd:n=4")));
  CHECK((same("db2", "daubechies:n=2") && same("db3", "daubechies:n=3") && same("db4", "daubechies:n=4")));
}
