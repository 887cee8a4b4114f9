#include "specimens.hpp"

#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>

using namespace subcert;
using subcert::testing::mask_of;

namespace {

Scheme surface(const std::string& specification) { return make_linear_scheme(specification); }

/// The box spline of these directions with its support from 0 on.
LatticeMask box_spline(const std::vector<LatticePoint>& directions) {
  MultivariatePolynomial symbol(2, power(Rational(2), 2 - static_cast<long>(directions.size())));
  for (const LatticePoint& direction : directions)
    symbol *= MultivariatePolynomial(2, std::vector<MultivariatePolynomial::Monomial>{{1, {0, 0}}, {1, direction}});
  return {symbol, 2};
}

/// f(x) - f(x - direction), for values at 2^-level i.
LatticeSequence difference(const LatticeSequence& values, const LatticePoint& direction, int level) {
  LatticeSequence result = values;
  for (const auto& [point, value] : values) {
    LatticePoint moved = point;
    for (int n = 0; n < 1 << level; ++n) moved = moved + direction;
    result[moved] -= value;
  }
  std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
  return result;
}

LatticeSequence sum(LatticeSequence a, const LatticeSequence& b, const Rational& factor = 1) {
  for (const auto& [point, value] : b) a[point] += factor * value;
  std::erase_if(a, [](const auto& entry) { return entry.second == 0; });
  return a;
}

/// The scheme of `steps` steps at a time, which has the same limits.
LatticeMask power_of(const LatticeMask& mask, int steps) {
  std::vector<MultivariatePolynomial::Monomial> terms;
  for (const auto& [point, value] : refined_delta(mask, steps)) terms.push_back({value, point});
  std::vector<LatticePoint> rows = mask.dilation().rows();
  for (int n = 1; n < steps; ++n) rows = times(mask.dilation().rows(), rows);
  return {MultivariatePolynomial(mask.dimension(), terms), Dilation(rows)};
}

}  // namespace

TEST_CASE("derivatives of box splines are differences of box splines") {
  const LatticePoint x{1, 0}, y{0, 1}, d{1, 1};
  const int level = 2;
  const LatticeMask loop = box_spline({x, x, y, y, d, d});
  const LatticeSequence without_x = limit_values(box_spline({x, y, y, d, d}), level);
  CHECK(limit_values(loop, level, {1, 0}) == difference(without_x, x, level));
  const LatticeSequence without_xy = limit_values(box_spline({x, y, d, d}), level);
  CHECK(limit_values(loop, level, {1, 1}) == difference(difference(without_xy, x, level), y, level));
  // Twice along (1, 1): D_xx + 2 D_xy + D_yy.
  const LatticeSequence without_d = limit_values(box_spline({x, x, y, y}), level);
  CHECK(sum(sum(limit_values(loop, level, {2, 0}), limit_values(loop, level, {1, 1}), 2),
            limit_values(loop, level, {0, 2})) == difference(difference(without_d, d, level), d, level));
}

TEST_CASE("derivatives do not depend on the dilation, nor on the number of steps taken at a time") {
  // The 4-8 scheme and its box spline with the dilation 2; tiles of [1,-2;2,1], no power of which is diagonal.
  const LatticeMask once = surface("four-eight:").mask, twice = surface("box:[1,0;1,0;0,1;0,1;1,1;1,1;1,-1;1,-1]").mask;
  for (const LatticePoint& orders : {LatticePoint{0, 0}, {1, 0}, {1, 1}, {0, 2}, {2, 1}, {3, 1}}) {
    const LatticeSequence a = limit_values(once, 0, orders), b = limit_values(twice, 0, orders);
    REQUIRE(a.size() == b.size());
    const LatticePoint shift = b.begin()->first - a.begin()->first;
    for (const auto& [point, value] : a) CHECK(b.at(point + shift) == value);
  }
  const Dilation turned({{1, -2}, {2, 1}});
  MultivariatePolynomial tile(2), symbol(2, Rational(1, 125));
  for (const LatticePoint& digit : turned.digits())
    tile += MultivariatePolynomial(2, std::vector<MultivariatePolynomial::Monomial>{{1, digit}});
  for (int n = 0; n < 4; ++n) symbol *= tile;
  for (const LatticeMask& mask : {surface("sqrt3:").mask, LatticeMask(symbol, turned)}) {
    const LatticeMask two = power_of(mask, 2);
    for (const LatticePoint& orders : {LatticePoint{0, 0}, {1, 0}, {0, 1}}) {
      CHECK(limit_values(mask, 2, orders) == limit_values(two, 1, orders));
      CHECK(limit_values(mask, 1, orders).size() > limit_values(mask, 0, orders).size());
    }
  }
}

TEST_CASE("derivatives are what difference quotients tend to") {
  // M^level is a multiple of the identity or of a quarter turn.
  for (const auto& [specification, level] :
       {std::pair("sqrt3:", 6), std::pair("four-eight:", 10), std::pair("butterfly:w=1/16", 5)}) {
    INFO(specification);
    const LatticeMask mask = surface(specification).mask;
    const LatticeSequence values = limit_values(mask, level);
    const auto value_at_point = [&values = values](const LatticePoint& point) {
      const auto found = values.find(point);
      return found == values.end() ? 0.0 : found->second.convert_to<double>();
    };
    for (const auto& [point, slope] : limit_values(mask, 0, {1, 0})) {
      LatticePoint centre = point, unit{1, 0};
      for (int n = 0; n < level; ++n) {
        centre = mask.dilation() * centre;
        unit = mask.dilation() * unit;
      }
      const long length = std::max(std::abs(unit[0]), std::abs(unit[1]));
      for (long& coordinate : unit) coordinate /= length;
      const double quotient = (value_at_point(centre + unit) - value_at_point(centre - unit)) / 2 *
                              static_cast<double>(length);
      CHECK(std::abs(quotient - slope.convert_to<double>()) < 0.05);
    }
  }
}

TEST_CASE("values of tensor products are products") {
  const Scheme equal = surface("tensor:(bspline:degree=3)x(dd:n=2)");
  CHECK(limit_values(equal.mask, 2) == limit_values(equal.mask.without_factors(), 2));
  CHECK(limit_values(equal.mask, 2, {1, 0}) == limit_values(equal.mask.without_factors(), 2, {1, 0}));
  // The four-point scheme is C^1 alone, but D_xy of the product is continuous.
  const LimitValues slope = limit_values(mask_of("dd:n=2"), 3, 1);
  const LatticeSequence mixed = limit_values(tensor_product({mask_of("dd:n=2"), mask_of("dd:n=2")}), 3, {1, 1});
  for (const auto& [point, value] : mixed) CHECK(value == slope.at(point[0]) * slope.at(point[1]));
  CHECK(limit_values(tensor_product({mask_of("bspline:degree=2,a=3"), mask_of("dd:n=2")}), 1).at({2, 3}) ==
        limit_values(mask_of("bspline:degree=2,a=3"), 1).at(2) * limit_values(mask_of("dd:n=2"), 1).at(3));
}

TEST_CASE("orders and levels are checked") {
  const LatticeMask loop = surface("loop:").mask;
  CHECK_THROWS_WITH(limit_values(loop, 0, {1}), Catch::Contains("an order for each of 2 variables"));
  CHECK_THROWS_WITH(limit_values(loop, 0, {1, -1}), Catch::Contains("orders >= 0"));
  CHECK_THROWS_WITH(limit_values(loop, -1), Catch::Contains("level >= 0"));
  CHECK_THROWS_WITH(limit_values(loop, 12), Catch::Contains("at most 1000000 values"));
  CHECK_THROWS_WITH(limit_values(surface("tensor:(bspline:degree=3,a=3)x(dd:n=2)").mask.without_factors(), 0, {1, 0}),
                    Catch::Contains("need an isotropic dilation"));
}

TEST_CASE("extremes of surfaces enclose all values") {
  for (const char* specification :
       {"loop:", "quincunx:", "sqrt3:", "zwart-powell:", "butterfly:w=1/16", "grid:points=3x3,d=2",
        "grid:points=2x2,d=1", "tensor:(bspline:degree=2,a=3)x(dd:n=2)", "box:[1,0;0,1;1,1]"}) {
    INFO(specification);
    const LatticeMask mask = surface(specification).mask.without_factors();
    const LimitRange range = limit_range(mask, {Rational(1, 1000), {Deadline::in(100)}});
    CHECK(range.complete);
    const Enclosure &maximum = range.maximum, &minimum = range.minimum;
    CHECK(*maximum.upper - *maximum.lower <= *maximum.lower / 1000);
    CHECK(*minimum.upper - *minimum.lower <= *maximum.lower / 1000);
    Rational largest = 0, smallest = 0;
    for (const auto& [point, value] : limit_values(mask, mask.dilation().factor() ? 3 : 4)) {
      largest = std::max(largest, value);
      smallest = std::min(smallest, value);
    }
    CHECK(largest <= *maximum.upper);
    CHECK(smallest >= *minimum.lower);
    CHECK(range.nonnegative.truth == (smallest < 0 ? Truth::no : Truth::yes));
  }
}

TEST_CASE("extremes that are known") {
  const LimitRange loop = limit_range(surface("loop:").mask);
  CHECK(*loop.maximum.lower == Rational(1, 2));
  CHECK(loop.highest == std::vector<Rational>{0, 0});
  CHECK(*loop.maximum.upper - Rational(1, 2) <= Rational(1, 2'000'000));
  CHECK(loop.minimum.is_exact());
  CHECK(loop.lowest->empty());
  // The largest and the least value of a product, from those of its factor: 1, and 1 times the least one.
  const LimitRange factor = limit_range(mask_of("dd:n=2"));
  const LimitRange product = limit_range(surface("tensor:(dd:n=2)x(dd:n=2)").mask);
  CHECK(*product.maximum.lower == 1);
  CHECK(*product.minimum.lower <= *factor.minimum.upper);
  CHECK(*product.minimum.upper >= *factor.minimum.lower);
  CHECK(product.nonnegative.is_no());
  CHECK(product.sup_norm.lower == product.maximum.lower);
  CHECK(product.sup_norm.upper == product.maximum.upper);
  CHECK_FALSE(product.l1_norm.lower);
  // A mask that is its own factor is one of one variable.
  const LimitRange curve = limit_range(LatticeMask(mask_of("dd:n=2")));
  CHECK(curve.maximum.lower == factor.maximum.lower);
  CHECK(curve.l1_norm.upper == factor.l1_norm.upper);
  CHECK(curve.nonnegative.is_no());
  CHECK_FALSE(curve.highest);
  // Without memory or time the values that were found are lower bounds.
  const LimitRange late = limit_range(surface("butterfly:w=1/16").mask, {Rational(1, 1'000'000), {Deadline::in(0)}});
  CHECK(!late.complete);
  CHECK(*late.maximum.lower == 1);
  CHECK(!late.maximum.upper);
  CHECK(!late.sup_norm.upper);
  CHECK(!late.minimum.lower);
  const LimitRange small = limit_range(surface("butterfly:w=1/16").mask,
                                       {Rational(1, 1'000'000), {Deadline::in(100), 1 << 16}});
  CHECK(!small.complete);
  CHECK(*small.maximum.lower == 1);
}

TEST_CASE("surfaces converge by a short look at powers in any time") {
  for (const char* scheme : {"grid:points=6x7,d=2", "butterfly:w=1/16", "grid:points=3x3,d=1", "loop:"}) {
    CAPTURE(scheme);
    CHECK(converges(surface(scheme).mask, {16, Deadline::in(0)}).is_yes());
  }
}
