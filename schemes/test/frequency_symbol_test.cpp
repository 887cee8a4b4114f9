#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/as_written.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/specification.hpp>
#include <subcert/schemes/test/draw.hpp>

#include <fmt/format.h>

using namespace subcert;

namespace {

LaurentPolynomial laurent_of(const std::string& text) { return make_scheme(text).mask.curve().symbol(); }

std::string why_refused(const std::string& text) {
  try {
    return "accepted as " + make_linear_scheme(text).specification;
  } catch (const SpecificationError& error) {
    return error.expected();
  }
}

}  // namespace

TEST_CASE("random symbols in a frequency are those in z") {
  Draw draw;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto [w, half] = std::vector<std::pair<std::string, std::string>>{
        {"w", "w/2"},
        {"ω", "ω/2"},
        {"omega", "(omega/2)"},
        {"\\xi", "\\frac{\\xi}{2}"},
        {"t", "½t"}}[static_cast<std::size_t>(draw.number(0, 4))];
    const auto exponential = [&](long k) {
      const std::string unit = draw.one_of({"i", "j", "I"}), times = draw.one_of({"*", " "});
      const std::string argument = fmt::format("{}{}{}{}{}", k, times, unit, times, w);
      return draw.coin() ? "e^{" + argument + "}" : draw.one_of({"exp(", "\\exp("}) + argument + ")";
    };
    // The B-spline of an odd order and a factor that is 1 at z = 1.
    const long squares = draw.number(1, 4), moved = draw.number(-3, 3), weight = draw.number(-9, 9);
    const std::string slash = draw.one_of({"", "\\"});
    std::string text, power = std::to_string(2 * squares);
    switch (draw.number(0, 2)) {
      case 0: text = fmt::format("2 {}cos^{}({})", slash, power, half); break;
      case 1: text = fmt::format("2{}cos({})^{{{}}}", slash, half, power); break;
      default: text = fmt::format("2((1 + {}cos({}))/2)^{}", slash, w, squares);
    }
    text += fmt::format(" (1 {:+}*{}sin^2({})) {}", weight, slash, half, exponential(moved));
    const LaurentPolynomial cosine({Rational(1, 4), Rational(1, 2), Rational(1, 4)}, -1);
    LaurentPolynomial expected = LaurentPolynomial(2) * LaurentPolynomial::monomial(1, moved) *
                                 (LaurentPolynomial(1) +
                                  LaurentPolynomial(Rational(weight)) * (LaurentPolynomial(1) - cosine));
    for (long k = 0; k < squares; ++k) expected *= cosine;
    CAPTURE(trial, text, specification_as_written(text));
    CHECK(laurent_of(text) == expected);
  }
}

TEST_CASE("symbols as books on wavelets print them") {
  const LaurentPolynomial cubic = laurent_of("bspline:degree=3"), quadratic = laurent_of("[1,3,3,1]/4@0");
  for (const char* text :
       {"2cos^4(w/2)", "a(w) = 2 cos(w/2)^4", "2\\cos^4\\left(\\frac{\\omega}{2}\\right)", "2cos⁴(ω/2)",
        "$2 \\cos^{4} \\frac{\\omega}{2}$", "2 (cos(w/2))^4", "symbol:2cos^4(w/2),arity=2", "1/8 (1+e^{iw})^4 e^{-2iw}",
        "a(e^{i\\omega}) = \\frac{(1+e^{-i\\omega})^4}{8} e^{2i\\omega}"}) {
    CAPTURE(text, specification_as_written(text));
    CHECK(laurent_of(text) == cubic);
  }
  for (const char* text : {"(1+e^{iw})^3/4", "2 e^{3iw/2} cos^3(w/2)", "2 e^{3 i w/2} cos(w/2)^2 cos(w/2)",
                           "2\\mathrm{e}^{\\frac{3i\\omega}{2}}\\cos^3(\\omega/2)"}) {
    CAPTURE(text, specification_as_written(text));
    CHECK(laurent_of(text) == quadratic);
  }
  CHECK(make_parametric_scheme("2cos^2(ω/2)(1+16μ cos(ω) sin²(ω/2))").mask.to_text('w') ==
        make_parametric_scheme("four-point:w").mask.to_text('w'));
  // e may be a parameter.
  for (const char* power : {"e^2", "e^{2}"}) {
    CAPTURE(power);
    CHECK(make_parametric_scheme(fmt::format("2cos^2(w/2)(1+{}*sin^2(w/2))", power)).mask.to_text('e') ==
          make_parametric_scheme("[-e^2/8,1/2,1+e^2/4,1/2,-e^2/8]@-2").mask.to_text('e'));
  }
  CHECK(laurent_of("(1+2cos(w))^2/3*e^{iw},arity=3") == laurent_of("[1,2,3,2,1]/3@-1,arity=3"));
}

TEST_CASE("what is no symbol in a frequency says why") {
  const auto says = [](const char* text, const std::string& part) {
    CAPTURE(text, why_refused(text), part);
    CHECK(why_refused(text).find(part) != std::string::npos);
  };
  says("2cos^3(w/2)", "whole multiples of w once it is multiplied out");
  says("2cos^4(w/3)", "a multiple of half a frequency");
  says("2cos^4(w/2+1)", "a multiple of half a frequency");
  says("2cos^4(iw)", "a multiple of half a frequency");
  says("2cos^4(i)", "a multiple of half a frequency");
  says("2cos^4(freq)", "a multiple of half a frequency");
  says("2cos^4()", "a multiple of half a frequency");
  says("2cos w/2", "parentheses about the argument");
  says("2\\cos\\frac{\\omega}{2}^4", "parentheses about the argument");
  says("2cos^{-4}(w/2)", "a whole power from 1 to 64");
  says("2cos^{4/3}(w/2)", "a whole power from 1 to 64");
  says("2/cos^2(w/2)", "no quotients by sums");
  says("exp(w)", "a multiple of half a frequency");
  says("2sin^3(w)", "an even power of a sine");
  says("2cos^2(w/2)cos^2(v/2)", "the same frequency everywhere, here w");
  says("2cos^4(w/2)z", "no z, but e^{i w}");
  says("2cos^4(w/2)w", "w in functions of w alone");
  says("2e^{iw/2}cos(w/2)(1+m-m)", "numbers alone where odd multiples of w/2 stand");
  says("2cos^99(w)", "a whole power from 1 to 64");
  says("2cos^4(w/2", "a bracket that closes");
  says("cos^4(w/2)", "as all do: divide by that");
  const std::string valid = "$2 \\cos^{4}\\left(\\frac{ω}{2}\\right) e^{-2 i ω}(1+ sin²(ω)),arity=2";
  for (std::size_t i = 0; i < valid.size(); ++i) {
    (void)why_refused(valid.substr(0, i));
    for (const char c : {'0', '-', ',', '[', '{', '}', '\\', '^', '(', 'e', '=', 'i', '\xff', '\0'}) {
      std::string changed = valid;
      changed[i] = c;
      (void)why_refused(changed);
    }
  }
}
