#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/as_written.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/refinement_rules.hpp>
#include <subcert/schemes/specification.hpp>
#include <subcert/schemes/test/draw.hpp>

#include <fmt/format.h>

using namespace subcert;

namespace {

LaurentPolynomial symbol_of(const std::string& text) { return make_scheme(text).mask.curve().symbol(); }

std::string refusal(const std::string& text) {
  try {
    return "accepted as " + make_linear_scheme(text).specification;
  } catch (const SpecificationError& error) {
    return std::to_string(error.position()) + " " + error.token() + ": " + error.expected();
  }
}

/// The weights of f_{i + first}, ..., which sum to 1, for f'_{arity i + output}.
struct Rule {
  long output, first;
  std::vector<Rational> weights;
};

Rule draw_rule(Draw& draw, long output) {
  Rule rule{output, draw.number(-4, 2), {}};
  Rational sum = 0;
  for (long k = draw.number(0, 4); k > 0; --k) sum += rule.weights.emplace_back(draw.number(-9, 9), draw.number(1, 9));
  rule.weights.emplace_back(1 - sum);
  return rule;
}

std::string shifted(const std::string& letter, long shift) {
  return shift == 0 ? letter : fmt::format("{}{:+}", letter, shift);
}

/// In one of the forms that papers have.
std::string printed(const Rule& rule, long arity, const std::string& letter, long style, Draw& draw) {
  const auto datum = [&](const std::string& index, bool fine) {
    const std::string level = fine ? "k+1" : "k";
    switch (style) {
      case 0: return "f_{" + index + "}^{" + level + "}";
      case 1: return "P^{(" + level + ")}_{" + index + "}";
      case 2: return (fine ? "f'_{" : "f_{") + index + "}";
      default: return (fine ? "g[" : "f[") + index + "]";
    }
  };
  std::string text = datum(shifted(std::to_string(arity) + letter, rule.output), true) +
                     draw.one_of({"=", " = ", " &= "});
  for (std::size_t k = 0; k < rule.weights.size(); ++k) {
    const Rational& weight = rule.weights[k];
    const std::string size = to_text(abs(weight)), above = numerator(abs(weight)).str(),
                      below = denominator(weight).str();
    text += weight < 0 ? draw.one_of({"-", " - "}) : k > 0 ? draw.one_of({"+", " + "}) : "";
    const std::string value = datum(shifted(letter, rule.first + static_cast<long>(k)), false);
    switch (draw.number(0, 3)) {
      case 0: text += size + draw.one_of({"", " ", "*", " \\cdot "}) + value; break;
      case 1: text += "\\frac{" + above + "}{" + below + "}" + value; break;
      case 2: text += "\\frac{" + above + value + "}{" + below + "}"; break;
      default: text += "(" + value + ")*" + above + "/" + below;
    }
  }
  return text;
}

}  // namespace

TEST_CASE("random rules in every notation give their mask") {
  Draw draw;
  for (int trial = 0; trial < 2000; ++trial) {
    const long arity = draw.number(2, 5), moved = draw.number(-3, 3);
    const long style = draw.number(0, 3);
    const std::string letter = draw.one_of({"i", "j", "n", "m"});
    std::vector<std::string> rules;
    LaurentPolynomial symbol;
    for (long q = 0; q < arity; ++q) {
      const Rule rule = draw_rule(draw, q + arity * draw.number(-1, 1) + moved);
      for (std::size_t k = 0; k < rule.weights.size(); ++k)
        symbol += LaurentPolynomial({rule.weights[k]}, rule.output - arity * (rule.first + static_cast<long>(k)));
      rules.push_back(printed(rule, arity, letter, style, draw));
    }
    draw.shuffle(rules);
    const std::string between = draw.one_of({", ", ";", " \\\\ ", ",\\quad ", "\n", " and "});
    std::string text;
    for (const std::string& rule : rules) text += (text.empty() ? "" : between) + rule;
    text = draw.one_of({"", "\\begin{cases} ", "$"}) + text + draw.one_of({"", ".", ","});
    CAPTURE(trial, text);
    const Scheme scheme = make_scheme(text);
    CHECK(scheme.mask.curve().arity() == arity);
    CHECK(scheme.mask.curve().symbol() == symbol);
  }
}

TEST_CASE("the rules of papers") {
  CHECK(symbol_of(
            "f_{2i}^{k+1} = f_i^k, f_{2i+1}^{k+1} = -1/16 f_{i-1}^k + 9/16 f_i^k + 9/16 f_{i+1}^k - 1/16 f_{i+2}^k") ==
        symbol_of("DD4"));
  CHECK(symbol_of("f_{2i}=f_i; f_{2i+1} = \\frac{1}{16}(-f_{i-1}+9f_i+9f_{i+1}-f_{i+2})") == symbol_of("DD4"));
  CHECK(symbol_of("p_{2i} = ¾p_i + ¼p_{i−1}\np_{2i+1} = ¾p_i + ¼p_{i+1}") == symbol_of("[1,3,3,1]/4@-1"));
  CHECK(symbol_of("f_2i = f_i, f_{2i+1} = (f_i + f_{i+1})/2.") == symbol_of("[1,2,1]/2@-1"));
  const ParametricScheme family = make_parametric_scheme(
      "\\begin{aligned} f_{2i}^{k+1} &= f_i^k \\\\ f_{2i+1}^{k+1} &= (\\tfrac12+\\mu)(f_i^k+f_{i+1}^k) - "
      "\\mu(f_{i-1}^k+f_{i+2}^k) \\end{aligned}");
  CHECK(family.name == "mu");
  CHECK(family.mask == make_parametric_scheme("four-point:w").mask);
  CHECK(symbol_of("f_2i = 3/4 f_i + 1/4 f_{i-1}, f_{2i+1} = 1/4 (3f_i + f_{i+1})") == symbol_of("[1,3,3,1]/4@-1"));
  CHECK(make_parametric_scheme("f_{2i} = f_i, f_{2i+1} = (1/2 + 1/4 mu)(f_i + f_{i+1}) - 1/4 mu (f_{i-1} + f_{i+2})")
            .mask == make_parametric_scheme("[-m/4,0,1/2+m/4,1,1/2+m/4,0,-m/4]").mask);
  CHECK(has_parameter("f_{2i} = f_i, f_{2i+1} = w f_i + (1-w) f_{i+1}"));
}

TEST_CASE("rules that are none are refused, with what would be right") {
  using Catch::StartsWith;
  CHECK_THAT(refusal("f_{2i} = f_i"), StartsWith("1 f_{2i}: 2 rules, one for each class of indices modulo 2; found 1"));
  CHECK_THAT(refusal("f_{2i} = f_i, f_{2i+2} = f_{i+1}"), StartsWith("15 f_{2i+2}: one rule for each class"));
  CHECK_THAT(refusal("f_{2i} = f_i, f_{3i+1} = f_i"), StartsWith("15 f_{3i+1}: f_{2i+q}, as in the first rule"));
  CHECK_THAT(refusal("f_{2i} = f_i, g_{2i+1} = f_i"), StartsWith("15 g_{2i+1}: f_{2i+q}, as in the first rule"));
  CHECK_THAT(refusal("f_{2i} = f_i f_{2i+1} = f_i"), StartsWith("14 f_{2i+1}: a comma or a semicolon"));
  CHECK_THAT(refusal("so f_{2i} = f_i, f_{2i+1} = f_i"), StartsWith("1 so : a rule"));
  CHECK_THAT(refusal("f_{99i} = f_i"), StartsWith("1 f_{99i}: an index from 2i to 64i"));
  for (const char* side :
       {"f_i f_{i+1}",   "f_i + 1/2",   "f_i^2 + w",  "f_i + g_{i+1}",   "f_i + f_j",         "1/f_i",
        "f_{2i}",        "a_j f_{i+j}", "z f_i",      "zeta f_i",        "max(f_i, f_{i+1})", "(f_i",
        "f_i = f_{i+1}", "1",           "",           "f_i + (1 + f_i)", "f_{i,j}",           "#f_i",
        "(#1)",          "(f_i)^2",     "f_i / (f_i)"}) {
    const std::string found = refusal("f_{2i} = f_i, f_{2i+1} = " + std::string(side));
    CAPTURE(side, found);
    CHECK(found.find("a sum of data as f_{i+1}, each times a number, or a letter other than z") != std::string::npos);
  }
  CHECK_THAT(refusal("f_{2i} = ½f_i + ½f_i, f_{2i+1} = ½"), StartsWith("34 ½: a sum of data"));
  CHECK(refusal("f_{2i} = f_i, f_{2i+1} = " + std::string(20000, '(')).find("a sum of data") != std::string::npos);
  const std::string valid = "f_{2i}^{k+1} = ¾f_i + ¼f_{i−1}, f_{2i+1} = \\frac12(f_i + f_{i+1})";
  for (std::size_t i = 0; i < valid.size(); ++i) {  // no prefix and no change is more than refused
    (void)refusal(valid.substr(0, i));
    for (const char c : {'0', '-', ',', '[', '{', '}', '\\', '^', '(', '#', '=', '_', '\xff', '\0'}) {
      std::string changed = valid;
      changed[i] = c;
      (void)refusal(changed);
    }
  }
}

TEST_CASE("masks with their name, bare lists and columns") {
  const LaurentPolynomial cubic = symbol_of("[1,4,6,4,1]/8");
  for (const char* text : {"a = [1,4,6,4,1]/8", "a(z) = (1+z)^4/8z^2", "\\alpha = \\frac18 [1,4,6,4,1]",
                           "a_n = 1/8 (1, 4, 6, 4, 1)", "1/8, 1/2, 3/4, 1/2, 1/8", "0.125 0.5 0.75 0.5 0.125",
                           "1/8 1/2 3/4 1/2 1/8", "[1/8; 1/2; 3/4; 1/2; 1/8]", "[1;4;6;4;1]/8"}) {
    CAPTURE(text);
    CHECK(symbol_of(text) == cubic);
  }
  CHECK(symbol_of("-1/16, 0, 9/16, 1, 9/16, 0, -1/16") == symbol_of("DD4"));
  CHECK(symbol_of("-1/16 0 9/16 1 9/16 0 −1/16") == symbol_of("DD4"));
  for (const char* text :
       {"1/16", "1 + 2", "w = 1/16", "1/8, 1/2, w", "ab = [1,1]", "a b = [1,1]", "= [1,1]", "1,2:3"}) {
    CAPTURE(text);
    CHECK_THAT(refusal(text), !Catch::StartsWith("accepted"));
  }
}

TEST_CASE("rules of a mask are printed as they are read") {
  CHECK(rules_text(make_scheme("chaikin").mask.curve()) ==
        "f_{2i} = 3/4 f_i + 1/4 f_{i+1}\nf_{2i+1} = 1/4 f_i + 3/4 f_{i+1}\n");
  CHECK(rules_text(make_scheme("four-point").mask.curve()) ==
        "f_{2i} = f_i\nf_{2i+1} = -1/16 f_{i-1} + 9/16 f_i + 9/16 f_{i+1} - 1/16 f_{i+2}\n");
  CHECK(rules_text(Mask(LaurentPolynomial::monomial(1, 1), 2)) == "f_{2i} = 0\nf_{2i+1} = f_i\n");
  Draw draw;
  for (int trial = 0; trial < 50; ++trial) {
    const long arity = draw.number(2, 5);
    LaurentPolynomial symbol;
    for (long phase = 0; phase < arity; ++phase) {
      const Rule rule = draw_rule(draw, phase);
      for (std::size_t k = 0; k < rule.weights.size(); ++k)
        symbol = symbol +
                 LaurentPolynomial::monomial(rule.weights[k], phase - arity * (rule.first + static_cast<long>(k)));
    }
    const Mask mask(symbol, static_cast<int>(arity));
    CAPTURE(rules_text(mask));
    CHECK(make_scheme(rules_text(mask)).mask.curve() == mask);
  }
}
