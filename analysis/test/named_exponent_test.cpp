#include <subcert/analysis/family/named_exponent.hpp>
#include <subcert/analysis/radii/joint/named_radius.hpp>
#include <subcert/analysis/test/matrices.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;
using subcert::testing::square_matrix;

namespace {

/// Of one matrix, whose spectral radius is enclosed by other means.
std::optional<AttainedNumber> named(const RationalMatrix& one, long degree = 10) {
  const ProductEvidence product = prove_product({one}, {0});
  return named_radius(one, 1, product.eigenvalue, product.radius, degree);
}

double modulus(const AttainedNumber& number) {
  return std::pow(number.point.squared_modulus().convert_to<double>(), 0.5 / static_cast<double>(number.length));
}

LaurentPolynomial polynomial(const std::vector<Rational>& coefficients) { return {coefficients, 0}; }

std::optional<NamedExponent> named_exponent_of(const std::string& specification) {
  const Scheme scheme = make_scheme(specification);
  RegularityOptions options;
  options.rounding = scheme.rounding;
  return named_exponent(scheme.mask, regularity_of(scheme.mask, {Deadline::in(60)}, options), scheme.algebraic);
}

}  // namespace

TEST_CASE("named radii: of eigenvalues that are known") {
  const auto golden = named(square_matrix({{1, 1}, {1, 0}}));
  REQUIRE(golden);
  CHECK(golden->polynomial == polynomial({-1, -1, 1}));
  CHECK(golden->point.im == 0);
  CHECK(modulus(*golden) == Approx((1 + std::sqrt(5.0)) / 2));
  // A negative eigenvalue is named by its modulus.
  const auto negative = named(square_matrix({{-1, -1}, {-1, 0}}));
  REQUIRE(negative);
  CHECK(negative->polynomial == golden->polynomial);
  CHECK(negative->point.re > 0);
  const auto both_signs = named(square_matrix({{0, 2}, {1, 0}}));
  REQUIRE(both_signs);
  CHECK(both_signs->polynomial == polynomial({-2, 0, 1}));
  CHECK(both_signs->point.re > 0);
  const auto complex = named(square_matrix({{1, -2}, {2, 1}}));
  REQUIRE(complex);
  CHECK(complex->polynomial == polynomial({5, -2, 1}));
  CHECK(complex->point.im != 0);
  const auto rational = named(square_matrix({{Rational(7, 3), 5}, {0, 1}}));
  REQUIRE(rational);
  CHECK(rational->polynomial == polynomial({-7, 3}));
  CHECK(rational->point == RationalComplex{Rational(7, 3), 0});
  // Large and small ones, which are scaled for the search.
  for (const Rational& factor : {power(Rational(2), 300), power(Rational(10), -90)}) {
    const auto scaled_one = named(factor * square_matrix({{1, 1}, {1, 0}}));
    REQUIRE(scaled_one);
    CHECK(abs(Rational(scaled_one->point.re / factor - golden->point.re)) < power(Rational(10), -30));
  }
}

TEST_CASE("named radii: nothing where the number is not told from others, or of too large a degree") {
  const RationalMatrix two = square_matrix({{2, 0}, {0, 3}});
  CHECK(named_radius(two, 1, {3, 0}, {Rational(5, 2), Rational(7, 2)}, 10));
  CHECK_FALSE(named_radius(two, 1, {3, 0}, {Rational(3, 2), Rational(7, 2)}, 10));
  CHECK_FALSE(named_radius(two, 1, {3, 0}, {Rational(5, 2), Rational(11, 4)}, 10));
  CHECK_FALSE(named_radius(two, 1, {2, 0}, {Rational(5, 2), Rational(7, 2)}, 10));  // another one is near
  CHECK_FALSE(named_radius(two, 1, {3, 0}, {0, 4}, 10));
  CHECK_FALSE(named_radius(two, 1, {3, 0}, Enclosure::at_least(1), 10));
  // 2 and -2 belong to two polynomials.
  CHECK_FALSE(named(square_matrix({{2, 0}, {0, -2}})));
  CHECK_FALSE(named(square_matrix({{1, 1}, {1, 0}}), 1));
  CHECK(named(square_matrix({{1, 1}, {1, 0}}), 2));
}

TEST_CASE("named radii: random matrices") {
  Random random;
  int found = 0;
  for ([[maybe_unused]] const auto round : rounds(60)) {
    const auto size = static_cast<std::size_t>(random.integer(1, 5));
    RationalMatrix one(size, size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) one(i, j) = Rational(random.integer(-4, 4), random.integer(1, 3));
    const ProductEvidence product = prove_product({one}, {0});
    const auto number = named(one);
    if (!number) continue;
    ++found;
    CHECK(modulus(*number) == Approx(product.radius.lower->convert_to<double>()).epsilon(1e-10));
    const RationalComplex value = value_at(number->polynomial, number->point);
    CHECK(value.squared_modulus() < power(Rational(10), -40));
    CHECK(number->polynomial.coefficient(0) != 0);
  }
  CHECK(found > 20);
}

TEST_CASE("named exponents: of masks with algebraic coefficients") {
  struct Known {
    const char* scheme;
    int rules;
    LaurentPolynomial radius;
    std::size_t length;
  };
  for (const Known& known : {Known{"daubechies:n=2", 2, polynomial({-2, -2, 1}), 1},
                             // (1 + sqrt 10 + sqrt(5 + 2 sqrt 10))/2, [Dau88]
                             Known{"daubechies:n=3", 3, polynomial({9, -12, -24, -8, 4}), 1},
                             // The same as where the number is rational
                             Known{"mask:[1+t,3+t,3-t,1-t]/4,where=t^2-3:1..2", 2, polynomial({-2, -2, 1}), 1}}) {
    INFO(known.scheme);
    const auto found = named_exponent_of(known.scheme);
    REQUIRE(found);
    CHECK(found->rules == known.rules);
    CHECK(found->base == 2);
    CHECK(found->radius.polynomial == known.radius);
    CHECK(found->radius.length == known.length);
  }
}

TEST_CASE("named exponents: fields of Daubechies' masks are theirs") {
  for (const auto& [specification, root] :
       {std::pair("daubechies:n=2", std::sqrt(3.0)), std::pair("daubechies:n=3", std::sqrt(5 + 2 * std::sqrt(10.0)))}) {
    const Scheme scheme = make_scheme(specification);
    REQUIRE(scheme.algebraic);
    REQUIRE(scheme.rounding);
    const Mask mask = scheme.mask.curve();
    const ParametricMask& meant = scheme.algebraic->mask;
    // The zero, to the distance by which the mask is rounded, by Newton's method.
    const LaurentPolynomial& p = scheme.algebraic->polynomial;
    Rational t(root);
    for (int step = 0; step < 12; ++step)
      t = to_multiple(t - p(t) / p.derivative()(t), power(Rational(2), -1000), Rounding::nearest);
    const Mask near = meant.at(t);
    REQUIRE(near.symbol().length() == mask.symbol().length());
    for (long k = 0; k < mask.symbol().length(); ++k)
      CHECK(abs(Rational(near.symbol().coefficient(near.symbol().lowest() + k) -
                         mask.symbol().coefficient(mask.symbol().lowest() + k))) <
            scheme.rounding->distance + power(Rational(2), -990));
  }
}

TEST_CASE("named exponents: value and enclosure agree") {
  for (const char* specification :
       {"daubechies:n=2", "daubechies:n=3", "primal:n=2", "dual:n=3", "ary:a=3,points=4,d=1", "mask:[1,2,1,0,1,1]/3",
        "mask:[-1,2,6,6,3]/8", "mask:[1-t,5+t,14+2*t,14-2*t,1-t,-3+t]/16,where=t^2-7:2.6..2.7"}) {
    INFO(specification);
    const Scheme scheme = make_scheme(specification);
    const auto named_one = named_exponent_of(specification);
    if (!named_one) continue;
    RegularityOptions options;
    options.rounding = scheme.rounding;
    const Enclosure exponent = regularity_of(scheme.mask, {Deadline::in(60)}, options).exponent();
    const double value = named_one->rules - static_cast<double>(named_one->dimension) *
                                                std::log(modulus(named_one->radius)) /
                                                std::log(static_cast<double>(named_one->base));
    CHECK(value == Approx(exponent.lower->convert_to<double>()).epsilon(1e-11));
  }
}
