#include "specimens.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/cmake/catch.hpp>

using namespace subcert;
using subcert::testing::mask_of;
using subcert::testing::masks;

namespace {

Rational relative_width(const Enclosure& e) { return (*e.upper - *e.lower) / *e.upper; }

}  // namespace

TEST_CASE("variance ranges that are known in closed form") {
  const VarianceRange hat = variance_range(mask_of("primal:n=1"));  // psi(x) = x^2 + (1 - x)^2
  CHECK(hat.complete);
  CHECK(hat.maximum.contains(1));
  CHECK(hat.minimum.contains(Rational(1, 2)));
  REQUIRE(hat.slope);
  CHECK(hat.slope->contains(2));
  CHECK_FALSE(hat.slope_reason.empty());
  CHECK(hat.mean == Rational(2, 3));

  const VarianceRange quadratic = variance_range(mask_of("bspline:degree=2"));
  CHECK(quadratic.maximum.contains(Rational(19, 32)));
  CHECK(quadratic.minimum.contains(Rational(1, 2)));
  // psi = 1/2 + 3 (y^2 - 1/4)^2 / 2 about y = 1/2 from an integer, so the largest slope is 1/sqrt(12).
  REQUIRE(quadratic.slope);
  CHECK(*quadratic.slope->lower * *quadratic.slope->lower <= Rational(1, 12));
  CHECK(*quadratic.slope->upper * *quadratic.slope->upper >= Rational(1, 12));

  for (const char* text : {"bspline:degree=3", "bspline:degree=3,a=3"}) {
    const VarianceRange cubic = variance_range(mask_of(text));
    CHECK(cubic.maximum.contains(Rational(1, 2)));
    CHECK(cubic.minimum.contains(Rational(265, 576)));
    CHECK(cubic.complete);
  }
  for (const char* text : {"dd:n=2", "dd:n=3"}) CHECK(variance_range(mask_of(text)).maximum.contains(1));
}

TEST_CASE("variance ranges of all families hold the exact grid") {
  for (const Mask& mask : masks()) {
    CAPTURE(mask.symbol().to_mask_text(), mask.arity());
    const VarianceRange range = variance_range(mask),
                        rough = variance_range(mask, {.relative_width = Rational(1, 1000)});
    CHECK(range.complete);
    CHECK(relative_width(range.maximum) <= Rational(1, 1'000'000));
    CHECK(relative_width(range.minimum) <= Rational(1, 1'000'000));
    const VarianceGrid grid = variance_grid(mask, mask.arity() == 2 ? 7 : 4, false);
    CHECK(grid.largest() <= *range.maximum.upper);
    CHECK(grid.smallest() >= *range.minimum.lower);
    CHECK(*range.maximum.lower >= grid.largest() * Rational(999'999, 1'000'000));
    CHECK(*range.minimum.upper <= grid.smallest() * Rational(1'000'001, 1'000'000));
    CHECK(*rough.maximum.lower <= *range.maximum.upper);
    CHECK(*rough.minimum.lower <= *range.minimum.upper);
    CHECK(*rough.maximum.upper >= *range.maximum.lower);
    CHECK(range.mean <= *range.maximum.upper);
    CHECK(range.mean >= *range.minimum.lower);
    if (!range.slope) {
      CHECK_FALSE(range.slope_reason.empty());
      continue;
    }
    CHECK(relative_width(*range.slope) <= Rational(1, 1'000'000));
    CHECK(grid.steepest() <= *range.slope->upper);
    CHECK(*range.slope->lower <= *rough.slope->upper);
    CHECK(*rough.slope->lower <= *range.slope->upper);
  }
}

TEST_CASE("budgets and bad arguments") {
  CHECK_THROWS_AS(variance_range(mask_of("dd:n=2"), {.relative_width = 0}), Error);
  CHECK_THROWS_AS(variance_range(mask_of("mask:[1,1]")), Error);
  CHECK_THROWS_AS(variance_range(mask_of("mask:[1,0,0,1]")), Error);
  CHECK_THROWS_AS(compare_variance(mask_of("dd:n=2"), mask_of("ary:a=3,points=4,d=3")), Error);
  for (const Budget& budget : {Budget{Deadline::in(0)}, Budget{{}, 0}}) {
    const VarianceRange partial = variance_range(mask_of("primal:n=10"), {Rational(1, 1'000'000), budget});
    CHECK_FALSE(partial.complete);
    CHECK(partial.maximum.contains(Rational(4152017505, 100000000000)));
    REQUIRE(partial.slope);
    CHECK(partial.slope->contains(Rational(101421690, 1000000000000000)));
  }
  // Other curves would be refuted or proved at the first cell.
  const VarianceOrder late = compare_variance(mask_of("primal:n=5"), mask_of("primal:n=4"), {40, Deadline::in(0)});
  CHECK(late.below != Truth::no);
  const VarianceRange unknown = variance_range(mask_of("four-point:w=1/5"));
  CHECK_FALSE(unknown.slope);
  CHECK_FALSE(unknown.slope_reason.empty());
}

TEST_CASE("variance curves in order") {
  for (int n = 2; n <= 6; ++n) {
    const std::string text = "primal:n=" + std::to_string(n), before = "primal:n=" + std::to_string(n - 1);
    const VarianceOrder order = compare_variance(mask_of(text), mask_of(before));
    CHECK(order.below == Truth::yes);
    const VarianceGrid a = variance_grid(mask_of(text), 4, false), b = variance_grid(mask_of(before), 4, false);
    for (std::size_t i = 0; i < a.values.size(); ++i)
      CHECK(b.values[i] - a.values[i] >= *order.smallest_difference.lower);
    const VarianceOrder reversed = compare_variance(mask_of(before), mask_of(text));
    CHECK(reversed.below == Truth::no);
    CHECK(reversed.difference < 0);
  }
  CHECK(compare_variance(mask_of("primal:n=3"), mask_of("primal:n=3,d=3")).below == Truth::yes);
  const VarianceOrder equal = compare_variance(mask_of("dd:n=2"), mask_of("dd:n=2"));
  CHECK(equal.below == Truth::no);
  CHECK(equal.difference == 0);
}
