#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

Mask read_mask(const char* text, int arity = 2) { return {LaurentPolynomial::parse_mask(text), arity}; }

const std::vector<Mask> binary{read_mask("[1,3,3,1]/4@-2"),
                               read_mask("[1,2,1]/2@-1"),
                               read_mask("[-1,0,9,16,9,0,-1]/16@-3"),
                               read_mask("[1,4,6,4,1]/8@-2"),
                               read_mask("[7,13,9,11,11,9,13,7]/40@-4"),
                               read_mask("[1,1]@0")};

}  // namespace

TEST_CASE("tensor products have the smaller of the degrees, the factors their multiplicities") {
  for (const Mask& a : binary)
    for (const Mask& b : binary) {
      const PolynomialReproduction p = polynomial_reproduction(tensor_product({a, b}).without_factors());
      const PolynomialReproduction pa = polynomial_reproduction(a), pb = polynomial_reproduction(b);
      CHECK(p.sum_rules == std::min(sum_rules(a), sum_rules(b)));
      CHECK(p.generation_degree() == std::min(pa.generation_degree(), pb.generation_degree()));
      CHECK(p.reproduction_degree == std::min(pa.reproduction_degree, pb.reproduction_degree));
      CHECK(p.factors == std::vector<int>{sum_rules(a), sum_rules(b)});
      CHECK(p.parametrization == std::vector<Rational>{pa.parametrization.front(), pb.parametrization.front()});
      const PolynomialReproduction by_factors = polynomial_reproduction(tensor_product({a, b}));
      CHECK(by_factors.sum_rules == p.sum_rules);
      CHECK(by_factors.factors == p.factors);
      CHECK(by_factors.reproduction_degree == p.reproduction_degree);
      CHECK(by_factors.parametrization == p.parametrization);
    }
  const PolynomialReproduction cube = polynomial_reproduction(tensor_product({binary[2], binary[3], binary[4]}));
  CHECK(cube.sum_rules == 3);
  CHECK(cube.reproduction_degree == 1);
  const auto box = limit_support(tensor_product({binary[0], binary[2]}));
  CHECK(box[0].lower == -2);
  CHECK(box[1].upper == 3);
}

TEST_CASE("the degrees mean what they say") {
  // One step on the values of a monomial, against the monomial at the new parameters.
  Random random;
  for (const auto round : rounds(10)) {
    const Mask& a = binary[static_cast<std::size_t>(random.integer(0, 4))];
    const Mask& b = binary[static_cast<std::size_t>(random.integer(0, 4))];
    // Mixed with another scheme, so that the symbol is no product.
    const MultivariatePolynomial mixed = tensor_product({a, b}).symbol() + tensor_product({b, a}).symbol();
    const LatticeMask mask(mixed * MultivariatePolynomial(2, Rational(1, 2)), 2);
    const PolynomialReproduction p = polynomial_reproduction(mask);
    bool all = true;
    for (long degree = 0; degree <= p.reproduction_degree + 1; ++degree)
      for (long ex = 0; ex <= degree; ++ex)
        for (long i = 0; i < 2; ++i)
          for (long j = 0; j < 2; ++j) {
            const auto monomial = [&](const Rational& x, const Rational& y) {
              Rational product = 1;
              for (long k = 0; k < ex; ++k) product *= x;
              for (long k = ex; k < degree; ++k) product *= y;
              return product;
            };
            Rational value = 0;
            for (const auto& term : mask.symbol().terms()) {
              const long n = term.exponents[0], m = term.exponents[1];
              if ((n - i) % 2 != 0 || (m - j) % 2 != 0) continue;
              value += term.coefficient *
                       monomial(Rational(i - n) / 2 + p.parametrization[0], Rational(j - m) / 2 + p.parametrization[1]);
            }
            const bool right = value == monomial((i + p.parametrization[0]) / 2, (j + p.parametrization[1]) / 2);
            if (degree <= p.reproduction_degree) CHECK(right);
            all = all && right;
          }
    CHECK_FALSE(all);
  }
}

TEST_CASE("convergence of products follows the factors") {
  for (const Mask& a : binary)
    for (const Mask& b : binary) {
      const Decision product = converges(tensor_product({a, b})),
                     symbol = converges(tensor_product({a, b}).without_factors());
      CHECK(product.truth == (converges(a).is_yes() && converges(b).is_yes() ? Truth::yes : Truth::no));
      CHECK(symbol.truth == product.truth);
    }
  CHECK(converges(tensor_product({binary[2], binary[2], binary[3]}).without_factors()).is_yes());
  // Not decided by one level: ||S_q|| = 11/10.
  const Mask slow = read_mask("[-3,0,8,10,8,0,-3]/10@-3"), diverging = read_mask("[2,2]@0");
  for (const auto& [factors, truth] :
       {std::pair(std::vector{slow, binary[3]}, Truth::unknown),
        std::pair(std::vector{binary[3], slow}, Truth::unknown), std::pair(std::vector{slow, diverging}, Truth::no),
        std::pair(std::vector{binary[3], binary[3], slow}, Truth::unknown)})
    CHECK(converges(tensor_product(factors), {1, Deadline::in(20)}).truth == truth);
}

TEST_CASE("the smoothness of a product is that of its roughest factor") {
  const Mask &hat = binary[1], &cubic = binary[3];
  CHECK(proved_smoothness(hat).order == 0);
  CHECK(proved_smoothness(cubic).order == 2);
  for (const LatticeMask& product : {tensor_product({hat, cubic}), tensor_product({cubic, hat, cubic})})
    CHECK(proved_smoothness(product).order == 0);
  CHECK(proved_smoothness(tensor_product({cubic, cubic})).order == 2);
  CHECK_THROWS_AS(proved_smoothness(tensor_product({cubic, cubic}).without_factors()), Error);
}

TEST_CASE("what does not converge and what is not decided") {
  const MultivariatePolynomial one(2, 1);
  CHECK(converges(LatticeMask(one, 2)).is_no());
  const auto linear = tensor_product({binary[1], binary[1]});
  CHECK(converges(LatticeMask(linear.symbol() * MultivariatePolynomial(2, 2), 2)).is_no());
  // The three-direction box spline of degree 1 has the factor 1 + x y in place of squares.
  const auto box = MultivariatePolynomial::parse("1/2*x^-1*y^-1 + 1/2*x^-1 + 1/2*y^-1 + 1 + 1/2*x + 1/2*y + 1/2*x*y",
                                                 2);
  const PolynomialReproduction p = polynomial_reproduction(LatticeMask(box, 2));
  CHECK(p.sum_rules == 2);
  CHECK(p.reproduction_degree == 1);
  CHECK(p.factors == std::vector<int>{1, 1});
  CHECK(converges(LatticeMask(box, 2)).is_yes());
}

TEST_CASE("norms of the operator") {
  CHECK(operator_norm(tensor_product({binary[2], binary[1]})) == Rational(5, 4));
  CHECK(operator_norm(tensor_product({binary[2], binary[2]})) == Rational(25, 16));
}
