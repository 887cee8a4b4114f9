#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/reports/formats/mathml.hpp>

#include <algorithm>

using namespace subcert;
using namespace subcert::formats;

namespace {

/// Without <math>, <semantics> and the annotation.
std::string inner(const std::string& latex, bool block = false) {
  const std::string whole = mathml(latex, block);
  const std::string begin = block ? "<math display=\"block\"><semantics>" : "<math><semantics>";
  REQUIRE(whole.starts_with(begin));
  return whole.substr(begin.size(), whole.find("<annotation") - begin.size());
}

std::string what(const std::string& latex) {
  try {
    mathml(latex);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::domain);
    return error.what();
  }
  return "no error";
}

std::string repeated(int times, const std::string& text) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

/// The text of the elements of class `changed`, without tags, one after the other.
std::string changed(const std::string& html) {
  std::string result;
  const std::string mark = "class=\"changed\">";
  for (std::size_t at = html.find(mark); at != std::string::npos; at = html.find(mark, at)) {
    at += mark.size();
    result += result.empty() ? "" : "; ";
    for (int depth = 1; depth > 0; ++at) {
      if (html[at] != '<') {
        result += html[at];
        continue;
      }
      depth += html[at + 1] == '/' ? -1 : 1;
      at = html.find('>', at);
    }
  }
  return result;
}

/// Every element is closed where it has to be.
void check_nesting(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const bool closes = html[at + 1] == '/';
    const std::size_t from = at + (closes ? 2 : 1);
    const std::string name = html.substr(from, html.find_first_of(" >", from) - from);
    if (name == "wbr") continue;
    if (!closes) {
      open.push_back(name);
    } else {
      REQUIRE(!open.empty());
      REQUIRE(open.back() == name);
      open.pop_back();
    }
  }
  CHECK(open.empty());
}

}  // namespace

TEST_CASE("every form of every statement is set in MathML") {
  std::size_t forms = 0;
  for (const statements::Statement& statement : statements::statements()) {
    INFO(statement.id);
    const std::string printed = printed_latex(statement), corrected = corrected_latex(statement);
    for (const std::string& latex : {printed, corrected}) {
      if (latex.empty()) continue;
      std::string html;
      REQUIRE_NOTHROW(html = mathml(latex, true));
      check_nesting(html);
      REQUIRE_NOTHROW(html = formula_html(latex));
      check_nesting(html);
      CHECK(changed(html).empty());
      ++forms;
    }
    if (corrected.empty() || corrected == printed) continue;
    const MarkedFormulas both = marked_difference(printed, corrected);
    check_nesting(both.printed);
    check_nesting(both.corrected);
    CHECK(changed(both.printed) + changed(both.corrected) != "");
  }
  CHECK(forms > statements::statements().size());
}

TEST_CASE("typical formulas") {
  CHECK(inner("\\frac{1}{2n}") == "<mfrac><mn>1</mn><mrow><mn>2</mn><mi>n</mi></mrow></mfrac>");
  CHECK(inner("\\frac12n") == "<mrow><mfrac><mn>1</mn><mn>2</mn></mfrac><mi>n</mi></mrow>");
  CHECK(inner("\\phi_n'") ==
        "<msubsup><mi>ϕ</mi><mi>n</mi>"
        "<mpadded scriptlevel=\"-1\" voffset=\"-0.45em\" height=\"0.3em\"><mo>′</mo></mpadded>"
        "</msubsup>");
  CHECK(inner("f'^{2}_{1}").find("<msubsup>") != std::string::npos);
  CHECK(inner("x_1^{-1}") ==
        "<msubsup><mi>x</mi><mn>1</mn><mrow><mo form=\"prefix\">−</mo><mn>1</mn></mrow></msubsup>");
  CHECK(inner("\\sum_{j=1}^n j", true) ==
        "<mrow><munderover><mo lspace=\"0\" rspace=\"0\">∑</mo><mrow><mi>j</mi><mo lspace=\"0\" "
        "rspace=\"0\">=</mo><mn>1</mn></mrow>"
        "<mi>n</mi></munderover><mspace width=\"0.167em\"></mspace><mi>j</mi></mrow>");
  CHECK(inner("\\sum_j") == "<msub><mo lspace=\"0\" rspace=\"0\">∑</mo><mi>j</mi></msub>");
  CHECK(inner("\\|f\\|_\\infty") ==
        "<mrow><mo stretchy=\"false\">‖</mo><mi>f</mi><msub><mo stretchy=\"false\">‖</mo>"
        "<mi mathvariant=\"normal\">∞</mi></msub></mrow>");
  CHECK(inner("(a)^2") ==
        "<mrow><mo stretchy=\"false\">(</mo><mi>a</mi><msup><mo stretchy=\"false\">)</mo><mn>2</mn></msup></mrow>");
  CHECK(inner("(\\frac ab)^2") ==
        "<msup><mrow><mo>(</mo><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>)</mo></mrow><mn>2</mn></msup>");
  CHECK(inner("(\\frac ab)") == "<mrow><mo>(</mo><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>)</mo></mrow>");
  CHECK(inner("\\left.a\\right|") == "<mrow><mi>a</mi><mo>|</mo></mrow>");
  CHECK(inner("\\bar{\\mathbf{a}}, \\mathbb{Z}, \\mathcal{L}, \\Pi") ==
        "<mrow><mover accent=\"true\"><mi>𝐚</mi><mo stretchy=\"false\">¯</mo></mover><mo>,</mo><mi>ℤ</mi>"
        "<mo>,</mo><mi>ℒ</mi><mo>,</mo><mi mathvariant=\"normal\">Π</mi></mrow>");
  CHECK(inner("2\\sin x") ==
        "<mrow><mn>2</mn><mspace width=\"0.167em\"></mspace><mi>sin</mi><mo>\u2061</mo>"
        "<mspace width=\"0.167em\"></mspace><mi>x</mi></mrow>");
  CHECK(inner("a - b") == "<mrow><mi>a</mi><mo form=\"infix\">−</mo><mi>b</mi></mrow>");
  CHECK(inner("a - (b)^2").starts_with("<mrow><mi>a</mi><mo form=\"infix\">−</mo>"));
  CHECK(inner("a, -b") == "<mrow><mi>a</mi><mo>,</mo><mo form=\"prefix\">−</mo><mi>b</mi></mrow>");
  CHECK(inner("\\sqrt[3]{x} \\binom nk") ==
        "<mrow><mroot><mi>x</mi><mn>3</mn></mroot><mrow><mo>(</mo><mfrac linethickness=\"0\"><mi>n</mi><mi>k</mi>"
        "</mfrac><mo>)</mo></mrow></mrow>");
  CHECK(inner("1 < \\dots < n, \\dots") ==
        "<mrow><mn>1</mn><mo>&lt;</mo><mo lspace=\"0\" rspace=\"0\">⋯</mo>"
        "<mo>&lt;</mo><mi>n</mi><mo>,</mo><mo lspace=\"0\" rspace=\"0\">…</mo></mrow>");
  CHECK(inner("1.25 \\text{ at } x") == "<mrow><mn>1.25</mn><mtext>\u00a0at\u00a0</mtext><mi>x</mi></mrow>");
  CHECK(inner("") == "<mrow></mrow>");
}

TEST_CASE("the LaTeX text is the annotation") {
  CHECK(mathml("a<b") ==
        "<math><semantics><mrow><mi>a</mi><mo>&lt;</mo><mi>b</mi></mrow><annotation "
        "encoding=\"application/x-tex\">a&lt;b</annotation></semantics></math>");
}

TEST_CASE("bars and brackets find their partners, the others stand alone") {
  const std::string bar = "<mo stretchy=\"false\">|</mo>";
  CHECK(inner("n|x|") == "<mrow><mi>n</mi><mrow>" + bar + "<mi>x</mi>" + bar + "</mrow></mrow>");
  CHECK(inner("||x|-1|") == "<mrow>" + bar + "<mrow>" + bar + "<mi>x</mi>" + bar +
                                "</mrow><mo form=\"infix\">−</mo><mn>1</mn>" + bar + "</mrow>");
  CHECK(inner("[a,b)").starts_with("<mrow><mo stretchy=\"false\">["));
  CHECK(inner("]a") == "<mrow><mo form=\"postfix\" stretchy=\"false\">]</mo><mi>a</mi></mrow>");
  CHECK(inner("(|a)").find("<mo lspace=\"0\" rspace=\"0\" stretchy=\"false\">|</mo>") != std::string::npos);
}

TEST_CASE("a long formula is several, with breaks between") {
  const std::string html = formula_html("S_n \\text{ is } C^1, \\quad n > 1");
  CHECK(html.find("</math> is <math") != std::string::npos);
  CHECK(html.find("class=\"quad\"") != std::string::npos);
  CHECK(html.find(">n &gt; 1</annotation>") != std::string::npos);
  CHECK(formula_html("\\text{lost}") == "lost");
  CHECK(formula_html("a" + repeated(10, " + b")).find("<wbr>") == std::string::npos);
  CHECK(formula_html("a" + repeated(50, " + b")).find("</math><wbr><math") != std::string::npos);
  CHECK(formula_html("2n\\text{-point}").ends_with("</math>\u2060-point"));
}

TEST_CASE("what cannot be read is named with its place") {
  CHECK(what("a + \\foo") == "formula in LaTeX, position 5: unknown command '\\foo'");
  CHECK(what("\\frac{a}{b") == "formula in LaTeX, position 9: '{'; expected '}'");
  CHECK(what("a}") == "formula in LaTeX, position 2: '}'; expected no '}' without its beginning");
  CHECK(what("x_1_2") == "formula in LaTeX, position 4: '_'; expected one index and one exponent");
  CHECK(what("\\frac1") == "formula in LaTeX, position 7: 'end'; expected an argument of \\frac");
  CHECK(what("\\left(a") == "formula in LaTeX, position 1: '\\left'; expected a \\right that ends it");
  CHECK(what("a\\right)").find("position 2: '\\right'") != std::string::npos);
  CHECK(what("\\text{a $b$}").find("position 9") != std::string::npos);
  for (const char* text :
       {"\\",       "a &b",          "x^",      "x^^2",     "\\mathbf{+}", "\\mathcal1", "\\left x\\right)",
        "\\text{a", "\\text{\\foo}", "\\sqrt[", "\\bigl",   "\\biggest(",  "{",          "\\begin{cases}",
        "ä",        "\\bar",         "\\right", "\\mathbb", "#",           "\x01"})
    CHECK(what(text) != "no error");
}

TEST_CASE("no depth and no length of a formula ends the program") {
  for (const char* text : {"{", "(", "\\frac", "\\hat", "x^{", "\\left(", "[|", "\\sqrt{", "\\text{", "_{"}) {
    CHECK_NOTHROW(what(repeated(40, text)));
    CHECK(what(repeated(10'000, text)) != "no error");
  }
  CHECK(what(repeated(45, "(") + repeated(45, ")")) == "no error");
  CHECK(what(repeated(200, "(") + "a" + repeated(200, ")")) != "no error");
  CHECK(what(repeated(40, "{(((") + "a" + repeated(40, ")))}")) != "no error");
  const std::string long_one = repeated(1600, "a+b");
  CHECK_NOTHROW(marked_difference(long_one, repeated(1600, "b+c")));
}

TEST_CASE("what both forms have in common is not marked") {
  const auto marks = [](const char* printed, const char* corrected) {
    const MarkedFormulas both = marked_difference(printed, corrected);
    return changed(both.printed) + " / " + changed(both.corrected);
  };
  CHECK(marks("a > b", "a \\geq b") == "&gt; / ≥");
  CHECK(marks("a", "a") == " / ");
  CHECK(marks("1, 2, 3", "2, 3, 4") == "1; 2; 3 / 2; 3; 4");  // a list in its order
  CHECK(marks("x_{-1} = 1", "x_0 = 1") == "−1 / 0");
  CHECK(marks("A^T B^{-1}", "B^{-1} A^T") == "AT / AT");
  CHECK(marks("\\sqrt{a}\\sqrt{b}", "\\sqrt{ab}") == "ab / ab");  // no leaf tells them apart
  CHECK(marks("x^{2}", "x^2") == " / ");
  CHECK(marks("x^{a_b}", "x^a_b") == "b / b");
  CHECK(marks("\\mathrm{d}", "d") == "d / d");
  CHECK(marks("n^2", "n2") == "2 / 2");                     // an exponent is no factor
  CHECK(marks("\\hat A x", "A x") == "ˆ / ");               // the accent alone
  CHECK(marks("\\frac{n}{2}", "\\frac{n}{3}") == "2 / 3");  //
  CHECK(marks("a + b = c", "d + e = c") == "a+b / d+e");    // no crumbs
  CHECK(marks("x = (r + 1) s", "x = (r - 1) s") == "+ / −");
  CHECK(marks("x = 2 (r + 1), y", "x = 2, y") == "(r+1) / ");
  CHECK(marks("\\text{a} = 4, 5", "\\text{a, b}") == "=4,5 / , b");  // a comma of a text is none of a list
  CHECK(marks("S \\text{ is fast}", "S \\text{ is slow}") == "fast / slow");
  CHECK(marks("1 + \\text{two words}", "1") == "+; two words / ");
}
