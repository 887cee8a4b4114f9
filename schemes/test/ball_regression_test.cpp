#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/grid_regression.hpp>
#include <subcert/schemes/specification.hpp>

#include <map>

using namespace subcert;

namespace {

Scheme triangular(const std::string& fields) { return make_linear_scheme("triangular:" + fields); }

/// How many coefficients of the rule of the new point m / 2 have which value.
std::map<Rational, int> rule(const LatticeMask& mask, const LatticePoint& m) {
  std::map<Rational, int> counts;
  for (const auto& term : mask.symbol().terms())
    if (mask.dilation().divide(term.exponents).digit == mask.dilation().divide(m).digit) ++counts[term.coefficient];
  return counts;
}

const std::vector<LatticePoint> edges{{1, 0}, {0, 1}, {1, 1}};

}  // namespace

TEST_CASE("least squares on triangular grids: stencils and coefficients of degree 1") {
  // [CLY25, sec. 5, figures]: 7 data for vertices and 10 for edges on the equilateral grid with 3/2 < L < sqrt(3); 9, 8
  // and 12 on the rectangular one. All coefficients of a rule agree for the weight function 1.
  const LatticeMask equilateral = triangular("L=8/5,d=1").mask;
  CHECK(rule(equilateral, {0, 0}) == std::map<Rational, int>{{Rational(1, 7), 7}});
  for (const LatticePoint& edge : edges)
    CHECK(rule(equilateral, edge) == std::map<Rational, int>{{Rational(1, 10), 10}});
  CHECK(equilateral == triangular("d=1,L=16/10").mask);
  const LatticeMask rectangular = triangular("L=8/5,grid=rectangular").mask;
  CHECK(rule(rectangular, {0, 0}) == std::map<Rational, int>{{Rational(1, 9), 9}});
  CHECK(rule(rectangular, {1, 0}) == std::map<Rational, int>{{Rational(1, 8), 8}});
  CHECK(rule(rectangular, {0, 1}) == std::map<Rational, int>{{Rational(1, 8), 8}});
  CHECK(rule(rectangular, {1, 1}) == std::map<Rational, int>{{Rational(1, 12), 12}});
  // Weights divided by their sums: 1 - (r/L)^2 = 1 - 25/64 r^2.
  const LatticeMask weighted = triangular("L=8/5,power=1").mask;
  CHECK(rule(weighted, {0, 0}) == std::map<Rational, int>{{Rational(64, 298), 1}, {Rational(39, 298), 6}});
  for (const LatticePoint& edge : edges)
    CHECK(rule(weighted, edge) ==
          std::map<Rational, int>{
              {Rational(231, 1210), 2}, {Rational(181, 1210), 2}, {Rational(81, 1210), 4}, {Rational(31, 1210), 2}});
  CHECK(weighted == triangular("L=8/5,weights=[256;231;181;156;81;31]").mask);
  CHECK(ball_distances({Rational(8, 5)}) ==
        std::vector<Rational>{0, Rational(1, 4), Rational(3, 4), 1, Rational(7, 4), Rational(9, 4)});
  // Means of the ends of the edges: the linear box spline.
  CHECK(triangular("L=3/5,d=0").mask == make_linear_scheme("box:[1,0;0,1;1,-1]").mask);
}

TEST_CASE("least squares on triangular grids reproduce the degree, and the weights are polynomials") {
  for (const char* grid : {"", ",grid=rectangular"})
    for (int degree = 0; degree <= 5; ++degree)
      for (const char* weight : {"", ",power=2"}) {
        const std::string text = "L=7/2,d=" + std::to_string(degree) + grid + weight;
        CAPTURE(text);
        const LatticeMask mask = triangular(text).mask;
        const PolynomialReproduction polynomials = polynomial_reproduction(mask);
        CHECK(polynomials.reproduction_degree == degree / 2 * 2 + 1);  // even and odd degrees agree
        CHECK(polynomials.parametrization == std::vector<Rational>{0, 0});
        CHECK(mask.symbol().reversed() == mask.symbol());
      }
  // On the equilateral grid rotations by 60 degrees keep the mask, and the coefficients of degree 2 divided by the
  // weights are a linear function of the squared distance.
  const LatticeMask mask = triangular("L=5/2,d=2,power=1").mask;
  std::map<Rational, Rational> ratio;
  for (const auto& term : mask.symbol().terms()) {
    const long i = term.exponents[0], j = term.exponents[1];
    CHECK(mask.symbol().coefficient({-j, i + j}) == term.coefficient);
    if (i % 2 != 0 || j % 2 != 0) continue;
    const Rational distance(i * i + i * j + j * j, 4);
    ratio[distance] = term.coefficient / (1 - distance * 4 / 25);
  }
  REQUIRE(ratio.size() == 4);  // 0, 1, 3, 4
  for (const auto& [distance, value] : ratio) CHECK(value == ratio[0] + distance * (ratio[1] - ratio[0]));
}

TEST_CASE("specifications of least squares on triangular grids") {
  for (const char* fields :
       {"L=8/5,d=1", "L=2,d=2,grid=rectangular,power=2", "L=8/5,d=0,weights=[1;1/2;1/3;1/4;1/5;1/6]", "L=10,d=6"})
    CHECK(triangular(fields).specification == std::string("triangular:") + fields);
  CHECK(triangular("power=0,L=16/10,grid=equilateral").specification == "triangular:L=8/5,d=1");
  const auto refusal = [](const std::string& fields) {
    try {
      return triangular(fields).specification;
    } catch (const SpecificationError& error) {
      return std::to_string(error.position()) + " '" + error.token() + "' " + error.expected();
    }
  };
  CHECK(refusal("d=1") == "1 'triangular' the key 'L', as in triangular:L=8/5,d=1");
  CHECK(refusal("L=1/2") == "14 '1/2' 1/2 < L <= 10, got 1/2");
  CHECK(refusal("L=17") == "14 '17' 1/2 < L <= 10, got 17");
  CHECK(refusal("L=1/1001") == "14 '1/1001' L with a denominator up to 1000");
  CHECK(refusal("L=1") == "14 '1' data that determine polynomials of degree 1, got 1 around a new point");
  CHECK(refusal("L=8/5,d=7") == "20 '7' d as an integer from 0 to 6");
  CHECK(refusal("L=8/5,d=3") == "14 '8/5' data that determine polynomials of degree 3, got 7 around a new point");
  CHECK(refusal("L=8/5,grid=hexagonal") == "23 'hexagonal' grid=equilateral or grid=rectangular");
  CHECK(refusal("L=8/5,power=9") == "24 '9' power as an integer from 0 to 8");
  CHECK(refusal("L=8/5,power=1,weights=[1]") == "34 '[1]' power or weights, not both");
  CHECK(refusal("L=8/5,weights=[1;2]") ==
        "26 '[1;2]' 6 weights, one for each squared distance 0, 1/4, 3/4, 1, 7/4, 9/4");
  CHECK(refusal("L=8/5,weights=[1;0]") == "29 '0' a weight > 0 of at most 40 characters");
  CHECK_THROWS_AS(ball_regression_mask({Rational(8, 5), -1}), Error);
  CHECK_THROWS_AS(ball_regression_mask({Rational(8, 5), 1, Lattice::equilateral, -1}), Error);
  CHECK_THROWS_AS(ball_regression_mask({Rational(8, 5), 1, Lattice::equilateral, 0, {1, 2}}), Error);
}
