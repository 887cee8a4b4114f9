#include "specimens.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/regularity/holder_bound.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using subcert::testing::mask_of;

namespace {

Rational column_sum(const RationalMatrix& m, std::size_t column) {
  Rational sum = 0;
  for (std::size_t i = 0; i < m.rows(); ++i) sum += abs(m(i, column));
  return sum;
}

}  // namespace

TEST_CASE("sixteen levels give the digits of Tables 1 and 2") {
  const char* primal[] = {"1.649", "1.777", "1.816", "1.794", "1.786", "1.776", "1.771", "1.761", "1.753"};
  const char* dual[] = {"2.285", "2.647", "2.729", "2.677", "2.664", "2.633", "2.616", "2.594", "2.577"};
  for (int n = 2; n <= 10; ++n) {
    const auto bound = [&](const char* family) {
      return to_fixed(*holder_bounds(mask_of(family + std::to_string(n)), 16).last().exponent.lower, 3,
                      Rounding::nearest);
    };
    CHECK(bound("primal:n=") == primal[n - 2]);
    CHECK(bound("dual:n=") == dual[n - 2]);
  }
}

TEST_CASE("B-splines have their degree as bound, at every level and arity") {
  for (int arity = 2; arity <= 5; ++arity)
    for (int degree = 1; degree <= 5; ++degree) {
      const HolderBounds bounds = holder_bounds(
          mask_of("bspline:degree=" + std::to_string(degree) + ",a=" + std::to_string(arity)), 4);
      CHECK(bounds.sum_rules == degree + 1);
      for (const HolderBound& bound : bounds.levels) CHECK(bound.exponent.contains(degree));
      CHECK(bounds.last().exponent.is_exact());
    }
  CHECK_THROWS_AS(holder_bounds(Mask(LaurentPolynomial(2), 2), 4), Error);
}

TEST_CASE("products of transition matrices hold the powers of the symbol") {
  for (const char* text :
       {"primal:n=3", "dual:n=2", "dd:n=2", "ary:a=3,points=4,d=3", "ary:a=4,points=5", "four-point:w=1/7"}) {
    const Mask mask = mask_of(text);
    const Mask derived = divided_difference_scheme(mask, sum_rules(mask));
    const auto transitions = transition_matrices(derived);
    REQUIRE(transitions.size() == static_cast<std::size_t>(mask.arity()));
    // The norm of level 2 is the largest first column over products of two.
    Rational most = 0;
    for (const RationalMatrix& first : transitions)
      for (const RationalMatrix& second : transitions) most = std::max(most, column_sum(second * first, 0));
    CHECK(most == level_norms(derived, 2).norms.back());
  }
}

TEST_CASE("stability is decided exactly") {
  for (const char* text : {"primal:n=2", "primal:n=9", "dual:n=6", "dd:n=3", "bspline:degree=4", "bspline:degree=2,a=3",
                           "bspline:degree=3,a=4", "ary:a=3,points=4,d=3", "ary:a=6,points=4", "four-point:w=1/20"}) {
    CAPTURE(text);
    CHECK(has_stable_shifts(mask_of(text)).is_yes());
  }
  // Symmetric zeros: B-splines times 1 + z^2. Cyclic zeros: phi(x/3).
  CHECK(has_stable_shifts(mask_of("mask:[1,2,2,2,1]/4")).is_no());
  CHECK(has_stable_shifts(mask_of("mask:[1,0,0,1]")).is_no());
  CHECK(has_stable_shifts(mask_of("mask:[1,0,0,2,0,0,1]/2")).is_no());
  CHECK(has_stable_shifts(mask_of("mask:[1,0,2,0,3,0,2,0,1]/3,arity=3")).is_no());
}

TEST_CASE("Sobolev exponents of known functions") {
  for (int degree = 1; degree <= 4; ++degree)
    for (int arity = 2; arity <= 4; ++arity)
      CHECK(sobolev_regularity(mask_of("bspline:degree=" + std::to_string(degree) + ",a=" + std::to_string(arity)))
                .exponent.contains(Rational(2 * degree + 1, 2)));
  // [Eir92]: the 4-point and 6-point interpolatory schemes.
  const auto four = sobolev_regularity(mask_of("dd:n=2")).exponent,
             six = sobolev_regularity(mask_of("dd:n=3")).exponent;
  CHECK(to_fixed(*four.lower, 4, Rounding::nearest) == "2.4408");
  CHECK(to_fixed(*six.lower, 4, Rounding::nearest) == "3.1751");
  CHECK(*four.upper - *four.lower < power(Rational(10), -15));
}
