#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/classical.hpp>
#include <subcert/schemes/specification.hpp>
#include <subcert/schemes/vector_schemes.hpp>

#include <fmt/format.h>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

LatticeMask mask_of(const std::string& text) { return make_refinable_scheme(text).mask; }

/// A_k of a mask of one variable.
RationalMatrix matrix(const LatticeMask& mask, long k) {
  const std::size_t size = mask.components();
  RationalMatrix result(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) result(i, j) = mask.entries()[i * size + j].coefficient({k});
  return result;
}

/// The derivative of an order of a polynomial, given by its coefficients, at x.
Rational derivative(const std::vector<Rational>& polynomial, std::size_t order, const Rational& x) {
  Rational sum = 0;
  for (std::size_t n = polynomial.size(); n-- > order;) {
    Rational factor = 1;
    for (std::size_t i = 0; i < order; ++i) factor *= static_cast<long>(n - i);
    sum = sum * x + factor * polynomial[n];
  }
  return sum;
}

/// The B-spline of this degree that begins at the knot with this index, by its recursion in the degree.
Rational bspline(int degree, int multiplicity, long first, const Rational& x) {
  const auto knot = [&](long k) { return Rational(k / multiplicity); };
  if (degree == 0) return knot(first) <= x && x < knot(first + 1) ? 1 : 0;
  const Rational up = knot(first + degree) - knot(first), down = knot(first + degree + 1) - knot(first + 1);
  Rational value = 0;
  if (up != 0) value += (x - knot(first)) / up * bspline(degree - 1, multiplicity, first, x);
  if (down != 0) value += (knot(first + degree + 1) - x) / down * bspline(degree - 1, multiplicity, first + 1, x);
  return value;
}

std::string refusal_of(const std::string& text) {
  try {
    (void)make_refinable_scheme(text);
  } catch (const SpecificationError& error) {
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return std::to_string(error.position()) + " '" + error.token() + "' " + error.expected();
  }
  return "accepted";
}

MultivariateRegularity regularity(const LatticeMask& mask) { return vector_regularity(mask, {Deadline::in(20)}); }

bool is_exactly(const Enclosure& exponent, const Rational& value) {
  return exponent.lower == value && exponent.upper == value;
}

/// As narrow as a product that is proved to attain the radius makes it.
bool is_closely(const Enclosure& exponent, const Rational& value) {
  return exponent.contains(value) && *exponent.upper - *exponent.lower < power(Rational(10), -30);
}

/// The mask of the functions phi(parts x - i), i = 0, ..., parts - 1.
LatticeMask polyphase_mask(const Mask& mask, long parts) {
  std::vector<MultivariatePolynomial> entries;
  const IndexRange range = support(mask);
  for (long i = 0; i < parts; ++i)
    for (long c = 0; c < parts; ++c) {
      std::vector<Monomial> terms;
      for (long m = -200; m <= 200; ++m)
        if (const long k = parts * m + c - mask.arity() * i; k >= range.first && k <= range.last)
          if (const Rational a = mask.symbol().coefficient(k); a != 0) terms.push_back({a, {m}});
      entries.emplace_back(1, terms);
    }
  return {std::move(entries), Dilation::multiple(1, mask.arity())};
}

}  // namespace

TEST_CASE("names of vectors of functions read as themselves") {
  for (const char* text : {"merrien:lambda=-1/8,mu=1/2", "merrien:lambda=0,mu=0", "hermite-dd:points=4,order=2",
                           "hermite-dd:points=2,order=3,a=3", "cl:2", "cl:3", "bat:1", "bat:2", "bat:3", "sa4",
                           "bspline:degree=3,multiplicity=2", "bspline:degree=2,multiplicity=2,a=3", "ghm",
                           "tensor:(ghm)x(ghm)", "tensor:(ghm)x(bspline:degree=1)", "tensor:(dd:n=1)x(ghm)x(dd:n=1)",
                           "tensor:(merrien:lambda=-1/8,mu=-1/2)x(refinable:[[[1,0],[0,1]],[[1,0],[0,1]]]@0)"}) {
    CAPTURE(text);
    const Scheme scheme = make_refinable_scheme(text);
    CHECK(scheme.specification == text);
    CHECK(scheme.form.has_value());
    CHECK(scheme.mask.components() > 1);
    CHECK(make_refinable_scheme(scheme.specification).mask == scheme.mask);
  }
}

TEST_CASE("what is no vector is the scheme of numbers") {
  CHECK(make_refinable_scheme("bspline:degree=3").specification == "bspline:degree=3");
  CHECK(make_refinable_scheme("bspline:degree=3,multiplicity=1,a=3").specification == "bspline:degree=3,a=3");
  CHECK(make_refinable_scheme("hermite-dd:points=4,order=1").specification == "dd:n=2");
  CHECK(make_refinable_scheme("tensor:(dd:n=1)x(dd:n=2)").mask.factors().size() == 2);
}

TEST_CASE("matrices of vectors of functions, as they were computed by another program") {
  CHECK(mask_of("merrien:lambda=-1/8,mu=1/2") ==
        mask_of("refinable:[[[4,2],[-1,1]],[[8,0],[0,4]],[[4,-2],[1,1]]]/8@-1"));
  CHECK(mask_of("hermite-dd:points=2,order=2") == mask_of("merrien:lambda=-1/8,mu=-1/2"));
  CHECK(mask_of("hermite-dd:points=2,order=3") ==
        mask_of("refinable:[[[32,60,0],[-10,-14,24],[1,1,-4]],[[64,0,0],[0,32,0],[0,0,16]],"
                "[[32,-60,0],[10,-14,-24],[1,-1,-4]]]/64@-1"));
  CHECK(mask_of("hermite-dd:points=4,order=2") ==
        mask_of("refinable:[[[13,5],[-3,-1]],[[0,0],[0,0]],[[243,405],[-81,-81]],[[512,0],[0,256]],"
                "[[243,-405],[81,-81]],[[0,0],[0,0]],[[13,-5],[3,-1]]]/512@-3"));
  CHECK(mask_of("bspline:degree=3,multiplicity=2") ==
        mask_of("refinable:[[[2,5],[0,1]],[[6,2],[2,6]],[[1,0],[5,2]]]/8@0"));
  CHECK(mask_of("bspline:degree=2,multiplicity=2,a=3") ==
        mask_of("refinable:[[[3,4],[0,1]],[[5,4],[2,4]],[[3,0],[6,9]],[[0,0],[6,4]],[[0,0],[2,1]]]/9@0,arity=3"));
}

TEST_CASE("Hermite interpolation reproduces polynomials with as many coefficients as there are data") {
  Random random;
  for (const auto round : rounds(20)) {
    const int n = static_cast<int>(random.integer(1, 3)), order = static_cast<int>(random.integer(1, 4)),
              arity = static_cast<int>(random.integer(2, 4));
    CAPTURE(round, n, order, arity);
    const LatticeMask mask = hermite_interpolation_mask(n, order, arity);
    std::vector<Rational> polynomial(static_cast<std::size_t>(2 * n * order));
    for (Rational& c : polynomial) c = random.rational();
    const auto size = static_cast<std::size_t>(order);
    for (long i = -arity; i <= 2 * arity; ++i) {
      std::vector<Rational> refined(size, 0);
      for (long j = -20; j <= 20; ++j) {
        const RationalMatrix a = matrix(mask, i - arity * j);
        for (std::size_t k = 0; k < size; ++k)
          for (std::size_t m = 0; m < size; ++m) refined[m] += a(k, m) * derivative(polynomial, k, j);
      }
      for (std::size_t m = 0; m < size; ++m)
        CHECK(refined[m] ==
              power(Rational(arity), -static_cast<long>(m)) * derivative(polynomial, m, Rational(i, arity)));
    }
  }
  CHECK(hermite_interpolation_mask(3, 1) == LatticeMask(deslauriers_dubuc_mask(3)));
  CHECK(hermite_interpolation_mask(2, 1, 3) == LatticeMask(deslauriers_dubuc_mask(2, 3)));
}

TEST_CASE("B-splines with multiple knots satisfy their equation") {
  Random random;
  for (const auto round : rounds(20)) {
    const int degree = static_cast<int>(random.integer(1, 6)),
              multiplicity = static_cast<int>(random.integer(1, degree)),
              arity = static_cast<int>(random.integer(2, 4));
    CAPTURE(round, degree, multiplicity, arity);
    const LatticeMask mask = multiple_knot_bspline_mask(degree, multiplicity, arity);
    const Rational x(random.integer(1, 100 * (degree + 2)), 101);
    for (int p = 0; p < multiplicity; ++p) {
      Rational sum = 0;
      for (long k = 0; k <= 40; ++k)
        for (int c = 0; c < multiplicity; ++c)
          if (const Rational a = matrix(mask, k)(static_cast<std::size_t>(p), static_cast<std::size_t>(c)); a != 0)
            sum += a * bspline(degree, multiplicity, c, arity * x - k);
      CHECK(sum == bspline(degree, multiplicity, p, x));
    }
  }
  const LatticeMask simple = multiple_knot_bspline_mask(4, 1, 3), known(bspline_mask(4, 3));
  CHECK(simple.symbol() == known.symbol().shifted({-known.symbol().lowest().front()}));
}

namespace {

/// sum over k of A_k G A_{k+2l}^T.
RationalMatrix gram_step(const LatticeMask& mask, const RationalMatrix& gram, long l) {
  RationalMatrix sum(gram.rows(), gram.rows());
  for (long k = -8; k <= 8; ++k) {
    const RationalMatrix product = matrix(mask, k) * gram * transposed(matrix(mask, k + 2 * l));
    for (std::size_t i = 0; i < gram.rows(); ++i)
      for (std::size_t j = 0; j < gram.rows(); ++j) sum(i, j) += product(i, j);
  }
  return sum;
}

bool has_orthogonal_shifts(const LatticeMask& mask, const RationalMatrix& gram) {
  for (long l = -4; l <= 4; ++l)
    if (!(gram_step(mask, gram, l) == (l == 0 ? Rational(2) * gram : RationalMatrix(gram.rows(), gram.rows()))))
      return false;
  return true;
}

RationalMatrix diagonal(const std::vector<Rational>& entries) {
  RationalMatrix result(entries.size(), entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) result(i, i) = entries[i];
  return result;
}

}  // namespace

TEST_CASE("shifts of orthogonal multiwavelets are orthogonal") {
  CHECK(has_orthogonal_shifts(geronimo_hardin_massopust_mask(), diagonal({2, 1})));
  // With (x, y) for x + sqrt(D) y and [x, root y; y, x] for its matrix the transpose of a matrix over the field is
  // D^-1 [..]^T D for D = diag(1, root): its rows of y are scaled back.
  const auto is_orthogonal = [](const QuadraticMask& mask, const Rational& second) {
    return has_orthogonal_shifts(mask.doubled, diagonal({1, second, Rational(1, mask.root), second / mask.root}));
  };
  CHECK(is_orthogonal(chui_lian_mask(2), 1));
  CHECK(is_orthogonal(chui_lian_mask(3), 6));
  CHECK(is_orthogonal(shen_tan_tham_mask(), 1));
  for (const int order : {1, 2, 3}) CHECK(is_orthogonal(balanced_mask(order), 1));
  CHECK_FALSE(is_orthogonal(chui_lian_mask(3), 1));
}

TEST_CASE("masks over a quadratic field are rounded and doubled alike") {
  const QuadraticMask mask = chui_lian_mask(2);
  CHECK(mask.root == 7);
  CHECK(mask.components() == 2);
  CHECK(mask.at(2) == mask_of("refinable:[[[1,1],[-1,-1]],[[2,0],[0,1]],[[1,-1],[1,-1]]]/2@0"));
  CHECK(matrix(mask.doubled, 0) * matrix(mask.doubled, 2) == matrix(quadratic_mask({{{0}, 0, 0, {1, 4}, {1, 8}},
                                                                                    {{0}, 0, 1, {-1, 4}, {-1, 8}},
                                                                                    {{0}, 1, 0, {-7, 16}, {-1, 8}},
                                                                                    {{0}, 1, 1, {7, 16}, {1, 8}}},
                                                                                   2, 7, Dilation::multiple(1, 2))
                                                                        .doubled,
                                                                    0));
  CHECK_THROWS(quadratic_mask({{{0}, 0, 0, 1, 1}}, 1, 4, Dilation::multiple(1, 2)));
  CHECK_THROWS(quadratic_mask({{{0}, 0, 0, 1, 1}}, 1, -3, Dilation::multiple(1, 2)));
  CHECK_THROWS(quadratic_mask({{{0}, 1, 0, 1, 1}}, 1, 3, Dilation::multiple(1, 2)));
  for (const long root : {2, 7, 15199}) {
    const Rational value = rounded_root(root, 64), unit = power(Rational(2), -64);
    CHECK(value * value <= root);
    CHECK((value + unit) * (value + unit) > root);
  }
}

TEST_CASE("square roots may be typed in masks of matrices") {
  const std::string typed = "[[[2,2],[-sqrt(7),-sqrt(7)]],[[4,0],[0,2]],[[2,-2],[sqrt(7),-sqrt(7)]]]/4@0";
  const Scheme scheme = make_refinable_scheme("refinable:" + typed), named = make_refinable_scheme("cl:2");
  REQUIRE(scheme.quadratic);
  CHECK(scheme.quadratic->root == 7);
  CHECK(scheme.quadratic->doubled == named.quadratic->doubled);
  CHECK(scheme.mask == named.mask);
  CHECK(scheme.rounding->distance == named.rounding->distance);
  CHECK(scheme.specification == "refinable:" + typed);
  CHECK(make_refinable_scheme(scheme.specification).specification == scheme.specification);
  // the other spellings of the root, and the transposed matrices
  const Scheme again = make_refinable_scheme(
      "refinable:[[[1/2,1/2],[-7/(4*sqrt(7)),-sqrt(28)/8]],[[1,0],[0,1/2]],[[1/2,-1/2],[sqrt(7)/4,-sqrt(7)/4]]]");
  CHECK(again.specification == "refinable:" + typed.substr(0, typed.size() - 2) + "@-1");
  const Scheme transposed = make_refinable_scheme(
      "vector:[[[2,-sqrt(7)],[2,-sqrt(7)]],[[4,0],[0,2]],[[2,sqrt(7)],[-2,-sqrt(7)]]]/4@0");
  CHECK(transposed.form == VectorForm::vector);
  CHECK(transposed.quadratic->doubled == named.quadratic->doubled);
  // roots of squares are rational
  CHECK_FALSE(make_refinable_scheme("refinable:[[[sqrt(4),0],[0,1]],[[1,0],[0,sqrt(1)]]]/2").quadratic);
  // as Geronimo, Hardin and Massopust print it
  const Scheme ghm = make_refinable_scheme(
      "refinable:[[[12,16*sqrt(2)],[-sqrt(2),-6]],[[12,0],[9*sqrt(2),20]],[[0,0],[9*sqrt(2),-6]],"
      "[[0,0],[-sqrt(2),0]]]/20@0");
  const Enclosure exponent = vector_regularity(*ghm.quadratic, {Deadline::in(20)}).exponent;
  CHECK(*exponent.lower <= 1);
  CHECK(*exponent.upper >= 1);
  CHECK(*exponent.upper - *exponent.lower < Rational(1, 1'000'000'000));
  // two functions beside each other: one by its integral
  const std::string both =
      "refinable:[[[2,2,0],[-sqrt(7),-sqrt(7),0],[0,0,2]],[[4,0,0],[0,2,0],[0,0,4]],"
      "[[2,-2,0],[sqrt(7),-sqrt(7),0],[0,0,2]]]/4@0";
  const Scheme several = make_refinable_scheme(both), one = make_refinable_scheme(both + ",integral=[0,0,1]");
  CHECK(vector_regularity(*several.quadratic, {Deadline::in(20)}).vector->solutions == 2);
  const MultivariateRegularity hat = vector_regularity(*one.quadratic, {Deadline::in(20)}, {.integral = one.integral});
  CHECK(hat.vector->solutions == 1);
  CHECK(*hat.exponent.lower > Rational(999, 1000));
  // an integral with the root, that of the matrices or one of its own
  const Scheme multiple = make_refinable_scheme(both + ",integral=[0,0,sqrt(28)-1]");
  CHECK(multiple.specification == both + ",integral=[0,0,-1+2*sqrt(7)]");
  CHECK(*multiple.integral == std::vector<Rational>{0, 0, -1, 0, 0, 2});
  CHECK(vector_regularity(*multiple.quadratic, {Deadline::in(20)}, {.integral = multiple.integral}).vector->solutions ==
        1);
  const std::string rational = "refinable:[[[2,0],[0,1]],[[4,0],[0,3]],[[2,0],[0,3]],[[0,0],[0,1]]]/4@-1";
  const Scheme own = make_refinable_scheme(rational + ",integral=[0,1/sqrt(3)]");
  CHECK(own.specification == rational + ",integral=[0,1/3*sqrt(3)]");
  CHECK(own.quadratic->root == 3);
  CHECK(make_refinable_scheme(own.specification).integral == own.integral);
  CHECK(*vector_regularity(*own.quadratic, {Deadline::in(20)}, {.integral = own.integral}).exponent.lower > 1);
  CHECK_FALSE(make_refinable_scheme(rational + ",integral=[0,sqrt(4)]").quadratic);
  for (const char* bad : {"[0,0,sqrt(2)]", "[sqrt(7),0]", "[sqrt(7)-sqrt(7),0,0]", "[0,0,sqrt(x)]", "[0,0,sqrt(7]"}) {
    CAPTURE(bad);
    CHECK(refusal_of(both + ",integral=" + bad) != "accepted");
  }
  CHECK(refusal_of("refinable:[[[sqrt(2),0],[0,1]],[[1,0],[0,sqrt(3)]]]")
            .find("'sqrt(3)' one square root in all entries, here multiples of sqrt(2)") != std::string::npos);
  CHECK(refusal_of("refinable:[[[sqrt(2,0],[0,1]],[[1,0],[0,1]]]") != "accepted");
}

/// Merrien's scheme with lambda = -1/8.
std::string merrien_text(const std::string& mu) {
  return fmt::format(
      "hermite:[[[1/2,-1/8],[1/2-({0})/2,({0})/4]],[[1,0],[0,1/2]],[[1/2,1/8],[({0})/2-1/2,({0})/4]]]@-1", mu);
}

TEST_CASE("square roots may be typed in masks of Hermite schemes") {
  const Rational narrow(1, 1'000'000'000);
  const auto regularity = [](const Scheme& scheme) {
    return *regularity_of(scheme.mask, {Deadline::in(20)}, {.quadratic = scheme.quadratic, .hermite = true}).surface;
  };
  // HC^1 for -3 < mu < 1, with the exponent 2 - log2(max(1, |1 + mu|))
  for (const auto& [mu, largest, converges] : {std::tuple{"sqrt(2)/4", Rational(135355339059, 100'000'000'000), true},
                                               {"-sqrt(2)", Rational(1), true},
                                               {"-2*sqrt(2)", Rational(182842712474, 100'000'000'000), true},
                                               {"sqrt(2)", Rational(241421356237, 100'000'000'000), false},
                                               {"-3*sqrt(2)", Rational(324264068711, 100'000'000'000), false}}) {
    CAPTURE(mu);
    const Scheme scheme = make_refinable_scheme(merrien_text(mu));
    REQUIRE(scheme.quadratic);
    CHECK(make_refinable_scheme(scheme.specification).quadratic->doubled == scheme.quadratic->doubled);
    const MultivariateRegularity found = regularity(scheme);
    CHECK(found.converges.truth == (converges ? Truth::yes : Truth::no));
    if (!converges) continue;
    CHECK(found.vector->hermite->order == 1);
    CHECK(abs(*found.exponent.lower - (2 - *log_ratio(largest, 2).lower)) < narrow);
    CHECK(*found.exponent.upper - *found.exponent.lower < narrow);
    CHECK(found.exact.is_yes());
  }
  CHECK_FALSE(make_refinable_scheme(merrien_text("sqrt(4)/4")).quadratic);
}

TEST_CASE("bicubic Hermite splines are products of cubic ones") {
  const std::string cubic = "merrien:lambda=-1/8,mu=-1/2", rough = "merrien:lambda=-1/8,mu=1/2";
  const auto regularity = [](const std::string& text) { return vector_regularity(mask_of(text), {Deadline::in(60)}); };
  const auto product = [](const std::string& a, const std::string& b) { return fmt::format("tensor:({})x({})", a, b); };
  const MultivariateRegularity bicubic = regularity(product(cubic, cubic));
  CHECK(is_exactly(bicubic.exponent, 2));
  CHECK(bicubic.exact.is_yes());
  CHECK(bicubic.space->family.size() == 30);
  REQUIRE(bicubic.vector->components.size() == 4);
  for (const ComponentRegularity& one : bicubic.vector->components) CHECK(is_exactly(one.exponent, 2));
  CHECK(is_closely(*bicubic.sobolev, Rational(5, 2)));
  // the worse of the two factors, also beside a scheme of numbers
  const Enclosure log = log_ratio(3, 2);
  for (const std::string& text : {product(rough, cubic), product("bspline:degree=3", rough)}) {
    CAPTURE(text);
    const Enclosure exponent = regularity(text).exponent;
    CHECK(*exponent.lower <= 3 - *log.lower);
    CHECK(*exponent.upper >= 3 - *log.upper);
    CHECK(*exponent.upper - *exponent.lower < Rational(1, 1'000'000'000));
  }
  CHECK(is_exactly(regularity(product(cubic, "hermite-dd:points=2,order=3")).exponent, 2));
  // values and derivatives, component (i, k) at 2 i + k
  constexpr int level = 2;
  const LatticeMask one = mask_of(cubic), both = mask_of(product(cubic, cubic));
  const auto value = [](const LatticeSequence& values, const LatticePoint& point) {
    const auto found = values.find(point);
    return found == values.end() ? Rational(0) : found->second;
  };
  const LatticeSequence along = limit_values(one, *vector_regularity(one, {Deadline::in(20)}).vector->values, level),
                        grid = limit_values(both, *bicubic.vector->values, level);
  for (long x = -4; x <= 4; ++x)
    for (long y = -4; y <= 4; ++y)
      for (long c = 0; c < 4; ++c) CHECK(value(grid, {x, y, c}) == value(along, {x, c / 2}) * value(along, {y, c % 2}));
  CHECK(value(grid, {2, 2, 0}) == Rational(1, 4));
  CHECK(value(grid, {2, 2, 3}) == Rational(1, 64));
}

TEST_CASE("tensor products of vectors have all products of components") {
  const LatticeMask a = mask_of("ghm"), b = mask_of("bspline:degree=3,multiplicity=2,a=3"),
                    product = mask_of("tensor:(ghm)x(bspline:degree=3,multiplicity=2,a=3)");
  CHECK(product.components() == 4);
  CHECK(product.dilation().rows() == std::vector<LatticePoint>{{2, 0}, {0, 3}});
  for (long k = 0; k <= 3; ++k)
    for (long l = 0; l <= 4; ++l)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
          CHECK(product.entries()[4 * i + j].coefficient({k, l}) ==
                matrix(a, k)(i / 2, j / 2) * matrix(b, l)(i % 2, j % 2));
}

TEST_CASE("exponents of vectors of functions by name") {
  const auto exponent = [](const std::string& text) { return regularity(mask_of(text)).exponent; };
  CHECK(is_exactly(exponent("ghm"), 1));
  CHECK(is_exactly(exponent("hermite-dd:points=2,order=2"), 2));
  CHECK(is_exactly(exponent("hermite-dd:points=2,order=3"), 3));
  CHECK(is_closely(exponent("hermite-dd:points=4,order=2"), 3));
  CHECK(is_exactly(exponent("merrien:lambda=-1/8,mu=-1"), 2));
  for (int degree = 2; degree <= 5; ++degree)
    for (int multiplicity = 2; multiplicity <= degree; ++multiplicity)
      CHECK(is_exactly(exponent(fmt::format("bspline:degree={},multiplicity={}", degree, multiplicity)),
                       degree - multiplicity + 1));
  CHECK(is_exactly(exponent("bspline:degree=4,multiplicity=2,a=3"), 3));
  // 2 - log2(max(1, |1 + mu|))
  // Where the order of differences that floating point proposes is not above the exponent.
  CHECK(exponent("merrien:lambda=-1/8,mu=-23/8").is_bounded());
  const Enclosure merrien = exponent("merrien:lambda=-1/8,mu=1/2"), log = log_ratio(Rational(3, 2), 2);
  CHECK(*merrien.lower <= 2 - *log.lower);
  CHECK(*merrien.upper >= 2 - *log.upper);
  CHECK(*merrien.upper - *merrien.lower < Rational(1, 1'000'000'000));
  const auto quadratic = [](const std::string& text) {
    return vector_regularity(*make_refinable_scheme(text).quadratic, {Deadline::in(20)});
  };
  const Rational narrow(1, 1'000'000'000);
  const Enclosure seven = log_ratio(7, 2);
  for (const char* text : {"cl:2", "bat:1"}) {
    const MultivariateRegularity found = quadratic(text);
    CHECK(found.vector->solutions == 1);
    CHECK(found.vector->components.size() == 2);
    CHECK(found.exact.is_yes());  // of all matrices that are so near to the rounded ones
    CHECK(*found.exponent.lower <= 2 - *seven.lower / 2);
    CHECK(*found.exponent.upper >= 2 - *seven.upper / 2);
    CHECK(*found.exponent.upper - *found.exponent.lower < narrow);
  }
  for (const auto& [text, value] : {std::pair{"cl:3", Rational(1)},
                                    {"sa4", Rational(9464003529, 10'000'000'000)},
                                    {"bat:2", Rational(11679675249, 10'000'000'000)},
                                    {"bat:3", Rational(10387198057, 10'000'000'000)}}) {
    CAPTURE(text);
    const MultivariateRegularity all = quadratic(text);
    const Enclosure& found = all.exponent;  // as enclosed by another program, to ten digits
    CHECK(*found.lower <= value + narrow / 10);
    CHECK(*found.upper >= value);
    CHECK(*found.upper - *found.lower < narrow);
    CHECK(all.exact.is_yes());
    for (const ComponentRegularity& one : all.vector->components) CHECK(one.exact.is_yes());
  }
  const auto sobolev = regularity(mask_of("ghm")).sobolev;
  REQUIRE(sobolev);
  CHECK(is_closely(*sobolev, Rational(3, 2)));
}

TEST_CASE("each B-spline is as smooth as the multiplicities of its own knots let it be") {
  for (const auto& [degree, multiplicity] : {std::pair{3, 2}, {4, 3}, {5, 4}, {4, 4}, {6, 4}}) {
    CAPTURE(degree, multiplicity);
    const auto found = regularity(multiple_knot_bspline_mask(degree, multiplicity)).vector->components;
    REQUIRE(static_cast<int>(found.size()) == multiplicity);
    for (int p = 0; p < multiplicity; ++p) {
      int most = 0;  // of the knots p, ..., p + degree + 1, which are rounded down to multiples of the multiplicity
      for (int first = 0; first <= degree + 1; ++first) {
        int times = 0;
        for (int k = p; k <= p + degree + 1; ++k) times += k / multiplicity == (p + first) / multiplicity ? 1 : 0;
        most = std::max(most, times);
      }
      CHECK(is_exactly(found[static_cast<std::size_t>(p)].exponent, degree - most + 1));
    }
  }
}

TEST_CASE("the parts of a function are as smooth as it is") {
  for (const char* text :
       {"dd:n=2", "bspline:degree=2", "four-point:w=1/20", "mask:[1,3,3,1]/4", "bspline:degree=3,a=3"}) {
    CAPTURE(text);
    const Mask mask = make_scheme(text).mask.curve();
    const Enclosure whole = holder_regularity(mask, 8, {Deadline::in(20)}).exponent;
    for (const long parts : {2, 3}) {
      const Enclosure exponent = regularity(polyphase_mask(mask, parts)).exponent;
      CHECK(*exponent.lower <= *whole.upper);
      CHECK(*exponent.upper >= *whole.lower);
      CHECK(*exponent.upper - *exponent.lower < Rational(1, 1'000'000));
    }
  }
}

TEST_CASE("names of vectors of functions that cannot be read") {
  CHECK(refusal_of("merrien:lambda=-1/8") == "1 'merrien' the key 'mu', as in merrien:lambda=-1/8,mu=-1/2");
  CHECK(refusal_of("merrien:lambda=x,mu=1").find("16 'x' an exact number") == 0);
  CHECK(refusal_of("hermite-dd:points=3,order=2") == "19 '3' points as an even number");
  CHECK(refusal_of("hermite-dd:points=64,order=2") == "28 '2' points * order <= 64 (here points = 64)");
  CHECK(refusal_of("hermite-dd:points=4,order=0").find("27 '0' order as an integer from 1") == 0);
  CHECK(refusal_of("bspline:degree=3,multiplicity=4") == "31 '4' multiplicity as an integer from 1 to 3");
  CHECK(refusal_of("bspline:degree=3,multiplicty=2").find("did you mean") != std::string::npos);
  CHECK(refusal_of("cl:4") == "4 '4' the number of cl as an integer from 2 to 3");
  CHECK(refusal_of("bat") == "1 'bat' bat:1");
  CHECK(refusal_of("sa4:2").find("nothing after sa4") != std::string::npos);
  CHECK(refusal_of("tensor:(cl:2)x(dd:n=1)") == "9 'cl:2' factors with rational coefficients");
  CHECK(refusal_of("ghm:1").find("nothing after ghm") != std::string::npos);
  CHECK(refusal_of("tensor:(ghm)x(gmh)").find("15 'gmh'") == 0);
  CHECK(refusal_of("tensor:(ghm)x(tensor:(ghm)x(ghm))x(ghm)").find("three variables") != std::string::npos);
  // What is rounded is no factor; tensor products of numbers alone are as they were.
  for (const char* other : {"ghm", "primal:n=2"})
    CHECK(refusal_of(std::string("tensor:(daubechies:n=2)x(") + other + ")").find("rational") != std::string::npos);
  CHECK(make_refinable_scheme("tensor:(primal:n=40)x(primal:n=40)").mask.factors().size() == 2);
  for (const char* text : {"bspline:degree=3,multiplicity=2", "tensor:(ghm)x(ghm)", "ghm", "merrien:lambda=0,mu=0"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(make_linear_scheme(text),
                      Catch::Contains("a scheme of numbers; of vectors 'subcert regularity'"));
    CHECK_THROWS_WITH(make_scheme(text), Catch::Contains("scheme of"));
  }
  CHECK_THROWS(multiple_knot_bspline_mask(2, 3));
  for (const auto& [n, order, arity] : {std::tuple(0, 2, 2), {2, 0, 2}, {2, 2, 1}})
    CHECK_THROWS_WITH(hermite_interpolation_mask(n, order, arity), Catch::Contains("need n >= 1, order >= 1"));
  CHECK_THROWS(vector_tensor_product({geronimo_hardin_massopust_mask()}));
}

TEST_CASE("matrices as papers and programs print them") {
  const std::string typed = "hermite:[[[4,-1],[6,-1]],[[8,0],[0,4]],[[4,1],[-6,-1]]]/8@-1";
  REQUIRE(make_refinable_scheme(typed).specification == typed);
  for (const char* body :
       {"[1/2,-1/8;3/4,-1/8],[1,0;0,1/2],[1/2,1/8;-3/4,-1/8]", "[1/2 -1/8;3/4 -1/8] [1 0;0 1/2]\n[1/2 1/8;-3/4 -1/8]",
        "[[1/2,-1/8;3/4,-1/8],[1,0;0,1/2],[1/2,1/8;-3/4,-1/8]]", "[[4,-1;6,-1],[8,0;0,4],[4,1;-6,-1]]/8",
        "[[1/2 -1/8\n3/4 -1/8],[1 0\n0 1/2],[1/2 1/8\n-3/4 -1/8]]",
        "A_{-1}=[1/2,-1/8;3/4,-1/8], A_0 = [1,0;0,1/2], A_{1} = [1/2,1/8;-3/4,-1/8]",
        "A_1 = [[1/2,1/8],[-3/4,-1/8]]; A_0=[[1,0],[0,1/2]]; A_{-1}=[[1/2,-1/8],[3/4,-1/8]]",
        "A(-1)=[1/2 -1/8;3/4 -1/8]\nA(0)=[1 0;0 1/2]\nA(1)=[1/2 1/8;-3/4 -1/8]",
        "A_{-1} = \\begin{pmatrix} 1/2 & -1/8 \\\\ \\frac34 & -1/8 \\end{pmatrix}, "
        "A_0 = \\begin{bmatrix} 1 & 0 \\\\ 0 & \\frac{1}{2} \\end{bmatrix}, A_1 = [1/2,1/8;-3/4,-1/8]"}) {
    CAPTURE(body);
    CHECK(make_refinable_scheme("hermite:" + std::string(body)).specification == typed);
  }
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      make_refinable_scheme(text);
      return "accepted";
    } catch (const SpecificationError& error) {
      return error.expected();
    }
  };
  CHECK(refusal("hermite:A_0=[1,0;0,1],A_2=[1,0;0,1]") == "a matrix for the index 1");
  CHECK(refusal("hermite:A_0=[1,0;0,1],A_0=[1,0;0,1]") == "one matrix for each index");
  CHECK(refusal("A_0=[1,0;0,1],A_1=[1,0;0,1]") == "refinable:, vector: or hermite: before the matrices");
  CHECK(refusal("hermite:[1,0;0,1,[1,0;0,1]") != "accepted");
}
