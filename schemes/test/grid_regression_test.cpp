#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/grid_regression.hpp>
#include <subcert/schemes/local_regression.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

using Exponents = MultivariatePolynomial::Exponents;

/// All exponents of total degree at most `degree`.
std::vector<Exponents> exponents_up_to(std::size_t variables, long degree) {
  std::vector<Exponents> result{{}};
  for (std::size_t v = 0; v < variables; ++v) {
    std::vector<Exponents> longer;
    for (const Exponents& e : result) {
      long sum = 0;
      for (long x : e) sum += x;
      for (long x = 0; sum + x <= degree; ++x) {
        longer.push_back(e);
        longer.back().push_back(x);
      }
    }
    result = longer;
  }
  return result;
}

Rational monomial(const Exponents& exponents, const std::vector<Rational>& x) {
  Rational product = 1;
  for (std::size_t v = 0; v < x.size(); ++v)
    for (long k = 0; k < exponents[v]; ++k) product *= x[v];
  return product;
}

/// The same weights from the normal equations in the monomial basis.
std::vector<Rational> by_normal_equations(const std::vector<std::vector<Rational>>& nodes, int degree,
                                          const std::vector<Rational>& x) {
  std::vector<std::vector<Rational>> points{{}};
  for (const auto& axis : nodes) {
    std::vector<std::vector<Rational>> longer;
    for (const Rational& t : axis)
      for (const auto& point : points) {
        longer.push_back(point);
        longer.back().push_back(t);
      }
    points = longer;
  }
  const auto basis = exponents_up_to(nodes.size(), degree);
  RationalMatrix gram(basis.size(), basis.size()), right(basis.size(), 1);
  for (std::size_t a = 0; a < basis.size(); ++a) {
    for (std::size_t b = 0; b < basis.size(); ++b)
      for (const auto& point : points) gram(a, b) += monomial(basis[a], point) * monomial(basis[b], point);
    right(a, 0) = monomial(basis[a], x);
  }
  const RationalMatrix u = solve(gram, right);
  std::vector<Rational> result;
  for (const auto& point : points) {
    Rational sum = 0;
    for (std::size_t a = 0; a < basis.size(); ++a) sum += u(a, 0) * monomial(basis[a], point);
    result.push_back(sum);
  }
  return result;
}

std::vector<Rational> range(long first, long last) {
  std::vector<Rational> result;
  for (long i = first; i <= last; ++i) result.emplace_back(i);
  return result;
}

Scheme surface(const std::string& text) { return make_linear_scheme(text); }

Rational coefficient(const Scheme& scheme, long i, long j) { return scheme.mask.symbol().coefficient({i, j}); }

}  // namespace

TEST_CASE("products of orthogonal polynomials and normal equations give the same weights") {
  Random random;
  for (const auto round : rounds(20)) {
    std::vector<std::vector<Rational>> nodes;
    std::vector<Rational> x;
    const bool three = random.chance(30);
    const int degree = static_cast<int>(random.integer(0, three ? 2 : 3));
    for (int v = 0; v < (three ? 3 : 2); ++v) {
      std::vector<Rational> axis;
      for (long i = 0, t = -3; i < degree + 1 + random.integer(0, 2); ++i)
        axis.push_back(Rational(t += random.integer(1, 3), 2));
      nodes.push_back(axis);
      x.push_back(random.rational());
    }
    CHECK(grid_regression_weights(nodes, degree, x) == by_normal_equations(nodes, degree, x));
  }
}

TEST_CASE("the closed forms of degree 1 on 2n x 2n and (2n+1) x (2n+1) grids") {
  for (long n = 1; n <= 6; ++n) {  // [MLZD15, App. B.2]
    const Scheme even = surface("grid:points=" + std::to_string(2 * n) + "x" + std::to_string(2 * n));
    const Rational xi = Rational(1, 2 * n * n * (4 * n * n - 1));
    for (long r = -n + 1; r <= n; ++r)
      for (long s = -n + 1; s <= n; ++s) {
        CHECK(coefficient(even, -2 * r, -2 * s) == xi / 4 * (8 * n * n - 6 * r - 6 * s + 4));
        CHECK(coefficient(even, 1 - 2 * r, -2 * s) == xi / 4 * (8 * n * n + 6 * r - 6 * s - 2));
        CHECK(coefficient(even, -2 * r, 1 - 2 * s) == xi / 4 * (8 * n * n - 6 * r + 6 * s - 2));
        CHECK(coefficient(even, 1 - 2 * r, 1 - 2 * s) == xi / 4 * (8 * n * n + 6 * r + 6 * s - 8));
      }
    const Scheme odd = surface("grid:points=" + std::to_string(2 * n + 1) + "x" + std::to_string(2 * n + 1));
    const Rational scale = Rational(1, (2 * n + 1) * (2 * n + 1)), slope = Rational(3, 4 * n * (n + 1));
    for (long r = -n; r <= n; ++r)
      for (long s = -n; s <= n; ++s) {
        CHECK(coefficient(odd, -1 - 2 * r, -1 - 2 * s) == scale * (1 - slope * (r + s)));
        CHECK(coefficient(odd, -2 * r, -1 - 2 * s) == scale * (1 + slope * (r - s)));
        CHECK(coefficient(odd, -1 - 2 * r, -2 * s) == scale * (1 - slope * (r - s)));
        CHECK(coefficient(odd, -2 * r, -2 * s) == scale * (1 + slope * (r + s)));
      }
  }
}

TEST_CASE("the printed coefficients of degree 3 on (2n+1) x (2n+1) grids") {
  // [MB16, eq. (3.9)], beta_1, ..., beta_10 as printed; those not printed by exchanging r and s.
  for (long n = 2; n <= 5; ++n) {
    const Rational scale = Rational(n - 1) * (n + 2) * (2 * n - 1) * (2 * n + 3) * n * n * (n + 1) * (n + 1) *
                           (2 * n + 1) * (2 * n + 1);
    const auto value = [&](long r, long s, const Rational& x, const Rational& y) {
      const auto b1 = [&] {
        return Rational((n - 1) * (n + 2) * n * n * (n + 1) * (n + 1)) *
               (14 * n * n + 14 * n - 15 * r * r - 15 * s * s - 3);
      };
      const auto b2 = [&](long p, long q) {
        return Rational(5 * p * n * (n + 1)) *
               (18 * n * n * n * n + 36 * n * n * n - (9 * q * q + 21 * p * p + 3) * n * n -
                (21 * p * p + 9 * q * q + 21) * n + 7 * p * p + 18 * q * q + 5);
      };
      const auto b4 = [&](long p) { return Rational(-15 * n * (n - 1) * (n + 1) * (n + 2)) * (n * n + n - 3 * p * p); };
      const Rational b5 = Rational(9 * r * s * (n - 1) * (n + 2)) * (2 * n - 1) * (2 * n + 3);
      const auto b7 = [&](long p) { return Rational(-35 * p * n * (n + 1)) * (3 * n * n + 3 * n - 5 * p * p - 1); };
      const auto b8 = [&](long p, long q) { return Rational(-45 * q * (n - 1) * (n + 2)) * (n * n + n - 3 * p * p); };
      return Rational((b1() + b2(r, s) * x + b2(s, r) * y + b4(r) * x * x + b5 * x * y + b4(s) * y * y +
                       b7(r) * x * x * x + b8(r, s) * x * x * y + b8(s, r) * x * y * y + b7(s) * y * y * y) /
                      scale);
    };
    const std::vector<Rational> position{Rational(-1, 4), Rational(1, 4)};
    const auto weights = grid_regression_weights({range(-n, n), range(-n, n)}, 3, position);
    std::size_t differences = 0;
    for (long s = -n; s <= n; ++s)
      for (long r = -n; r <= n; ++r)
        if (weights[static_cast<std::size_t>((s + n) * (2 * n + 1) + r + n)] != value(r, s, position[0], position[1]))
          ++differences;
    CAPTURE(n);
    CHECK(differences == 0);
  }
}

TEST_CASE("the printed coefficients of degree 3 on 4 x 4 data") {
  // [MB16, eq. (3.7)]: the denominator is printed for every n, the coefficients are those of n = 2.
  const long n = 2;
  const Rational scale = Rational(4 * (n - 1)) * (2 * n + 3) * (2 * n - 3) * (n + 1) * n * n * (2 * n - 1) *
                         (2 * n - 1) * (2 * n + 1) * (2 * n + 1);
  const auto b1 = [](long r, long s) {
    return 9450 * r * r * r + (1890 * s - 19845) * r * r + (1890 * s * s - 3024 * s - 10773) * r + 9450 * s * s * s -
           19845 * s * s - 10773 * s + 35154;
  };
  const auto b2 = [](long r, long s) {
    return -13650 * r * r * r + (1890 * s + 14805) * r * r - (3780 * s * s - 378 * s - 31731) * r + 1890 * s * s -
           3024 * s - 10773;
  };
  const auto b4 = [](long r, long s) {
    return -15750 * r * r * r - (1890 * s - 29295) * r * r + (1890 * s + 14805) * r + 1890 * s - 19845;
  };
  const auto b5 = [](long r, long s) {
    return (-3780 * s + 1890) * r * r - (3780 * s * s - 10584 * s - 378) * r + 1890 * s * s + 378 * s - 3024;
  };
  const auto b7 = [](long r) { return 1050 * (2 * r - 1) * (5 * r * r - 5 * r - 9); };
  const auto b8 = [](long r, long s) { return 1890 * (2 * s - 1) * (r * r - r - 1); };
  const Scheme scheme = surface("grid:points=4x4,d=3");
  for (long p = 0; p < 2; ++p)
    for (long q = 0; q < 2; ++q)
      for (long r = -1; r <= 2; ++r)
        for (long s = -1; s <= 2; ++s) {
          const Rational x(2 * p + 1, 4), y(2 * q + 1, 4);
          const Rational value = b1(r, s) + b2(r, s) * x + b2(s, r) * y + b4(r, s) * x * x + b5(r, s) * x * y +
                                 b4(s, r) * y * y + b7(r) * x * x * x + b8(r, s) * x * x * y + b8(s, r) * x * y * y +
                                 b7(s) * y * y * y;
          CHECK(coefficient(scheme, p - 2 * r, q - 2 * s) == value / scale);
        }
}

TEST_CASE("specifications of two and three variables are read and printed back") {
  for (const char* text :
       {"tensor:(primal:n=3,d=1)x(dual:n=2,d=1)", "tensor:(mask:[1,3,3,1]/4@-2)x(bspline:degree=3)x(dd:n=2)",
        "grid:points=4x4,d=3", "grid:points=5x4,d=2", "grid:points=3x3x3,d=1", "grid:points=4x4,d=1,a=3",
        "tensor:(ary:a=3,points=4,d=3)x(bspline:degree=2,a=3)",
        "tensor:(regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1)x(four-point:w=1/16)"})
    CHECK(specification_of(make_any_scheme(text)) == text);
  CHECK(specification_of(make_any_scheme("primal:n=3")) == "primal:n=3,d=1");
  CHECK(specification_of(make_any_scheme("grid:points=04x2")) == "grid:points=4x2,d=1");
  const auto product = surface("tensor:(mask:[1,2,1]/2)x(mask:[1,1])");
  CHECK(to_mask_text(product.mask) == "[[1,2,1],[1,2,1]]/2@-1,-1");
  CHECK(product.mask.factors().size() == 2);
  CHECK(to_mask_text(surface("grid:points=2x2").mask) == "[[0,1,1,0],[1,2,2,1],[1,2,2,1],[0,1,1,0]]/4@-2,-2");

  const auto error = [](std::string_view text) {
    try {
      make_any_scheme(text);
    } catch (const SpecificationError& caught) {
      return std::to_string(caught.position()) + " " + caught.token();
    }
    return std::string("none");
  };
  CHECK(error("tensor:") == "8 ");
  CHECK(error("tensor") == "1 tensor");
  CHECK(error("tensor:(primal:n=3)") == "8 (primal:n=3)");
  CHECK(error("tensor:(primal:n=3)x(dual:n=0)") == "29 0");
  CHECK(error("tensor:(primal:n=3)x(dual:m=2)") == "27 m");
  CHECK(error("tensor:(primal:n=3)x(ary:a=65,points=4)") == "28 65");
  CHECK(error("tensor:(primal:n=3)(dual:n=2)") == "20 (dual:n=2)");
  CHECK(error("tensor:(primal:n=3)x") == "21 ");
  CHECK(error("tensor:(primal:n=3)x(dual:n=2") == "21 (dual:n=2");
  CHECK(error("tensor:(dd:n=1)x(dd:n=1)x(dd:n=1)x(dd:n=1)").substr(0, 2) == "8 ");
  CHECK(error("tensor:(tensor:(dd:n=1)x(dd:n=1))x(dd:n=1)") == "9 tensor");
  CHECK(error("tensor:(dual:n=200)x(dual:n=200)") == "22 dual:n=200");
  CHECK(error("grid:") == "1 grid");
  CHECK(error("grid:points=4") == "13 4");
  CHECK(error("grid:points=4x1") == "15 1");
  CHECK(error("grid:points=4x4x4x4") == "13 4x4x4x4");
  CHECK(error("grid:points=4x4,d=-1") == "19 -1");
  CHECK(error("grid:points=4x4,n=1") == "17 n");
  CHECK(error("grid:points=400x400") == "13 400x400");
  CHECK(error("other:n=1") == "1 other");
  CHECK_THROWS_AS(make_scheme("grid:points=4x4"), SpecificationError);
}
