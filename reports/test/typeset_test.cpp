#include <subcert/cmake/catch.hpp>
#include <subcert/reports/formats/html.hpp>
#include <subcert/reports/formats/provenance.hpp>
#include <subcert/reports/formats/typeset.hpp>

using namespace subcert::formats;

TEST_CASE("pages: words, signs and powers as they are printed") {
  CHECK(typeset("Hoelder exponent &gt;= 2 ... 3, n^2 max |psi'|") ==
        "Hölder exponent ≥ 2 … 3, n<sup>2</sup> max |<i>ψ</i>'|");
  CHECK(typeset("||S_b^16||, h^0.99 of f^(2), 2^-8, C^k, phi(x)^2") ==
        "||S<sub>b</sub><sup>16</sup>||, h<sup>0.99</sup> of f<sup>(2)</sup>, 2<sup>-8</sup>, C<sup>k</sup>, "
        "<i>φ</i>(x)<sup>2</sup>");
  CHECK(typeset("S_n and dual S_12, f_j, psi_n(x), log_2(3), log2(3), N^(1 - log2(N)/2)") ==
        "S<sub>n</sub> and dual S<sub>12</sub>, f<sub>j</sub>, <i>ψ</i><sub>n</sub>(x), log<sub>2</sub>(3), "
        "log<sub>2</sub>(3), N<sup>(1 - log<sub>2</sub>(N)/2)</sup>");
  CHECK(typeset("2q_n, 12psi_n, 1.5 % of 3") == "2q<sub>n</sub>, 12<i>ψ</i><sub>n</sub>, 1.5&nbsp;% of 3");
  CHECK(typeset("<p>psi</p>") == "<p><i>ψ</i></p>");
}

TEST_CASE("pages: what is no word or power stays") {
  for (const char* text : {"psi_max", "x_sd",   "f_",       "_n",
                           "a_b_c",   "n_max",  "S_n2",     "xS_n",
                           "x2S_n",   "log2",   "epsilon",  "graphic",
                           "phi2",    "^2",     "a ^ b",    "2^",
                           "x^^2",    "x^word", "a^((k-1)", "a^(a sum that is too long for a power)",
                           "",        "...",    "&lt;=",    "a <b title=\"psi^2 ... phi\">b</b>"})
    CHECK(typeset(text) == text);
}

TEST_CASE("pages: lists break behind commas alone") {
  CHECK(typeset("[1,-3,3]/4, or so") == "[1,<wbr>-3,<wbr>3]/4, or so");
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
