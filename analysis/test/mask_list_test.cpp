#include <subcert/analysis/family/mask_list.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;

namespace {

Mask mask(const char* specification) { return make_scheme(specification).mask.curve(); }

ExponentOfList exponent(const MaskList& list) { return exponent_of(list, {Deadline::in(60)}); }

void check_near(const std::optional<Rational>& found, double expected) {
  REQUIRE(found);
  CHECK(found->convert_to<double>() == Approx(expected).margin(1e-5));
}

/// The ends of the exponent of a list that is exact.
void check_exact(const ExponentOfList& found, double expected) {
  CHECK(found.exact.is_yes());
  check_near(found.exponent.lower, expected);
  check_near(found.exponent.upper, expected);
  CHECK(*found.exponent.lower <= *found.exponent.upper);
}

// An asymmetric mask with two sum rules: four coefficients of a filter near that of Daubechies.
const Mask skew(LaurentPolynomial({Rational(1, 4), Rational(1, 2), Rational(1, 4)}, 0) *
                    LaurentPolynomial({Rational(27, 10), Rational(-7, 10)}, 0),
                2);

}  // namespace

TEST_CASE("lists of masks: one mask, or the same one twice, is that scheme") {
  for (const char* one : {"primal:n=2", "four-point:w=1/20", "bspline:degree=3", "ary:a=3,points=4,d=1"}) {
    INFO(one);
    const auto alone = holder_regularity(mask(one), 8, {Deadline::in(20)}).proved_exponent();
    for (const MaskList& list : {MaskList{{mask(one)}},
                                 {{mask(one), mask(one)}},
                                 {{mask(one)}, {0, 0}, {}},
                                 {{mask(one), mask(one)}, {}, {{0, 1}, {1, 0}}}}) {
      const ExponentOfList found = exponent(list);
      REQUIRE(found.exponent.lower);
      CHECK(abs(*found.exponent.lower - *alone.lower) < Rational(1, 1000000));
      if (found.exponent.upper) CHECK(*found.exponent.upper >= *alone.lower - Rational(1, 1000000));
    }
  }
}

TEST_CASE("lists of masks: the interpolating scheme of four points and the cubic spline") {
  const std::vector<LatticeMask> masks{mask("dd:n=2"), mask("bspline:degree=3")};
  check_exact(exponent({masks}), 2);
  check_exact(exponent({masks, {0, 1}, {}}), 2.5);
  check_exact(exponent({masks, {1, 0}, {}}), 2.5);
  // As a graph the same sequences.
  const ExponentOfList graph = exponent({masks, {}, {{0, 1}, {1, 0}}});
  check_near(graph.exponent.lower, 2.5);
  CHECK(exponent({masks}).sequence == std::vector<std::size_t>{0});
}

TEST_CASE("lists of masks: the order of levels matters where masks are no mirror images") {
  // 0 twice in a row is not allowed, so that 1 comes at least every second level.
  const std::vector<LatticeMask> masks{mask("four-point:w=1/4"), mask("four-point:w=1/16")};
  const ExponentOfList found = exponent({masks, {}, {{0, 1}, {1, 0}, {1, 1}}});
  check_near(found.exponent.lower, 0.99734);
  CHECK(found.sequence == std::vector<std::size_t>{0, 1});
  // The other direction of each pair allows the same sequences read backwards, of which there are as many.
  const std::vector<LatticeMask> skewed{skew, mask("dd:n=2"), mask("bspline:degree=3")};
  const std::vector<std::pair<std::size_t, std::size_t>> cycle{{0, 1}, {1, 2}, {2, 0}};
  const ExponentOfList as_graph = exponent({skewed, {}, cycle}), as_period = exponent({skewed, {0, 1, 2}, {}});
  check_near(as_graph.exponent.lower, as_period.exponent.lower->convert_to<double>());
  const ExponentOfList backwards = exponent({skewed, {0, 2, 1}, {}});
  const ExponentOfList graph_backwards = exponent({skewed, {}, {{1, 0}, {2, 1}, {0, 2}}});
  check_near(graph_backwards.exponent.lower, backwards.exponent.lower->convert_to<double>());
  CHECK(abs(*as_period.exponent.lower - *backwards.exponent.lower) > Rational(1, 1000));
}

TEST_CASE("lists of masks: supports of any place and length are put on one window") {
  const Mask spline = mask("bspline:degree=3");
  const Mask moved(spline.symbol().shifted(7), 2);
  check_exact(exponent({{mask("dd:n=2"), moved}, {0, 1}, {}}), 2.5);
  check_near(exponent({{mask("bspline:degree=1"), mask("bspline:degree=5")}}).exponent.lower, 1);
}

TEST_CASE("lists of masks: what is refused") {
  const Mask none = Mask(LaurentPolynomial({1, 1, 1}, 0), 2);
  for (const MaskList& list : {MaskList{},
                               {{mask("dd:n=2"), mask("bspline:degree=2,a=3")}},
                               {{none}},
                               {{mask("dd:n=2")}, {1}, {}},
                               {{mask("dd:n=2")}, {}, {{0, 1}}},
                               {{mask("dd:n=2"), mask("dd:n=2")}, {}, {{0, 1}}},
                               {{mask("dd:n=2"), mask("dd:n=2"), mask("dd:n=2")}, {}, {{1, 2}, {0, 1}}},
                               {{mask("dd:n=2")}, std::vector<std::size_t>(7, 0), {}}})
    CHECK_THROWS_AS(exponent(list), Error);
  // Masks that diverge have no lower end.
  CHECK_FALSE(exponent({{mask("four-point:w=1"), mask("dd:n=2")}}).exponent.lower);
}
