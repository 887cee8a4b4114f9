#include "first_answer.hpp"

#include <subcert/proofs-checks/properties/mask_list_file.hpp>

#include <subcert/cmake/catch.hpp>

using namespace subcert;
using namespace subcert::properties;
using namespace subcert::properties::testing;

namespace {

const std::string slider = "mask = 'four-point:w'\n", conic_scheme = "mask = 'conic-four-point:v'\n",
                  halving = "recurrence = 'v=sqrt((1+v)/2)'\n",
                  masks_of_two = "masks = ['dd:n=2', 'bspline:degree=3']\n";

}  // namespace

TEST_CASE("properties of every sequence of values") {
  check_all(slider,
            {"levels = '0.001 <= w <= 0.19'\nsmoothness = '>= 1'", "levels = '0 <= w <= 1/8'\nconvergent = true",
             "levels = '1/32 <= w <= 1/8'\nholder = '>= 6/5'", "levels = '0 <= w <= 1/8'\nsmoothness = '>= 0'"});
  const Decision refuted = first_answer(slider + "levels = '0 <= w <= 0.1'\nsmoothness = '>= 1'");
  CHECK(refuted.is_no());
  CHECK(refuted.reason == "not for w = 0 at all levels");
  const Decision open = first_answer("mask = 'six-point:w'\nlevels = '0.013 <= w <= 0.016'\nsmoothness = '>= 3'");
  CHECK(open.truth == Truth::unknown);
  CHECK_FALSE(open.reason.empty());
}

TEST_CASE("properties of values that follow each other") {
  const auto answer = [&](const std::string& rest) {
    return first_answer(conic_scheme + "levels = '9/20 <= v <= 1000'\n" + rest);
  };
  CHECK(answer(halving + "start = '1/4 <= v0 <= 1000'\nsmoothness = '>= 1'").is_yes());
  CHECK(answer(halving + "start = 'v0 = 1/2'\nholder = '>= 2'").is_yes());
  // Not of all sequences in the range, and no lower one is known to fail for all of these.
  CHECK(answer(halving + "start = 'v0 = 1/2'\nsmoothness = '>= 2'").truth == Truth::unknown);
  CHECK(answer(halving + "start = '-1/2 <= v0 <= 1'\nsmoothness = '>= 1'").reason.find("no mask") != std::string::npos);
  CHECK(answer("recurrence = 'v=v/2'\nstart = 'v0=1'\nsmoothness = '>= 1'").reason.find("lead into the range") !=
        std::string::npos);
}

TEST_CASE("properties of lists of masks") {
  CHECK(first_answer(masks_of_two + "period = [0, 1]\nholder = '>= 2.4999'").is_yes());
  CHECK(first_answer(masks_of_two + "period = [0, 1]\nsmoothness = '>= 2'").is_yes());
  CHECK(first_answer(masks_of_two + "holder = '>= 5/2'").is_no());
  CHECK(first_answer(masks_of_two + "convergent = true").is_yes());
  CHECK(
      first_answer(
          "masks = ['four-point:w=1/4', 'four-point:w=1/16']\nfollows = [[0, 1], [1, 0], [1, 1]]\nholder = '>= 0.997'")
          .is_yes());
  const auto schemes = read_expectations(masks_of_two + "period = [0, 1]\nholder = '>= 2'");
  CHECK(schemes.at(0).name == "dd:n=2, bspline:degree=3 in a period");
  CHECK(schemes.at(0).expectations.size() == 1);
}

TEST_CASE("properties of a value for each new point") {
  check_all(slider,
            {"points = '0.001 <= w <= 0.15'\nsmoothness = '>= 1'", "points = '0 <= w <= 1/8'\nconvergent = true",
             "points = '0.001 <= w <= 0.15'\nholder = '>= 1.0058'", "points = '0 <= w <= 1/8'\nsmoothness = '>= 0'"});
  const Decision refuted = first_answer(slider + "points = '0.001 <= w <= 0.15'\nholder = '>= 1.0059'");
  CHECK(refuted.is_no());
  CHECK(refuted.reason == "the exponents are at least 1.0058057, of some limits at most 1.0058058");
  // C1 with one value for each level, and with one for each point open.
  const std::string values = " = '1/100 <= w <= 17/100'\nsmoothness = '>= 1'";
  CHECK(first_answer(slider + "levels" + values).is_yes());
  CHECK(first_answer(slider + "points" + values).truth == Truth::unknown);
  const Decision diverges = first_answer(
      "mask = 'mask:[-1/2+7/5*w,1/10+7/5*w,3/2-7/5*w,9/10-7/5*w]'\npoints = '0 <= w <= 1'\nconvergent = true");
  CHECK(diverges.truth == Truth::unknown);
  CHECK(diverges.reason.starts_with("no convergence is proved for all choices of values"));
  const auto schemes = read_expectations(slider + "points = '0 <= w <= 1/8'\nholder = '>= 1'");
  CHECK(schemes.at(0).name == "four-point:w");
  CHECK(schemes.at(0).lines == "mask = \"four-point:w\"\npoints = \"0 <= w <= 1/8\"\n");
}

TEST_CASE("properties of levels: what is refused") {
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {slider + "levels = '0 < w <= 1'\nconvergent = true", "'levels' takes \"LOW <= w <= HIGH\""},
           {slider + "levels = 3\nconvergent = true", "'levels' takes"},
           {slider + "levels = '0 <= w <= 1'\nfor = '0 <= w <= 1'\nconvergent = true", "beside 'for'"},
           {slider + "points = '0 <= w < 1'\nconvergent = true", "'points' takes \"LOW <= w <= HIGH\""},
           {slider + "points = '1 <= w <= 1'\nconvergent = true", "'points' takes \"LOW <= w <= HIGH\""},
           {slider + "points = '0 <= v <= 1'\nconvergent = true", "'points' takes \"LOW <= w <= HIGH\""},
           {slider + "points = true\nconvergent = true", "'points' takes"},
           {slider + "points = '0 <= w <= 1'\nfor = '0 <= w <= 1'\nconvergent = true", "'points' beside 'for'"},
           {slider + "points = '0 <= w <= 1'\nlevels = '0 <= w <= 1'\nconvergent = true", "'points' beside 'levels'"},
           {slider + "points = '0 <= w <= 1'\nstart = 'w0=1'\nconvergent = true", "'start' needs 'levels'"},
           {slider + "points = '0 <= w <= 1'\nsum_rules = 2", "no property of masks that change from point to point"},
           {slider + "points = '0 <= w <= 1'\nholder = '= 2'", "over points takes \">= X\""},
           {slider + "points = '0 <= w <= 1'", "the scheme has no expected property"},
           {masks_of_two + "points = '0 <= w <= 1'\nconvergent = true", "'masks' stands without"},
           {"mask = 'dd:n=2'\npoints = '0 <= w <= 1'\nconvergent = true", "parameter"},
           {"mask = 'merrien:lambda=-1/8,mu'\npoints = '0 <= mu <= 1'\nconvergent = true", "masks of numbers"},
           {slider + "levels = '0 <= w <= 1'\nstable = true", "is no property of masks that change"},
           {slider + "levels = '0 <= w <= 1'\nsum_rules = 2", "is no property of masks that change"},
           {slider + "levels = '0 <= w <= 1'\nconvergent = false", "over levels takes true"},
           {slider + "levels = '0 <= w <= 1'\nholder = '< 2'", "over levels takes \">= X\""},
           {slider + "levels = '0 <= w <= 1'\nstart = 'w0=1'\nconvergent = true", "expected both"},
           {slider + "levels = '0 <= w <= 1'\nstart = 'w=1'\nrecurrence='w=w'\nconvergent = true", "'start' takes"},
           {slider + "levels = '0 <= w <= 1'\nstart = 'w0=1'\nrecurrence='w'\nconvergent = true", "'recurrence' takes"},
           {slider + "start = 'w0=1'\nconvergent = true", "'start' needs 'levels'"},
           {slider + "period = [0]\nconvergent = true", "'period' needs 'masks'"},
           {masks_of_two + slider + "convergent = true", "'masks' stands without"},
           {masks_of_two + "period = [2]\nconvergent = true", "expected the number of a mask, 0 to 1"},
           {masks_of_two + "period = [-1]\nconvergent = true", "expected the number of a mask, 0 to 1"},
           {masks_of_two + "period = ['0']\nconvergent = true", "expected the number of a mask, 0 to 1"},
           {masks_of_two + "period = 0\nconvergent = true", "'period' takes a list of 1 to 6 numbers of masks"},
           {masks_of_two + "period = []\nconvergent = true", "'period' takes a list of 1 to 6 numbers of masks"},
           {masks_of_two + "period = [0,0,0,0,0,0,0]\nconvergent = true", "'period' takes a list of 1 to 6"},
           {masks_of_two + "follows = [0]\nconvergent = true", "numbers in each pair [BEFORE, AFTER]"},
           {masks_of_two + "follows = [[0]]\nconvergent = true", "numbers in each pair [BEFORE, AFTER]"},
           {masks_of_two + "follows = [[0, 1]]\nconvergent = true", "no sequence of masks goes on for ever"},
           {masks_of_two + "follows = [[0, 0]]\nperiod = [0]\nconvergent = true", "'follows' beside 'period'"},
           {"masks = 'dd:n=2'\nconvergent = true", "'masks' takes a list of 1 to 64 specifications of schemes"},
           {"masks = []\nconvergent = true", "'masks' takes a list of 1 to 64 specifications of schemes"},
           {"masks = [2]\nconvergent = true", "'masks' takes specifications of schemes in quotes"},
           {"masks = ['loop']\nconvergent = true", "expected a linear scheme of one variable"},
           {"masks = ['daubechies:n=5']\nconvergent = true", "expected a scheme with exact coefficients"},
           {"masks = ['dd:n=2', 'ary:a=3,points=4,d=1']\nconvergent = true", "expected masks of one arity"},
           {masks_of_two, "the scheme has no expected property"},
           {masks_of_two + "interpolatory = true", "is no property of masks that change"},
           {slider + "levels = '0 <= w <= 1'\nHC = '>= 1'", "'HC' is a property of Hermite schemes, got others"},
           {slider + "points = '0 <= w <= 1'\nHC = '>= 1'", "'HC' is a property of Hermite schemes, got others"},
           {slider + "for = '0 <= w <= 1'\nHC = '>= 1'", "'HC' is a property of Hermite schemes, got others"},
           {masks_of_two + "HC = '>= 1'", "'HC' is a property of Hermite schemes, got others"},
           {"masks = ['ghm']\nHC = '>= 1'", "'HC' is a property of Hermite schemes, got others"},
           {"masks = ['hermite-dd:points=2,order=3']\nHC = '>= 1'", "need HC2 or more, as there are 2 derivatives"},
           {"masks = ['hermite-dd:points=2,order=2']\nHC = '= 1'", "'HC' takes \">= K\""},
           {"mask = 'merrien:lambda=-1/8,mu'\nlevels = '0 <= mu <= 1'\nHC = true", "'HC' takes \">= K\""}}) {
    CAPTURE(text);
    CHECK(error_of(text).find(message) != std::string::npos);
  }
}

TEST_CASE("lists of masks: matrices") {
  const std::string masks = "masks = ['merrien:lambda=-1/8,mu=3/2', 'merrien:lambda=-1/8,mu=-1/2']\n";
  const auto holds_of = [&](const std::string& rest) {
    const ExpectedScheme scheme = read_expectations(masks + rest).front();
    return has_property(scheme, scheme.expectations.front(), {60}).truth;
  };
  CHECK(holds_of("convergent = true") == Truth::yes);
  CHECK(holds_of("smoothness = '>= 1'") == Truth::no);
  CHECK(holds_of("follows = [[0, 1], [1, 0]]\nsmoothness = '>= 1'") == Truth::yes);
  CHECK(holds_of("period = [0, 1]\nholder = '>= 1.9'") == Truth::no);
  CHECK(holds_of("follows = [[0, 1], [1, 0], [1, 1]]\nHC = '>= 1'") == Truth::yes);
  CHECK(holds_of("follows = [[0, 1], [1, 0], [1, 1]]\nHC = '>= 2'") == Truth::no);
  CHECK(holds_of("period = [1, 0]\nHC = '>= 1'") == Truth::yes);
  CHECK(holds_of("HC = '>= 1'") == Truth::no);
  MaskListFile file = read_mask_list(masks);
  CHECK(file.list.hermite);
  CHECK_THROWS_WITH(add_mask(file, "ghm"), Catch::Contains("expected Hermite schemes alone or none"));
  CHECK_THROWS_WITH(add_mask(file, "dd:n=2"), Catch::Contains("expected matrices of one size"));
  CHECK_THROWS_WITH(add_mask(file, "refinable:[[[[1,0],[0,1]]]]"), Catch::Contains("expected masks of one variable"));
}

TEST_CASE("levels of masks of matrices: values of a letter") {
  const std::string merrien = "mask = 'merrien:lambda=-1/8,mu'\n", some = "levels = '-3/4 <= mu <= 1/2'\n";
  check_all(merrien + some, {"HC = '>= 1'", "convergent = true", "holder = '>= 7/5'",
                             "recurrence = 'mu=mu/2'\nstart = 'mu0=1/2'\nHC = '>= 1'"});
  check_all(merrien, {"for = '-3/4 <= mu <= 1/2'\nHC = '>= 1'"});
  const Decision refuted = first_answer(merrien + "levels = '-3/4 <= mu <= 3/2'\nHC = '>= 1'");
  CHECK(refuted.is_no());
  CHECK(refuted.reason == "not for mu = 1.5 at all levels");
  CHECK(first_answer(merrien + some + "HC = '>= 2'").truth != Truth::yes);
}

TEST_CASE("lists of masks: keys of a file of its own") {
  const MaskListFile file = read_mask_list(masks_of_two + "period = [1, 0]\n");
  CHECK(file.specifications == std::vector<std::string>{"dd:n=2", "bspline:degree=3"});
  CHECK(file.list.period == std::vector<std::size_t>{1, 0});
  CHECK(read_mask_list(masks_of_two + "follows = [[1, 1], [0, 1]]\n").list.follows.size() == 2);
  CHECK_THROWS_WITH(read_mask_list(masks_of_two + "order = 1\n"), Catch::Contains("unknown key 'order'"));
  CHECK_THROWS_WITH(read_mask_list("period = [0]\n"), Catch::Contains("no masks"));
}
