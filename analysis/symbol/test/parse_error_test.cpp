#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>

using namespace subcert;

TEST_CASE("what is printed can be seen") {
  CHECK(visible("a b-c\xc3\xb6\xe2\x88\x92") == "a b-c\xc3\xb6\xe2\x88\x92");
  CHECK(visible("a\tb\x7f\x1b[31m") == "a\\u0009b\\u007f\\u001b[31m");
  CHECK(visible("2.5\xc2\xa0\xe2\x80\x8b\xef\xbb\xbf") == "2.5\\u00a0\\u200b\\ufeff");
  // No UTF-8: a lone byte, a cut character, one that could be shorter, a surrogate.
  CHECK(visible("\xff") == "\\xff");
  CHECK(visible("\xe2\x88") == "\\xe2\\x88");
  CHECK(visible("\xc0\x80") == "\\xc0\\x80");
  CHECK(visible("\xed\xa0\x80") == "\\xed\\xa0\\x80");
  CHECK(visible("").empty());
  CHECK(printable(std::string(41, 'x')) == std::string(40, 'x') + "...");
  std::string longest;
  for (int k = 0; k < 41; ++k) longest += "\xc3\xb6";
  CHECK(printable(longest) == longest.substr(0, 80) + "...");
  CHECK(in_quotes("-3") == "'-3'");
  CHECK(in_quotes("\xe2\x88\x92"
                  "3") ==
        "'\xe2\x88\x92"
        "3' (with U+2212)");
}

TEST_CASE("the word that is meant") {
  const std::vector<std::string> words{"primal", "dual", "dd", "four-point", "analyze"};
  CHECK(nearest_word("Primal", words) == "primal");
  CHECK(nearest_word("pirmal", words) == "primal");
  CHECK(nearest_word("four_point", words) == "four-point");
  CHECK(nearest_word("jspline", {"bspline", "j-spline"}) == "j-spline");
  CHECK(nearest_word("spline", {"bspline", "j-spline"}) == "bspline");
  CHECK(nearest_word("DD4", words) == "dd");
  CHECK(nearest_word("analyse", words) == "analyze");
  CHECK(nearest_word("x", words).empty());
  CHECK(nearest_word("", words).empty());
  CHECK(nearest_word("chaikin", words).empty());
  CHECK(nearest_word(std::string(1000000, 'a'), words).empty());
  CHECK(did_you_mean("pimal", words) == "; did you mean 'primal'?");
  CHECK(did_you_mean("x", words).empty());
  CHECK(did_you_mean("rule-8", {"rule-7", "rule-8-n", "rule-8-d"}) == "; did you mean one of rule-8-n, rule-8-d?");
  const std::vector<std::string> options{"--levels", "--level-of-detail", "--property"};
  CHECK(did_you_mean("--prop", options) == "; did you mean '--property'?");
  CHECK(did_you_mean("--pr", options).empty());
  CHECK(did_you_mean("--lev", options).empty());
  CHECK(expected_one_of({"primal", "dual"}, "dul") == "'dul'; expected primal, dual; did you mean 'dual'?");
  CHECK(expected_one_of({"primal", "dual"}, "x") == "'x'; expected primal, dual");
}
