#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/family/box_search.hpp>
#include <subcert/analysis/family/property_map.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
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
  for (const char* bad :
       {"four-point:w", "mask:[w,1-v]", "mask:[w,t", "mask:[w,1-w,t]", "mask:[1/w,1,1-1/t]", "mask:[w^13,1,1-w^13]",
        "mask:[(w,1,1-w]", "mask:[w,1,1-w]@x", "mask:[w,t,1]/(w-w)", "mask:[0,0]", "mask:", ""})
    CHECK_THROWS_AS(make_parametric_mask(bad, "wt"), SpecificationError);
}

TEST_CASE("masks with quotients in two parameters") {
  const ParametricMask mask = make_parametric_mask("mask:[w/t,1,1-w/t]/1@-1", "wt");
  CHECK(mask.at(Values{3, 5}) == make_scheme("mask:[3/5,1,2/5]@-1").mask.curve());
  CHECK(mask == make_parametric_mask("mask:[2*w,2*t,2*t-2*w]/(2*t)@-1", "wt"));
  CHECK(make_parametric_mask("mask:[1/(1+w)/(1+t),1,1-1/(1+w)/(1+t)]", "wt").sizes() == std::vector<std::size_t>{2, 2});
  CHECK(subcert::testing::error_kind([&] { mask.at(Values{1, 0}); }) == ErrorKind::domain);
  CHECK_FALSE(mask.controls({{0, -1}, {1, 1}}));
  CHECK(mask.controls({{0, -2}, {1, -1}}));
  CHECK(make_parametric_mask("mask:[w,t,t,w]/(w+t)", "wt").at(Values{1, 3}) ==
        make_scheme("corner-cutting:w=1/4").mask.curve());
}

TEST_CASE("the symbols of a box are convex combinations of its controls") {
  subcert::testing::Random random;
  for (const char* text :
       {six_points, "mask:[w*t-t^2,1-w*t+t^2,1-w*t+t^2,w*t-t^2]", "mask:[1,w+t-t^2,w+t-t^2,1]/(1+w+t-t^2)"}) {
    const ParametricMask mask = make_parametric_mask(text, "wt");
    const Box box{{Rational(1, 5), Rational(-1, 3)}, {Rational(2, 3), Rational(1, 2)}};
    const auto controls = mask.controls(box);
    REQUIRE(controls);
    const Powers<Rational> below = bernstein(mask.denominators(), box, mask.sizes());
    for (int round = 0; round < 10; ++round) {
      const Rational u(random.integer(0, 12), 12), v(random.integer(0, 12), 12);
      const auto basis = [](const Rational& x, std::size_t n, std::size_t i) {
        Rational result = power(x, static_cast<long>(i)) * power(1 - x, static_cast<long>(n - i));
        for (std::size_t k = 0; k < i; ++k) result *= Rational(static_cast<long>(n - k), static_cast<long>(k + 1));
        return result;
      };
      LaurentPolynomial sum;
      Rational total = 0;
      for (std::size_t j = 0, at = 0; j < below.sizes[1]; ++j)
        for (std::size_t i = 0; i < below.sizes[0]; ++i, ++at) {
          const Rational weight = basis(u, below.sizes[0] - 1, i) * basis(v, below.sizes[1] - 1, j) * below.entries[at];
          sum += LaurentPolynomial(weight) * (*controls)[at];
          total += weight;
        }
      const Values w{box.low[0] + u * box.width(0), box.low[1] + v * box.width(1)};
      CHECK(LaurentPolynomial(1 / total) * sum == mask.at(w).symbol());
      CHECK(value_at(mask.denominators(), w) == total);
    }
  }
}

TEST_CASE("boxes and their parts") {
  const Box box{{0, 1, 2}, {1, 3, 6}};
  CHECK(box.volume() == 8);
  CHECK(box.middle() == Values{Rational(1, 2), 2, 4});
  CHECK(box.corner(5) == Values{1, 1, 6});
  Rational volume = 0;
  for (unsigned corner = 0; corner < box.corners(); ++corner) {
    const Box part = box.part(corner);
    CHECK(part.corner(corner) == box.corner(corner));
    CHECK(part.corner(7 - corner) == box.middle());
    volume += part.volume();
  }
  CHECK(volume == box.volume());
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

TEST_CASE("a map of three parameters is true at all of its points, and as that of two where one has no effect") {
  // The 4-point scheme with another tension on each side of a parameter that moves the mask.
  subcert::testing::Random random;
  const char* text = "mask:[-w,0,1/2+w+s*t,1,1/2+w-s*t,0,-w]";
  const ParametricMask mask = make_parametric_mask(text, "wst");
  const Box box{{Rational(-1, 4), Rational(-1, 2), Rational(-1, 2)}, {Rational(1, 4), Rational(1, 2), Rational(1, 2)}};
  const PropertyMap map = property_map(mask, *parse_range_property("convergent"), box, {4, 2, {Deadline::in(60)}});
  CHECK(map.sum_rules == 1);
  CHECK(map.complete);
  CHECK(map.share(Truth::yes) > Rational(1, 10));
  CHECK(map.share(Truth::yes) + map.share(Truth::no) + map.share(Truth::unknown) == 1);
  Rational volume = 0;
  for (const MapCell& cell : map.cells) {
    volume += cell.box.volume();
    if (cell.holds == Truth::unknown || random.integer(0, 3) > 0) continue;
    Values inside;
    for (std::size_t v = 0; v < 3; ++v)
      inside.push_back(cell.box.low[v] + cell.box.width(v) * Rational(random.integer(0, 8), 8));
    const Decision converges = holder_regularity(mask.at(inside), 6, {Deadline::in(10)}).converges;
    CHECK_FALSE((cell.holds == Truth::yes ? converges.is_no() : converges.is_yes()));
  }
  CHECK(volume == box.volume());
  const PropertyMap flat = map_of("mask:[-w,0,1/2+w+t,1,1/2+w-t,0,-w]", "convergent",
                                  {{Rational(-1, 4), -1}, {Rational(1, 4), 1}}, 4);
  const PropertyMap thick = property_map(
      make_parametric_mask("mask:[-w,0,1/2+w+t,1,1/2+w-t,0,-w]", "wts"), *parse_range_property("convergent"),
      {{Rational(-1, 4), -1, 0}, {Rational(1, 4), 1, 1}}, {4, 2, {Deadline::in(60)}});
  CHECK(flat.share(Truth::yes) == thick.share(Truth::yes));
  CHECK(flat.share(Truth::no) == thick.share(Truth::no));
}

TEST_CASE("determinants of products over boxes") {
  subcert::testing::Random random;
  for (const char* text :
       {"mask:[-w,0,1/2+w+t,1,1/2+w-t,0,-w]", "mask:[w,t,t,w]/(w+t)", "mask:[1,w*t,w*t,1]/(1+w*t)"}) {
    const ParametricMask mask = make_parametric_mask(text, "wt");
    const ParametricFamily family = transition_matrices(mask);
    family::FamilyRadius radius(family);
    for (const EigenvalueBound& bound : {EigenvalueBound{{0, 1}, 2, 0}, {{1}, -3, 0}, {{0}, 0, 2}}) {
      const Powers<Rational> polynomial = radius.characteristic(bound, Deadline());
      for (int round = 0; round < 4; ++round) {
        const Values w{random.integer(-9, 9), Rational(random.integer(1, 9), 10)};
        const Rational q = value_at(mask.denominators(), w);
        if (q == 0) continue;
        const RationalMatrix product = family.at(w).product(bound.word);
        RationalMatrix shifted = Rational(bound.re < 0 ? 1 : -1) * (bound.re == 0 ? second_compound(product) : product);
        for (std::size_t i = 0; i < shifted.rows(); ++i)
          shifted(i, i) += bound.re == 0 ? Rational(bound.im * bound.im) : bound.modulus();
        const auto factors = static_cast<long>(shifted.rows() * bound.word.size() * (bound.re == 0 ? 2 : 1));
        CHECK(value_at(polynomial, w) == determinant(shifted) * power(q, factors));
      }
    }
  }
}

TEST_CASE("a product is too large on a box only where it is at all of its values") {
  // The product 0 of corner cutting has the eigenvalues 2 r and 2 - 4 r, r = w/(w+t), also where both are negative.
  const ParametricMask mask = make_parametric_mask("mask:[w,t,t,w]/(w+t)", "wt");
  family::FamilyRadius radius(transition_matrices(divided_difference_scheme(mask, 1)));
  const auto above = [&](const Box& box, const Rational& least) {
    return radius.from_below(box, {0}, least, false, Deadline()).has_value();
  };
  for (const int sign : {1, -1}) {
    const auto box = [=](const Rational& w, const Rational& t) {
      const Rational side(1, 10);
      return sign > 0 ? Box{{w, t}, {w + side, t + side}} : Box{{-w - side, -t - side}, {-w, -t}};
    };
    CHECK(above(box(1, 3), Rational(9, 10)));  // r < 1.1/4.1
    CHECK_FALSE(above(box(1, 3), 1));          // r = 1/4 at one corner
    CHECK_FALSE(above(box(1, 3), Rational(6, 5)));
  }
  // Matrices of size 3, with the eigenvalues 2 r, 1 and 1 - 4 r: a negative denominator turns the sign of a
  // determinant.
  family::FamilyRadius odd(transition_matrices(
      divided_difference_scheme(make_parametric_mask("mask:[w,w/2+t/2,t-w,w/2+t/2,w]/(w+t)", "wt"), 1)));
  for (const Box& box :
       {Box{{3, 1}, {Rational(31, 10), Rational(11, 10)}}, Box{{Rational(-31, 10), Rational(-11, 10)}, {-3, -1}}}) {
    CHECK(odd.from_below(box, {0}, Rational(4, 3), false, Deadline()));
    CHECK_FALSE(odd.from_below(box, {0}, 2, false, Deadline()));
  }
  // Too large at the corners and in the middle, but not between them.
  family::FamilyRadius dip(transition_matrices(divided_difference_scheme(
      make_parametric_mask("mask:[251/1000-(w-1/4)^2-t^2/100,749/1000+(w-1/4)^2+t^2/100,749/1000+(w-1/4)^2+t^2/100,"
                           "251/1000-(w-1/4)^2-t^2/100]",
                           "wt"),
      1)));
  CHECK_FALSE(dip.from_below({{0, 0}, {1, 1}}, {0}, 1, false, Deadline()));
  CHECK(dip.from_below({{Rational(2, 5), 0}, {Rational(1, 2), 1}}, {0}, 1, false, Deadline()));
  CHECK_FALSE(above({{Rational(-1, 10), Rational(-1, 10)}, {Rational(1, 10), Rational(1, 10)}}, Rational(1, 100)));
}

TEST_CASE("shifts are stable on a box only where they are at all of its values") {
  // At the tension w + t = -1/2, or w/(8 t) + 1/8, the 4-point scheme is a hat of three times the width.
  for (const char* text :
       {"mask:[-w-t,0,1/2+w+t,1,1/2+w+t,0,-w-t]", "mask:[-w/8/t-1/8,0,5/8+w/8/t,1,5/8+w/8/t,0,-w/8/t-1/8]"}) {
    const Box range{{-1, -1}, {1, 1}};
    const family::BoxSearch search(make_parametric_mask(text, "wt"), *parse_range_property("C1"), range, {});
    const auto stable = [&](const Rational& w, const Rational& side) {
      return search.refutes_on({{w, Rational(1, 8)}, {w + side, Rational(1, 8) + side}});
    };
    CHECK(stable(Rational(-1, 2), Rational(1, 1000)));
    CHECK(stable(0, Rational(1, 1000)));
    // The middle is stable here, where a corner is not.
    CHECK_FALSE(stable(Rational(-5, 8), Rational(1, 10)));
    CHECK_FALSE(stable(Rational(-5, 8), Rational(1, 1000)));
    CHECK_FALSE(stable(-1, 2));
  }
}

TEST_CASE("a map with a denominator is that of the parameter in its place") {
  // Corner cutting with the ratio 1/(w+t), which converges for w + t > 1 alone.
  const PropertyMap map = map_of("mask:[1,w+t-1,w+t-1,1]/(w+t)", "convergent", {{1, 1}, {4, 2}}, 8);
  CHECK(map.share(Truth::yes) == 1);
  // Both signs of a denominator are decided; where it may vanish nothing is.
  const PropertyMap signs = map_of("mask:[w,t,t,w]/(w+t)", "convergent", {{-2, -2}, {2, 2}}, 8);
  CHECK(signs.share(Truth::yes) > Rational(1, 4));
  for (const MapCell& cell : signs.cells) {
    const Values centre = cell.box.middle();
    if (cell.holds == Truth::yes) CHECK(centre[0] * centre[1] > 0);
    if (cell.holds == Truth::no) CHECK(centre[0] * centre[1] < 0);
    const Rational low = cell.box.low[0] + cell.box.low[1], high = cell.box.high[0] + cell.box.high[1];
    if (low <= 0 && 0 <= high) CHECK(cell.holds == Truth::unknown);
  }
  const PropertyMap beyond = map_of("mask:[1,w+t-1,w+t-1,1]/(w+t)", "convergent", {{-1, 1}, {3, 2}}, 8);
  CHECK(beyond.share(Truth::yes) > Rational(1, 4));
  for (const MapCell& cell : beyond.cells) {
    const Rational low = cell.box.low[0] + cell.box.low[1], high = cell.box.high[0] + cell.box.high[1];
    if (cell.holds == Truth::yes) CHECK(low > 1);
    if (cell.holds == Truth::no) CHECK((low > 0 && high < 1));
  }
}

TEST_CASE("a map ends with its budget, with a reason") {
  const PropertyMap map = property_map(make_parametric_mask(six_points, "wt"), *parse_range_property("C1"),
                                       {{0, 0}, {1, 1}}, {4, 1, {Deadline::in(0)}});
  CHECK_FALSE(map.complete);
  REQUIRE(map.cells.size() == 1);
  CHECK(map.cells.front().reason == "the budget ran out");
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
  CHECK(kind("C1", {{0}, {1}}, 4) == ErrorKind::domain);
  CHECK(kind("C1", {{0, 0, 0}, {1, 1, 1}}, 4) == ErrorKind::domain);
}

constexpr const char* zero_on_cycle =
    "mask:[1/4,1/2+1/4*w,3/4+1/4*w,3/4+1/4*w,1/4,-1/4-1/2*w,-1/2-1/2*w,-1/4-1/2*w,1/4,3/4+1/4*w,3/4+1/4*w,1/2+1/4*w,"
    "1/4],arity=4";

TEST_CASE("zeros on a cycle of roots of unity at an irrational value") {
  // w = (sqrt(5) - 1)/2
  const LaurentPolynomial unstable = unstable_values(make_parametric_scheme(zero_on_cycle).mask);
  CHECK(unstable.exact_quotient(LaurentPolynomial({-1, 1, 1}, 0)).has_value());
}

TEST_CASE("stability of all masks nearby") {
  const Mask four = make_scheme("four-point:w=1/16").mask.curve();
  // The zeros of the even part stay: only errors elsewhere count.
  const Rational e(1, 100);
  CHECK(has_stable_shifts(four, std::vector<Rational>{e, 0, e, 0, e, 0, e}, 4).is_yes());
  CHECK_FALSE(has_stable_shifts(four, Rational(1, 2), 4).is_yes());
  CHECK(has_stable_shifts(four, power(Rational(10), -12), 4).is_yes());
  CHECK(has_stable_shifts(four, power(Rational(10), -12), 0).is_yes());
  CHECK_FALSE(has_stable_shifts(make_scheme("mask:[1,1,1,1]/2").mask.curve(), power(Rational(10), -12), 1).is_yes());
  CHECK_FALSE(has_stable_shifts(make_scheme("mask:[1,0,0,1]").mask.curve(), power(Rational(10), -12), 1).is_yes());
  // 0 at some of the zeros of Phi_10 and Phi_20 for w = (sqrt(5) - 1)/2 in place of 309017/500000
  const ParametricMask pentagon = make_parametric_scheme(zero_on_cycle).mask;
  CHECK(has_stable_shifts(pentagon.at(Rational(309017, 500000)), power(Rational(10), -12), 2).is_yes());
  CHECK_FALSE(has_stable_shifts(pentagon.at(Rational(309017, 500000)), power(Rational(10), -6), 2).is_yes());
}
