#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;

TEST_CASE("l1 specifications are read and printed back in canonical form") {
  const auto canonical = [](const char* text) {
    std::string once = make_l1_scheme(text).specification;
    CHECK(make_l1_scheme(once).specification == once);
    return once;
  };
  CHECK(canonical("l1:points=6") == "l1:points=6,d=1,iterations=6,delta=1e-8");
  CHECK(canonical("l1:points=6,d=1,iterations=6,delta=1e-8") == "l1:points=6,d=1,iterations=6,delta=1e-8");
  CHECK(canonical("l1:delta=0.0025,points=7x6,d=0") == "l1:points=7x6,d=0,iterations=6,delta=1/400");
  CHECK(canonical("l1:points=8,delta=1/3,residuals=joint") == "l1:points=8,d=1,iterations=6,delta=1/3,residuals=joint");
  CHECK(canonical("l1:points=8,iterations=0,tolerance=0.0010,residuals=separate,delta=2") ==
        "l1:points=8,d=1,iterations=0,delta=2,tolerance=1e-3");
  CHECK(canonical("l1:exact,points=6") == "l1:points=6,d=1,exact");
  CHECK(canonical("l1:points=7,exact,d=3") == "l1:points=7,d=3,exact");
  CHECK(canonical("l1:a=3,points=6") == "l1:points=6,d=1,a=3,iterations=6,delta=1e-8");
  CHECK(canonical("l1:points=6,a=2") == "l1:points=6,d=1,iterations=6,delta=1e-8");
  CHECK(canonical("l1:exact,points=6,a=4") == "l1:points=6,d=1,a=4,exact");
  CHECK(canonical("l1:points=6x7,a=16") == "l1:points=6x7,d=1,a=16,iterations=6,delta=1e-8");
  CHECK(make_l1_scheme("l1:points=6,a=3").rules.arity == 3);
  CHECK(make_l1_scheme("l1:points=6").rules.arity == 2);
  CHECK(make_l1_scheme("l1:points=6,exact").rules.options.exact);
  CHECK(canonical("l1:points=6,iterations=auto") == "l1:points=6,d=1,iterations=24,delta=1e-8");
  CHECK(canonical("l1:points=8,remainder=1/50000,iterations=auto") == "l1:points=8,d=1,iterations=10,delta=1e-8");
  CHECK_THAT(make_l1_scheme("l1:points=6,iterations=auto").choice,
             Catch::Matchers::Contains("24 fits leave at most 1e-6"));
  const L1Scheme scheme = make_l1_scheme("l1:points=4x5,d=2,iterations=3,delta=0.25e-3").rules;
  CHECK(scheme.points == std::vector<int>{4, 5});
  CHECK(scheme.degree == 2);
  CHECK(scheme.options.iterations == 3);
  CHECK(scheme.options.delta == 0.25e-3);
  CHECK(is_l1_specification("l1:points=6"));
  CHECK_FALSE(is_l1_specification("l12:points=6"));
}

TEST_CASE("bad l1 specifications name the token, its position and what would be right") {
  const auto message = [](const char* text) {
    try {
      make_l1_scheme(text);
    } catch (const SpecificationError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto contains = [](const std::string& part) { return Catch::Matchers::Contains(part); };
  CHECK_THAT(message("l1"), contains("position 1: 'l1'; expected l1:points=6,d=1,iterations=6,delta=1e-8"));
  CHECK_THAT(message("l1:d=1"), contains("expected the key 'points'"));
  CHECK_THAT(message("l1:points=1"), contains("position 11: '1'; expected points as an integer from 2 to 64"));
  CHECK_THAT(message("l1:points=6x17"), contains("position 13: '17'; expected points as an integer from 2 to 16"));
  CHECK_THAT(message("l1:points=6x6x6x6"), contains("of a grid, as 6x6, or of a volume, as 4x4x4"));
  CHECK_THAT(message("l1:points=4x9x4"), contains("position 13: '9'; expected points as an integer from 2 to 8"));
  CHECK_THAT(message("l1:points=6,d=4"), contains("position 15: '4'; expected d as an integer from 0 to 3"));
  CHECK_THAT(message("l1:points=6,a=1"), contains("position 15: '1'; expected a as an integer from 2 to 16"));
  CHECK_THAT(message("l1:points=6,a=17"), contains("expected a as an integer from 2 to 16"));
  CHECK_THAT(message("l1:points=6,a=3/2"), contains("expected a as an integer from 2 to 16"));
  CHECK_THAT(message("l1:points=2,d=2"), contains("expected d as an integer from 0 to 1"));
  CHECK_THAT(message("l1:points=6,delta=0"), contains("position 19: '0'; expected delta from 1e-300 to 1e300"));
  CHECK_THAT(message("l1:points=6,delta=-1e-8"), contains("expected delta from 1e-300"));
  CHECK_THAT(message("l1:points=6,delta=1e-8x"), contains("expected delta from 1e-300"));
  CHECK_THAT(message("l1:points=6,tolerance=1e-301"), contains("expected tolerance 0 or from 1e-300"));
  CHECK_THAT(message("l1:points=6,iterations=-1"), contains("iterations as an integer from 0 to 1000000"));
  CHECK_THAT(message("l1:points=6,residuals=vector"), contains("residuals=separate or residuals=joint"));
  CHECK_THAT(message("l1:points=6,exact,iterations=6"),
             contains("position 19: 'iterations=6'; expected points, d and a alone beside 'exact'"));
  CHECK_THAT(message("l1:delta=1e-8,exact,points=6"), contains("position 4: 'delta=1e-8'"));
  CHECK_THAT(message("l1:points=6,exact,exact"), contains("position 19: 'exact'; expected each key once"));
  CHECK_THAT(message("l1:points=6x6,exact"), contains("points of a curve, as 6, beside 'exact'"));
  CHECK_THAT(message("l1:points=4,iterations=auto"), contains("more points: no number of fits"));
  CHECK_THAT(message("l1:points=6x6,iterations=auto"), contains("auto is for curves"));
  CHECK_THAT(message("l1:points=6,remainder=1e-3"), contains("remainder beside iterations=auto alone"));
  CHECK_THAT(message("l1:points=6,iterations=auto,remainder=0"), contains("remainder from 1e-300"));
  CHECK_THAT(message("l1:points=6,n=3"), contains("position 13: 'n'; expected a key of"));
}
