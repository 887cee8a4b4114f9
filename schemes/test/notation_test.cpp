#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/as_written.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/specification.hpp>
#include <subcert/schemes/test/draw.hpp>

#include <functional>

using namespace subcert;

namespace {

using Coefficients = std::vector<Rational>;

/// Coefficients that sum to 1 over each class, the first and the last not zero.
Coefficients draw_mask(Draw& draw) {
  for (;;) {
    Coefficients c(static_cast<std::size_t>(draw.number(2, 9)));
    const long below = std::vector<long>{1, 2, 3, 4, 16, 30, 1024}[static_cast<std::size_t>(draw.number(0, 6))];
    for (Rational& one : c) one = Rational(draw.number(-20, 20), below);
    for (std::size_t parity = 0; parity < 2; ++parity) {
      Rational sum = 0;
      for (std::size_t k = parity + 2; k < c.size(); k += 2) sum += c[k];
      c[parity] = 1 - sum;
    }
    if (c.front() != 0 && c.back() != 0) return c;
  }
}

Integer common_denominator(const Coefficients& c) {
  Integer common = 1;
  for (const Rational& one : c) common = lcm(common, denominator(one));
  return common;
}

std::string joined(const Coefficients& c, const std::string& comma, const std::function<std::string(Rational)>& print) {
  std::string text;
  for (const Rational& one : c) text += (text.empty() ? "" : comma) + print(one);
  return text;
}

std::string with_minus(std::string text, const std::string& minus) {
  std::string result;
  for (const char c : text) result += c == '-' ? minus : std::string(1, c);
  return result;
}

std::string fraction_of(const Rational& value) {
  const std::string magnitude = numerator(abs(value)).str(), below = denominator(value).str();
  return (value < 0 ? "-" : "") + (below == "1" ? magnitude : "\\frac{" + magnitude + "}{" + below + "}");
}

/// The same mask in one of the forms of lists.
std::string list_in_some_form(const Coefficients& c, Draw& draw) {
  const std::string minus = draw.one_of({"-", "−", "–"}), blank = draw.one_of({"", " ", " ", "  "});
  const auto exact = [&](const Rational& one) { return with_minus(to_text(one), minus); };
  const auto sum = [&](const Rational& one) {
    const Rational part(draw.number(-9, 9), draw.number(1, 9));
    return exact(one - part) + blank + (part < 0 ? minus : "+") + blank + to_text(abs(part));
  };
  const Integer common = common_denominator(c);
  Coefficients whole;
  for (const Rational& one : c) whole.push_back(one * common);
  const std::string commas = joined(whole, "," + blank, exact), blanks = joined(whole, " " + blank, exact);
  const std::string factor = draw.one_of({"1/" + common.str(), "(1/" + common.str() + ")",
                                          "\\frac{1}{" + common.str() + "}", "\\tfrac1{" + common.str() + "}"});
  const std::string times = draw.one_of({"", " ", "*", " * ", "·", "×", "\\cdot "});
  switch (draw.number(0, 9)) {
    case 0: return "[" + commas + "]" + blank + "/" + blank + common.str();
    case 1: return "{" + commas + "}/" + common.str();
    case 2: return "[" + blanks + "]/" + common.str();
    case 3: return factor + times + "[" + commas + "]";
    case 4: return factor + times + "(" + commas + ")";
    case 5: return factor + times + "\\left[" + blanks + "\\right]";
    case 6: return "[" + joined(c, "," + blank, exact) + "]";
    case 7: return "[" + joined(c, blank + ",", sum) + "]";
    case 8:
      return "\\{" + joined(c, ",", [&](const Rational& one) { return with_minus(fraction_of(one), minus); }) + "\\}";
    default: {
      const long p = draw.number(2, 9);
      Coefficients parts;
      for (const Rational& one : whole) parts.push_back(one / p);
      return std::to_string(p) + "/" + common.str() + times + "[" + joined(parts, ",", exact) + "]";
    }
  }
}

std::string raised(const std::string& number) {
  std::string result;
  const std::vector<std::string> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  for (const char c : number) result += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
  return result;
}

/// The same mask as the sum of its terms.
std::string symbol_in_some_form(const Coefficients& c, long first, Draw& draw) {
  const Integer common = common_denominator(c);
  const std::string minus = draw.one_of({"-", "−"}), blank = draw.one_of({"", " "});
  const std::string times = draw.one_of({"", " ", "*", "·"});
  const long style = draw.number(0, 3);
  std::string sum;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Rational value = c[k] * common;
    const std::string power = std::to_string(first + static_cast<long>(k));
    sum += (value < 0 ? minus : sum.empty() ? "" : "+") + blank + to_text(abs(value)) + times;
    sum += style == 0   ? "z^" + power
           : style == 1 ? "z^{" + power + "}"
           : style == 2 ? "z**" + power
                        : "z" + raised(power);
    sum += blank;
  }
  switch (draw.number(0, 2)) {
    case 0: return "(" + sum + ")/" + common.str();
    case 1: return "1/" + common.str() + "*(" + sum + ")";
    default: return "$\\frac{" + sum + "}{" + common.str() + "}$";
  }
}

}  // namespace

TEST_CASE("random masks in every notation read back") {
  Draw draw;
  for (int trial = 0; trial < 3000; ++trial) {
    const Coefficients c = draw_mask(draw);
    const long first = draw.number(-12, 12);
    const bool list = draw.coin();
    const std::string text = list ? list_in_some_form(c, draw) + "@" + std::to_string(first)
                                  : symbol_in_some_form(c, first, draw);
    CAPTURE(trial, text, specification_as_written(text));
    CHECK(make_scheme(text).mask.curve().symbol() == LaurentPolynomial(c, first));
  }
}

TEST_CASE("tables of several lines are lists of rows") {
  const std::string rows[] = {"0 1 2 1 0", "1 6 10 6 1", "2 10 16 10 2", "1 6 10 6 1", "0 1 2 1 0"};
  const std::string expected =
      make_linear_scheme("[[0,1,2,1,0],[1,6,10,6,1],[2,10,16,10,2],[1,6,10,6,1],[0,1,2,1,0]]/24").specification;
  const auto table = [&](const std::string& begin, const std::string& end, const std::string& blank) {
    std::string text;
    for (const std::string& row : rows) {
      std::string line;
      for (const char c : row) line += c == ' ' ? blank : std::string(1, c);
      text += (text.empty() ? "" : end + "\n" + begin) + line;
    }
    return text;
  };
  for (const std::string& text :
       {"[" + table("", "", " ") + "]/24", "[\n" + table("", "", "\t") + "\n]/24", "[" + table("", ";", " ") + "]/24",
        "[" + table("", "\r", ", ") + "]/24", "[[" + table(" [", "]", "  ") + "]]/24",
        "[[" + table(" [", "],", ", ") + "]]/24", "mask2:[" + table("", "", " ") + "]/24"}) {
    CAPTURE(text, specification_as_written(text));
    CHECK(make_linear_scheme(text).specification == expected);
  }
  CHECK(make_linear_scheme("1/4 1/2 1/4\n1/2 1 1/2\n1/4 1/2 1/4").specification ==
        make_linear_scheme("[1,2,1;2,4,2;1,2,1]/4").specification);
  CHECK(make_linear_scheme("1/4\n3/4\n3/4\n1/4").specification == make_linear_scheme("[1,3,3,1]/4").specification);
  for (const char* dilation : {"[1,1;1,-1]", "[[1,1],[1,-1]]", "[ [1, 1], [1, -1] ]"})
    CHECK(
        make_linear_scheme("mask2:[0,1,0;1,4,1;0,1,0]/4,dilation=" + std::string(dilation)).mask.dilation().to_text() ==
        "[1,1;1,-1]");
  CHECK(make_linear_scheme("box:[[1,0],[0,1],[1,1]]").specification == "box:[1,0;0,1;1,1]");
  for (const char* bad : {"box:[[1,0],0,1]", "box:[[1,0],[0,1]", "mask2:[0,1,0;1,4,1;0,1,0]/4,dilation=[[1,1]]"})
    CHECK_THROWS_AS(make_linear_scheme(bad), SpecificationError);
}

TEST_CASE("random families with names of several letters are those with one") {
  Draw draw;
  for (int trial = 0; trial < 500; ++trial) {
    const Coefficients a = draw_mask(draw);
    if (a == Coefficients{1, 1}) continue;  // no letter is left
    const std::string name = draw.one_of({"w", "mu", "alpha", "tension", "omega", "z", "e", "zeta"});
    const std::string written = draw.one_of({name, name == "mu" ? "μ" : name == "alpha" ? "\\alpha{}" : name});
    const std::string star = draw.one_of({"*", "", " "});
    const auto list = [&](const std::string& parameter, const std::string& times) {
      std::string text;
      for (std::size_t k = 0; k < a.size(); ++k) {
        const Rational slope = k < 2 ? 1 - a[k] : -a[k];  // towards [1, 1]
        text += (k == 0 ? "[" : ",") + to_text(a[k]) + (slope < 0 ? "-" : "+") + numerator(abs(slope)).str() + times +
                parameter + "/" + denominator(slope).str();
      }
      return text + "]";
    };
    const std::string text = list(written == "\\alpha{}" ? "\\alpha" : written, star);
    CAPTURE(trial, text);
    const ParametricScheme scheme = make_parametric_scheme(text), plain = make_parametric_scheme(list("w", "*"));
    CHECK(scheme.mask == plain.mask);
    CHECK(scheme.name == name);
    CHECK(has_parameter(text));
    CHECK(make_parametric_scheme(scheme.specification).specification == scheme.specification);
    CHECK(make_parametric_scheme(scheme.specification).mask == scheme.mask);
  }
}

TEST_CASE("names of parameters") {
  const auto names = [](const char* text) { return make_parametric_scheme(text).name; };
  CHECK(names("four-point:mu") == "mu");
  CHECK(make_parametric_scheme("four-point:ω").specification == "four-point:omega");
  CHECK(names("(1+z)^2(-μ+2μz+(1-2μ)z²+2μz³-μz⁴)/2z³") == "mu");
  CHECK(make_parametric_scheme("(1+z)^2(-μ+2μz+(1-2μ)z²+2μz³-μz⁴)/2z³").mask ==
        make_parametric_scheme("(1+z)^2(-w+2wz+(1-2w)z^2+2wz^3-wz^4)/2z^3").mask);
  CHECK(names("[ww,1-ww,1-ww,ww]") == "w");
  // Keys of the family have the letters of the name.
  CHECK(make_parametric_scheme("regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1,weights=[tau;1;tau|tau;1;1;tau]")
            .specification == "regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1,weights=[tau;1;tau|tau;1;1;tau]");
  CHECK(in_letters("mask:[st,1-s*t,1-st,st]", {"s", "t"}) ==
        std::pair<std::string, std::string>("mask:[st,1-s*t,1-st,st]", "st"));
  CHECK(in_letters("[mu*nu,1-μ ν,1,1]", {"mu", "nu"}).first == "mask:[m*n,1-m n,1,1]");
  CHECK_FALSE(has_parameter("[75e-2,1/4,25e-2,0.75]"));
  for (const char* bad : {"[mu,1-nu,1-mu,mu]", "[w,1-mu,1-w,w]", "[sqrt(w),1-w,1-w,w]", "[w,1-pi,1-w,w]",
                          "(1+z)(1+zeta)", "[2e-1,1-e,1-2e-1,e]", "four-point:w2", "[μν,1,1,1]", "[2μ1,1,1,1]"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(make_parametric_scheme(bad), SpecificationError);
  }
  CHECK_THROWS_WITH(in_letters("[xi,1-xi,1-xi,xi]", {"xi", "x", "i"}), Catch::Contains("where they stand together"));
}

TEST_CASE("what could mean two things is refused, with what would be right") {
  const auto refusal = [](const char* text) -> std::string {
    try {
      return "accepted as " + make_linear_scheme(text).specification;
    } catch (const SpecificationError& error) {
      return std::to_string(error.position()) + " " + error.token() + ": " + error.expected();
    }
  };
  using Catch::StartsWith;
  CHECK_THAT(refusal("[½,1½,½]"), StartsWith("5 ½: a + or * before a fraction"));
  CHECK_THAT(refusal("[½,1 ½,½]"), StartsWith("6 ½: a + or * before a fraction"));
  CHECK_THAT(refusal("[\\frac12,1\\frac12]"), StartsWith("11 \\frac12: a + or * before a fraction"));
  CHECK_THAT(refusal("(1+z²3)/4"), StartsWith("6 3: a * behind the power"));
  CHECK_THAT(refusal("(1+z^{2}3)/4"), StartsWith("9 3: a * behind the power"));
  CHECK_THAT(refusal("(1+z^{k})/4"), StartsWith("6 {k}: a whole number as power"));
  CHECK_THAT(refusal("[1,²,1]"), StartsWith("4 ²: a base before the power"));
  CHECK_THAT(refusal("[1,1]\\foo"), StartsWith("6 \\foo: LaTeX of"));
  CHECK_THAT(refusal("\\frac{1}{"), StartsWith("9 {: a brace that closes"));
  CHECK_THAT(refusal("four-point:w=1/2/3"), StartsWith("14 1/2/3: an exact number"));
  CHECK_THAT(refusal("[1/2/3,1]"), StartsWith("7 1/2/3: an exact number"));
  for (const char* bad :
       {"[1,3,3,1]/4/2", "[2,2]/4/2", "mask:[2,2]/4/2", "[w,2-w,2-w,w]/4/2", "[1,3,3,1]/4*2", "[1,3,3,1]*1+1",
        "1+1/4[1,3,3,1]", "1-3/4[1,3,3,1]", "[1,3,3,1]/8+4", "1/2/2[1,3,3,1]", "[1,3,3,1]/2^2/1", "[1,1]4", "[1,1]z"})
    CHECK_THAT(refusal(bad), !StartsWith("accepted"));
  CHECK(refusal("-1/4[-1,-3,-3,-1]") == refusal("[1,3,3,1]/(2*2)"));
  CHECK(refusal("2^-2[1,3,3,1]") == refusal("1/2*1/2[1,3,3,1]"));
  CHECK(refusal("2^-2[1,3,3,1]") == refusal("[1,3,3,1]*1/4"));
  CHECK_THAT(refusal("0[1,1]"), StartsWith("1 0[1,1]: a family"));
  CHECK_THAT(refusal("primal n=3"), Catch::Contains("a colon behind 'primal'"));
  CHECK_THAT(refusal("bspline:degre=3"), Catch::Contains("the key 'degree'"));
  CHECK_THAT(refusal("bspline:degree=3,ariti=2"), Catch::Contains("a key of bspline:degree=3,a=2"));
  CHECK_THAT(refusal("grid:points=4x4,d=1,pionts=3"), Catch::Contains("did you mean 'points'?"));
  std::string deep;
  for (int k = 0; k < 1000; ++k) deep += "\\frac{1}{";
  CHECK_THROWS_AS(make_linear_scheme(deep), SpecificationError);
}

TEST_CASE("every prefix and every single change of a pasted text is read or refused") {
  for (const std::string valid : {"$\\frac{1}{16}\\left[−1, 0, 9, 16, 9, 0, −1\\right]$", "½·(1+z)²/2z⁻¹",
                                  "¹⁄₁₆{½,\\tfrac12}", "\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}"}) {
    const auto attempt = [](const std::string& text) {
      try {
        (void)make_linear_scheme(text);
      } catch (const SpecificationError& error) {
        const std::string message = error.what();
        for (std::size_t i = 0; i < message.size(); ++i)  // no character is cut
          if ((static_cast<unsigned char>(message[i]) & 0xE0U) == 0xC0U)
            CHECK((i + 1 < message.size() && (static_cast<unsigned char>(message[i + 1]) & 0xC0U) == 0x80U));
      }
    };
    for (std::size_t i = 0; i < valid.size(); ++i) {
      attempt(valid.substr(0, i));
      for (const char c : {'0', '-', ',', '[', '{', '}', '\\', '^', '(', '\xc2', '\xff', '\0'}) {
        std::string changed = valid;
        changed[i] = c;
        attempt(changed);
      }
    }
  }
}
