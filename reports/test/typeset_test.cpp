#include <subcert/cmake/catch.hpp>
#include <subcert/reports/formats/html.hpp>
#include <subcert/reports/formats/provenance.hpp>
#include <subcert/reports/formats/signs.hpp>
#include <subcert/reports/formats/typeset.hpp>

using namespace subcert::formats;

TEST_CASE("pages: words, signs and powers as they are printed") {
  CHECK(typeset("Hoelder exponent &gt;= 2 ... 3, n^2 max |psi'|") ==
        "Hölder exponent ≥&nbsp;2 … 3, n<sup>2</sup> max |<i>ψ</i>'|");
  CHECK(typeset("||S_b^16||, h^0.99 of f^(2), 2^-8, C^k, phi(x)^2") ==
        "||S<sub>b</sub><sup>16</sup>||, h<sup>0.99</sup> of f<sup>(2)</sup>, 2<sup>−8</sup>, C<sup>k</sup>, "
        "<i>φ</i>(x)<sup>2</sup>");
  CHECK(typeset("S_n and dual S_12, f_j, psi_n(x), log_2(3), log2(3), N^(1 - log2(N)/2)") ==
        "S<sub>n</sub> and dual S<sub>12</sub>, f<sub>j</sub>, <i>ψ</i><sub>n</sub>(x), log<sub>2</sub>(3), "
        "log<sub>2</sub>(3), N<sup>(1&nbsp;− log<sub>2</sub>(N)/2)</sup>");
  CHECK(typeset("0, +-2, +-(a - 1)") == "0, ±2, ±(a&nbsp;−&nbsp;1)");
  CHECK(typeset("2q_n, 12psi_n, 1.5 % of 3") == "2q<sub>n</sub>, 12<i>ψ</i><sub>n</sub>, 1.5&nbsp;% of 3");
  CHECK(typeset("<p>psi</p>") == "<p><i>ψ</i></p>");
}

TEST_CASE("pages: what is no word or power stays") {
  for (const char* text : {"psi_max", "x_sd",   "f_",       "_n",
                           "a_b_c",   "n_max",  "S_n2",     "xS_n",
                           "x2S_n",   "log2",   "epsilon",  "graphic",
                           "phi2",    "^2",     "a ^ b",    "2^",
                           "x^^2",    "x^word", "a^((k+1)", "a^(a sum that is too long for a power)",
                           "",        "...",    "&lt;=",    "a <b title=\"psi^2 ... phi\">b</b>"})
    CHECK(typeset(text) == text);
}

TEST_CASE("pages: no line ends between a word and what it counts, nor beside a sign of short terms") {
  CHECK(typeset("for all n and every d; Table 3, degree 1") ==
        "for all&nbsp;n and every&nbsp;d; Table&nbsp;3, degree&nbsp;1");
  CHECK(typeset("0 &lt; w &lt; 1/2, n - 1") == "0&nbsp;&lt;&nbsp;w&nbsp;&lt;&nbsp;1/2, n&nbsp;−&nbsp;1");
  for (const char* text :
       {"in a mask", "of all points", "the exponent = 1.9901439593863", "Table of words", "n points"})
    CHECK(typeset(text) == text);
}

TEST_CASE("signs: a hyphen is a minus before a number and between terms") {
  for (const char* text : {"-1/16",     "(-1/16)", "= -2",      "from -1 to -.5", "[-1,-w,-2]/16",
                           "1e-8",      "1/-2",    "n - 1",     "|x| - 2",        "(k + 1) - log2(3)",
                           "psi - phi", "x, -w",   "2w - 3",    "f' - g",         "&lt; -w",
                           "<b>-1",     "2^-k",    "y_n - y_m", "a|-|b|",         "…-1",
                           "2n-1]",     "n-1 and", "[1,2]@-7",  "from -n to n",   "... -n+1"}) {
    CAPTURE(text);
    CHECK(with_minus(text).find('-') == std::string::npos);
    CHECK(with_minus(text, "-") == text);
  }
  for (const char* text : {"2026-11-27",
                           "dyn-2015",
                           "6-point",
                           "pages 1-10",
                           "--jobs 2",
                           "use -j",
                           "-",
                           "a -",
                           "- b",
                           "two - or so",
                           "well-known",
                           "n-th",
                           "four-point:w=-1/16",
                           "mask:[-1,0,-1]/2",
                           "C-1",
                           "use n-1-2",
                           "xn-1",
                           "n-1a",
                           "n-gon",
                           "-x-y",
                           "tensor:(mask:[-1,1])x(four-point:w=-1)",
                           "Table 1 - proved",
                           "-."}) {
    CAPTURE(text);
    CHECK(with_minus(text) == text);
  }
}

TEST_CASE("pages: lists break behind commas alone") {
  CHECK(typeset("[1,-3,3]/4, or so") == "[1,<wbr>−3,<wbr>3]/4, or so");
  CHECK(typeset("<code>mask:[1,2]/4 psi^2 &lt;= 3</code> psi") ==
        "<code>mask:[1,<wbr>2]/4 psi^2 &lt;= 3</code> <i>ψ</i>");
}

TEST_CASE("pages: scripts, formulas, pictures and forms are as they were") {
  for (const char* kind : {"script", "style", "math", "svg", "pre", "option", "title", "textarea"}) {
    const std::string element = std::string("<") + kind + " id=a>psi^2, 1,2 ... Hoelder</" + kind + ">";
    CHECK(typeset(element + "psi") == element + "<i>ψ</i>");
  }
  for (const char* broken : {"<", "<b", "<script>psi", "a<"}) CHECK(typeset(broken) == broken);
}

TEST_CASE("pages: each says which program made it") {
  const std::string page = html_page("title", "<p>body</p>\n");
  CHECK(page.find(std::string("<meta name=generator content=\"subcert ") + version()) != std::string::npos);
  CHECK(page.find(std::string("Made by subcert ") + version()) != std::string::npos);
  CHECK(page.find(commit()) != std::string::npos);
}
