#include <subcert/analysis/limit/limit_cells.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;

namespace {

Mask mask_of(const std::string& specification) { return make_scheme(specification).mask; }

Rational width(const Enclosure& enclosure) { return *enclosure.upper - *enclosure.lower; }

}  // namespace

TEST_CASE("exact values at points of a cell lie in the range of psi on it") {
  testing::Random random;
  for (const char* text : {"primal:n=1", "primal:n=2", "primal:n=5", "primal:n=4,d=3", "dual:n=3", "primal-odd:n=2",
                           "dual-odd:n=3", "dd:n=2", "four-point:w=1/9", "ary:a=3,points=4,d=3", "bspline:degree=3"}) {
    CAPTURE(text);
    const Mask mask = mask_of(text);
    const LimitCells cells(mask);
    for (int round = 0; round < testing::rounds(6); ++round) {
      CellForm form = cells.variance_form(0, 0);
      const long depth = random.integer(0, 9);
      for (long k = 0; k < depth; ++k)
        form = cells.child(form, static_cast<int>(random.integer(0, mask.arity() - 1)), {});
      const CellRange range = cells.range(form);
      CAPTURE(form.level, form.index);
      std::int64_t parts = 1, index = form.index;
      int level = form.level;
      for (int k = 0; k < 4; ++k) {
        parts *= mask.arity();
        index *= mask.arity();
        ++level;
      }
      const std::int64_t inside = random.integer(0, static_cast<long>(parts));
      const Rational at_left = variance_at(mask, form.index, form.level);
      const Rational at_right = variance_at(mask, form.index + 1, form.level);
      const Rational value = variance_at(mask, index + inside, level);
      CHECK(value >= Rational(range.value_lower));
      CHECK(value <= Rational(range.value_upper));
      CHECK(at_left >= Rational(range.left_lower));
      CHECK(at_left <= Rational(range.left_upper));
      CHECK(at_right >= Rational(range.right_lower));
      CHECK(at_right <= Rational(range.right_upper));
      if (!cells.has_slopes()) continue;
      // A divided difference is a mean of slopes.
      const Rational mean = (at_right - at_left) * power(Rational(mask.arity()), form.level);
      CHECK(mean >= Rational(range.slope_lower));
      CHECK(mean <= Rational(range.slope_upper));
      CHECK(range.steepness <= std::max(std::abs(range.slope_lower), std::abs(range.slope_upper)));
    }
  }
}

TEST_CASE("exact values of the basic limit function lie in its ranges") {
  testing::Random random;
  for (const char* text : {"primal:n=3", "dual:n=2", "dd:n=3", "primal:n=3,d=3", "ary:a=4,points=4,d=3"}) {
    CAPTURE(text);
    const Mask mask = mask_of(text);
    const LimitCells cells(mask);
    const LimitValues exact = limit_values(mask, 6);
    const long fine = static_cast<long>(power(Rational(mask.arity()), 6).convert_to<double>());
    for (int round = 0; round < testing::rounds(12); ++round) {
      CellForm form = cells.limit_form(random.integer(cells.first_integer() - 1, cells.last_integer()));
      long size = fine;
      for (long k = random.integer(0, 5); k > 0; --k, size /= mask.arity())
        form = cells.child(form, static_cast<int>(random.integer(0, mask.arity() - 1)), {});
      const CellRange range = cells.range(form);
      CAPTURE(form.level, form.index);
      const Rational value = exact.at(static_cast<long>(form.index) * size + random.integer(0, size));
      CHECK(value >= Rational(range.value_lower));
      CHECK(value <= Rational(range.value_upper));
    }
  }
}

TEST_CASE("variance ranges of B-splines are the known ones") {
  const VarianceRange hat = variance_range(mask_of("bspline:degree=1"));  // (1-x)^2 + x^2
  CHECK(hat.complete);
  CHECK(hat.maximum.contains(1));
  CHECK(hat.minimum.contains(Rational(1, 2)));
  REQUIRE(hat.slope);
  CHECK(hat.slope->contains(2));
  const VarianceRange cubic = variance_range(mask_of("bspline:degree=3"));
  CHECK(cubic.complete);
  CHECK(cubic.maximum.contains(Rational(1, 2)));      // (1 + 16 + 1) / 36
  CHECK(cubic.minimum.contains(Rational(265, 576)));  // 2 (1 + 23^2) / 48^2
  CHECK(cubic.mean == squared_l2_norm(mask_of("bspline:degree=3")));
}

TEST_CASE("variance ranges contain the grid and are as narrow as asked for") {
  for (const char* text : {"primal:n=2", "primal:n=7", "primal:n=3,d=3", "dual:n=4", "primal-odd:n=2", "ary:a=3,points=6,d=3"}) {
    CAPTURE(text);
    const Mask mask = mask_of(text);
    const VarianceRange range = variance_range(mask);
    const VarianceGrid grid = variance_grid(mask, 6, false);
    CHECK(range.complete);
    CHECK(*range.maximum.lower >= grid.largest() * Rational(999, 1000));
    CHECK(*range.maximum.upper >= grid.largest());
    CHECK(*range.minimum.lower <= grid.smallest());
    CHECK(width(range.maximum) <= *range.maximum.upper / 1'000'000);
    CHECK(width(range.minimum) <= *range.minimum.upper / 1'000'000);
    REQUIRE(range.slope);
    CHECK(*range.slope->upper >= grid.steepest());
    CHECK(width(*range.slope) <= *range.slope->upper / 1'000'000);
  }
}

TEST_CASE("variance curves are compared at all points") {
  CHECK(is_below(mask_of("primal:n=3"), mask_of("primal:n=2")).below == Truth::yes);
  CHECK(is_below(mask_of("primal:n=3"), mask_of("primal:n=3,d=3")).below == Truth::yes);
  const Mask first = mask_of("primal:n=2"), second = mask_of("primal:n=3");
  const VarianceOrder crossed = is_below(first, second);
  REQUIRE(crossed.below == Truth::no);
  CHECK(crossed.difference <= 0);
}

TEST_CASE("variance ranges refuse what they cannot prove") {
  CHECK_THROWS_AS(variance_range(mask_of("mask:[1,0,0,1]")), std::domain_error);
  CHECK_THROWS_AS(variance_range(mask_of("primal:n=2"), {0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(variance_range(mask_of("primal:n=2"), {1, 0}), std::invalid_argument);
}
