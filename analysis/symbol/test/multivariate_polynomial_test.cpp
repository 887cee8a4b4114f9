#include <subcert/analysis/symbol/polynomials/multivariate_polynomial.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;
using Exponents = MultivariatePolynomial::Exponents;

namespace {

MultivariatePolynomial random_polynomial(Random& random, int variables, long most = 5) {
  std::vector<MultivariatePolynomial::Monomial> terms;
  for (long i = random.integer(0, most); i > 0; --i) {
    Exponents e;
    for (int v = 0; v < variables; ++v) e.push_back(random.integer(-3, 3));
    terms.push_back({random.rational(), e});
  }
  return MultivariatePolynomial(variables, terms);
}

}  // namespace

TEST_CASE("ring laws in two and three variables") {
  Random random;
  for (const auto i : rounds(60)) {
    const int variables = i % 2 ? 2 : 3;
    const auto p = random_polynomial(random, variables), q = random_polynomial(random, variables),
               r = random_polynomial(random, variables);
    CAPTURE(p.to_text(), q.to_text(), r.to_text());
    std::vector<Rational> point;
    for (int v = 0; v < variables; ++v) point.push_back(random.nonzero());
    for (const auto& x : {p + q, p - q, p * q, -p, p.reversed(), p.dilated(2), p.derivative(1), gcd(p, q)})
      CHECK(x.is_canonical());
    CHECK((p + q) * r == p * r + q * r);
    CHECK(p - p == MultivariatePolynomial(variables));
    CHECK((p * q + r)(point) == p(point) * q(point) + r(point));
    CHECK((p * q).derivative(0) == p.derivative(0) * q + p * q.derivative(0));
    CHECK(MultivariatePolynomial::parse(p.to_text(), variables) == p);
    std::vector<Rational> squares, inverses;
    for (const Rational& x : point) squares.push_back(x * x), inverses.push_back(1 / x);
    CHECK(p.dilated(2)(point) == p(squares));
    CHECK(p.reversed()(point) == p(inverses));
    MultivariatePolynomial self = p;
    self += self;
    CHECK(self == p + p);
    self = p;
    self *= self;
    CHECK(self == p * p);
  }
}

TEST_CASE("ring laws in five variables, which have no text") {
  Random random;
  constexpr int variables = 5;
  for (int i = 0; i < 10; ++i) {
    const auto p = random_polynomial(random, variables), q = random_polynomial(random, variables);
    std::vector<Rational> point;
    for (int v = 0; v < variables; ++v) point.push_back(random.nonzero());
    CHECK((p * q + p).is_canonical());
    CHECK((p * q + p)(point) == p(point) * q(point) + p(point));
    CHECK((p * q).derivative(variables - 1) == p.derivative(variables - 1) * q + p * q.derivative(variables - 1));
  }
  CHECK_THROWS_AS(MultivariatePolynomial(variables + 1), Error);
}

TEST_CASE("division and gcd in several variables") {
  Random random;
  for (const auto i : rounds(60)) {
    const int variables = i % 2 ? 2 : 3;
    const auto p = random_polynomial(random, variables);
    auto d = random_polynomial(random, variables);
    if (d.is_zero()) d = MultivariatePolynomial(variables, 2);
    CAPTURE(p.to_text(), d.to_text());
    const auto [quotient, remainder] = p.divided_by(d);
    CHECK(quotient * d + remainder == p);
    CHECK((p * d).exact_quotient(d) == p);
    CHECK(gcd(p * d, d).exact_quotient(d).has_value());
  }
  CHECK_THROWS_AS(MultivariatePolynomial(2).divided_by(MultivariatePolynomial(2)), Error);
}

TEST_CASE("tensor products, cosets and factors") {
  Random random;
  for (const auto i : rounds(40)) {
    const LaurentPolynomial p = random.polynomial(), q = random.polynomial();
    const Rational x = random.nonzero(), y = random.nonzero();
    const auto product = MultivariatePolynomial::tensor_product({p, q});
    CHECK(product({x, y}) == p(x) * q(y));
    MultivariatePolynomial sum(2);
    for (long r = 0; r < 2; ++r)
      for (long s = 0; s < 2; ++s) sum += product.coset(2, {r, s}).dilated(2).shifted({r, s});
    CHECK(sum == product);
    if (product.is_zero()) continue;
    const auto factor = MultivariatePolynomial::in_variable(2, 1, LaurentPolynomial::all_ones(2));
    CHECK((product * factor).multiplicity(factor) == q.multiplicity(LaurentPolynomial::all_ones(2)) + 1);
  }
  CHECK(MultivariatePolynomial::parse("x*y^-2 + 3", 2).coefficient({1, -2}) == 1);
  CHECK(MultivariatePolynomial::parse("x*y^-2 + 3", 2).lowest() == Exponents{0, -2});
  CHECK(MultivariatePolynomial::parse("z", 3).highest() == Exponents{0, 0, 1});
  CHECK(MultivariatePolynomial::parse("1/2*x*y", 2).to_latex() == "\\frac{1}{2} x y");
  CHECK_THROWS_AS(MultivariatePolynomial::parse("z", 2), ParseError);
  CHECK_THROWS_AS(MultivariatePolynomial(6), Error);
  CHECK_THROWS_AS(MultivariatePolynomial(2) + MultivariatePolynomial(3), Error);
}
