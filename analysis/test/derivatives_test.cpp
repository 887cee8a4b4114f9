#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;

namespace {

DerivativeProof derivative(const std::string& scheme, const LatticePoint& orders) {
  return has_derivative(make_linear_scheme(scheme).mask, orders);
}

Truth answer(const std::string& scheme, long order) { return derivative(scheme, {order}).decision.truth; }

}  // namespace

TEST_CASE("derivatives: order 0 is convergence") {
  CHECK(answer("chaikin", 0) == Truth::yes);
  CHECK(answer("mask:[1,1,1,1]/2", 0) == Truth::yes);
  CHECK(answer("mask:[1,1]", 0) == Truth::no);
  CHECK(derivative("loop", {0, 0}).decision.is_yes());
  CHECK(derivative("mask2:[[1,1],[1,1]]", {0, 0}).decision.is_no());
  CHECK(derivative("tensor:(chaikin)x(mask:[1,1])", {0, 0}).decision.is_no());
}

TEST_CASE("derivatives: B-splines of degree d have d - 1") {
  for (int degree = 1; degree <= 7; ++degree)
    for (int order = 0; order <= degree + 2; ++order) {
      CAPTURE(degree, order);
      const Truth wanted = order < degree ? Truth::yes : Truth::no;
      CHECK(answer("bspline:degree=" + std::to_string(degree), order) == wanted);
      CHECK(answer("bspline:degree=" + std::to_string(degree) + ",a=3", order) == wanted);
    }
}

TEST_CASE("derivatives: the exponent decides, and stability where it is the order") {
  CHECK(answer("dd:n=2", 1) == Truth::yes);
  CHECK(derivative("dd:n=2", {2}).decision.reason == "the exponent is at most 2, and the shifts are stable");
  CHECK(answer("dd:n=3", 2) == Truth::yes);  // 2.830
  CHECK(derivative("dd:n=3", {3}).decision.reason == "the exponent is below 3");
  // Norms of 16 levels are above 1, the exponent is above 1.
  CHECK(answer("dual:n=5", 2) == Truth::yes);
  CHECK(answer("dual:n=5", 3) == Truth::no);
}

TEST_CASE("derivatives: by the exponent where 16 levels of norms are too few") {
  CHECK(converges(make_linear_scheme("four-point:w=49/100").mask).truth == Truth::unknown);
  CHECK(answer("four-point:w=49/100", 0) == Truth::yes);
  CHECK(proved_smoothness(make_linear_scheme("four-point:w=1925/10000").mask).order == 0);
  CHECK(derivative("four-point:w=1925/10000", {1}).decision.reason.starts_with("the exponent is 1.00"));
  CHECK(answer("four-point:w=1928/10000", 1) == Truth::no);
}

TEST_CASE("derivatives: too few sum rules, at once, whatever the size") {
  const DerivativeProof large = derivative("primal:n=40,d=3", {4});
  CHECK(large.decision.is_no());
  CHECK(large.decision.reason == "the mask has only 4 sum rules, and its shifts are stable");
}

TEST_CASE("derivatives: shifts that are not stable") {
  // A hat, dilated and summed: the mask without its factor tells.
  CHECK(answer("mask:[1,1,1,1]/2", 1) == Truth::no);
  CHECK(answer("mask:[1,1,1,1]/2", 2) == Truth::no);
  // phi is C^1, as a sum of quadratic B-splines, but the mask has one sum rule.
  const DerivativeProof few = derivative("mask:[1,1,2,2,1,1]/4", {1});
  CHECK(few.decision.truth == Truth::unknown);
  CHECK(few.open_for_good);
  CHECK(few.decision.reason ==
        "the exponent is 2, but the divided differences need 2 sum rules, of which the mask has 1");
  CHECK(answer("mask:[1,1,2,2,1,1]/4", 2) == Truth::no);
}

TEST_CASE("derivatives: tensor products by their factors") {
  const std::string scheme = "tensor:(bspline:degree=3)x(dd:n=2)";
  CHECK(derivative(scheme, {2, 1}).decision.is_yes());
  CHECK(derivative(scheme, {3, 1}).decision.is_no());
  const Decision second = derivative(scheme, {2, 2}).decision;
  CHECK(second.is_no());
  CHECK(second.reason.starts_with("factor 2: "));
  // One factor that is refuted is enough, whatever is open about another.
  CHECK(derivative("tensor:(mask:[1,1,2,2,1,1]/4)x(dd:n=2)", {1, 2}).decision.is_no());
  CHECK(derivative("tensor:(mask:[1,1,2,2,1,1]/4)x(dd:n=2)", {1, 1}).decision.truth == Truth::unknown);
}

TEST_CASE("derivatives: surfaces by the exponent, which refutes none") {
  CHECK(derivative("loop", {1, 1}).decision.is_yes());
  const DerivativeProof open = derivative("loop", {3, 0});
  CHECK(open.decision.truth == Truth::unknown);
  CHECK(open.open_for_good);
}

TEST_CASE("derivatives: the domain") {
  CHECK_THROWS_WITH(derivative("chaikin", {1, 0}), "has_derivative: need 1 orders >= 0, got 1,0");
  CHECK_THROWS_WITH(derivative("loop", {1}), "has_derivative: need 2 orders >= 0, got 1");
  CHECK_THROWS_WITH(derivative("chaikin", {-1}), "has_derivative: need 1 orders >= 0, got -1");
}

TEST_CASE("derivatives: what is required is thrown with its proof") {
  const Mask box = make_linear_scheme("mask:[1,1]").mask.curve();
  try {
    require_derivative("box", box, {0});
    FAIL("a limit that does not exist");
  } catch (const NoLimit& error) {
    CHECK(error.kind() == ErrorKind::domain);
    CHECK(error.proof().decision.is_no());
    CHECK(std::string(error.what()).starts_with("box: no limit function; convergence: no ("));
  }
  CHECK_THROWS_WITH(require_derivative("hat", make_linear_scheme("bspline:degree=1").mask, {1}),
                    "hat: derivative 1 is not continuous; the exponent is at most 1, and the shifts are stable");
  CHECK_NOTHROW(require_derivative("hat", make_linear_scheme("bspline:degree=1").mask, {0}));
  CHECK_NOTHROW(require_derivative("quadratic", make_linear_scheme("chaikin").mask, {1}));
  CHECK_NOTHROW(require_convergence("any", {Truth::yes, ""}));
  try {
    require_derivative("few", make_linear_scheme("mask:[1,1,2,2,1,1]/4").mask, {1});
    FAIL("divided differences that do not converge");
  } catch (const NoLimit& error) {
    CHECK(error.kind() == ErrorKind::undecided);
    CHECK(error.proof().open_for_good);
  }
}

TEST_CASE("derivatives: random masks, never yes where the exponent says no") {
  testing::Random random;
  for ([[maybe_unused]] const auto round : testing::rounds(40)) {
    // (1 + z)^2 times a factor with the value 1/2 at 1.
    std::vector<Rational> rest{random.integer(-2, 6), random.integer(-2, 6), random.integer(-2, 6)};
    const Rational sum = rest[0] + rest[1] + rest[2];
    if (sum == 0) continue;
    for (Rational& c : rest) c /= 2 * sum;
    const LaurentPolynomial symbol = LaurentPolynomial::all_ones(2).pow(2) * LaurentPolynomial(rest, 0);
    CAPTURE(to_text(symbol, 'z'));
    const Mask mask(symbol, 2);
    const HolderRegularity exponent = holder_regularity(mask, 16, {Deadline::in(2)});
    if (exponent.converges.truth == Truth::unknown) continue;
    const Enclosure proved = exponent.proved_exponent();
    for (long order = 0; order <= 3; ++order) {
      const Truth found = has_derivative(mask, {order}).decision.truth;
      if (exponent.converges.is_no()) {
        CHECK(found == Truth::no);
        continue;
      }
      if (found == Truth::yes) CHECK_FALSE((proved.upper && *proved.upper < order));
      if (found == Truth::no) CHECK_FALSE((proved.lower && *proved.lower > order));
    }
  }
}
