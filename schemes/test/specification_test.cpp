#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/as_written.hpp>
#include <subcert/schemes/classical.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <fstream>

using namespace subcert;

namespace {

/// \xHH and \\ in the data file stand for bytes that a line cannot hold; *N repeats the line's text N times.
std::string unescaped(const std::string& line) {
  std::string result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 3 < line.size() && line[i + 1] == 'x') {
      result += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
      i += 3;
    } else {
      result += line[i];
    }
  }
  return result;
}

void check_refused(const std::string& text) {
  CAPTURE(text);
  try {
    const Scheme scheme = make_scheme(text);
    FAIL_CHECK("accepted as " << scheme.specification);
  } catch (const SpecificationError& error) {
    CHECK(error.position() >= 1);
    CHECK(error.position() <= specification_as_written(text).size() + 1);
    CHECK(!error.expected().empty());
    const std::string message = error.what();
    CHECK(message.size() < 1000);
    // What is beyond ASCII is shown as it was given.
    for (const char c : message) CHECK((static_cast<unsigned char>(c) >= ' ' && c != '\x7f'));
  }
}

}  // namespace

TEST_CASE("decimals are exact numbers") {
  const auto specification = [](const char* text) { return make_scheme(text).specification; };
  CHECK(specification("four-point:w=0.0625") == specification("four-point:w=1/16"));
  CHECK(specification("four-point:w=6.25e-2") == specification("four-point:w=1/16"));
  CHECK(specification("mask:[.25,0.75,75e-2,0.25]") == specification("mask:[1,3,3,1]/4"));
  CHECK(specification("regression:stencils=[-1..1;-1..2],at=[0;0.5]") ==
        specification("regression:stencils=[-1..1;-1..2],at=[0;1/2]"));
}

TEST_CASE("schemes as papers and people write them") {
  const auto same = [](const char* written, const char* specification) {
    CAPTURE(written);
    CHECK(specification_of(make_any_scheme(written)) == make_linear_scheme(specification).specification);
  };
  for (const char* written :
       {"[1,3,3,1]/4", " mask: [1, 3, 3, 1] / 4 ", "1/4*[1,3,3,1]", "0.25 [1,3,3,1]", "(1/4)*[1 3 3 1]", "[1 3  3 1]/4",
        "symbol:(1+z)^3/4z^2", "(1+z)^2(1+z)/(4z^2)", "1/4*(z^-2+3z^-1+3+z)", "MASK:[1,3,3,1]/4"})
    same(written, "mask:[1,3,3,1]/4@-2");
  CHECK(specification_of(make_any_scheme("L1: points=6")) == specification_of(make_any_scheme("l1:points=6")));
  same("Chaikin", "bspline:degree=2");
  same("DD4", "dd:n=2");
  same("four_point", "four-point:w=1/16");
  same("Primal_Odd: n=2", "primal-odd:n=2");
  same("Catmull_Clark", "catmull-clark");
  same("tensor:(chaikin)x([1,2,1]/2)", "tensor:(bspline:degree=2)x(mask:[1,2,1]/2)");
  same("1/16[-1 0 9 16 9 0 -1]", "mask:[-1,0,9,16,9,0,-1]/16");
  same("[1 2 1; 2 4 2; 1 2 1]/4", "mask2:[[1,2,1],[2,4,2],[1,2,1]]/4");
  same("[[1,2,1],[2,4,2],[1,2,1]]/4,arity=2", "mask2:[[1,2,1],[2,4,2],[1,2,1]]/4");
  same("(1+x)(1+y)(1+xy)/2xy", "mask2:[[1,1,0],[1,2,1],[0,1,1]]/2@-1,-1");
  same("symbol:(1+x)^2(1+y)^2(1+z)^2/8,arity=2", "symbol3:((1+x)(1+y)(1+z))^2/8");
  same("(1+z+z^2)^3/9z^3,arity=3", "mask:[1,3,6,7,6,3,1]/9@-3,arity=3");
  // A blank between a number and a sign that holds no other blank parts two entries, as in MATLAB.
  CHECK(specification_as_written("[1 -2 1]/4") == "mask:[1,-2,1]/4");
  CHECK(specification_as_written("[1 - 2 1]/4") == "mask:[1-2,1]/4");
  CHECK(specification_as_written("mask:[1/2 + w, 1, 1/2 -w]") == "mask:[1/2+w,1,1/2-w]");
  for (const char* canonical : {"primal:n=3,d=1", "mask:[1,3,3,1]/4@-2", "mask2:[[1]]@0,0,dilation=[1,1;1,-1]",
                                "l1:points=6", "tensor:(primal:n=3)x(dual:n=2)", "", ":", "mask:"})
    CHECK(specification_as_written(canonical) == canonical);
  // What could be read in two ways is refused.
  for (const char* bad : {"[1,1 6,15]/16", "[1,2,1]/2 @ 1 0", "[10 20 10]/2 0", "(1+z)^3/4z^-2", "(1+z)^3/4 z^-2"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(make_linear_scheme(bad), SpecificationError);
  }
  std::string many;
  for (int i = 0; i < 5000; ++i) many += "(1+z)";
  CHECK_THROWS_WITH(make_linear_scheme(many), Catch::Contains("fewer terms"));
  CHECK_THROWS_WITH(make_scheme("1/4(1+z)^3"), Catch::Contains("how far the divisor goes"));
  CHECK_THROWS_WITH(make_parametric_scheme("[1/2w,1,1-1/2w]"), Catch::Contains("how far the divisor goes"));
  CHECK(make_parametric_scheme("(1+z)^2(-w+2wz+(1-2w)z^2+2wz^3-wz^4)/2z^3").specification ==
        make_parametric_scheme("mask:[-w/2,0,1/2+w/2,1,1/2+w/2,0,-w/2]").specification);
  CHECK_THROWS_WITH(make_linear_scheme("chaikn"), Catch::Contains("did you mean 'chaikin'?"));
  CHECK_THROWS_WITH(make_linear_scheme("[1,3,3,1]/5"), Catch::Contains("read as 'mask:[1,3,3,1]/5'"));
}

TEST_CASE("malformed specifications are refused, with position") {
  std::ifstream file(std::string(SUBCERT_TEST_DATA) + "/malformed_specifications.txt");
  REQUIRE(file);
  int count = 0;
  for (std::string line; std::getline(file, line); ++count) check_refused(unescaped(line));
  CHECK(count >= 200);
  check_refused(std::string(2'000'000, '['));
  check_refused("mask:[" + std::string(100'000, '1') + "]");
  std::string many = "mask:[1";
  for (int i = 0; i < 50'000; ++i) many += ",0";
  check_refused(many + "]");
  check_refused("regression:stencils=" + std::string(50'000, '(') + ",at=[0;1]");
}

TEST_CASE("every prefix and every single change of a specification is read or refused") {
  for (const std::string valid :
       {"primal:n=3,d=1", "mask:[1,3,3,1]/4@-2,arity=2", "four-point:w=1/16", "cdf:n=2,m=4",
        "mask:[1+t,3+t,3-t,1-t]/4@0,arity=2,where=t^2-3:1.7..1.8",
        "regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1,weights=[1;2;1|1;2;2;1],first=-1"}) {
    const auto attempt = [](const std::string& text) {
      try {
        (void)make_scheme(text);
      } catch (const SpecificationError&) {
      }
    };
    for (std::size_t i = 0; i < valid.size(); ++i) {
      attempt(valid.substr(0, i));
      std::string changed = valid;
      for (char c : {'0', '9', '-', ',', ';', '[', ']', '=', '/', ':', '.', '\0', '\xff'}) {
        changed[i] = c;
        attempt(changed);
      }
    }
  }
}

TEST_CASE("a canonical specification reads as itself") {
  for (const char* text : {"primal:n=3",
                           "primal:d=3,n=2",
                           "primal:n=1,d=0",
                           "primal:n=50,d=9",
                           "dual:n=3",
                           "primal-odd:n=2,d=2",
                           "dual-odd:n=4,d=3",
                           "dual:n=2,d=99",
                           "ary:a=3,points=4,d=3",
                           "ary:a=4,points=5",
                           "dd:n=3",
                           "bspline:degree=3",
                           "bspline:degree=2,a=3",
                           "four-point:w=1/16",
                           "four-point:w=-2/40",
                           "four-point:w=0",
                           "mask:[1,3,3,1]/4",
                           "mask:[1/4,3/4,3/4,1/4]@7",
                           "mask:[0,1,2,1,0]/2",
                           "mask:[1,2,3,2,1]/3,arity=3",
                           "mask:[+1,1]@-0",
                           "regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1",
                           "regression:at=[0;1/2],stencils=[-1..1;-1..2],weights=[1;2;1|1;2;2;1],first=-1"}) {
    const Scheme once = make_scheme(text), twice = make_scheme(once.specification);
    CAPTURE(text, once.specification);
    CHECK(twice.specification == once.specification);
    CHECK(twice.mask.curve() == once.mask.curve());
    CHECK(!once.title.empty());
  }
  CHECK(make_scheme("primal:n=3").specification == "primal:n=3,d=1");
  CHECK(make_scheme("mask:[1,3,3,1]/4").specification == "mask:[1,3,3,1]/4@-2");
  CHECK(make_scheme("bspline:degree=3,a=2").specification == "bspline:degree=3");
}

TEST_CASE("families agree where they should") {
  for (int n = 1; n <= 4; ++n) {
    const std::string number = std::to_string(n), even = std::to_string(2 * n), odd = std::to_string(2 * n + 1);
    CHECK(make_scheme("dual:n=" + number).mask.curve() == make_scheme("ary:a=2,points=" + even).mask.curve());
    CHECK(make_scheme("dual-odd:n=" + number).mask.curve() == make_scheme("ary:a=2,points=" + odd).mask.curve());
    CHECK(make_scheme("dd:n=" + number).mask.curve() ==
          make_scheme("primal:n=" + number + ",d=" + std::to_string(2 * n - 1)).mask.curve());
  }
  CHECK(make_scheme("four-point:w=1/16").mask.curve() == make_scheme("dd:n=2").mask.curve());
  CHECK(make_scheme("bspline:degree=2").mask.curve() == make_scheme("dual:n=1").mask.curve());
  CHECK(make_scheme("regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1").mask.curve() ==
        make_scheme("primal:n=2").mask.curve());
  for (const FamilyHelp& family : families()) CHECK_NOTHROW(make_scheme(family.usage));
}

TEST_CASE("the error says what, where and what would be right") {
  try {
    (void)make_scheme("dual:n=3,m=2");
    FAIL("accepted");
  } catch (const SpecificationError& error) {
    CHECK(error.token() == "m");
    CHECK(error.position() == 10);
    CHECK(error.expected() == "a key of dual:n=3,d=1");
  }
}

TEST_CASE("classical families by name") {
  const auto mask_of = [](const char* text) { return make_scheme(text).mask.curve(); };
  CHECK(mask_of("four-point:w=1/16").symbol() == mask_of("dd:n=2").symbol());
  CHECK(mask_of("six-point:w=0").symbol() == mask_of("dd:n=2").symbol());
  CHECK(mask_of("six-point:w=3/256").symbol() == mask_of("dd:n=3").symbol());
  CHECK(mask_of("ternary-four-point:w=1/27").symbol() == mask_of("dd:n=2,a=3").symbol());
  CHECK(mask_of("dd:n=1,a=4").symbol() == mask_of("bspline:degree=1,a=4").symbol());
  CHECK(mask_of("j-spline:w=0").symbol() == mask_of("dd:n=2").symbol());
  CHECK(mask_of("j-spline:w=1").symbol() == mask_of("bspline:degree=3").symbol());
  CHECK(mask_of("j-spline:w=3/2").symbol() == mask_of("bspline:degree=5").symbol());
  CHECK(mask_of("corner-cutting:w=1/4").symbol() == mask_of("bspline:degree=2").symbol());
  CHECK(mask_of("dual-four-point:w=1/128").symbol() == mask_of("mask:[-5,-7,35,105,105,35,-7,-5]/128").symbol());
  CHECK(mask_of("ternary-three-point:w=5/18").arity() == 3);
  for (int m = 1; m <= 6; ++m) {
    const std::string text = "pseudo-spline:m=" + std::to_string(m) + ",l=";
    CHECK(make_scheme(text + "0").mask.curve().symbol() ==
          make_scheme("bspline:degree=" + std::to_string(2 * m - 1)).mask.curve().symbol());
    CHECK(make_scheme(text + std::to_string(m - 1)).mask.curve().symbol() ==
          make_scheme("dd:n=" + std::to_string(m)).mask.curve().symbol());
  }
  CHECK(mask_of("pseudo-spline:m=3/2,l=0").symbol() == mask_of("bspline:degree=2").symbol());
  CHECK(mask_of("pseudo-spline:m=5/2,l=1").symbol() == mask_of("dual-four-point:w=1/128").symbol());
  for (int twice = 4; twice <= 12; ++twice) {
    const auto degrees = polynomial_reproduction(
        make_scheme("pseudo-spline:m=" + std::to_string(twice) + "/2,l=1").mask.curve());
    CHECK(degrees.generation_degree() == twice - 1);
    CHECK(degrees.reproduction_degree == 3);
  }
  CHECK(polynomial_reproduction(mask_of("pseudo-spline:m=3/2,l=1")).reproduction_degree == 2);
  CHECK(mask_of("pseudo-spline:m=3,l=1").symbol() == mask_of("mask:[-3,-8,12,72,110,72,12,-8,-3]/128").symbol());
}

TEST_CASE("coefficients that are algebraic numbers") {
  const Scheme scheme = make_scheme("mask:[1+t,3+t,3-t,1-t]/4@0,where=t^2-3:1.7..1.8");
  REQUIRE(scheme.rounding);
  CHECK(scheme.rounding->sum_rules == 2);
  CHECK(scheme.rounding->distance < power(Rational(2), -1000));
  CHECK(scheme.mask.curve().symbol().multiplicity(LaurentPolynomial::all_ones(2)) == 2);
  // (4 a_0 - 1)^2 = 3, nearly.
  const Rational root = 4 * scheme.mask.curve().symbol().coefficient(0) - 1;
  CHECK(abs(root * root - 3) < power(Rational(2), -1000));
  CHECK(make_scheme(scheme.specification).mask.curve() == scheme.mask.curve());
  // The same number by another polynomial, and with powers that are reduced.
  CHECK(make_scheme("mask:[1+t^3/3,3+t,3-t,1-t]/4@0,where=(t^2-3)*(t^2+1):1.7..1.8").mask.curve() ==
        scheme.mask.curve());
  // Rational numbers are exact.
  const Scheme exact = make_scheme("mask:[t,1-t,1-t,t],where=(4*t-1)*(t-2):0..1");
  CHECK_FALSE(exact.rounding);
  CHECK(exact.mask.curve() == make_scheme("mask:[1,3,3,1]/4").mask.curve());
}

TEST_CASE("Daubechies' masks are near to orthonormal ones") {
  CHECK(make_scheme("daubechies:n=1").mask.curve().symbol() == LaurentPolynomial({1, 1}, 0));
  CHECK_FALSE(make_scheme("daubechies:n=1").rounding);
  for (const int n : {2, 3, 5, 10, 21}) {
    const Scheme scheme = make_scheme("daubechies:n=" + std::to_string(n));
    REQUIRE(scheme.rounding);
    CHECK(scheme.rounding->sum_rules == n);
    CHECK(scheme.mask.curve().symbol().multiplicity(LaurentPolynomial::all_ones(2)) == n);
    const LaurentPolynomial& a = scheme.mask.curve().symbol();
    CHECK(a.length() == 2 * n);
    // The autocorrelation a(z) a(1/z) / 2 is the interpolatory mask of Deslauriers and Dubuc.
    const LaurentPolynomial difference = LaurentPolynomial(Rational(1, 2)) * a * a.reversed() -
                                         make_scheme("dd:n=" + std::to_string(n)).mask.curve().symbol();
    for (const Rational& c : difference.coefficients()) CHECK(abs(c) < 8 * n * scheme.rounding->distance);
    // The larger coefficients come first.
    CHECK(abs(a.coefficient(0)) > abs(a.coefficient(2L * n - 1)));
  }
  const Scheme algebraic = make_scheme("mask:[1+t,3+t,3-t,1-t]/4@0,where=t^2-3:1.7..1.8");
  const LaurentPolynomial difference = make_scheme("daubechies:n=2").mask.curve().symbol() -
                                       algebraic.mask.curve().symbol();
  for (const Rational& c : difference.coefficients()) CHECK(abs(c) < power(Rational(2), -300));
}

TEST_CASE("duals of B-splines") {
  // (1 + z)^2 (-1 + 4 z - z^2) / 4, dual to the hat.
  CHECK(make_scheme("cdf:n=2,m=2").mask.curve().symbol() ==
        LaurentPolynomial({Rational(-1, 4), Rational(1, 2), Rational(3, 2), Rational(1, 2), Rational(-1, 4)}, -2));
  for (const auto& [n, m] : {std::pair{1, 3}, {2, 4}, {3, 5}, {4, 4}}) {
    const Mask dual = make_scheme("cdf:n=" + std::to_string(n) + ",m=" + std::to_string(m)).mask.curve();
    CHECK(dual.symbol().multiplicity(LaurentPolynomial::all_ones(2)) == m);
    // The product of dual symbols is interpolatory.
    const LaurentPolynomial product = LaurentPolynomial(Rational(1, 2)) * dual.symbol() *
                                      bspline_mask(n == 1 ? 1 : n - 1).symbol();
    if (n == 1) continue;
    for (const long parity : {0L, 1L}) {
      const LaurentPolynomial half = product.coset(2, parity);
      if (half.length() == 1) CHECK(half.coefficient(half.lowest()) == 1);
    }
    CHECK((product.coset(2, 0).length() == 1 || product.coset(2, 1).length() == 1));
  }
}

TEST_CASE("masks with two letters, by their values") {
  const std::string_view six_points = "mask:[t,0,-w-3*t,0,1/2+w+2*t,1,1/2+w+2*t,0,-w-3*t,0,t]";
  const ParametricMask mask = make_parametric_mask(six_points, "wt");
  CHECK(mask.at({Rational(1, 16), 0}) == make_scheme("four-point:w=1/16").mask.curve());
  CHECK(make_parametric_mask(six_points, "tw").at({0, Rational(1, 16)}) == mask.at({Rational(1, 16), 0}));
  CHECK_THROWS_AS(make_parametric_mask("four-point:w", "wt"), SpecificationError);
  CHECK_THROWS_AS(make_parametric_mask("mask:[w,1-w+s]@0", "wt"), SpecificationError);
}

TEST_CASE("matrices with letters are those with numbers in their place") {
  const std::string matrices = "[[[{0},1],[0,1/2]],[[1,1],[{0},0]]]@-1";
  for (const char* form : {"refinable", "vector", "hermite"}) {
    CAPTURE(form);
    const std::string text = form + (":" + matrices);
    CHECK(make_parametric_mask(fmt::format(fmt::runtime(text), "w"), "w").lattice_mask_at({Rational(1, 3)}) ==
          make_refinable_scheme(fmt::format(fmt::runtime(text), "1/3")).mask);
  }
}
