#include "specimens.hpp"

#include <subcert/analysis/limit/cell_walk.hpp>
#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::mask_of;
using subcert::testing::masks;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

bool within(const Rational& value, double lower, double upper) {
  return Rational(lower) <= value && value <= Rational(upper);
}

}  // namespace

TEST_CASE("exact values inside a cell lie in its enclosures: psi") {
  Random random;
  for (const Mask& mask : masks()) {
    CAPTURE(mask.symbol().to_mask_text(), mask.arity());
    const LimitCells cells(mask);
    for (const auto round : rounds(6)) {
      CellForm form = cells.variance_form(0, 0);
      const int level = static_cast<int>(random.integer(0, 9));
      const double spare = random.chance(50) ? 0 : 1e-9;
      for (int l = 0; l < level; ++l) {
        const int digit = static_cast<int>(random.integer(0, mask.arity() - 1));
        form = random.chance(60) ? cells.child(form, digit, {spare, spare})
                                 : cells.variance_child(form, cells.range(form), digit, {spare, spare});
        if (random.chance(10)) form = cells.variance_form(form.index, form.level);
      }
      const CellRange range = cells.range(form);
      CAPTURE(form.level, form.index);
      CHECK(range.value_lower <= range.value_upper);
      // All points of two levels below, and differences of neighbours.
      const long parts = mask.arity() * mask.arity();
      const Rational step = power(Rational(mask.arity()), -(form.level + 2));
      Rational last;
      for (long i = 0; i <= parts; ++i) {
        const Rational value = variance_at(mask, form.index * parts + i, form.level + 2);
        CHECK(within(value, range.value_lower, range.value_upper));
        if (i == 0) CHECK(within(value, range.left_lower, range.left_upper));
        if (i == parts) CHECK(within(value, range.right_lower, range.right_upper));
        if (i > 0 && cells.has_slopes()) CHECK(within((value - last) / step, range.slope_lower, range.slope_upper));
        last = value;
      }
    }
  }
}

TEST_CASE("exact values inside a cell lie in its enclosures: phi and phi'") {
  Random random;
  for (const Mask& mask : masks()) {
    CAPTURE(mask.symbol().to_mask_text(), mask.arity());
    const LimitCells cells(mask);
    const int deep = mask.arity() == 2 ? 6 : 4;
    const LimitValues exact = limit_values(mask, deep);
    for (const auto round : rounds(12)) {
      const long k = static_cast<long>(random.integer(cells.first_integer() - 1, cells.last_integer()));
      CellForm form = cells.limit_form(k);
      const int level = static_cast<int>(random.integer(0, deep - 1));
      for (int l = 0; l < level; ++l)
        form = cells.child(form, static_cast<int>(random.integer(0, mask.arity() - 1)), {0, 0});
      const CellRange range = cells.range(form);
      long parts = 1;
      for (int l = level; l < deep; ++l) parts *= mask.arity();
      const Rational step = power(Rational(mask.arity()), -deep);
      for (long i = 0; i <= parts; ++i) {
        const long index = static_cast<long>(form.index) * parts + i;
        CHECK(within(exact.at(index), range.value_lower, range.value_upper));
        if (i > 0 && cells.has_slopes())
          CHECK(within((exact.at(index) - exact.at(index - 1)) / step, range.slope_lower, range.slope_upper));
      }
    }
  }
  const LimitCells cells(mask_of("bspline:degree=3"));
  REQUIRE(cells.has_slopes());
  const CellRange cell = cells.range(cells.child(cells.limit_form(-2), 1, {}));  // [-3/2, -1]
  for (const Rational& value : {Rational(1, 48), Rational(1, 6)})
    CHECK(within(value, cell.value_lower, cell.value_upper));
  for (const Rational& slope : {Rational(1, 8), Rational(1, 2)})
    CHECK(within(slope, cell.slope_lower, cell.slope_upper));
}

TEST_CASE("deep cells keep the scale of the oscillation") {
  // For n = 20 psi differs from its mean by 2e-11: the exact slopes of deep cells are met to many digits.
  const Mask mask = mask_of("primal:n=20");
  const LimitCells cells(mask);
  CellForm form = cells.variance_form(0, 0);
  for (int l = 0; l < 12; ++l) form = cells.child(form, l % 2, {0, 0});
  const CellRange range = cells.range(form);
  const Rational slope = (variance_at(mask, form.index + 1, form.level) - variance_at(mask, form.index, form.level)) *
                         power(Rational(2), form.level);
  CHECK(within(slope, range.slope_lower, range.slope_upper));
  CHECK(range.slope_upper - range.slope_lower < 1e-11);
  CHECK(Rational(range.steepness) <= abs(slope) * Rational(1000001, 1000000));
}

TEST_CASE("inner products of integer shifts") {
  // Those of the B-spline of degree d are the values of the B-spline of degree 2 d + 1 at the integers.
  for (int degree = 1; degree <= 3; ++degree) {
    const auto products = l2_inner_products(mask_of("bspline:degree=" + std::to_string(degree)));
    const LimitValues spline = limit_values(mask_of("bspline:degree=" + std::to_string(2 * degree + 1)), 0);
    for (std::size_t k = 0; k < products.size(); ++k) CHECK(products[k] == spline.at(static_cast<long>(k)));
  }
  for (const Mask& mask : masks()) {
    const auto products = l2_inner_products(mask);
    Rational sum = products[0];
    for (std::size_t k = 1; k < products.size(); ++k) sum += 2 * products[k];
    CHECK(sum == 1);
    CHECK(products[0] == squared_l2_norm(mask));
  }
}

TEST_CASE("extremes, norms, sign and monotonicity of phi") {
  const LimitRange cubic = limit_range(mask_of("bspline:degree=3"));
  CHECK(cubic.complete);
  CHECK(cubic.maximum.contains(Rational(2, 3)));
  CHECK(cubic.minimum.contains(0));
  CHECK(cubic.l1_norm.contains(1));
  REQUIRE(cubic.slope);
  CHECK(cubic.slope->contains(Rational(2, 3)));  // at 2/3 from the centre
  for (const Mask& mask : masks()) {
    CAPTURE(mask.symbol().to_mask_text(), mask.arity());
    const LimitRange range = limit_range(mask, {.relative_width = Rational(1, 10'000)});
    CHECK(range.complete);
    const LimitValues grid = limit_values(mask, mask.arity() == 2 ? 7 : 4);
    Rational sum = 0, largest = 0, smallest = 0, steepest = 0;
    const Rational step = power(Rational(mask.arity()), -grid.level);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      sum += abs(grid.values[i]) * step;
      largest = std::max(largest, grid.values[i]);
      smallest = std::min(smallest, grid.values[i]);
      if (i > 0) steepest = std::max(steepest, Rational(abs(grid.values[i] - grid.values[i - 1]) / step));
    }
    CHECK(largest <= *range.maximum.upper);
    CHECK(smallest >= *range.minimum.lower);
    CHECK(*range.sup_norm.upper >= largest);
    CHECK(abs(sum - *range.l1_norm.upper) < Rational(1, 50));
    CHECK(*range.l1_norm.upper - *range.l1_norm.lower <= *range.l1_norm.upper / 10'000);
    if (range.slope) CHECK(steepest <= *range.slope->upper);
  }
  CHECK(is_positive(mask_of("primal:n=3"), Rational(-49, 10), Rational(49, 10)).is_yes());
  CHECK(is_positive(mask_of("dd:n=2"), Rational(-9, 10), Rational(9, 10)).is_yes());
  CHECK(is_positive(mask_of("dd:n=2"), Rational(-3, 2), Rational(0)).is_no());
  CHECK_THROWS_AS(is_positive(mask_of("dd:n=2"), 1, 0), Error);
}

TEST_CASE("walks over cells end with what is proved: out of time, out of memory") {
  const Mask mask = mask_of("dd:n=2");
  const LimitRange whole = limit_range(mask);
  for (const Budget& budget : {Budget{Deadline::in(0)}, Budget{{}, 0}, Budget{{}, 20'000}}) {
    const LimitRange part = limit_range(mask, {Rational(1, 1'000'000), budget});
    CHECK_FALSE(part.complete);
    CHECK(part.cells < whole.cells);
    CHECK(*part.maximum.upper >= *whole.maximum.lower);
    CHECK(*part.minimum.lower <= *whole.minimum.upper);
    CHECK(*part.slope->upper >= *whole.slope->lower);
    CHECK(*part.l1_norm.lower <= *whole.l1_norm.upper);
    CHECK(*part.l1_norm.upper >= *whole.l1_norm.lower);
  }
  const Decision late = is_positive(mask, Rational(-9, 10), Rational(9, 10), {40, Deadline::in(0)});
  CHECK(late.truth == Truth::unknown);
  CHECK(late.reason.ends_with("the time is up"));
}

TEST_CASE("a walk that is late gives the cells that are left the range of a larger one") {
  const LimitCells cells(mask_of("bspline:degree=3"));
  Deadline soon = Deadline::in(0.3);
  std::size_t inherited = 0;
  std::vector<CellForm> first;
  first.push_back(cells.limit_form(0));
  walk_cells(
      cells, std::move(first), {soon}, [](const CellRange&) {},
      [&](const WalkedCell& cell, bool may_split) {
        std::vector<CellForm> parts;
        if (!cell.own) {
          ++inherited;
          const CellRange own = cells.range(cell.form);
          CHECK(cell.range.value_lower <= own.value_upper);
          CHECK(cell.range.value_upper >= own.value_lower);
          CHECK_FALSE(may_split);
        }
        if (may_split)
          for (int t = 0; t < 2; ++t) parts.push_back(cells.child(cell.form, t, {}));
        if (cell.form.level >= 6)
          while (!soon.expired()) {
          }
        return parts;
      });
  CHECK(inherited > 0);
}
