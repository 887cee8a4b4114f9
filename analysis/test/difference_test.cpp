#include "specimens.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using subcert::testing::mask_of;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

/// By the definition: multiply the symbol out, sum |coefficients| over cosets.
Rational norm_by_definition(const Mask& mask, int level) {
  LaurentPolynomial power_of_symbol = 1;
  long factor = 1;
  for (int k = 0; k < level; ++k, factor *= mask.arity()) power_of_symbol *= mask.symbol().dilated(factor);
  std::vector<Rational> sums(static_cast<std::size_t>(factor), 0);
  std::size_t residue = 0;
  for (const Rational& c : power_of_symbol.coefficients()) {
    sums[residue] += abs(c);
    residue = (residue + 1) % sums.size();
  }
  return *std::max_element(sums.begin(), sums.end());
}

Mask random_mask(Random& random) {
  const int arity = static_cast<int>(random.integer(2, 4));
  LaurentPolynomial symbol = random.nonzero_polynomial(9);
  switch (random.integer(0, 3)) {
    case 0: symbol = symbol + symbol.reversed(); break;              // palindromic, odd
    case 1: symbol = symbol + symbol.reversed().shifted(-1); break;  // palindromic, even
    case 2: symbol *= LaurentPolynomial::all_ones(arity).pow(2); break;
    default: break;
  }
  return {symbol.is_zero() ? LaurentPolynomial(2) : symbol, arity};
}

}  // namespace

TEST_CASE("level norms are what their definition says") {
  Random random;
  for (const auto round : rounds(120)) {
    const Mask mask = random_mask(random);
    const int levels = mask.arity() == 2 ? 7 : mask.arity() == 3 ? 4 : 3;
    const LevelNorms result = level_norms(mask, levels);
    CAPTURE(mask.symbol().to_mask_text(), mask.arity());
    REQUIRE(static_cast<int>(result.norms.size()) == levels);
    for (int level = 1; level <= levels; ++level)
      CHECK(result.norms[static_cast<std::size_t>(level) - 1] == norm_by_definition(mask, level));
    CHECK(result.norms.front() == operator_norm(mask));
  }
}

TEST_CASE("ties, huge numbers and a spent budget") {
  // All cosets tie: the Haar mask and its powers.
  CHECK(level_norms(mask_of("mask:[1,1]"), 12).norms.back() == 1);
  // Beyond the range of double precision the answer is still exact.
  const Mask huge({LaurentPolynomial({power(Rational(10), 200), -1, 3}, 0)}, 2);
  CHECK(level_norms(huge, 4).norms.back() == norm_by_definition(huge, 4));
  const Mask small({LaurentPolynomial({power(Rational(10), -200), -power(Rational(10), -201)}, 0)}, 2);
  CHECK(level_norms(small, 4).norms.back() == norm_by_definition(small, 4));
  CHECK(level_norms(mask_of("primal:n=300"), 16, Deadline::in(1e-3)).norms.size() < 16);
  const Mask long_one = mask_of("primal:n=300");
  CHECK(level_norms(long_one, 9, Deadline::in(0)).norms.size() < 9);
  CHECK_THROWS_AS(level_norms(huge, 0), Error);
}

TEST_CASE("cosets that tie are summed in batches, and the deadline holds among them") {
  const Mask haar = mask_of("mask:[1,1]");  // all cosets have the sum 1
  const LevelNorms all = level_norms(haar, 15);
  CHECK(all.held == LevelNorms::most_held);
  CHECK(all.exact > LevelNorms::most_held);
  CHECK(all.norms == std::vector<Rational>(15, 1));
  const LevelNorms partial = level_norms(haar, 40, Deadline::in(0.3));
  CHECK(partial.norms.size() < 40);
  CHECK(partial.held <= LevelNorms::most_held);
  for (const Rational& norm : partial.norms) CHECK(norm == 1);
}

TEST_CASE("sum rules and divided difference schemes") {
  CHECK(sum_rules(mask_of("primal:n=4")) == 2);
  CHECK(sum_rules(mask_of("dual:n=4")) == 3);
  CHECK(sum_rules(mask_of("dd:n=3")) == 6);
  CHECK(sum_rules(mask_of("bspline:degree=4,a=3")) == 5);
  for (const char* text : {"primal:n=3", "dual-odd:n=2", "ary:a=3,points=4,d=3", "dd:n=2"}) {
    const Mask mask = mask_of(text);
    const int rules = sum_rules(mask);
    for (int k = 0; k <= rules; ++k) {
      const LaurentPolynomial factor = LaurentPolynomial::all_ones(mask.arity()).pow(k) *
                                       LaurentPolynomial(power(Rational(mask.arity()), -k));
      CHECK(divided_difference_scheme(mask, k).symbol() * factor == mask.symbol());
    }
    CHECK_THROWS_AS(divided_difference_scheme(mask, rules + 1), Error);
    CHECK_THROWS_AS(divided_difference_scheme(mask, -1), Error);
  }
}

TEST_CASE("convergence is proved or refuted") {
  for (const char* text :
       {"primal:n=1", "primal:n=7", "dual:n=5", "dd:n=2", "dd:n=5", "four-point:w=1/5", "primal:n=4,d=3",
        "ary:a=3,points=4,d=3", "ary:a=5,points=3", "bspline:degree=1", "mask:[1,2,2,2,1]/4"}) {
    CAPTURE(text);
    CHECK(converges(mask_of(text)).is_yes());
  }
  for (const char* text : {"mask:[1,1]", "mask:[1,0,0,1]", "mask:[1,1,0,0,0,0]", "four-point:w=1/2", "mask:[2,1,-1]",
                           "mask:[1,1,1],arity=3"}) {
    CAPTURE(text);
    const Decision decision = converges(mask_of(text));
    CHECK(decision.is_no());
    CHECK(!decision.reason.empty());
  }
  const Mask wrong_sums(LaurentPolynomial::parse_mask("[1,3,3,2]/4"), 2);
  CHECK(converges(wrong_sums).is_no());
  CHECK(proved_smoothness(wrong_sums).order == -1);
  CHECK_FALSE(has_positive_mask(wrong_sums));
  // Positive but no longer than the arity: the theorem does not apply, and the scheme diverges.
  CHECK_FALSE(has_positive_mask(mask_of("mask:[1,1]")));
  CHECK(has_positive_mask(mask_of("mask:[1,2,1]/2")));
}

TEST_CASE("smoothness proved by divided differences") {
  for (int degree = 1; degree <= 5; ++degree)
    for (int arity = 2; arity <= 3; ++arity)
      CHECK(proved_smoothness(mask_of("bspline:degree=" + std::to_string(degree) + ",a=" + std::to_string(arity)))
                .order == degree - 1);
  CHECK(proved_smoothness(mask_of("dd:n=2")).order == 1);
  CHECK(proved_smoothness(mask_of("dd:n=3")).order == 2);
  for (int n = 2; n <= 10; ++n) {
    CAPTURE(n);
    CHECK(proved_smoothness(mask_of("primal:n=" + std::to_string(n))).order == 1);
    CHECK(proved_smoothness(mask_of("dual:n=" + std::to_string(n))).order == 2);
    CHECK(proved_smoothness(mask_of("dual-odd:n=" + std::to_string(n))).order == 2);
  }
}

TEST_CASE("proofs of convergence of many long coefficients end with their budget") {
  const Mask mask = mask_of("daubechies:n=24");
  const Stopwatch watch;
  const SmoothnessProof proof = proved_smoothness(mask, {16, Deadline::in(0)});
  CHECK(!proof.obstacle.empty());
  CHECK(watch.seconds() < 1);
}

TEST_CASE("what a short look at powers proves is proved in any time, so that more time never tells less") {
  for (const char* scheme : {"four-point", "primal:n=4,d=3", "ary:a=3,points=5,d=1", "dual:n=6,d=1"}) {
    CAPTURE(scheme);
    CHECK(converges(make_scheme(scheme).mask, {16, Deadline::in(0)}).is_yes());
  }
}
