// Families of masks of matrices: which polynomials they keep, ranges, maps and curves.

#include <subcert/analysis/family/box_search.hpp>
#include <subcert/analysis/family/exponent_curve.hpp>
#include <subcert/analysis/family/property_map.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/symbol/masks/polynomial_data.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

using namespace subcert;

namespace {

const Budget budget{Deadline::in(60)};

ParametricMask of_one(const std::string& text) { return make_parametric_scheme(text).mask; }
ParametricMask of_two(const std::string& text, const std::string& first, const std::string& second) {
  const auto [lettered, letters] = in_letters(text, {first, second});
  return make_parametric_mask(lettered, letters);
}

/// Cubic Hermite interpolation that moves the values it has, and keeps linear functions.
constexpr const char* smoothed_cubic =
    "hermite:[[[w,0],[0,0]],[[1/2,-1/8],[3/4,-1/8]],[[1-2*w,0],[0,1/2]],[[1/2,1/8],[-3/4,-1/8]],[[w,0],[0,0]]]@-2";

/// The four-point scheme with w on pairs of neighbours.
std::string pairs_of_four_point() {
  const auto a = [](long k) { return k == 0 ? "1" : std::abs(k) == 1 ? "(1/2+w)" : std::abs(k) == 3 ? "-w" : "0"; };
  std::string text;
  for (long k = -2; k <= 2; ++k)
    text += fmt::format("{}[[{},{}],[{},{}]]", k == -2 ? "" : ",", a(2 * k), a(2 * k - 2), a(2 * k + 1), a(2 * k - 1));
  return "vector:[" + text + "]@-2";
}

/// Bounds of the exponent by the differences of a family at one value.
Enclosure exponent_by_differences(const ParametricMask& mask, const Values& w) {
  const auto found = joint_spectral_radius(difference_matrices(mask).at(w), budget);
  const Rational rules = sum_rules(mask), &lower = *found.radius.lower;
  return {rules - *log_ratio(*found.radius.upper, mask.arity()).upper,
          lower > 0 ? std::optional<Rational>(rules - *log_ratio(lower, mask.arity()).lower) : std::nullopt};
}

std::string message(const std::function<void()>& run) {
  try {
    run();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

PropertyRange range_of(const ParametricMask& mask, const char* property, const Rational& low, const Rational& high,
                       const Rational& width = Rational(1, 1000)) {
  return property_range(mask, *parse_range_property(property), low, high, {width, 1, budget});
}

LatticeMask merrien_mask(const Rational& lambda, const Rational& mu) {
  return make_refinable_scheme(fmt::format("merrien:lambda={},mu={}", lambda, mu)).mask;
}

}  // namespace

TEST_CASE("Merrien's scheme is typed with letters") {
  subcert::testing::Random random;
  const ParametricMask mask = of_two("merrien:lambda,mu", "lambda", "mu");
  const ParametricMask turned = of_two("merrien:mu=2*mu-1,lambda=-lambda", "mu", "lambda");
  for (int round = 0; round < 5; ++round) {
    const Rational lambda(random.integer(-20, 20), 7), mu(random.integer(-20, 20), 9);
    CHECK(mask.lattice_mask_at({lambda, mu}) == merrien_mask(lambda, mu));
    CHECK(turned.lattice_mask_at({mu, lambda}) == merrien_mask(-lambda, 2 * mu - 1));
    CHECK(transposed(transposed(mask)) == mask);
  }
  const ParametricScheme one = make_parametric_scheme("merrien:lambda=-1/8,mu");
  CHECK(one.name == "mu");
  CHECK(one.form == VectorForm::hermite);
  CHECK(make_parametric_scheme(one.specification).mask == one.mask);
  CHECK(one.mask.lattice_mask_at({Rational(2, 3)}) == merrien_mask(Rational(-1, 8), Rational(2, 3)));
  for (const char* bad : {"merrien:lambda=1,mu=2", "merrien:lambda,mu", "merrien:lambda", "merrien:mu=w,mu=w",
                          "merrien:lambda=1,mu=w,nu=1", "merrien:lambda=(w,mu=1", "hermite:[[[w]]]",
                          "hermite:[[[1,w]],[[1,2]]]", "hermite:[[1,w],[1,2]]", "refinable:[[[0*w,0],[0,0]]]"})
    CHECK_THROWS_AS(make_parametric_scheme(bad), SpecificationError);
}

TEST_CASE("Matrices with quotients and a denominator are read and printed") {
  const ParametricScheme scheme = make_parametric_scheme("refinable:[[[1,w],[1/(2+w),0]],[[1,2],[3,4]]]/2@0,arity=3");
  CHECK(make_parametric_scheme(scheme.specification).mask == scheme.mask);
  const LatticeMask at = scheme.mask.lattice_mask_at({Rational(1)});
  CHECK(at == make_refinable_scheme("refinable:[[[3,3],[1,0]],[[3,6],[9,12]]]/6@0,arity=3").mask);
  CHECK(scheme.mask.support() == IndexRange{0, 1});
}

TEST_CASE("Polynomials whose data are kept for all values") {
  const PolynomialData two = kept_polynomials(of_two("merrien:lambda,mu", "lambda", "mu"));
  CHECK(two.data.size() == 2);
  CHECK(two.hermite);
  CHECK(two.interpolating);
  CHECK(sum_rules(of_one("merrien:lambda=-1/8,mu")) == 3);
  CHECK(sum_rules(of_one("merrien:lambda=-1/8,mu=-1/2+0*w")) == 4);
  const PolynomialData moved = kept_polynomials(of_one(smoothed_cubic));
  CHECK(moved.data.size() == 2);
  CHECK(moved.hermite);
  CHECK_FALSE(moved.interpolating);
  const PolynomialData pairs = kept_polynomials(of_one(pairs_of_four_point()));
  REQUIRE(pairs.data.size() == 2);
  CHECK_FALSE(pairs.hermite);
  CHECK(pairs.data[0][0] == pairs.data[0][1]);
  // A vector that depends on the letter, and two.
  CHECK(sum_rules(of_one("vector:[[[1,0],[w,1/2]],[[1,0],[w,1/2]]]")) == 0);
  CHECK(sum_rules(of_one("vector:[[[1,0],[0*w,1]],[[1,0],[0,1]]]")) == 0);
}

TEST_CASE("Differences of a family tell the exponents of its schemes") {
  subcert::testing::Random random;
  const ParametricMask mask = of_two("merrien:lambda,mu", "lambda", "mu");
  int compared = 0;
  for (int round = 0; round < 12; ++round) {
    const Rational lambda(random.integer(-16, 0), 64), mu(random.integer(-190, 60), 64);
    const Enclosure by_differences = exponent_by_differences(mask, {lambda, mu});
    if (*by_differences.lower <= 1) continue;
    const MultivariateRegularity by_values = vector_regularity(merrien_mask(lambda, mu), budget);
    INFO(lambda << " " << mu);
    REQUIRE(by_values.exponent.upper);
    CHECK(*by_differences.lower <= *by_values.exponent.upper);
    CHECK(*by_values.exponent.lower <= *by_differences.upper);
    ++compared;
  }
  CHECK(compared >= 3);
  // The window holds what joins two intervals: splines of degree 3 are C^1 and no more.
  CHECK(exponent_by_differences(of_one("merrien:lambda=-1/8,mu=-1/2+0*w"), {0}).lower == Rational(2));
}

TEST_CASE("Merrien's scheme is HC1 for -3 < mu < 1") {
  const PropertyRange range = range_of(of_one("merrien:lambda=-1/8,mu"), "HC1", -5, 3);
  CHECK(range.complete);
  REQUIRE(range.ends.size() == 2);
  CHECK(range.ends[0].low <= -3);
  CHECK(-3 <= range.ends[0].high);
  CHECK(range.ends[1].low <= 1);
  CHECK(1 <= range.ends[1].high);
  CHECK(range.ends[0].holds == Truth::no);
  CHECK(range.pieces.front().holds == Truth::no);
  CHECK(range.pieces[2].holds == Truth::yes);
  // An exponent beside that: 2 - log2|1 + mu| >= 3/2 for |1 + mu| <= sqrt 2; open where HC1 fails.
  const PropertyRange holder = range_of(of_one("merrien:lambda=-1/8,mu"), "holder>=3/2", -4, 0);
  CHECK(holder.pieces.front().holds == Truth::unknown);
  CHECK(holder.pieces.front().high >= -3);
  CHECK(holder.pieces.front().high < Rational(-29, 10));
  CHECK(holder.pieces[1].holds == Truth::no);
  CHECK(holder.pieces.back().holds == Truth::yes);
}

TEST_CASE("Convergence of vectors is decided as that of the numbers they are made of") {
  const PropertyRange pairs = range_of(of_one(pairs_of_four_point()), "convergent", -1, 1),
                      numbers = range_of(of_one("four-point:w"), "convergent", -1, 1);
  CHECK(pairs.sum_rules == numbers.sum_rules);
  for (const RangePiece& piece : pairs.pieces)
    for (const RangePiece& other : numbers.pieces)
      if (std::max(piece.low, other.low) < std::min(piece.high, other.high) && piece.holds != Truth::unknown &&
          other.holds != Truth::unknown)
        CHECK(piece.holds == other.holds);
  CHECK(pairs.complete);
  // Their smoothness is proved, and not refuted.
  const PropertyRange smooth = range_of(of_one(pairs_of_four_point()), "C1", Rational(1, 100), Rational(1, 10));
  CHECK(smooth.pieces.size() == 1);
  CHECK(smooth.pieces.front().holds == Truth::yes);
  CHECK(range_of(of_one(pairs_of_four_point()), "C1", Rational(1, 4), 1).pieces.front().holds == Truth::unknown);
}

TEST_CASE("Hermite schemes that move their values are proved, and not refuted") {
  const PropertyRange near = range_of(of_one(smoothed_cubic), "HC1", Rational(-1, 100), Rational(1, 100));
  CHECK(near.pieces.size() == 1);
  CHECK(near.pieces.front().holds == Truth::yes);
  const PropertyRange far = range_of(of_one(smoothed_cubic), "HC1", 5, 6);
  CHECK(far.pieces.front().holds == Truth::unknown);
  CHECK_THAT(far.pieces.front().reason, Catch::Contains("only of schemes that interpolate"));
  CHECK(range_of(of_one(smoothed_cubic), "convergent", 5, 6).pieces.front().holds == Truth::no);
  // What is proved beside that is found from the middle of what is not.
  const PropertyRange wide = range_of(of_one(smoothed_cubic), "HC1", Rational(-1, 10), Rational(9, 10), 1);
  CHECK(std::ranges::any_of(wide.pieces, [](const RangePiece& piece) { return piece.holds == Truth::yes; }));
  // Nor where HC1 is proved.
  for (const RangePiece& piece : range_of(of_one(smoothed_cubic), "holder>=19/10", -1, 1, 1).pieces)
    CHECK(piece.holds != Truth::no);
}

TEST_CASE("A map of Merrien's scheme agrees with single values") {
  subcert::testing::Random random;
  const ParametricMask mask = of_two("merrien:lambda,mu", "lambda", "mu");
  const Box box{{Rational(-1, 4), -3}, {0, 1}};
  const PropertyMap map = property_map(mask, *parse_range_property("HC1"), box, {8, 1, budget});
  CHECK(map.sum_rules == 2);
  CHECK(map.share(Truth::yes) > Rational(1, 4));
  CHECK(map.share(Truth::no) > Rational(1, 20));
  for (const MapCell& cell : map.cells) {
    if (cell.holds == Truth::unknown || random.integer(0, 3) > 0) continue;
    Values w;
    for (std::size_t v = 0; v < 2; ++v)
      w.push_back(cell.box.low[v] + cell.box.width(v) * Rational(random.integer(0, 8), 8));
    const auto exponent = vector_regularity(merrien_mask(w[0], w[1]), budget).exponent;
    INFO(w[0] << " " << w[1]);
    if (cell.holds == Truth::yes) CHECK((exponent.upper && *exponent.upper > 1));
    if (cell.holds == Truth::no) CHECK(*exponent_by_differences(mask, w).upper <= 1);
  }
}

TEST_CASE("The curve of Merrien's scheme encloses its exponent") {
  const ExponentCurve curve = exponent_curve(of_one("merrien:lambda=-1/8,mu"), -4, 2, {48, 1, budget});
  CHECK(curve.sum_rules == 3);
  for (const CurvePiece& piece : curve.pieces) {
    const double mu = Rational((piece.proof.low + piece.proof.high) / 2).convert_to<double>();
    const double exponent = 2 - std::max(0.0, std::log2(std::abs(1 + mu)));
    REQUIRE(piece.exponent.lower);
    CHECK(piece.exponent.lower->convert_to<double>() <= exponent + 1e-9);
    if (piece.exponent.upper) CHECK(piece.exponent.upper->convert_to<double>() >= exponent - 1e-9);
    if (piece.proof.low >= -2 && piece.proof.high <= 0) CHECK(piece.exponent.upper);
    if (piece.proof.high <= -3 || piece.proof.low >= 1) CHECK_FALSE(piece.exponent.upper);
  }
}

TEST_CASE("What cannot be asked of families of matrices is said in one line") {
  const ParametricMask merrien = of_one("merrien:lambda=-1/8,mu");
  const auto told = [](const ParametricMask& mask, const char* property) {
    return message([&] { range_of(mask, property, 0, 1); });
  };
  using Catch::Contains;
  for (const char* property : {"stable", "sobolev>=1", "positive"})
    CHECK_THAT(told(merrien, property), Contains("for a mask of matrices"));
  CHECK_THAT(told(merrien, "HC3"), Contains("below the number 3 of sum rules"));
  CHECK_THAT(told(merrien, "HC0"), Contains("need HC1 or more"));
  CHECK_THAT(told(of_one("four-point:w"), "HC1"), Contains("got a mask of numbers"));
  CHECK_THAT(told(of_one(pairs_of_four_point()), "HC1"), Contains("transposed"));
  CHECK_THAT(told(of_one("hermite:[[[1/2,1/2-w/2],[-1/8,w/4]],[[1,0],[0,1/2]],[[1/2,w/2-1/2],[1/8,w/4]]]@-1"), "HC1"),
             Contains("transposed"));
  CHECK_THAT(told(of_one("vector:[[[1,0],[w,1/2]],[[1,0],[w,1/2]]]"), "convergent"), Contains("need a vector"));
}
