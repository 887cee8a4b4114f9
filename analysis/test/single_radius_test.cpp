#include "specimens.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/radii/joint/single_radius.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using subcert::testing::mask_of;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

HolderRegularity regularity_of(const std::string& specification) {
  return holder_regularity(mask_of(specification), 4, {Deadline::in(20)});
}

Mask derived(const std::string& specification) {
  const Mask mask = mask_of(specification);
  return divided_difference_scheme(mask, sum_rules(mask));
}

LaurentPolynomial centred(const Mask& mask) {
  return mask.symbol().shifted(-(mask.symbol().lowest() + mask.symbol().highest()) / 2);
}

/// The symbol of the n-th power of a scheme.
LaurentPolynomial power_symbol(const LaurentPolynomial& b, int arity, int n) {
  LaurentPolynomial result(1);
  for (int k = 0; k < n; ++k) result = b * result.dilated(arity);
  return result;
}

/// (C^n)_{00}.
std::vector<Rational> central_coefficients(const LaurentPolynomial& b, int arity, int n) {
  const RationalMatrix c = central_matrix(b, arity);
  RationalMatrix power = RationalMatrix::identity(c.rows());
  std::vector<Rational> result;
  for (int k = 0; k < n; ++k) {
    power = power * c;
    result.push_back(power(0, 0));
  }
  return result;
}

}  // namespace

TEST_CASE("the largest coefficient is the central one where the symbol is non-negative") {
  Random random;
  for (const auto i : rounds(30)) {
    const int arity = static_cast<int>(random.integer(2, 4));
    std::vector<Rational> coefficients;
    for (long k = random.integer(1, 5); k > 0; --k) coefficients.emplace_back(random.integer(-4, 4));
    const LaurentPolynomial q(coefficients, 0);
    if (q.is_zero() || q(1) == 0) continue;
    const LaurentPolynomial b = q * q.reversed() * LaurentPolynomial(arity / (q(1) * q(1)));
    CAPTURE(b.to_text(), arity);
    const auto centre = central_coefficients(b, arity, 3);
    for (int n = 1; n <= 3; ++n) {
      const LaurentPolynomial power = power_symbol(b, arity, n);
      CHECK(centre[static_cast<std::size_t>(n) - 1] == power.coefficient(0));
      for (const Rational& c : power.coefficients()) CHECK(abs(c) <= power.coefficient(0));
    }
    // Two ways to the joint spectral radius.
    const Mask mask(b.shifted(random.integer(-3, 3)), arity);
    const SingleRadius single = single_spectral_radius(mask);
    REQUIRE(single.applies.is_yes());
    const auto matrices = transition_matrices(mask);
    const Enclosure& radius = single.growth.radius;
    CHECK(*radius.upper - *radius.lower < power(Rational(10), -40));
    const LaurentPolynomial p = characteristic_polynomial(matrices[static_cast<std::size_t>(single.letter)]);
    const Enclosure of_letter = largest_root_modulus(p).largest;
    CHECK(*of_letter.lower <= *radius.upper);
    CHECK(*radius.lower <= *of_letter.upper);
    const JointSpectralRadius joint = joint_spectral_radius(matrices, {Deadline::in(0.2)});
    CHECK(*joint.radius.lower <= *radius.upper);
    CHECK(*radius.lower <= *joint.radius.upper);
  }
}

TEST_CASE("without time the letter still has the radius that it attains") {
  const HolderRegularity spline = holder_regularity(make_scheme("bspline:degree=40").mask.curve(), 2,
                                                    {Deadline::in(0), 1 << 20});
  CHECK(spline.radius.exact.is_yes());
  CHECK(spline.radius.product.radius.contains(2));
}

TEST_CASE("known exponents by one spectral radius") {
  for (int arity = 2; arity <= 4; ++arity)
    for (int degree = 1; degree <= 5; ++degree) {
      const HolderRegularity spline = regularity_of("bspline:degree=" + std::to_string(degree) +
                                                    ",a=" + std::to_string(arity));
      CHECK(spline.radius.method() == JsrMethod::single_spectral_radius);
      CHECK(spline.radius.exact.is_yes());
      CHECK((spline.exponent.is_exact() && *spline.exponent.lower == degree));
      CHECK(spline.logarithm.at_most == 0);
    }

  // [FM13]: 2 and 2.830074998558, for the 6-point scheme and for the dual 4-point scheme.
  const HolderRegularity four = regularity_of("dd:n=2");
  CHECK((four.exponent.is_exact() && *four.exponent.lower == 2));
  CHECK(four.logarithm.at_least == 1);
  CHECK(four.logarithm.at_most == 1);
  CHECK(four.logarithm.derivative == 1);
  for (const char* text : {"dd:n=3", "mask:[-5,-7,35,105,105,35,-7,-5]/128"}) {
    const HolderRegularity six = regularity_of(text);
    CHECK(six.radius.method() == JsrMethod::single_spectral_radius);
    CHECK(to_fixed(*six.exponent.lower, 12, Rounding::nearest) == "2.830074998558");
    CHECK(to_fixed(*six.exponent.upper, 12, Rounding::nearest) == "2.830074998558");
    CHECK(six.logarithm.at_most == 0);
    CHECK(six.logarithm.derivative == 2);
  }

  // The tension scheme: radius 1 + sqrt(1 - 16 w) for two sum rules, 0 <= w <= 1/16.
  for (const char* text : {"1/17", "1/20", "1/32", "1/100", "3/64"}) {
    const HolderRegularity tension = regularity_of(std::string("four-point:w=") + text);
    CAPTURE(text);
    CHECK(tension.radius.method() == JsrMethod::single_spectral_radius);
    CHECK(tension.bounds.sum_rules == 2);
    const Rational square = 1 - 16 * *parse_rational(text), low = *tension.radius.radius.lower - 1,
                   high = *tension.radius.radius.upper - 1;
    CHECK(low * low <= square);
    CHECK(high * high >= square);
    CHECK(tension.logarithm.at_most == 0);
  }
  CHECK(*regularity_of("four-point:w=0").exponent.lower == 1);
  CHECK(*regularity_of("four-point:w=1/16").exponent.lower == 2);
}

TEST_CASE("where one spectral radius is not enough") {
  const auto reason = [](const Mask& mask) {
    const Decision decision = single_spectral_radius(mask).applies;
    CHECK(decision.is_no());
    return decision.reason;
  };
  CHECK(reason(derived("primal:n=3")).find("negative") != std::string::npos);
  CHECK(reason(derived("four-point:w=1/10")).find("negative") != std::string::npos);
  CHECK(reason(Mask(LaurentPolynomial({1, 2, -1}, 0), 2)).find("symmetric") != std::string::npos);
  CHECK(reason(Mask(LaurentPolynomial({Rational(3, 2), Rational(3, 2)}, 0), 3)).find("even") != std::string::npos);
  CHECK_THROWS_AS(central_growth(LaurentPolynomial({1, 2}, 0), 2), Error);
  // Binary symmetric masks of either parity: once all factors are out, the rest has a centre among the integers.
  for (const char* text :
       {"dual:n=1", "dual:n=2", "dual:n=5", "dual-odd:n=2", "primal:n=4", "primal-odd:n=2", "dd:n=4"})
    CHECK(symmetry(derived(text)).kind == Symmetry::odd);
}

TEST_CASE("powers of the logarithm") {
  // The second difference scheme of the 4-point scheme: the eigenvalue 1 in a Jordan block of size 2.
  const Mask mask = mask_of("dd:n=2");
  const LaurentPolynomial second = centred(divided_difference_scheme(mask, 2));
  const CoefficientGrowth growth = central_growth(second, 2);
  CHECK((growth.radius.is_exact() && *growth.radius.lower == 1));
  CHECK(growth.power == 1);
  // ||S_[2]^n|| grows like n: its increments settle.
  const auto centre = central_coefficients(second, 2, 12);
  const Rational last = centre[11] - centre[10], before = centre[10] - centre[9];
  CHECK(last > 0);
  CHECK(abs(last - before) < Rational(1, 100));
  // Interpolatory schemes of higher order have no logarithm.
  for (const char* text : {"dd:n=4", "dd:n=5"}) CHECK(regularity_of(text).logarithm.at_most == 0);
  // The closed polytope of a scheme whose exponent is not an integer says the same.
  const HolderRegularity polytope = regularity_of("dual:n=2");
  CHECK(polytope.radius.method() == JsrMethod::invariant_polytope);
  CHECK(polytope.logarithm.at_most == 0);
  CHECK(polytope.logarithm.derivative == 2);
  const HolderRegularity unstable = regularity_of("mask:[1,2,2,2,1]/4");
  // The quadratic spline again, without a logarithm.
  CHECK(unstable.exponent.is_exact());
  CHECK(unstable.logarithm.at_most == 0);
}
