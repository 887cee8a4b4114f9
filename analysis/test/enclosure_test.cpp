#include <subcert/analysis/limit/limit_cells.hpp>
#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

Mask mask_of(const std::string& specification) { return make_scheme(specification).mask; }

const std::vector<std::string>& specimens() {
  static const std::vector<std::string> list{"primal:n=1",
                                             "primal:n=2",
                                             "primal:n=5",
                                             "primal:n=9",
                                             "dual:n=2",
                                             "primal-odd:n=3",
                                             "dual-odd:n=2",
                                             "primal:n=4,d=3",
                                             "dd:n=2",
                                             "dd:n=3",
                                             "bspline:degree=3",
                                             "bspline:degree=2,a=3",
                                             "ary:a=3,points=4,d=3",
                                             "ary:a=3,points=3",
                                             "ary:a=4,points=5,d=1",
                                             "ary:a=5,points=6,d=3",
                                             "four-point:w=1/9",
                                             "four-point:w=1/5",
                                             "mask:[1,2,1,2,4,2,1,2,1]/8"};
  return list;
}

std::vector<Mask> masks() {
  std::vector<Mask> result;
  for (const std::string& text : specimens()) result.push_back(mask_of(text));
  // Without symmetry: products of smoothing factors and a positive factor.
  const LaurentPolynomial two({Rational(1, 2), Rational(1, 2)}, 0),
      three({Rational(1, 3), Rational(1, 3), Rational(1, 3)}, 0);
  const LaurentPolynomial uneven({Rational(3, 5), Rational(1, 2), Rational(-1, 10)}, -4);
  result.push_back({two.pow(4) * uneven * LaurentPolynomial(2), 2});
  result.push_back({three.pow(3) * uneven * LaurentPolynomial(3), 3});
  return result;
}

bool within(const Rational& value, double lower, double upper) {
  return Rational(lower) <= value && value <= Rational(upper);
}

Enclosure scaled(const Enclosure& e, const Rational& factor) { return {*e.lower * factor, *e.upper * factor}; }

Rational relative_width(const Enclosure& e) { return (*e.upper - *e.lower) / *e.upper; }

}  // namespace

TEST_CASE("exact values inside a cell lie in its enclosures: psi") {
  Random random;
  for (const Mask& mask : masks()) {
    CAPTURE(mask.symbol().to_mask_text(), mask.arity());
    const LimitCells cells(mask);
    for (int round = 0; round < rounds(6); ++round) {
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
    for (int round = 0; round < rounds(12); ++round) {
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
  const LimitCell cell = limit_cell(mask_of("bspline:degree=3"), -3, 1);  // [-3/2, -1]
  CHECK(cell.value.contains(Rational(1, 48)));
  CHECK(cell.value.contains(Rational(1, 6)));
  REQUIRE(cell.slope);
  CHECK(cell.slope->contains(Rational(1, 8)));
  CHECK(cell.slope->contains(Rational(1, 2)));
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
    const VarianceRange range = variance_range(mask), rough = variance_range(mask, {Rational(1, 1000), 60});
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

TEST_CASE("Table 3 of Dyn, Heard, Hormann and Sharon") {
  // The maxima of psi that the table prints correctly to four places, and those of the slope. The largest |psi'| of the
  // others is not what is printed.
  struct Row {
    const char* scheme;
    Rational maximum, slope;
  };
  const Rational unit(1, 10'000);
  for (const Row& row : {Row{"primal:n=2,d=3", 1, Rational(10926, 10000)},
                         Row{"primal:n=3,d=3", Rational(4156, 10000), Rational(296, 10000)},
                         Row{"primal:n=5,d=3", Rational(2254, 10000), Rational(7, 10000)},
                         Row{"primal:n=3,d=5", 1, Rational(9048, 10000)},
                         Row{"primal:n=5,d=5", Rational(3793, 10000), Rational(22, 10000)}}) {
    CAPTURE(row.scheme);
    const VarianceRange range = variance_range(mask_of(row.scheme));
    CHECK(range.complete);
    CHECK(abs(*range.maximum.upper - row.maximum) <= unit);
    REQUIRE(range.slope);
    CHECK(abs(*range.slope->upper - row.slope) <= unit);
  }
  const VarianceRange fifth = variance_range(mask_of("primal:n=5"));
  CHECK(*scaled(*fifth.slope, 25).upper < Rational(1, 1000));  // printed: 0.0256
}

TEST_CASE("budgets and bad arguments") {
  CHECK_THROWS_AS(variance_range(mask_of("dd:n=2"), {0, 60}), std::invalid_argument);
  CHECK_THROWS_AS(variance_range(mask_of("dd:n=2"), {Rational(1, 10), 0}), std::invalid_argument);
  CHECK_THROWS_AS(variance_range(mask_of("mask:[1,1]")), std::domain_error);
  CHECK_THROWS_AS(is_below(mask_of("dd:n=2"), mask_of("ary:a=3,points=4,d=3")), std::invalid_argument);
  const VarianceRange partial = variance_range(mask_of("primal:n=10"), {Rational(1, 1'000'000), 1e-9});
  CHECK_FALSE(partial.complete);
  CHECK(partial.maximum.contains(Rational(4152017505, 100000000000)));
  REQUIRE(partial.slope);
  CHECK(partial.slope->contains(Rational(101421690, 1000000000000000)));
  const VarianceRange unknown = variance_range(mask_of("four-point:w=1/5"));
  CHECK_FALSE(unknown.slope);
  CHECK_FALSE(unknown.slope_reason.empty());
}

TEST_CASE("variance curves in order") {
  for (int n = 2; n <= 6; ++n) {
    const std::string text = "primal:n=" + std::to_string(n), before = "primal:n=" + std::to_string(n - 1);
    const VarianceOrder order = is_below(mask_of(text), mask_of(before));
    CHECK(order.below == Truth::yes);
    const VarianceGrid a = variance_grid(mask_of(text), 4, false), b = variance_grid(mask_of(before), 4, false);
    for (std::size_t i = 0; i < a.values.size(); ++i)
      CHECK(b.values[i] - a.values[i] >= *order.smallest_difference.lower);
    const VarianceOrder reversed = is_below(mask_of(before), mask_of(text));
    CHECK(reversed.below == Truth::no);
    CHECK(reversed.difference < 0);
  }
  const VarianceOrder equal = is_below(mask_of("dd:n=2"), mask_of("dd:n=2"));
  CHECK(equal.below == Truth::no);
  CHECK(equal.difference == 0);
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
    const LimitRange range = limit_range(mask, {Rational(1, 10'000), 60});
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
  CHECK(is_increasing(mask_of("bspline:degree=3"), -2, Rational(-1, 8)).is_yes());
  CHECK(is_increasing(mask_of("bspline:degree=3"), Rational(1, 8), 1).is_no());
  CHECK(is_increasing(mask_of("four-point:w=1/5"), -1, 0).truth == Truth::unknown);
  CHECK_THROWS_AS(is_positive(mask_of("dd:n=2"), 1, 0), std::invalid_argument);
}
