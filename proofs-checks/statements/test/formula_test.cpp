#include "../formula.hpp"
#include "../identities.hpp"
#include "../transcription.hpp"

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>

using namespace subcert;
using namespace subcert::statements;

TEST_CASE("formulas have the values that arithmetic gives them") {
  const Values at{{"n", 3}, {"j", Rational(1, 2)}};
  CHECK(Formula::parse("1/(2*n)*(1 - (6*j - 3)/(8*n^2 - 2))")(at) == Rational(1, 6));
  CHECK(Formula::parse("-n^2 + 2*n - 1.25")(at) == Rational(-17, 4));
  CHECK(Formula::parse("2^(n - 5)")(at) == Rational(1, 4));
  CHECK(Formula::parse("8/2/2")({}) == 2);
  CHECK(Formula::parse("tau1*tau12")({{"tau1", 3}, {"tau12", 5}}) == 15);
  CHECK(Formula::parse("tau12^2 + n").to_latex() == "\\tau_{12}^{2} + n");
  CHECK_THROWS_AS(Formula::parse("1/(n - 3)")(at), Undefined);
  CHECK_FAILS(Formula::parse("m")(at), domain);
  for (const char* text : {"", "1 +", "(1", "1)", "2n", "a b", "1..2", "1,2", "n^", "^2", "()", "1/*2"})
    CHECK_THROWS_AS(Formula::parse(text), ParseError);
  CHECK_THROWS_AS(Formula::parse(std::string(200, '(') + "1" + std::string(200, ')')), ParseError);
}

TEST_CASE("degree bounds of a formula") {
  const Formula f = Formula::parse("(n^2*j + 1)/(n - 1) + j^3");
  CHECK(f.degrees("n").numerator == 2);
  CHECK(f.degrees("n").denominator == 1);
  CHECK(f.degrees("j").numerator == 3);
  CHECK(f.degrees("j").denominator == 0);
}

TEST_CASE("misprints are marked in the transcription") {
  const std::string text = "a*r^3 {+ => -} 30*r";
  CHECK(form_text(text, Form::printed) == "a*r^3 + 30*r");
  CHECK(form_text(text, Form::corrected) == "a*r^3 - 30*r");
  CHECK(number_count(text) == 2);
  CHECK(with_changed_number(text, 1) == "a*r^3 {+ => -} 31*r");
  CHECK(with_changed_number("0.0018 9", 0) == "0.0021 9");
  CHECK(is_in_misprint("{8 => 6}*n", 0));
  CHECK_FALSE(is_in_misprint("{8 => 6}*n", 1));
  for (const char* bad : {"{a => b", "a}", "{a}", "{a {b => c}}"})
    CHECK_THROWS_AS(form_text(bad, Form::printed), ParseError);
}

TEST_CASE("identities are proved, and refuted with the first point") {
  const auto f = [](const char* text) { return Formula::parse(text); };
  CHECK_FALSE(identity(f("(n^2 - 1)/(n - 1)"), f("n + 1"), {{"n", 2}}).failed());
  CHECK(identity(f("n^2"), f("n + 2"), {{"n", 2}}).failure() == "n = 3: printed 9, derived 5");
  CHECK_FALSE(sum_identity({f("j^2"), "j", {0, 1}, {1, 0}}, f("n*(n + 1)*(2*n + 1)/6"), {{"n", 1}}).failed());
  CHECK(sum_identity({f("j^2"), "j", {0, 1}, {1, 0}}, f("n*(n + 1)*(2*n + 2)/6"), {{"n", 1}}).failed());
  CHECK_FALSE(positive(f("(n - j)/(2*n - 1)"), {{"n", "1 + x + y"}, {"j", "x"}}).failed());
  CHECK(positive(f("n - 2"), {{"n", "1 + x"}}).failed());
}
