#include <subcert/cmake/catch.hpp>
#include <subcert/reports/formats/paper_text.hpp>
#include <subcert/schemes/specification.hpp>

#include <random>

using namespace subcert;
using namespace subcert::formats;

TEST_CASE("texts and tables for LaTeX and Markdown") {
  CHECK(latex_text("S_n 50% {a} ^ ~ \\ >= 2 < 3 | #&$") ==
        "S\\_n 50\\% \\{a\\} \\textasciicircum{} \\textasciitilde{} \\textbackslash{} $\\ge$ 2 \\textless{} 3 "
        "\\textbar{} \\#\\&\\$");
  const TableRows rows{{"a", "b"}, {"1", "2|3"}};
  CHECK(markdown_table(rows) == "| a | b |\n|---|---|\n| 1 | 2\\|3 |\n");
  CHECK(
      latex_tabular(rows, "c") ==
      "\\begin{tabular}{lc}\n  \\toprule\n  a & b \\\\\n  \\midrule\n  1 & 2|3 \\\\\n  \\bottomrule\n\\end{tabular}\n");
}

TEST_CASE("formulas for LaTeX") {
  CHECK(latex_formula("-1 + 4*w + 32*w^3") == "-1 + 4 w + 32 w^{3}");
  CHECK(latex_formula("1/16 <= mu < r2") == "\\frac{1}{16} \\le \\mu < r_{2}");
  CHECK(latex_formula("tension^-12") == "\\mathrm{tension}^{-12}");
  CHECK(latex_formula("0<=x>=2") == "0\\le x\\ge2");
  CHECK(latex_formula("C^1") == "C^{1}");
  CHECK(latex_formula("0.25") == "0.25");
  const auto relation = [](const char* low, const char* high, int digits) {
    const auto end = [](const char* text) { return *text ? parse_rational(text) : std::nullopt; };
    return relation_latex({end(low), end(high)}, digits);
  };
  CHECK(relation("2", "2", 14) == "= 2");
  CHECK(relation("1/3", "1/3", 14) == "= \\frac{1}{3}");
  CHECK(relation("1999/1000", "19995/10000", 4) == "= 1.999\\ldots");
  // Digits are those of the number, never rounded up, and zeros count.
  CHECK(relation("19996/10000", "19998/10000", 3) == "= 1.99\\ldots");
  CHECK(relation("15001/10000", "15002/10000", 3) == "= 1.50\\ldots");
  CHECK(relation("3/2", "8/5", 3) == "\\in [1.5,\\, 1.6]");
  CHECK(relation("1", "", 3) == "\\ge 1");
  CHECK(relation("", "1", 3) == "\\le 1");
  CHECK(relation("", "", 3).empty());
}

TEST_CASE("masks and symbols for LaTeX") {
  const auto mask = [](const char* text) { return mask_latex(make_linear_scheme(text).mask); };
  const auto symbol = [](const char* text) { return symbol_latex(make_scheme(text).mask.curve()); };
  CHECK(mask("bspline:degree=2") == "(a_{-2}, \\ldots, a_{1}) = \\frac{1}{4}(1,\\, 3,\\, 3,\\, 1)");
  CHECK(mask("mask2:[[1,2,1],[2,2,0]]/2@0,-1") ==
        "(a_{i,j}) = \\frac{1}{2}\\begin{bmatrix} 2 & 2 & 0 \\\\ 1 & 2 & 1 \\end{bmatrix},\\quad i = 0, \\ldots, 2,\\; "
        "j = 0, \\ldots, -1");
  CHECK(symbol("bspline:degree=2") == "a(z) = \\frac{(1 + z)^{3}}{4 z^{2}}");
  CHECK(symbol("bspline:degree=1") == "a(z) = \\frac{(1 + z)^{2}}{2 z}");
  CHECK(symbol("mask:[1,1]@0") == "a(z) = (1 + z)");
  CHECK(symbol("mask:[1,1]@3") == "a(z) = z^{3}(1 + z)");
  CHECK(symbol("dd:n=2") == "a(z) = \\frac{(1 + z)^{4}(-1 + 4 z - z^{2})}{16 z^{3}}");
  CHECK(symbol("bspline:degree=2,a=3") == "a(z) = \\frac{(1 + z + z^{2})^{3}}{9 z^{3}}");
}

TEST_CASE("symbols in LaTeX read back as their masks") {
  std::mt19937 engine(48);
  const auto number = [&](long low, long high) { return std::uniform_int_distribution<long>(low, high)(engine); };
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Rational> c(static_cast<std::size_t>(number(2, 8)));
    for (Rational& one : c) one = Rational(number(-9, 9), number(1, 6));
    for (std::size_t parity = 0; parity < 2; ++parity) {
      Rational sum = 0;
      for (std::size_t k = parity + 2; k < c.size(); k += 2) sum += c[k];
      c[parity] = 1 - sum;
    }
    const Mask mask(LaurentPolynomial(c, number(-6, 6)), 2);
    const std::string text = symbol_latex(mask).substr(std::string("a(z) = ").size());
    CAPTURE(trial, text);
    CHECK(make_scheme(text).mask.curve() == mask);
  }
}
