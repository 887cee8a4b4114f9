// Properties of families with a parameter: what is proved and refuted agrees with the schemes at single values, and the
// ends are those that are known.
#include <subcert/analysis/family/family_radius.hpp>
#include <subcert/analysis/family/property_range.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <ctime>

using namespace subcert;
using subcert::testing::Random;

namespace {

Rational q(const char* text) { return *parse_rational(text); }

PropertyRange range_of(const char* scheme, const char* property, const char* low, const char* high,
                       const Rational& width = power(Rational(10), -9)) {
  return property_range(make_parametric_scheme(scheme).mask, *parse_range_property(property), q(low), q(high),
                        {width, 2, {Deadline::in(60)}});
}

/// The verdicts, as y, n and ?, of pieces and single points.
std::string verdicts(const PropertyRange& range) {
  std::string text;
  for (const RangePiece& piece : range.pieces)
    text += piece.holds == Truth::yes ? 'y' : piece.holds == Truth::no ? 'n' : '?';
  return text;
}

void check_cover(const PropertyRange& range, const Rational& low, const Rational& high) {
  REQUIRE_FALSE(range.pieces.empty());
  CHECK(range.pieces.front().low == low);
  CHECK(range.pieces.back().high == high);
  for (std::size_t k = 1; k < range.pieces.size(); ++k) CHECK(range.pieces[k].low == range.pieces[k - 1].high);
}

}  // namespace

TEST_CASE("the 4-point scheme is C1 between 0 and a cubic number") {
  const PropertyRange range = range_of("four-point:w", "C1", "-2/5", "1");
  CHECK(range.sum_rules == 2);
  check_cover(range, q("-2/5"), 1);
  CHECK(verdicts(range) == "n?y?n");
  const Rational width = power(Rational(10), -8);
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}})
    CHECK(range.pieces[k].high - range.pieces[k].low < width);
  CHECK(range.pieces[1].low <= 0);
  CHECK(range.pieces[1].high >= 0);
  // [HMR09]: near 0.19273.
  CHECK(range.pieces[3].low > q("19272/100000"));
  CHECK(range.pieces[3].high < q("19274/100000"));
  REQUIRE_FALSE(range.ends.empty());
  const RangeEnd& end = range.ends.back();
  CHECK(end.polynomial == LaurentPolynomial({-1, 4, 0, 32}, 0));
  CHECK(count_real_roots(end.polynomial, range.pieces[3].low, range.pieces[3].high) == 1);
  // At 1/16 there are four sum rules.
  REQUIRE(range.special.size() == 1);
  CHECK(range.special[0].value.is_exact());
  CHECK(*range.special[0].value.lower == q("1/16"));
  CHECK(range.special[0].holds == Truth::yes);
}

TEST_CASE("the ternary 4-point scheme is C2 exactly between 1/15 and 1/9") {
  const PropertyRange range = range_of(
      "mask:[-1/18+1/6*u,-1/18-1/6*u,0,7/18-1/2*u,13/18+1/2*u,1,13/18+1/2*u,7/18-1/2*u,0,-1/18-1/6*u,-1/18+1/6*u],"
      "arity=3",
      "C2", "0", "1/5");
  CHECK(range.sum_rules == 3);
  CHECK(verdicts(range) == "n?y?n");
  REQUIRE(range.ends.size() == 2);
  CHECK(range.ends[0].polynomial == LaurentPolynomial({-1, 15}, 0));  // [HIDS02]
  CHECK(range.ends[1].polynomial == LaurentPolynomial({-1, 9}, 0));
}

TEST_CASE("ends of Hoelder ranges are zeros of exact polynomials") {
  const PropertyRange range = range_of("four-point:w", "holder>=3/2", "0", "1/5");
  CHECK(verdicts(range) == "n?y?n");
  REQUIRE(range.ends.size() == 2);
  CHECK(range.ends[0].polynomial == LaurentPolynomial({-1, 16, 64}, 0));
}

TEST_CASE("ranges agree with schemes at single values") {
  Random random;
  for (const char* property : {"convergent", "C1", "C2", "holder>=3/2"}) {
    const PropertyRange range = range_of("four-point:t", property, "-3/4", "3/4", power(Rational(10), -4));
    check_cover(range, q("-3/4"), q("3/4"));
    const RangeProperty asked = *parse_range_property(property);
    for (int round = 0; round < 12; ++round) {
      const Rational w(random.integer(-74, 74), 99);
      const auto piece = std::find_if(range.pieces.begin(), range.pieces.end(),
                                      [&](const RangePiece& p) { return p.low <= w && w <= p.high; });
      REQUIRE(piece != range.pieces.end());
      const Enclosure exponent =
          holder_regularity(make_scheme("four-point:w=" + to_text(w)).mask.curve(), 8, {Deadline::in(10)}).exponent;
      CAPTURE(property, to_text(w));
      if (piece->holds == Truth::yes) CHECK(*exponent.lower > asked.order);
      if (piece->holds == Truth::no) CHECK_FALSE(*exponent.lower > asked.order);
    }
  }
}

TEST_CASE("single values in gaps are looked at on their own") {
  // At w = 0 the hat function, between schemes that are smoother, as coefficients are positive on both sides of 0 only.
  const PropertyRange range = range_of("mask:[w^2,1/2,1-2*w^2,1/2,w^2]", "C1", "-1/4", "1/4", power(Rational(10), -4));
  CHECK(verdicts(range) == "yny");
  CHECK(range.pieces[1].low == 0);
  CHECK(range.pieces[1].high == 0);
  CHECK_FALSE(range.pieces[0].high_included);
  CHECK_FALSE(range.pieces[2].low_included);
  // At w = 0 a hat of three times the width, with a sum rule more, whose scheme diverges.
  const PropertyRange hat = range_of("mask:[1/2,1/3*w^2,1/6*w^2,1-2/3*w^2,1/6*w^2,1/3*w^2,1/2-1/3*w^2]", "convergent",
                                     "-1/2", "1/2");
  CHECK(verdicts(hat) == "yny");
  REQUIRE(hat.special.size() == 1);
  CHECK(hat.special[0].why == SpecialValue::Why::sum_rules);
  CHECK(hat.special[0].holds == Truth::no);
  // The hat between schemes that are rougher.
  const PropertyRange rough = range_of("mask:[-w^2,1/2,1+2*w^2,1/2,-w^2]", "C1", "-1/4", "1/4",
                                       power(Rational(10), -4));
  CHECK(verdicts(rough) == "n?n");
  REQUIRE(rough.special.size() == 1);
  CHECK(rough.special[0].value.is_exact());
  CHECK(*rough.special[0].value.lower == 0);
  CHECK(rough.special[0].why == SpecialValue::Why::threshold);
  CHECK(rough.special[0].holds == Truth::no);
  // A hat of three times the width at -1/2: a continuous function, but the scheme does not converge.
  const PropertyRange at_half = range_of("four-point:w", "C1", "-3/4", "-1/4");
  CHECK(std::ranges::all_of(at_half.special, [](const SpecialValue& one) { return one.holds == Truth::no; }));
  // Corner cutting: the quadratic spline at 1/4; shifts that are not stable at 1/2, where the reduced mask decides.
  const PropertyRange corner = range_of("mask:[w,1-w,1-w,w]", "C1", "1/8", "3/4");
  CHECK(verdicts(corner) == "nyn");
  REQUIRE(corner.special.size() == 2);
  CHECK(corner.special[0].holds == Truth::yes);
  CHECK(corner.special[1].why == SpecialValue::Why::unstable);
  CHECK(corner.special[1].holds == Truth::no);
}

TEST_CASE("a pair of complex eigenvalues bounds a radius over an interval") {
  // b = (-w, 1, 1, w): T_0 has a pair of eigenvalues with the product 1 + w^2.
  const ParametricMask mask = make_parametric_scheme("mask:[-1/2*w,1/2-1/2*w,1,1/2+1/2*w,1/2*w]").mask;
  family::FamilyRadius radius(transition_matrices(divided_difference_scheme(mask, 1)));
  for (const bool sharp : {false, true}) {
    const auto bound = radius.from_below({{1}, {q("3/2")}}, {0}, q("7/5"), sharp, Deadline());
    REQUIRE(bound);
    CHECK(bound->re == 0);
    CHECK(bound->im >= q("7/5"));
    CHECK(bound->im * bound->im < 2);
    if (sharp) CHECK(bound->im * bound->im > q("1999/1000"));
  }
  CHECK_FALSE(radius.from_below({{1}, {q("3/2")}}, {0}, q("3/2"), false, Deadline()));
  CHECK(in_one_letter(radius.characteristic({{0}, 0, q("3/2")}, Deadline()))
            .divided_by(LaurentPolynomial({-5, 0, 4}, 0))
            .remainder.is_zero());
}

TEST_CASE("no property above the sum rules but at special values") {
  const PropertyRange range = range_of("four-point:w", "C2", "0", "1/8", power(Rational(10), -3));
  CHECK(verdicts(range).find('y') == std::string::npos);
  REQUIRE(range.special.size() == 1);
  // The 4-point scheme has the exponent 2 with a logarithm.
  CHECK(range.special[0].holds == Truth::no);
}

TEST_CASE("where shifts are stable") {
  // (1 + z)(w + (1-w) z^2)... : [w, w, 1-w, 1-w] has the cosets w + (1-w) z, twice.
  const PropertyRange range = range_of("mask:[w,w,1-w,1-w]", "stable", "-1", "2");
  check_cover(range, -1, 2);
  for (const RangePiece& piece : range.pieces) {
    if (piece.low == piece.high) continue;
    const Rational middle = (piece.low + piece.high) / 2;
    CHECK((piece.holds == Truth::yes) <=
          has_stable_shifts(make_parametric_scheme("mask:[w,w,1-w,1-w]").mask.at(middle)).is_yes());
  }
  const PropertyRange hat = range_of("mask:[w,1/2,1-2*w,1/2,w]", "stable", "-1", "1");
  check_cover(hat, -1, 1);
}

TEST_CASE("control matrices hold the family in their hull") {
  for (const char* text : {"mask:[w^2,1/2,1-2*w^2,1/2,w^2]", "mask:[1,1+w,w]/(1+w)", "mask:[1,w-2,w-3]/(w-2)"}) {
    CAPTURE(text);
    const ParametricMask mask = make_parametric_scheme(text).mask;
    const ParametricFamily family = transition_matrices(mask);
    const Rational low = q("-1/3"), high = q("1/2"), w = q("1/7");
    const auto controls = family.controls({{low}, {high}});
    REQUIRE(controls);
    const MatrixFamily at = family.at({w});
    const LaurentPolynomial denominator = family.mask.denominator();
    const Rational u = (w - low) / (high - low), v = 1 - u;
    const auto n = static_cast<std::size_t>(family.mask.degree());
    // In the one family the binomials, in the others the values of the denominator at the ends.
    const std::vector<Rational> weights = n == 2 ? std::vector<Rational>{v * v, 2 * u * v, u * u}
                                                 : std::vector<Rational>{v * denominator(low), u * denominator(high)};
    Rational total = 0;
    for (const Rational& weight : weights) total += weight;
    for (std::size_t t = 0; t < 2; ++t) {
      RationalMatrix sum(family.size(), family.size());
      for (std::size_t k = 0; k <= n; ++k)
        for (std::size_t i = 0; i < family.size(); ++i)
          for (std::size_t j = 0; j < family.size(); ++j)
            sum(i, j) += weights[k] / total * (*controls)[(n + 1) * t + k](i, j);
      CHECK(sum == at[t]);
    }
    CHECK(at.matrices() == transition_matrices(mask.at(w)));
  }
  CHECK_FALSE(transition_matrices(make_parametric_scheme("mask:[1,1+w,w]/(1+w)").mask).controls({{-2}, {0}}));
}

TEST_CASE("a family with denominators has the range of the same family without") {
  // Corner cutting with w = 1/(1 + v).
  const PropertyRange direct = range_of("corner-cutting:w", "C1", "1/10", "2/5"),
                      quotient = range_of("mask:[1,v,v,1]/(1+v)", "C1", "3/2", "9");
  CHECK(verdicts(direct) == verdicts(quotient));
  const PropertyRange convergent = range_of("mask:[1,v,v,1]/(1+v)", "convergent", "11/10", "9");
  CHECK(verdicts(convergent) == "y");
  CHECK_THROWS_AS(range_of("mask:[1,v,v,1]/(1+v)", "C1", "-2", "0"), Error);
}

TEST_CASE("signs of the differences over a parameter") {
  // a = (w, 1-w, 1-w, w), b = 2 (w, 1-2w, w).
  const PropertyRange positive = range_of("corner-cutting:w", "positive", "-1", "2");
  check_cover(positive, -1, 2);
  CHECK(verdicts(positive) == "nyn");
  CHECK(positive.pieces[1].low == 0);
  CHECK(positive.pieces[1].high == 1);
  CHECK(positive.pieces[1].low_included);
  CHECK_FALSE(positive.pieces[2].low_included);
  const PropertyRange monotone = range_of("corner-cutting:w", "monotone", "-1", "2");
  CHECK(verdicts(monotone) == "nyn");
  CHECK(monotone.pieces[1].high == q("1/2"));
  // Irrational ends are enclosed: 2 - w^2 changes its sign.
  const PropertyRange square = range_of("mask:[1-w^2/2,1/2,w^2/2,1/2]", "positive", "0", "2");
  CHECK(verdicts(square) == "y?n");
  CHECK(square.complete);
  REQUIRE_FALSE(square.special.empty());
  CHECK(square.special.back().why == SpecialValue::Why::sign);
  // The 4-point scheme keeps signs nowhere else, and monotone data for w = 0 only.
  CHECK(verdicts(range_of("four-point:w", "positive", "-1/2", "0")) == "y");
  CHECK(verdicts(range_of("four-point:w", "positive", "1/100", "1")) == "n");
  CHECK_THROWS_AS(range_of("corner-cutting:w", "convex", "0", "1"), Error);
}

TEST_CASE("Sobolev exponents over a parameter") {
  const PropertyRange range = range_of("four-point:w", "sobolev>=1", "-1", "1");
  check_cover(range, -1, 1);
  // At -1/2 it is the hat function of three times the width, whose shifts are not stable.
  CHECK(verdicts(range) == "nynyn");
  CHECK(range.pieces[1].low == q("-1/2"));
  CHECK(range.pieces[1].high == q("-1/2"));
  CHECK(range.pieces[3].low == q("-1/8"));
  CHECK(range.pieces[3].high == q("1/4"));
  CHECK(range.pieces[3].low_included);
  CHECK(range.pieces[3].high_included);
  REQUIRE(range.ends.size() == 2);
  CHECK(range.ends[1].word.empty());
  CHECK(range.ends[1].holds == Truth::yes);
  // Both ends are zeros of one polynomial.
  const PropertyRange irrational = range_of("six-point:w", "sobolev>=3", "0", "1/10");
  CHECK(verdicts(irrational) == "n?y?n");
  CHECK(irrational.complete);
  REQUIRE(irrational.ends.size() == 2);
  CHECK(irrational.ends[0].polynomial == irrational.ends[1].polynomial);
  // Above the sum rules for all w: at special values only.
  CHECK(verdicts(range_of("four-point:w", "sobolev>=12/5", "0", "1/4")) == "nyn");
  CHECK(verdicts(range_of("four-point:w", "sobolev>=5/2", "0", "1/4")) == "n");
  CHECK(verdicts(range_of("mask:[1,v,v,1]/(1+v)", "sobolev>=1", "2", "9")) == "nyn");
  // Polynomials of large degree are not looked for.
  CHECK_FALSE(range_of("six-point:w", "sobolev>=3001/1000", "0", "1/10").complete);
}

TEST_CASE("ranges of Sobolev exponents agree with schemes at single values") {
  Random random;
  for (const char* scheme : {"four-point:t", "mask:[1,t,t,1]/(1+t)", "ternary-four-point:t", "corner-cutting:t"})
    for (const char* property : {"sobolev>=1/2", "sobolev>=1", "sobolev>=5/3"}) {
      const PropertyRange range = range_of(scheme, property, "-3/4", "3/4");
      check_cover(range, q("-3/4"), q("3/4"));
      const RangeProperty asked = *parse_range_property(property);
      for (int round = 0; round < 12; ++round) {
        const Rational w(random.integer(-74, 74), 99);
        const auto piece = std::find_if(range.pieces.begin(), range.pieces.end(), [&](const RangePiece& p) {
          return (p.low_included ? p.low <= w : p.low < w) && (p.high_included ? w <= p.high : w < p.high);
        });
        const Mask mask = make_parametric_scheme(scheme).mask.at(w);
        const Enclosure exponent = sobolev_regularity(mask).exponent;
        CAPTURE(scheme, property, to_text(w));
        if (piece->holds == Truth::yes) CHECK(*exponent.lower >= asked.order);
        if (piece->holds == Truth::no) CHECK(*exponent.lower < asked.order);
      }
    }
}

TEST_CASE("specifications of families") {
  CHECK(make_parametric_scheme("four-point:w").mask.to_text('w') == "[-w,0,1/2+w,1,1/2+w,0,-w]@-3");
  CHECK(make_parametric_scheme("mask:[1-t,1,t]/1@0").specification == "mask:[1-t,1,t]@0");
  for (const char* bad :
       {"mask:[1,2,1]/2", "mask:[v,1-v,w,1-w]", "mask:[w,1]", "mask:[w,1/w]", "four-point:", "mask:[w,1-w,w*,1]",
        "primal:n=w", "mask:", "mask:[w,w,1-w,1-w]@x", "mask:[w^13,1,1-w^13]", "mask:[1,1,w]/(1+w",
        "mask:[1,1+w,w]/(w-w)", "mask:[w,1,1-w]/(1+v)", "regression:stencils=[-1..1;-1..2],at=[0;1/2],d=1",
        "regression:stencils=[-1..1;-1..2],at=[0;w],weights=[v;1;1|1;1;1;1]",
        "regression:stencils=[-1..1;-1..2],at=[0;w],weights=[0;w;1|1;1;1;1]",
        "regression:stencils=[-1..1;-1..2],at=[0;w],weights=[1;1|1;1;1;1]",
        "regression:stencils=[-40..40;-40..40],at=[0;w],d=3"})
    CHECK_THROWS_AS(make_parametric_scheme(bad), SpecificationError);
  for (const char* bad :
       {"", "C", "C-1", "C1/2", "holder>=", "holder>=-1", "C1000", "smooth", "holder>2", "sobolev>=", "sobolev>=-1"})
    CHECK_FALSE(parse_range_property(bad));
}

TEST_CASE("zeros in intervals") {
  const LaurentPolynomial p = LaurentPolynomial({-2, 0, 1}, 0) * LaurentPolynomial({-1, 1}, 0) *
                              LaurentPolynomial({0, 1}, 0);
  CHECK(count_real_roots(p, -2, 2) == 4);
  CHECK(count_real_roots(p, 0, 1) == 0);
  CHECK(count_real_roots(p, 0, 2) == 2);
  CHECK(count_real_roots(p * p, -2, 2) == 4);
  const auto roots = real_roots(p, -2, 2, power(Rational(10), -6));
  REQUIRE(roots.size() == 4);
  CHECK(roots[1].is_exact());
  CHECK(*roots[3].lower * *roots[3].lower < 2);
  CHECK(*roots[3].upper * *roots[3].upper > 2);
  CHECK(interpolation({0, 1, 3}, {1, 2, 10}) == LaurentPolynomial({1, 0, 1}, 0));
  RationalMatrix m(2, 2);
  m(0, 0) = 2, m(0, 1) = 1, m(1, 0) = 1, m(1, 1) = 1;
  CHECK(determinant(m) == 1);
}

TEST_CASE("equal matrices of a family with a symmetry leave no symmetry that is none") {
  // At some values two of the four control matrices are equal, and the flip exchanges others than the outer ones.
  for (const auto& [low, high] : {std::pair{"1/5", "3/4"}, {"-1", "1"}, {"1/5", "1"}}) {
    const PropertyRange range = range_of("mask:[w,1/2-w,1/2,1/2,1/2-w,w]", "convergent", low, high, q("1/100"));
    check_cover(range, q(low), q(high));
    for (const RangePiece& piece : range.pieces) {
      CAPTURE(piece.low, piece.high, piece.reason);
      CHECK(piece.reason.find("failed") == std::string::npos);
      CHECK(piece.reason.empty() == (piece.holds != Truth::unknown));
    }
  }
}

TEST_CASE("a range ends with its budget, with reasons") {
  for (const char* scheme : {"mask:[w,-1/8,-w,9/8,9/8,-w,-1/8,w]", "mask:[5/4+w,-w,-1/8,-1/8,-1/8,-1/8,-w,5/4+w]"}) {
    const ParametricScheme family = make_parametric_scheme(scheme);
    constexpr double seconds = 2;
    const std::clock_t start = std::clock();
    const PropertyRange range = property_range(family.mask, *parse_range_property("convergent"), q("1/5"), q("3/4"),
                                               {power(Rational(10), -9), 1, {Deadline::in(seconds)}});
    CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < 1.2 * seconds + 1);
    check_cover(range, q("1/5"), q("3/4"));
    for (const RangePiece& piece : range.pieces) CHECK(piece.reason.empty() == (piece.holds != Truth::unknown));
  }
  const PropertyRange none = property_range(make_parametric_scheme("four-point:w").mask, *parse_range_property("C1"), 0,
                                            1, {power(Rational(10), -9), 1, {Deadline::in(0)}});
  REQUIRE(none.pieces.size() == 1);
  CHECK(none.pieces.front().reason == "the budget ran out");
}

TEST_CASE("positive coefficients decide what a search leaves open beside an end") {
  const PropertyRange range = range_of("corner-cutting:w", "convergent", "0", "1");
  CHECK(verdicts(range) == "nyn");
  CHECK(range.complete);
  CHECK(range.pieces[1].low == 0);
  CHECK(range.pieces[1].high == 1);
  CHECK_FALSE((range.pieces[1].low_included || range.pieces[1].high_included));
  CHECK(range.pieces[0].low == range.pieces[0].high);
  // The values beside the range that is positive are not touched: [w,1-w,1-w,w] with w < 0.
  CHECK(verdicts(range_of("corner-cutting:w", "convergent", "-1/10", "1/2")).back() == 'y');
}
