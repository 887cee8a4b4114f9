#include <subcert/analysis/family/property_map.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/parametric_specification.hpp>

using namespace subcert;

namespace {

constexpr const char* six_points = "mask:[t,0,-w-3*t,0,1/2+w+2*t,1,1/2+w+2*t,0,-w-3*t,0,t]";

PropertyMap map_of(const char* mask, const char* property, const Box& box, int resolution) {
  return property_map(make_parametric_mask(mask, "wt"), *parse_range_property(property), box,
                      {resolution, 2, {Deadline::in(60)}});
}

}  // namespace

TEST_CASE("masks with two parameters") {
  const ParametricMask mask = make_parametric_mask(six_points, "wt");
  const ParametricMask turned = make_parametric_mask(six_points, "tw");
  const Rational w(1, 16), t(1, 50);
  CHECK(mask.at({w, t}) == turned.at({t, w}));
  CHECK(mask.at({w, t}) == make_scheme("six-point:w=1/50").mask.curve());
  CHECK(mask.at({w, 0}) == make_scheme("four-point:w=1/16").mask.curve());
  const ParametricMask products = make_parametric_mask("mask:[w*t,1-w*t,1-w*t,w*t]/1@-2,arity=2", "wt");
  CHECK(products.sizes() == std::vector<std::size_t>{2, 2});
  CHECK(products.at({Rational(1, 2), Rational(1, 2)}) == make_scheme("corner-cutting:w=1/4").mask.curve());
  for (const char* bad : {"four-point:w", "mask:[w,1-v]", "mask:[w,t", "mask:[w,1-w,t]", "mask:[1/w,1,1-1/w]",
                          "mask:[w^13,1,1-w^13]", "mask:[(w),1,1-w]", "mask:[w,1,1-w]@x", "mask:", ""})
    CHECK_THROWS_AS(make_parametric_mask(bad, "wt"), SpecificationError);
}

TEST_CASE("a map of two parameters is true at all of its points") {
  subcert::testing::Random random;
  const Box box{{Rational(-1, 8), Rational(-1, 16)}, {Rational(1, 4), Rational(1, 16)}};
  for (const char* property : {"C1", "convergent", "holder>=9/8"}) {
    CAPTURE(property);
    const RangeProperty asked = *parse_range_property(property);
    const PropertyMap map = map_of(six_points, property, box, 8);
    CHECK(map.sum_rules == 2);
    CHECK(map.complete);
    CHECK(map.share(Truth::yes) + map.share(Truth::no) + map.share(Truth::unknown) == 1);
    CHECK(map.share(Truth::yes) > Rational(1, 16));
    Rational area = 0;
    for (const MapCell& cell : map.cells) {
      const Box& r = cell.box;
      area += (r.high[0] - r.low[0]) * (r.high[1] - r.low[1]);
      if (cell.holds == Truth::unknown || random.integer(0, 3) > 0) continue;
      const auto inside = [&](std::size_t side) {
        return Rational(r.low[side] + (r.high[side] - r.low[side]) * Rational(random.integer(0, 8), 8));
      };
      const Mask mask = make_parametric_mask(six_points, "wt").at({inside(0), inside(1)});
      const Enclosure exponent = holder_regularity(mask, 4, {Deadline::in(10)}).exponent;
      if (cell.holds == Truth::yes)
        CHECK((!exponent.upper || *exponent.upper > asked.order));
      else if (asked.order > 0)
        CHECK(*exponent.lower < asked.order);
      else
        CHECK(*exponent.lower <= 0);
    }
    CHECK(area == Rational(3, 8) * Rational(1, 8));
  }
}

TEST_CASE("on an axis a map agrees with the range of one parameter") {
  // C1 of the 4-point scheme for 0 < w < 0.19273.
  const PropertyMap map = map_of(six_points, "C1",
                                 {{Rational(-1, 8), Rational(-1, 100)}, {Rational(1, 4), Rational(1, 100)}}, 16);
  for (const MapCell& cell : map.cells) {
    const Box& r = cell.box;
    if (!(r.low[1] <= 0 && 0 <= r.high[1])) continue;
    if (cell.holds == Truth::yes) CHECK((r.low[0] > 0 && r.high[0] < Rational(19273, 100000)));
    if (cell.holds == Truth::no) CHECK((r.high[0] <= 0 || r.low[0] > Rational(19272, 100000)));
  }
  CHECK(map.share(Truth::no) > Rational(1, 5));
}

TEST_CASE("maps that make no sense are refused") {
  const Box unit{{0, 0}, {1, 1}};
  const auto kind = [&](const char* property, const Box& box, int resolution) {
    return subcert::testing::error_kind([&] { map_of(six_points, property, box, resolution); });
  };
  CHECK(kind("C2", unit, 4) == ErrorKind::domain);
  CHECK(kind("stable", unit, 4) == ErrorKind::domain);
  CHECK(kind("C1", {{0, 0}, {0, 1}}, 4) == ErrorKind::domain);
  CHECK(kind("C1", unit, 0) == ErrorKind::domain);
}

TEST_CASE("stability of all masks nearby") {
  const Mask four = make_scheme("four-point:w=1/16").mask.curve();
  // The zeros of the even part stay: only errors elsewhere count.
  const Rational e(1, 100);
  CHECK(has_stable_shifts(four, std::vector<Rational>{e, 0, e, 0, e, 0, e}).is_yes());
  CHECK_FALSE(has_stable_shifts(four, Rational(1, 2)).is_yes());
  CHECK(has_stable_shifts(four, power(Rational(10), -12)).is_yes());
  CHECK_FALSE(has_stable_shifts(make_scheme("mask:[1,1,1,1]/2").mask.curve(), power(Rational(10), -12)).is_yes());
  CHECK_FALSE(has_stable_shifts(make_scheme("mask:[1,0,0,1]").mask.curve(), power(Rational(10), -12)).is_yes());
}
