#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>

using namespace subcert;
using namespace subcert::data;

TEST_CASE("values between points are on the straight line") {
  const GridData<double> open = curve_data(std::vector<double>{1, 3, 4});
  const std::vector<Rational> at{Rational(-1), 0, Rational(1, 4), 1, Rational(3, 2), 2, Rational(5, 2)};
  CHECK(interpolate(open, at) == std::vector<double>{-1, 1, 1.5, 3, 3.5, 4, 4.5});
  const GridData<double> closed = curve_data(std::vector<double>{1, 3, 4}, 1, true);
  CHECK(interpolate(closed, at) == std::vector<double>{4, 1, 1.5, 3, 3.5, 4, 2.5});
  CHECK_FAILS(interpolate(curve_data(std::vector<double>{1}), at), domain);
  CHECK_FAILS(interpolate(curve_data(std::vector<double>{1, 2, 3, 4}, 2), at), domain);
}

TEST_CASE("boundaries have names, and those that the filters have made common") {
  for (const auto* names : {&refinement_boundary_names(), &smoothing_boundary_names()})
    for (const std::string& name : *names) CHECK(parse_boundary(name));
  for (const std::string& name : refinement_boundary_names()) CHECK(to_text(*parse_boundary(name)) == name);
  CHECK(parse_boundary("interp") == Boundary::regression);
  CHECK(parse_boundary("mirror") == Boundary::reflect);
  CHECK(parse_boundary("wrap") == Boundary::periodic);
  CHECK_FALSE(parse_boundary("other"));
  CHECK_FALSE(parse_boundary(""));
}

TEST_CASE("a scheme of any family refines data") {
  const GridData<double> curve = curve_data(std::vector<double>{1, 3, 4, 0, 2, 7, 1, 1});
  const GridData<double> surface{std::vector<double>(30, 2), 1, {Axis::of(5), Axis::of(6)}};
  const RefineOptions options{2, Boundary::regression, 1};
  const auto values = [&](const GridData<double>& data, const char* text) {
    return refine(data, make_any_scheme(text), options).values;
  };
  CHECK(values(curve, "dual:n=2") == refine(curve, make_scheme("dual:n=2").mask.curve(), options).values);
  CHECK(values(curve, "l1:points=6") == refine(curve, make_l1_scheme("l1:points=6").rules, options).values);
  CHECK(values(surface, "grid:points=4x4").size() == 16 * 20);
  CHECK(values(surface, "tensor:(dd:n=2)x(primal:n=1)").size() == 17 * 21);
  CHECK(fewest_points(make_any_scheme("tensor:(dd:n=2)x(primal:n=1)"), Boundary::regression) ==
        std::vector<std::size_t>{4, 2});
  CHECK(fewest_points(make_any_scheme("grid:points=4x3"), Boundary::regression) == std::vector<std::size_t>{4, 3});
  CHECK(fewest_points(make_any_scheme("l1:points=4x5"), Boundary::regression) == std::vector<std::size_t>{4, 5});
  CHECK(values(surface, "tensor:(dd:n=2)x(ary:a=3,points=2,d=1)").size() == 17 * 46);
  CHECK(values(surface, "loop").size() > 200);
  for (const char* text : {"sqrt3", "quincunx", "mask2:[[1,1],[1,1]]@0,0,dilation=[-2,0;0,-2]"}) {
    CHECK_FAILS(refine(surface, make_any_scheme(text), options), domain);
    CHECK_FAILS(fewest_points(make_any_scheme(text), Boundary::regression), domain);
  }
  CHECK_FAILS(refine(curve, make_scheme("dual:n=2").mask, {1, Boundary::nearest}), domain);
}
