#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/polynomials/sum_of_squares.hpp>
#include <subcert/cmake/catch.hpp>

using namespace subcert;

TEST_CASE("sums of squares prove that a polynomial is not negative on the unit circle") {
  const LaurentPolynomial one(1), cosine({1, 0, 1}, -1);  // 2 cos t
  for (const LaurentPolynomial& p :
       {one, LaurentPolynomial(4) - cosine, LaurentPolynomial(Rational(7, 3)) + cosine,
        // zeros at 1, -1, twice at i and at the third roots of unity, and with multiplicity 4
        LaurentPolynomial(2) - cosine, LaurentPolynomial(2) + cosine, cosine * cosine,
        (cosine + one) * (cosine + one) * (LaurentPolynomial(3) + cosine), (cosine * cosine).pow(2),
        // zeros at no roots of unity, and nearly a zero
        (LaurentPolynomial(Rational(5, 4)) - cosine * cosine).pow(2),
        LaurentPolynomial(2 + power(Rational(10), -12)) - cosine, (LaurentPolynomial(3) - cosine).pow(40)}) {
    CAPTURE(p.to_text());
    CHECK(is_nonnegative_on_unit_circle(p));
    const auto squares = sum_of_squares(p);
    REQUIRE(squares);
    CHECK(squares->proves(p));
    CHECK_FALSE(squares->proves(p - LaurentPolynomial(2 * abs(p(1)) + abs(p(-1)) + 1)));
  }
}

TEST_CASE("what is negative somewhere has no such proof") {
  const LaurentPolynomial cosine({1, 0, 1}, -1);
  for (const LaurentPolynomial& p : {cosine, LaurentPolynomial(-1), LaurentPolynomial(1) - cosine,
                                     LaurentPolynomial(2 - power(Rational(10), -12)) - cosine}) {
    CAPTURE(p.to_text());
    const auto squares = sum_of_squares(p);
    CHECK((!squares || !squares->proves(p)));
  }
}
