#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/mask.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;

TEST_CASE("what a mask knows about itself") {
  const Mask chaikin(LaurentPolynomial::parse_mask("[1,3,3,1]/4@-2"), 2);
  CHECK(is_affine(chaikin));
  CHECK(support(chaikin) == IndexRange{-2, 1});
  CHECK(limit_support(chaikin).upper == 1);
  CHECK(symmetry(chaikin).kind == Symmetry::even);
  CHECK(symmetry(chaikin).centre == Rational(-1, 2));

  const Mask ternary(LaurentPolynomial::parse_mask("[1,2,3,2,1]/3@-2"), 3);
  CHECK(coset_sums(ternary) == std::vector<Rational>{1, 1, 1});
  CHECK(symmetry(ternary).kind == Symmetry::odd);
  CHECK(limit_support(ternary).lower == -1);

  const Mask skew(LaurentPolynomial::parse_mask("[1,2,1,0]/2@5"), 2);
  CHECK(symmetry(skew).kind == Symmetry::odd);
  CHECK(symmetry(skew).centre == 6);
  CHECK(symmetry(Mask(LaurentPolynomial::parse_mask("[1,2,3]@0"), 2)).kind == Symmetry::none);
  CHECK_FALSE(is_affine(Mask(LaurentPolynomial::parse_mask("[1,2,3]@0"), 2)));

  CHECK_THROWS_AS(Mask(LaurentPolynomial(), 2), Error);
  CHECK_THROWS_AS(Mask(LaurentPolynomial(1), 1), Error);
  const MultivariateMask surface = tensor_product({chaikin, chaikin});
  CHECK(surface.dimension() == 2);
  CHECK(surface.symbol().coefficient({0, 1}) == Rational(3, 16));
  const MultivariateMask mixed = tensor_product({chaikin, ternary});
  CHECK(mixed.dilation() == Dilation({{2, 0}, {0, 3}}));
  CHECK(coset_sums(mixed) == std::vector<Rational>(6, 1));
  CHECK_THROWS_AS(mixed.arity(), Error);
}
