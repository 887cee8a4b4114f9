#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/classical.hpp>
#include <subcert/schemes/specification.hpp>
#include <subcert/schemes/surface_schemes.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

Scheme surface_scheme(const std::string& text) { return make_linear_scheme(text); }

MultivariatePolynomial polynomial(const std::string& text) { return MultivariatePolynomial::parse(text, 2); }

std::string refusal(const std::string& text) {
  try {
    (void)make_any_scheme(text);
  } catch (const SpecificationError& error) {
    CHECK(error.position() >= 1);
    CHECK(error.position() <= text.size() + 1);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return std::to_string(error.position()) + " '" + error.token() + "' " + error.expected();
  }
  return "accepted";
}

int sum_rules(const std::string& text) { return polynomial_reproduction(surface_scheme(text).mask).sum_rules; }
int reproduction(const std::string& text) {
  return polynomial_reproduction(surface_scheme(text).mask).reproduction_degree;
}

/// What the vertices and the new points read where coarse points are at M j: datum number and weight, by fine index.
Rational weight(const LatticeMask& mask, const LatticePoint& output, const LatticePoint& datum) {
  return mask.symbol().coefficient(output - mask.dilation() * datum);
}

}  // namespace

TEST_CASE("canonical texts of surface and volume schemes read as themselves") {
  for (const char* text : {"mask2:[[1,1,0],[1,2,1],[0,1,1]]/2@-1,-1",
                           "mask2:[[1,2,1],[2,4,2],[1,2,1]]/4@3,-7",
                           "mask2:[[1,1,1],[1,1,1],[1,1,1]]@0,0,arity=3",
                           "mask2:[[0,1,0],[1,4,1],[0,1,0]]/4@-1,-1,dilation=[1,-1;1,1]",
                           "mask2:[[0,1,0],[1,4,1],[0,1,0]]/4@-1,-1,dilation=[1,-1;1,1],digits=[0,0;5,4]",
                           "mask2:[[1,1],[1,1]]@0,0,digits=[0,0;1,0;0,1;-1,-1]",
                           "mask2:[[1,1]]@0,0,dilation=[0,2;1,0]",
                           "mask2:[[1,1],[1,1]]@0,0,dilation=[-2,0;0,-2]",
                           "mask3:[[[1,1],[1,1]],[[1,1],[1,1]]]@-1,-1,-1",
                           "mask3:[[[1,1]]]@0,0,0,dilation=[0,0,2;1,0,0;0,1,0]",
                           "box:[1,0;0,1]",
                           "box:[1,0;0,1;1,1],arity=3",
                           "box:[1,0;0,1;1,1;1,-1],dilation=[1,-1;1,1]",
                           "box:[1,0,0;0,1,0;0,0,1;1,1,1]",
                           "butterfly:w=1/16",
                           "butterfly:w=0",
                           "kobbelt:w=-1/3",
                           "loop",
                           "catmull-clark",
                           "doo-sabin",
                           "sqrt3",
                           "four-eight",
                           "quincunx",
                           "zwart-powell",
                           "midedge"}) {
    CAPTURE(text);
    CHECK(surface_scheme(text).specification == text);
    CHECK(!surface_scheme(text).title.empty());
    for (const Rational& sum : coset_sums(surface_scheme(text).mask)) CHECK(sum == 1);
    const LatticeMask& mask = surface_scheme(text).mask;
    std::string by_coefficients = "mask" + std::to_string(mask.dimension()) + ":" + to_mask_text(mask) +
                                  ",dilation=" + mask.dilation().to_text() +
                                  ",digits=" + to_text(mask.dilation().digits());
    CHECK(surface_scheme(by_coefficients).mask == mask);
    CHECK(surface_scheme(surface_scheme(by_coefficients).specification).mask == mask);
  }
  CHECK(surface_scheme("loop:").specification == "loop");
  CHECK(surface_scheme("mask2:[[1/2,1/2,0],[1/2,1,1/2],[0,1/2,1/2]]").specification ==
        "mask2:[[1,1,0],[1,2,1],[0,1,1]]/2@-1,-1");
  CHECK(surface_scheme("mask2:[[0,0,0,0],[0,1,1,0],[0,1,1,0]],arity=2").specification == "mask2:[[1,1],[1,1]]@-1,0");
  CHECK(surface_scheme("mask2:[[1,1],[1,1]]@0,0,digits=[0,0;1,0;0,1;1,1]").specification == "mask2:[[1,1],[1,1]]@0,0");
  for (const FamilyHelp& family : multivariate_families()) {
    CAPTURE(family.usage);
    CHECK_NOTHROW(make_linear_scheme(family.usage));
    CHECK_THROWS_AS(make_scheme(family.usage), SpecificationError);
  }
  Random random;
  for (const auto i : rounds(50)) {
    // Any coefficients, completed such that every class sums to 1.
    const Dilation dilation(i % 2 ? std::vector<LatticePoint>{{1, 2}, {-2, -1}}
                                  : std::vector<LatticePoint>{{2, 0}, {0, 3}});
    std::vector<Monomial> terms;
    for (long x = -2; x <= 2; ++x)
      for (long y = -1; y <= 2; ++y) terms.push_back({random.rational(), {x, y}});
    std::vector<Rational> missing(dilation.digits().size(), 1);
    for (const Monomial& term : terms) missing[dilation.divide(term.exponents).digit] -= term.coefficient;
    for (std::size_t d = 0; d < missing.size(); ++d) terms.push_back({missing[d], dilation.digits()[d]});
    const LatticeMask mask(MultivariatePolynomial(2, terms), dilation);
    CAPTURE(to_mask_text(mask));
    CHECK(surface_scheme("mask2:" + to_mask_text(mask) + ",dilation=" + dilation.to_text()).mask == mask);
  }
}

TEST_CASE("bad surface specifications say what, where and what would be right") {
  CHECK(refusal("mask2:[[1,1],[1]]") == "14 '[1]' rows of one length: a list of 2, as before, not of 1");
  CHECK(refusal("mask3:[[[1,1],[1,1]],[[1,1]]]") ==
        "22 '[[1,1]]' rows of one length: a list of 2, as before, not of 1");
  CHECK(refusal("mask2:[1,1]") == "8 '1,1]' lists in brackets, nested 2 deep for as many variables");
  CHECK(refusal("mask2:[[[1,1]]]") == "9 '[1,1]]]' lists in brackets, nested 2 deep for as many variables");
  CHECK(refusal("mask3:[[1,1],[1,1]]") == "9 '1,1],[1,1]]' lists in brackets, nested 3 deep for as many variables");
  CHECK(refusal("mask2:[[1,x],[1,1]]") == "11 'x' an exact number p, p/q with q > 0, a decimal, or a sum of such");
  CHECK(refusal("mask2:[[1,1],[1,1]") == "19 '' a comma or a closing bracket");
  CHECK(refusal("mask2:[[1,1],[1,1]]@0") == "22 '' @ and as many first indices as variables");
  CHECK(refusal("mask2:[[1,1],[1,1]]@0,arity=2") ==
        "23 'arity=2' the first index of y as an integer from -1000000000 to 1000000000");
  CHECK(refusal("mask2:[[1,1],[1,1]]/0") == "20 '/0' /D with a positive integer D, or @ and the first index");
  CHECK(refusal("mask2:[[0,0],[0,0]]") == "7 '[[0,0],[0,0]]' at least one non-zero coefficient");
  CHECK(refusal("mask2:[[1,1],[1,2]]") ==
        "7 '[[1,1],[1,2]]' coefficients that sum to 1 over each class of indices modulo [2,0;0,2]; the class of (0,0) "
        "sums to 2");
  CHECK(refusal("mask2:[[1,1,1]]") ==
        "7 '[[1,1,1]]' coefficients that sum to 1 over each class of indices modulo [2,0;0,2]; the class of (0,1) has "
        "none (another matrix: dilation=[a,b;c,d])");
  CHECK(
      refusal("mask2:[[1,1]]@0,0") ==
      "7 '[[1,1]]@0,0' coefficients that sum to 1 over each class of indices modulo [2,0;0,2]; the class of (0,1) has "
      "none (another matrix: dilation=[a,b;c,d])");
  CHECK(refusal("mask2:[[1,1],[1,1]],arity=1") == "27 '1' arity as an integer from 2 to 64");
  CHECK(refusal("mask2:[[1,1],[1,1]],arity=2,dilation=[2,0;0,2]") == "38 '[2,0;0,2]' arity or dilation, not both");
  CHECK(refusal("mask2:[[1,1],[1,1]],dilation=[2,0]") ==
        "30 '[2,0]' a square matrix, got a row of 2 entries among 1 rows");
  for (const char* matrix : {"[1,0;0,2]", "[1,0;0,1]", "[1,1;1,1]", "[0,1;1,0]", "[2,0;0,0]"})
    CHECK(refusal("mask2:[[1,1],[1,1]],dilation=" + std::string(matrix)) ==
          "30 '" + std::string(matrix) + "' eigenvalues larger than 1 in modulus, all of them, got " + matrix);
  CHECK(refusal("mask2:[[1,1],[1,1]],dilation=[2,0,0;0,2,0;0,0,2]") == "31 '2,0,0' 2 numbers, one for each variable");
  CHECK(refusal("mask2:[[1,1],[1,1]],dilation=[2,0;0,x]") == "37 'x' an entry as an integer from -64 to 64");
  CHECK(refusal("mask2:[[1,1],[1,1]],dilation=2") == "30 '2' a list in brackets, as [1;2]");
  CHECK(refusal("mask2:[[1,1],[1,1]],digits=[0,0;1,0;0,1;2,0]") ==
        "28 '[0,0;1,0;0,1;2,0]' digits of different classes modulo [2,0;0,2], got numbers 1 and 4 of one class");
  CHECK(refusal("mask2:[[1,1],[1,1]],digits=[0,0]") ==
        "28 '[0,0]' 4 digits, one of each class modulo [2,0;0,2], got 1");
  CHECK(refusal("mask2:[[1,1],[1,1]],m=2") == "21 'm' a key of mask2:[[1,1,0],[1,2,1],[0,1,1]]/2@-1,-1");
  std::string many = "mask2:[[1";
  for (int i = 1; i < 10'000; ++i) many += ",0";
  CHECK(refusal(many + "]]").find("at most 8192 coefficients") != std::string::npos);
  CHECK(refusal("mask2").substr(0, 9) == "1 'mask2'");
  std::string primes = "mask2:[[1";
  for (int n = 10'001; n < 17'000; n += 2) primes += ",1/" + std::to_string(n);
  CHECK(refusal(primes + "]]").find("digits of the common denominator") != std::string::npos);

  CHECK(refusal("box:[1,0;2,0]") == "5 '[1,0;2,0]' directions that span all 2 dimensions");
  CHECK(refusal("box:[1;0]") == "5 '[1;0]' directions of two or three variables, as [1,0;0,1;1,1]");
  CHECK(refusal("box:1,0") == "5 '1' a list in brackets, as [1;2]");
  CHECK(refusal("box:[1,0;0,1;0,0]") == "5 '[1,0;0,1;0,0]' directions other than zero");
  CHECK(refusal("box:[1,0;0,1,1]") == "10 '0,1,1' 2 numbers, one for each variable");
  CHECK(refusal("box:[2,0;0,2]") ==
        "5 '[2,0;0,2]' coefficients that sum to 1 over each class of indices modulo [2,0;0,2]; the class of (0,0) has "
        "none (another matrix: dilation=[a,b;c,d])");
  CHECK(refusal("box:[1,0;0,1;1,1],dilation=[1,-1;1,1]") ==
        "5 '[1,0;0,1;1,1]' directions that the dilation [1,-1;1,1] maps to multiples of directions");
  CHECK(refusal("box:[64,0;0,64;64,64],arity=64").find("at most 100000 coefficients") != std::string::npos);
  CHECK(refusal("loop:w=1") == "6 'w=1' nothing after loop");
  CHECK(refusal("butterfly:v=1") == "11 'v' the key 'w', as in butterfly:w=1/16");
  CHECK(refusal("butterfly:w=x").substr(0, 6) == "13 'x'");
  CHECK(refusal("four-point:w=1/16x").substr(0, 2) == "14");
}

TEST_CASE("every prefix and every single change of a surface specification is read or refused") {
  for (const std::string valid :
       {"mask2:[[0,1,0],[1,4,1],[0,1,0]]/4@-1,-1,dilation=[1,-1;1,1],digits=[0,0;1,0]",
        "mask3:[[[1,1],[1,1]],[[1,1],[1,1]]]@-1,-1,-1", "box:[1,0;0,1;1,1],arity=3", "butterfly:w=1/16", "loop:"}) {
    const auto attempt = [](const std::string& text) {
      try {
        (void)make_linear_scheme(text);
      } catch (const SpecificationError&) {
      }
    };
    for (std::size_t i = 0; i < valid.size(); ++i) {
      attempt(valid.substr(0, i));
      std::string changed = valid;
      for (char c : {'0', '9', '-', ',', ';', '[', ']', '=', '/', ':', '@', '.', '\0', '\xff'}) {
        changed[i] = c;
        attempt(changed);
      }
    }
  }
}

TEST_CASE("box splines are products of their factors, and tensor products where the directions are the axes") {
  CHECK(surface_scheme("box:[1,0;0,1;1,1]").mask == surface_scheme("mask2:[[1,1,0],[1,2,1],[0,1,1]]/2").mask);
  const std::string cubic = "box:[1,0;1,0;1,0;1,0;0,1;0,1;0,1;0,1]";
  CHECK(surface_scheme(cubic).mask == surface_scheme("catmull-clark").mask);
  CHECK(surface_scheme(cubic + ",arity=3").mask ==
        surface_scheme("tensor:(bspline:degree=3,a=3)x(bspline:degree=3,a=3)").mask);
  CHECK(surface_scheme("box:[1,0;1,0;0,1;0,1;0,1]").mask ==
        surface_scheme("tensor:(bspline:degree=1)x(bspline:degree=2)").mask);
  CHECK(surface_scheme("box:[1,0,0;0,1,0;0,0,1;0,0,1]").mask ==
        surface_scheme("tensor:(mask:[1,1])x(mask:[1,1])x(bspline:degree=1)").mask);
  // Signs of directions only shift, and the mask is centred.
  CHECK(surface_scheme("box:[-1,0;0,1;-1,-1]").mask == surface_scheme("box:[1,0;0,1;1,1]").mask);
  // 1 - z^(Mv) over 1 - z^v, as polynomials.
  for (const auto& [directions, dilation] :
       std::vector<std::pair<std::string, std::string>>{{"1,0;0,1;1,1;1,1", "[2,0;0,2]"},
                                                        {"1,0;0,1;1,1;2,1", "[3,0;0,3]"},
                                                        {"1,0;0,1;1,1;1,-1", "[1,-1;1,1]"},
                                                        {"1,0;0,1;1,1;1,-1;1,0;0,1;1,1;1,-1", "[1,1;1,-1]"},
                                                        {"1,0;0,1;1,-1", "[1,2;-2,-1]"},
                                                        {"1,0;0,1;1,-1;1,1;1,-2;2,-1", "[1,2;-2,-1]"},
                                                        {"1,0;0,1", "[2,0;0,3]"},
                                                        {"1,0;0,1", "[0,2;3,0]"},
                                                        {"1,0,0;0,1,0;0,0,1", "[0,0,2;1,0,0;0,1,0]"}}) {
    const std::string text = "box:[" + directions + "],dilation=" + dilation;
    CAPTURE(text);
    if (refusal(text) != "accepted") {
      CHECK(refusal(text).find("maps to multiples of directions") != std::string::npos);
      CHECK(directions == "1,0;0,1;1,-1");
      continue;
    }
    const LatticeMask mask = surface_scheme(text).mask;
    const int variables = mask.dimension();
    MultivariatePolynomial above(variables, 1), below(variables, 1);
    std::string rest = directions + ";";
    for (std::size_t end = 0; (end = rest.find(';')) != std::string::npos; rest = rest.substr(end + 1)) {
      LatticePoint v;
      std::string numbers = rest.substr(0, end) + ",";
      for (std::size_t comma = 0; (comma = numbers.find(',')) != std::string::npos; numbers = numbers.substr(comma + 1))
        v.push_back(std::stol(numbers.substr(0, comma)));
      const LatticePoint zero(v.size(), 0);
      above *= MultivariatePolynomial(variables, {{1, zero}, {-1, mask.dilation() * v}});
      below *= MultivariatePolynomial(variables, {{1, zero}, {-1, v}});
    }
    const MultivariatePolynomial left = mask.symbol() * below;
    const auto quotient = left.exact_quotient(above);
    REQUIRE(quotient);
    CHECK(quotient->count() == 1);
    CHECK(coset_sums(mask) == std::vector<Rational>(mask.dilation().digits().size(), 1));
  }
  CHECK_THROWS_AS(box_spline_mask({{1, 0}}, Dilation::multiple(2, 2)), Error);
  CHECK_THROWS_AS(box_spline_mask({{1, 0}, {0, 1, 0}}, Dilation::multiple(2, 2)), Error);
}

TEST_CASE("Loop's rules") {
  // [Loo87]: new points 3/8, 3/8, 1/8, 1/8; vertices 5/8 and 1/16 for each of six neighbours.
  const LatticeMask mask = surface_scheme("loop").mask;
  for (const LatticePoint& e : std::vector<LatticePoint>{{1, 0}, {0, 1}, {1, 1}}) {
    CHECK(weight(mask, e, {0, 0}) == Rational(3, 8));
    CHECK(weight(mask, e, e) == Rational(3, 8));
    CHECK(weight(mask, {0, 0}, e) == Rational(1, 16));
    CHECK(weight(mask, {0, 0}, LatticePoint{0, 0} - e) == Rational(1, 16));
  }
  CHECK(weight(mask, {0, 0}, {0, 0}) == Rational(5, 8));
  CHECK(weight(mask, {1, 0}, {1, 1}) == Rational(1, 8));
  CHECK(weight(mask, {1, 0}, {0, -1}) == Rational(1, 8));
  CHECK(mask.symbol().count() == 19);
  CHECK(sum_rules("loop") == 4);
  CHECK(reproduction("loop") == 1);
}

TEST_CASE("the butterfly scheme as printed") {
  // [DLG90; Dyn92]: 1/2 (1+x)(1+y)(1+xy)(1 - w c(x,y)) / (xy).
  const MultivariatePolynomial c = polynomial(
      "2*x^-2*y^-1 + 2*x^-1*y^-2 - 4*x^-1*y^-1 - 4*x^-1 - 4*y^-1 + 2*x^-1*y + 2*x*y^-1 + 12 - 4*x - 4*y - 4*x*y + "
      "2*x^2*y + 2*x*y^2");
  for (const Rational& w : {Rational(1, 16), Rational(0), Rational(-2, 7)}) {
    const MultivariatePolynomial bracket = polynomial("1") - MultivariatePolynomial(2, w) * c;
    const MultivariatePolynomial symbol = polynomial("1/2*x^-1*y^-1 + 1/2*y^-1") * polynomial("1 + y") *
                                          polynomial("1 + x*y") * bracket;
    CHECK(butterfly_mask(w).symbol() == symbol);
    CHECK(surface_scheme("butterfly:w=" + to_text(w)).mask.symbol() == symbol);
    CHECK(symbol.coset(2, {0, 0}) == polynomial("1"));
  }
  CHECK(surface_scheme("butterfly:w=0").mask == surface_scheme("box:[1,0;0,1;1,1]").mask);
  CHECK(sum_rules("butterfly:w=1/16") == 4);
  CHECK(reproduction("butterfly:w=1/16") == 3);
  CHECK(sum_rules("butterfly:w=1/15") == 2);
}

TEST_CASE("Kobbelt's sqrt(3) scheme from its rules") {
  // [Kob00]: a new point is the mean of the corners of its triangle, and a vertex of valence n moves by alpha_n =
  // (4 - 2 cos(2 pi / n)) / 9 towards the mean of its neighbours.
  const LatticeMask mask = surface_scheme("sqrt3").mask;
  CHECK(mask.dilation() == Dilation({{1, 2}, {-2, -1}}));
  const Rational alpha(1, 3);
  MultivariatePolynomial expected(2, 1 - alpha);
  LatticePoint n{1, 0};
  for (int turn = 0; turn < 6; ++turn, n = {-n[1], n[0] + n[1]}) {
    expected += MultivariatePolynomial(2, {{Rational(1, 3), n}, {alpha / 6, mask.dilation() * n}});
    // M turns the six neighbours by 30 degrees and stretches them by sqrt(3).
    const LatticePoint image = mask.dilation() * n;
    CHECK(image[0] * image[0] + image[0] * image[1] + image[1] * image[1] == 3);
  }
  CHECK(mask.symbol() == expected);
  CHECK(mask.dilation().is_isotropic());
  CHECK(sum_rules("sqrt3") == 3);
  CHECK(reproduction("sqrt3") == 1);
}

TEST_CASE("schemes on quadrilaterals from their rules") {
  const LatticeMask quincunx = surface_scheme("quincunx").mask;
  CHECK(weight(quincunx, {0, 0}, {0, 0}) == 1);
  // The point (0,1) is the centre of a face; its corners are those lattice points whose images are its neighbours.
  Rational corners = 0;
  for (const LatticePoint& j : std::vector<LatticePoint>{{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
    const LatticePoint apart = quincunx.dilation() * j - LatticePoint{0, 1};
    CHECK(std::abs(apart[0]) + std::abs(apart[1]) == 1);
    CHECK(weight(quincunx, {0, 1}, j) == Rational(1, 4));
    corners += weight(quincunx, {0, 1}, j);
  }
  CHECK(corners == 1);
  CHECK(sum_rules("quincunx") == 2);
  CHECK(reproduction("quincunx") == 1);

  // [VZ01]: a new point is the mean of the corners of its face; a vertex the mean of itself and of the mean of its four
  // neighbours along edges.
  const LatticeMask four_eight = surface_scheme("four-eight").mask;
  CHECK(to_mask_text(four_eight) == "[[1,2,1],[2,4,2],[1,2,1]]/8@-1,-1");
  CHECK(weight(four_eight, {0, 0}, {0, 0}) == Rational(1, 2));
  for (const LatticePoint& j : std::vector<LatticePoint>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
    CHECK(weight(four_eight, {0, 0}, j) == Rational(1, 8));
  for (const LatticePoint& j : std::vector<LatticePoint>{{0, 0}, {1, 0}, {0, 1}, {1, 1}})
    CHECK(weight(four_eight, {0, 1}, j) == Rational(1, 4));
  CHECK(sum_rules("four-eight") == 4);
  // Two steps make the box spline for M^2, which is 2 times a turn by a right angle.
  const MultivariatePolynomial two_steps = [&] {
    std::vector<Monomial> outer = four_eight.symbol().terms();
    for (Monomial& term : outer) term.exponents = four_eight.dilation() * term.exponents;
    return four_eight.symbol() * MultivariatePolynomial(2, outer);
  }();
  CHECK(two_steps == surface_scheme("box:[1,0;1,0;0,1;0,1;1,1;1,1;1,-1;1,-1]").mask.symbol());

  // [PR97]: the midpoints of edges.
  const LatticeMask midedge = surface_scheme("midedge").mask;
  CHECK(to_mask_text(midedge) == "[[1,1],[1,1]]/2@-1,-1");
  for (const LatticePoint& i : std::vector<LatticePoint>{{0, 0}, {1, 0}, {0, 1}, {7, -2}}) {
    std::vector<LatticePoint> ends;
    for (long x = -9; x <= 9; ++x)
      for (long y = -9; y <= 9; ++y)
        if (weight(midedge, i, {x, y}) != 0) {
          CHECK(weight(midedge, i, {x, y}) == Rational(1, 2));
          ends.push_back({x, y});
        }
    REQUIRE(ends.size() == 2);
    const LatticePoint edge = ends[1] - ends[0];
    CHECK(std::abs(edge[0]) + std::abs(edge[1]) == 1);
  }
  CHECK(sum_rules("midedge") == 2);
  CHECK(sum_rules("zwart-powell") == 2);
  CHECK(to_mask_text(surface_scheme("zwart-powell").mask) == "[[0,1,1,0],[1,2,2,1],[1,2,2,1],[0,1,1,0]]/4@-2,-2");

  // [CC78]: 1/4; 3/8 and 1/16; 9/16, 3/32 and 1/64. [DS78]: 9/16, 3/16, 3/16, 1/16.
  CHECK(to_mask_text(surface_scheme("catmull-clark").mask) ==
        "[[1,4,6,4,1],[4,16,24,16,4],[6,24,36,24,6],[4,16,24,16,4],[1,4,6,4,1]]/64@-2,-2");
  CHECK(to_mask_text(surface_scheme("doo-sabin").mask) == "[[1,3,3,1],[3,9,9,3],[3,9,9,3],[1,3,3,1]]/16@-2,-2");
  CHECK(surface_scheme("catmull-clark").mask.factors().size() == 2);
  const LatticeMask kobbelt = surface_scheme("kobbelt:w=1/16").mask;
  CHECK(weight(kobbelt, {1, 1}, {0, 0}) == Rational(81, 256));
  CHECK(weight(kobbelt, {1, 1}, {-1, 2}) == Rational(1, 256));
  CHECK(kobbelt.symbol().coset(2, {0, 0}) == polynomial("1"));
  CHECK(reproduction("kobbelt:w=1/16") == 3);
}
