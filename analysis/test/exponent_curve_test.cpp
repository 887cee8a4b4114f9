// Envelopes of the exponent over a parameter: they hold the exponents of the schemes at single values.
#include <subcert/analysis/family/exponent_curve.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <algorithm>

using namespace subcert;
using subcert::testing::Random;

namespace {

Rational number(const char* text) { return *parse_rational(text); }

ExponentCurve curve_of(const char* scheme, const char* low, const char* high, int pieces) {
  return exponent_curve(make_parametric_scheme(scheme).mask, number(low), number(high),
                        {pieces, 2, {Deadline::in(60)}});
}

}  // namespace

TEST_CASE("envelopes hold the exponents at single values") {
  struct Case {
    const char *scheme, *low, *high;
  };
  Random random;
  for (const Case& c : {Case{"four-point:w", "-1/4", "1/4"}, Case{"mask:[w^2,1/2,1-2*w^2,1/2,w^2]", "-3/4", "3/4"},
                        Case{"mask:[-1/2*w,1/2-1/2*w,1,1/2+1/2*w,1/2*w]", "-1", "3/2"}}) {
    const ExponentCurve curve = curve_of(c.scheme, c.low, c.high, 40);
    REQUIRE(curve.pieces.size() == 40);
    CHECK(curve.pieces.front().proof.low == number(c.low));
    CHECK(curve.pieces.back().proof.high == number(c.high));
    for (std::size_t k = 1; k < curve.pieces.size(); ++k)
      CHECK(curve.pieces[k].proof.low == curve.pieces[k - 1].proof.high);
    const ParametricMask mask = make_parametric_scheme(c.scheme).mask;
    for (int round = 0; round < 8; ++round) {
      const Rational w = number(c.low) + (number(c.high) - number(c.low)) * Rational(random.integer(1, 998), 999);
      const auto piece = std::find_if(curve.pieces.begin(), curve.pieces.end(),
                                      [&](const CurvePiece& p) { return p.proof.low <= w && w <= p.proof.high; });
      REQUIRE(piece != curve.pieces.end());
      const Enclosure exponent = holder_regularity(mask.at(w), 8, {Deadline::in(10)}).exponent;
      CAPTURE(c.scheme, to_text(w));
      if (exponent.upper && *piece->exponent.lower > 0) CHECK(*piece->exponent.lower <= *exponent.upper);
      if (piece->exponent.upper) CHECK(*exponent.lower <= *piece->exponent.upper);
    }
  }
}

TEST_CASE("the exponent of the 4-point scheme over its tension") {
  const ExponentCurve curve = curve_of("four-point:w", "0", "1/4", 60);
  CHECK(curve.sum_rules == 2);
  for (const CurvePiece& piece : curve.pieces) {
    CHECK(*piece.exponent.lower > 0);
    REQUIRE(piece.exponent.upper);
    if (!piece.proof.below) {  // no product leads around the value with more sum rules
      CHECK((piece.proof.low <= number("1/16") && number("1/16") <= piece.proof.high));
      CHECK(*piece.exponent.upper == 2);
      continue;
    }
    // 2 - log2(1 + sqrt(1 - 16 w)) below 1/16; another product beyond.
    CHECK(piece.proof.below->word == (piece.proof.high <= number("1/16") ? std::vector{0} : std::vector{1, 0}));
  }
  REQUIRE(curve.special.size() == 1);
  CHECK(curve.special[0].exponent->is_exact());
  CHECK(*curve.special[0].exponent->lower == 2);
}

TEST_CASE("curves of what is no family are refused") {
  CHECK_THROWS_AS(curve_of("four-point:w", "1", "0", 10), Error);
  CHECK_THROWS_AS(curve_of("four-point:w", "0", "1", 0), Error);
}
