#include "first_answer.hpp"

#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using namespace subcert::properties;
using namespace subcert::properties::testing;

TEST_CASE("true properties are proved and false ones refuted") {
  const std::string chaikin = "mask = 'mask:[1,3,3,1]/4'\n";
  for (const char* text :
       {"convergent = true", "smoothness = '>= 1'", "holder = '>= 2'", "holder = '<= 2'", "sum_rules = 3",
        "generates = 2", "reproduces = 1", "reproduces = '>= 1'", "support = [-2, 1]", "support = ['-2', '1/1']",
        "symmetry = 'even'", "stable = true", "interpolatory = false", "sobolev = '>= 2.49'", "variance = '<= 0.6'",
        "variance = '> 0.49'"}) {
    CAPTURE(text);
    CHECK(first_answer(chaikin + text).is_yes());
  }
  for (const char* text : {"convergent = false", "smoothness = '>= 3'", "holder = '> 2.1'", "holder = '< 2'",
                           "sum_rules = 2", "reproduces = 2", "support = [-2, 2]", "symmetry = 'odd'",
                           "smoothness = '>= 2'", "stable = false", "interpolatory = true", "variance = '<= 0.4'"}) {
    CAPTURE(text);
    CHECK(first_answer(chaikin + text).is_no());
  }
  CHECK(first_answer("mask = 'mask:[1,1]'\nconvergent = true").is_no());
}

TEST_CASE("properties for all values of a parameter") {
  const std::string tension = "mask = 'four-point:w'\n";
  check_all(tension, {"for = '0.001 < w < 0.1927'\nsmoothness = '>= 1'",
                      "for = '-0.4 <= w <= 49/100'\nconvergent = true", "for = '1/16 <= w <= 0.1'\nholder = '>= 3/2'",
                      "for = '-1/4 <= w < 1'\nstable = true", "for = '-1/8 <= w <= 1/4'\nsobolev = '>= 1'"});
  for (const char* text :
       {"for = '0.001 < w < 0.1928'\nsmoothness = '>= 1'", "for = '0 <= w <= 0.1'\nsmoothness = '>= 1'",
        "for = '0.05 <= w <= 0.07'\nsmoothness = '>= 2'", "for = '0 <= w <= 0.26'\nsobolev = '>= 1'"}) {
    CAPTURE(text);
    CHECK(first_answer(tension + text).is_no());
  }
  // Up to the end itself no interval is proved.
  const Decision open = first_answer(tension + "for = '0 < w < 0.1'\nsmoothness = '>= 1'");
  CHECK(open.truth == Truth::unknown);
  CHECK(open.reason.find("open for ") == 0);
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"for = '0 < v < 1'\nconvergent = true", "'for' takes"},
           {"for = '1 < w < 0'\nconvergent = true", "'for' takes"},
           {"for = 'w > 0'\nconvergent = true", "'for' takes"},
           {"for = 3\nconvergent = true", "'for' takes"},
           {"for = '0 < w < 1'\nconvergent = false", "over a range of a parameter takes true"},
           {"for = '0 < w < 1'\nholder = '< 2'", "over a range of a parameter takes"},
           {"for = '0 < w < 1'\nsum_rules = 2", "is a property of single schemes"}}) {
    CAPTURE(text);
    CHECK(error_of(tension + text).find(message) != std::string::npos);
  }
  CHECK(error_of("mask = 'dd:n=2'\nfor = '0 < w < 1'\nconvergent = true").find("family") != std::string::npos);
}

TEST_CASE("properties of rounded masks") {
  const std::string root = ",where=2t^2-1:0.7..0.8'\n", grows = "mask = 'mask:[1,1+t,0,-t]" + root;
  CHECK(first_answer("mask = 'mask:[t,1,1-t]" + root + "convergent = true").is_yes());
  for (const char* text : {"convergent = true", "smoothness = '>= 0'", "holder = '>= 1/2'"}) {  // its exponent is 0
    CAPTURE(text);
    CHECK(first_answer(grows + text).is_no());
  }
  CHECK(first_answer("mask = 'daubechies:n=3'\nstable = true").is_yes());
}

TEST_CASE("what needs convergence is not said without it") {
  const std::string grows = "mask = 'mask:[1,3/2,0,-1/2]'\n";
  for (const std::string& text : {grows + "stable = true", grows + "sobolev = '>= 0'", grows + "variance = '<= 100'",
                                  std::string("mask = 'mask:[1,1+t,0,-t],where=2t^2-1:0.7..0.8'\nstable = true")}) {
    CAPTURE(text);
    const Decision answer = first_answer(text);
    CHECK(answer.truth == Truth::unknown);
    CHECK_THAT(answer.reason, Catch::StartsWith("convergence is not proved: "));
  }
  // Sixteen levels do not contract, and the exponent is positive.
  check_all("mask = 'four-point:w=-0.4999'\n", {"convergent = true", "sobolev = '>= 0'"});
}

TEST_CASE("rounded masks whose convergence is not proved have no smoothness") {
  for (const char* text : {"holder = '>= 0'", "smoothness = '>= 0'"}) {
    CAPTURE(text);
    const Decision answer = first_answer(std::string("mask = 'mask:[1,1+t,0,-t],where=100000000t^2-2:0..1'\n") + text);
    CHECK(answer.truth == Truth::unknown);
    CHECK(answer.reason == "convergence is not proved");
  }
}

TEST_CASE("without time nothing is said of exponents") {
  for (const char* text : {"mask = 'quincunx:'\nsobolev = '>= 0'", "mask = 'ghm'\nsobolev = '>= 0'"}) {
    CAPTURE(text);
    const ExpectedScheme scheme = read_expectations(text).front();
    const Decision answer = has_property(scheme, scheme.expectations.front(), {0});
    CAPTURE(answer.reason);
    CHECK(answer.truth == Truth::unknown);
  }
}

TEST_CASE("masks whose coset sums are not 1 have no exponent") {
  ExpectedScheme scheme = read_expectations("mask = 'dd:n=2'\nholder = '>= 0'").front();
  std::get<Scheme>(scheme.scheme).mask = Mask(LaurentPolynomial({1, 1, 1}, -1), 2);
  const Decision answer = has_property(scheme, scheme.expectations.front(), {20});
  CHECK(answer.is_no());
  CHECK_THAT(answer.reason, Catch::StartsWith("a coset sum is not 1"));
}

TEST_CASE("Hermite schemes keep what is proved") {
  const std::string merrien = "mask = 'merrien:lambda=-1/8,mu=-1/2'\n";
  check_all(merrien, {"HC = '>= 0'", "HC = '>= 1'", "reproduces = 3"});
  const Decision refuted = first_answer(merrien + "HC = '>= 2'");
  CHECK(refuted.is_no());
  CHECK(refuted.reason == "HC^1 is proved, HC^2 refuted");
}

TEST_CASE("properties of vectors of functions") {
  const std::string ghm = "mask = 'ghm'\n", knots = "mask = 'bspline:degree=2,multiplicity=2'\n";
  for (const std::string& text :
       {ghm + "smoothness = '>= 0'", ghm + "holder = '>= 1'", ghm + "support = [0, 2]", knots + "support = [0, 2]"}) {
    CAPTURE(text);
    CHECK(first_answer(text).is_yes());
  }
  for (const std::string& text : {ghm + "smoothness = '>= 1'", ghm + "holder = '> 1'", ghm + "support = [0, 1]",
                                  knots + "support = [0, 1]", knots + "support = [1, 2]"}) {
    CAPTURE(text);
    CHECK(first_answer(text).is_no());
  }
  CHECK_THAT(first_answer(knots + "support = [0, 1]").reason, Catch::Contains("phi_2"));
  // The hat function on [-1, 1], and one beside it.
  const std::string beside = "mask = 'refinable:[[[2,0],[0,0]],[[4,0],[0,1]],[[2,0],[4,1]]]/4@-1'\n";
  const Decision both = first_answer(beside + "support = [-1, 1]");
  CHECK(both.is_yes());
  CHECK_THAT(both.reason, Catch::Contains("phi_1 [-1, 1], phi_2 [0, 1]"));
  CHECK(first_answer(beside + "support = [0, 1]").is_no());
  CHECK_THAT(error_of(ghm + "HC = '>= 1'"), Catch::Contains("is no property of vectors of functions"));
}

TEST_CASE("properties of surfaces") {
  const std::string quincunx = "mask = 'quincunx:'\n";
  for (const char* text :
       {"convergent = true", "smoothness = '>= 0'", "holder = '>= 0.61'", "holder = '< 0.62'", "sobolev = '>= 1.57'",
        "sum_rules = 2", "generates = 1", "reproduces = 1", "stable = true", "interpolatory = true"}) {
    CAPTURE(text);
    CHECK(first_answer(quincunx + text).is_yes());
  }
  for (const char* text : {"convergent = false", "smoothness = '>= 1'", "holder = '>= 0.62'", "sobolev = '> 1.58'",
                           "sum_rules = 3", "stable = false", "interpolatory = false"}) {
    CAPTURE(text);
    CHECK(first_answer(quincunx + text).is_no());
  }
  CHECK(first_answer("mask = 'zwart-powell:'\nstable = true").is_no());
  CHECK(first_answer("mask = 'zwart-powell:'\nholder = '<= 2'").is_yes());
  CHECK(first_answer("mask = 'zwart-powell:'\nholder = '> 2'").is_no());
  // C^1 with the exponent 2: never said to be C^2.
  CHECK_FALSE(first_answer("mask = 'zwart-powell:'\nsmoothness = '>= 2'").is_yes());
  CHECK(first_answer("mask = 'kobbelt:w=1/16'\nsmoothness = '>= 1'").is_yes());
  // Exactly a number: where it is proved to be it, not where the enclosure has a width.
  CHECK(first_answer("mask = 'dd:n=2'\nholder = '= 2'").is_yes());
  CHECK(first_answer("mask = 'dd:n=2'\nholder = '= 1.999999999'").is_no());
  CHECK(first_answer("mask = 'daubechies:n=3'\nholder = '= 1.0878'").is_no());
  CHECK(first_answer("mask = 'dd:n=2'\nreproduces = '= 3'").is_yes());
  CHECK_THAT(error_of(quincunx + "variance = '<= 1'"), Catch::Contains("is no property of surfaces"));
}

TEST_CASE("surfaces at vertices") {
  for (const char* text : {"mask = 'loop'\nvertices = 7", "mask = 'loop'\nvertices = '3..6,8'",
                           "mask = 'catmull-clark'\nvertices = '3'", "mask = 'butterfly:w=1/16'\nvertices = '4..7'"}) {
    CAPTURE(text);
    CHECK(first_answer(text).is_yes());
  }
  const Decision refuted = first_answer("mask = 'butterfly:w=1/16'\nvertices = '4..9'");
  CHECK(refuted.is_no());
  CHECK_THAT(refuted.reason, Catch::StartsWith("at valence 8: "));
  CHECK(first_answer("mask = 'midedge'\nvertices = '3..4'").is_yes());
  CHECK(first_answer("mask = 'butterfly:w=0'\nvertices = 4").truth == Truth::unknown);
  CHECK(first_answer("mask = 'butterfly:w=1/16'\nvertices = '3..9'").is_no());
  for (const char* wrong : {"'2..4'", "1001", "'x'", "true", "''", "7.5"})
    CHECK_THAT(error_of(std::string("mask = 'loop'\nvertices = ") + wrong),
               Catch::Contains("'vertices' takes valences, as \"3..12\" or 7"));
  CHECK_THAT(error_of("mask = 'dd:n=2'\nvertices = 7"), Catch::Contains("is no property of schemes of one variable"));
  CHECK_THAT(error_of("mask = 'loop'\nvalence = 7"), Catch::Contains("did you mean 'vertices'?"));
  CHECK_FAILS(first_answer("mask = 'quincunx:'\nvertices = 7"), domain);
}

TEST_CASE("of rounded coefficients nothing is said that depends on the rounding") {
  for (const char* text : {"sobolev = '>= 0'", "sobolev = '<= 9'", "variance = '<= 9'", "reproduces = 0"}) {
    CAPTURE(text);
    const Decision answer = first_answer(std::string("mask = 'daubechies:n=3'\n") + text);
    CHECK(answer.truth == Truth::unknown);
    CHECK(answer.reason == "the coefficients are rounded");
  }
  CHECK(first_answer("mask = 'daubechies:n=3'\nholder = '>= 1.08'").is_yes());
  CHECK(first_answer("mask = 'daubechies:n=3'\nholder = '<= 1.09'").is_yes());
}

TEST_CASE("a lower end that is not positive proves nothing") {
  for (const char* text : {"holder = '>= 0'", "holder = '> -1'"})
    CHECK_FALSE(first_answer(std::string("mask = 'mask:[1,0,0,1]'\n") + text).is_yes());
}

TEST_CASE("several schemes, with names, in the order of the file") {
  const auto schemes = read_expectations(
      "[[scheme]]\nname = 'linear'\nmask = 'bspline:degree=1'\nholder = '>= 1'\nconvergent = true\n\n[[scheme]]\nmask "
      "= 'dd:n=2'\ninterpolatory = true\n");
  REQUIRE(schemes.size() == 2);
  CHECK(schemes[0].name == "linear");
  CHECK(schemes[0].expectations[0].property == "holder");
  CHECK(schemes[0].expectations[1].place.line == 5);
  CHECK(schemes[1].name == "dd:n=2");
}

TEST_CASE("bad files are refused with line and column") {
  CHECK(error_of("") == "line 1, column 1: no scheme; expected 'mask' and properties, or tables [[scheme]]");
  CHECK(error_of("mask = 'bspline:degree=1'") == "line 1, column 8: the scheme has no expected property");
  CHECK(
      error_of("mask = 'bspline:degree=1'\nholder = 2") ==
      "line 2, column 10: 'holder' takes \">= X\", \"<= X\", \"> X\", \"< X\" or \"= X\"; 2 alone does not say which: "
      "\">= 2\", \"<= 2\", or \"= 2\" for exactly that number");
  CHECK(error_of("mask = 'bspline:degree=1'\nsmoothness = 1")
            .ends_with("'smoothness' takes \">= K\"; 1 alone does not say which: \">= 1\""));
  CHECK(error_of("mask = 'dd:n=2'\nreproduces = 3.0").ends_with("'reproduces' takes an integer or a comparison"));
  CHECK(error_of("mask = 'bspline:degree=1'\n smothness = '>= 1'")
            .rfind("line 2, column 2: unknown property 'smothness'; expected mask, name, convergent", 0) == 0);
  CHECK(error_of("msk = 'dd:n=2'\nstable = true")
            .ends_with(
                "symmetry, stable, interpolatory, variance, vertices, for, levels, points, recurrence, start, masks, "
                "period, follows; did you mean 'mask'?"));
  CHECK(error_of("[[scheme]]\nscheme = 'dd:n=2'\nstable = true").ends_with("; did you mean 'mask'?"));
  CHECK(error_of("mask = 'dd:n=2'\nC1 = true").ends_with("; did you mean 'smoothness'?"));
  CHECK(error_of("mask = 'dd:n=2'\nstable = true\nstable = false") ==
        "line 3, column 10: not TOML: Error while parsing key-value pair: cannot redefine existing boolean 'stable'");
  CHECK(error_of("mask = 'nothing:n=1'\nstable = true")
            .rfind("line 1, column 8: scheme specification, position 1: 'nothing'", 0) == 0);
  CHECK(error_of("mask = 'dd:n=2'\nstable = true\nstable = true").rfind("line 3", 0) == 0);
  for (const char* text : {"stable = true",
                           "mask = 3\nstable = true",
                           "mask = 'dd:n=2'\nstable = 'yes'",
                           "mask = 'dd:n=2'\nsmoothness = '>= 1/2'",
                           "mask = 'dd:n=2'\nsmoothness = '<= 1'",
                           "mask = 'dd:n=2'\nsmoothness = '>='",
                           "mask = 'dd:n=2'\nholder = '2'",
                           "mask = 'dd:n=2'\nholder = '>= 1e'",
                           "mask = 'dd:n=2'\nsupport = [1]",
                           "mask = 'dd:n=2'\nsupport = [1, 2.5]",
                           "mask = 'dd:n=2'\nsymmetry = 'left'",
                           "mask = 'dd:n=2'\nreproduces = 3.0",
                           "mask = 'dd:n=2'\nname = 3\nstable = true",
                           "scheme = 3",
                           "scheme = []",
                           "scheme = [3]",
                           "x = 1\n[[scheme]]\nmask = 'dd:n=2'\nstable = true",
                           "mask = \"dd:n=2",
                           "mask = 'dd:n=2'\nholder = [[[[",
                           "\xff\xfe",
                           "mask = 'mask:[0]'\nstable = true",
                           "mask = 'mask:[1]'\nstable = true"}) {
    CAPTURE(text);
    CHECK(error_of(text).rfind("line ", 0) == 0);
  }
  // Characters beyond ASCII belong into strings and comments.
  const auto named = properties::read_expectations(
      "name = 'H\xC3\xB6lder \"\\'  # \xC3\xA9 '\nmask = \"dd:n=2\"  # \"\nstable = true");
  CHECK(named.front().name == "H\xC3\xB6lder \"\\");  // as it was written
  CHECK(error_of("name = \"\xC3\xB6 \\\"\" # \xC3\xB6\nm\xC3\xA4sk = 'dd:n=2'") ==
        "line 2, column 2: not TOML: a character beyond ASCII outside of strings and comments");
  CHECK(error_of("name = '\xC3'\nmask = 'dd:n=2'") == "line 1, column 9: not TOML: not UTF-8");
  CHECK(error_of("ff=[ [[[+[[[[[\">\xC3\x9A[[").rfind("line 1", 0) == 0);
  CHECK(error_of(std::string(1'000'001, '#')).rfind("line 1, column 1: at most", 0) == 0);
  CHECK(error_of("a = " + std::string(100'000, '[')).rfind("line ", 0) == 0);
}
