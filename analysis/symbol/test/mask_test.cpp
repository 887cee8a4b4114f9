#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
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
  const LatticeMask surface = tensor_product({chaikin, chaikin});
  CHECK(surface.dimension() == 2);
  CHECK(surface.symbol().coefficient({0, 1}) == Rational(3, 16));
  const LatticeMask mixed = tensor_product({chaikin, ternary});
  CHECK(mixed.dilation() == Dilation({{2, 0}, {0, 3}}));
  CHECK(coset_sums(mixed) == std::vector<Rational>(6, 1));
  CHECK_THROWS_AS(mixed.arity(), Error);
}

TEST_CASE("masks of a lattice know their factors, and a mask of one variable is its own") {
  const Mask chaikin(LaurentPolynomial::parse_mask("[1,3,3,1]/4@-2"), 2);
  const Mask ternary(LaurentPolynomial::parse_mask("[1,2,3,2,1]/3@-2"), 3);
  const LatticeMask curve = chaikin;
  CHECK(curve.dimension() == 1);
  CHECK(curve.arity() == 2);
  CHECK(curve.curve() == chaikin);
  CHECK(coset_sums(curve) == coset_sums(chaikin));
  CHECK(curve.without_factors() == curve);
  CHECK_FALSE(curve.without_factors().has_factors());
  CHECK_THROWS_AS(curve.without_factors().curve(), Error);
  const LatticeMask product = tensor_product({chaikin, ternary, chaikin});
  CHECK(product.factors() == std::vector<Mask>{chaikin, ternary, chaikin});
  CHECK_THROWS_AS(product.curve(), Error);
  CHECK_THROWS_AS(tensor_product({}), Error);
  CHECK_THROWS_AS(tensor_product({chaikin, chaikin, chaikin, chaikin}), Error);
  for (const LatticeMask& mask : {curve, product}) {
    const std::vector<Interval> box = limit_support(mask);
    for (std::size_t v = 0; v < box.size(); ++v) {
      CHECK(box[v].lower == limit_support(mask.factors()[v]).lower);
      CHECK(box[v].upper == limit_support(mask.factors()[v]).upper);
    }
  }
}

TEST_CASE("factors of a product are scaled so that it has coset sums 1 where they have") {
  const auto times = [](const Rational& factor, const Mask& mask) {
    return Mask(mask.symbol() * LaurentPolynomial(factor), mask.arity());
  };
  const Mask chaikin(LaurentPolynomial::parse_mask("[1,3,3,1]/4@-2"), 2);
  const LatticeMask product = tensor_product({times(Rational(2, 3), chaikin), chaikin, times(Rational(3, 2), chaikin)});
  CHECK(coset_sums(product) == std::vector<Rational>(8, 1));
  CHECK(product.factors() == std::vector<Mask>(3, chaikin));
  CHECK(product == tensor_product({chaikin, chaikin, chaikin}));
  const LatticeMask twice = tensor_product({chaikin, times(2, chaikin)});
  CHECK(twice.factors() == std::vector<Mask>{times(2, chaikin), chaikin});
  CHECK(twice.symbol().coefficient({0, 0}) == Rational(9, 8));
  const Mask vanishing(LaurentPolynomial::parse_mask("[1,-1]"), 2);
  CHECK(tensor_product({chaikin, vanishing}).factors() == std::vector<Mask>{chaikin, vanishing});
}

TEST_CASE("data are kept where of M Z^s only 0 has a matrix, with derivatives per unit of the spacing") {
  using Terms = std::vector<LatticeMask::Term>;
  const Dilation two = Dilation::multiple(1, 2), three = Dilation::multiple(1, 3);
  const Terms hermite{{{0}, 0, 0, 1}, {{0}, 1, 1, Rational(1, 2)}, {{1}, 0, 1, 7}, {{2}, 1, 0, 0}};
  CHECK(keeps_data(hermite, 2, two, true));
  CHECK_FALSE(keeps_data(hermite, 2, two, false));
  CHECK_FALSE(keeps_data(hermite, 2, three, true));
  const Terms doubled{{{0}, 0, 0, 3}, {{0}, 1, 1, Rational(3, 2)}};
  CHECK(keeps_data(doubled, 2, two, true, 3));
  CHECK_FALSE(keeps_data(doubled, 2, two, true));
  CHECK_FALSE(keeps_data({{{0}, 0, 0, 1}}, 2, two, true));
  CHECK(keeps_data({{{0}, 0, 0, 1}, {{0}, 1, 1, Rational(1, 3)}, {{0}, 2, 2, Rational(1, 9)}}, 3, three, true));
  for (const LatticeMask::Term& more : Terms{{{2}, 0, 0, 1}, {{-2}, 1, 1, 1}, {{0}, 0, 1, 1}, {{4}, 1, 0, 1}}) {
    Terms terms = hermite;
    terms.push_back(more);
    CHECK_FALSE(keeps_data(terms, 2, two, true));
  }
  const Dilation quincunx({{1, 1}, {1, -1}});
  CHECK(keeps_data({{{0, 0}, 0, 0, 1}, {{1, 0}, 0, 0, 5}}, 1, quincunx, false));
  CHECK_FALSE(keeps_data({{{0, 0}, 0, 0, 1}, {{1, 1}, 0, 0, 5}}, 1, quincunx, false));
}
