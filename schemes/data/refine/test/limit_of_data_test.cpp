#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <cmath>

using namespace subcert;
using namespace subcert::data;
using subcert::testing::Random;

namespace {

const std::vector<std::string> schemes_with_limits{
    "primal:n=1",       "primal:n=3",           "primal:n=3,d=3",    "dual:n=2",         "dual:n=3,d=3",
    "dual-odd:n=2",     "ary:a=3,points=4,d=3", "ary:a=3,points=5",  "ary:a=4,points=4", "dd:n=2",
    "bspline:degree=2", "bspline:degree=3",     "mask:[1,3,3,1]/4@0"};

/// Refined so far that the points are within some 1e-6 of the limit; the nearest point to each parameter is compared.
double distance(const GridData<double>& limit, const GridData<double>& fine) {
  const Axis& a = limit.axes[0];
  const Axis& b = fine.axes[0];
  double largest = 0;
  for (std::size_t i = 0; i < a.count; ++i) {
    const Rational at = (a.parameter(i) - b.first) / b.step;
    const double index = nearest_double(at);
    const auto low = static_cast<long>(std::floor(index));
    const auto value = [&](long j) {
      const long n = static_cast<long>(b.count);
      return fine.values[static_cast<std::size_t>(b.closed ? (j + n) % n : std::clamp(j, 0L, n - 1))];
    };
    const double t = index - std::floor(index);
    largest = std::max(largest, std::abs(limit.values[i] - ((1 - t) * value(low) + t * value(low + 1))));
  }
  return largest;
}

}  // namespace

TEST_CASE("limits are what refinement tends to, up to the ends") {
  Random random;
  for (const std::string& text : schemes_with_limits)
    for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::periodic, Boundary::shrink})
      for (const int levels : {0, 2}) {
        const Mask mask = make_scheme(text).mask.curve();
        std::vector<double> data;
        for (std::size_t i = 0; i < AxisRefiner(mask, boundary).window() + 12; ++i)
          data.push_back(static_cast<double>(random.integer(-8, 8)) / 8);
        const auto limit = limit_of_data(curve_data(data), {mask}, {levels, boundary, 1});
        const int deep = mask.arity() == 2 ? 13 : mask.arity() == 3 ? 8 : 7;
        const auto fine = refine(curve_data(data), mask, {deep, boundary, 1});
        CAPTURE(text, to_text(boundary), levels);
        CHECK(limit.axes[0].step == power(Rational(mask.arity()), -levels));
        CHECK(distance(limit, fine) < 3e-3);
        if (boundary == Boundary::regression || boundary == Boundary::reflect) {
          CHECK(limit.axes[0].first == 0);
          CHECK(limit.axes[0].parameter(limit.axes[0].count - 1) == Rational(data.size() - 1));
        }
      }
}

TEST_CASE("polynomials are their own limits, exactly") {
  Random random;
  for (const std::string& text : schemes_with_limits) {
    const Mask mask = make_scheme(text).mask.curve();
    const int degree = polynomial_reproduction(mask).reproduction_degree;
    const auto p = [&](const Rational& x) {
      Rational product = 1;
      for (int k = 0; k < degree; ++k) product *= x - Rational(k, 3);
      return product;
    };
    std::vector<Rational> data;
    for (std::size_t i = 0; i < AxisRefiner(mask, Boundary::regression).window() + 9; ++i)
      data.push_back(p(Rational(i)));
    for (const Boundary boundary : {Boundary::regression, Boundary::shrink}) {
      const auto limit = limit_of_data(curve_data(data), {mask}, {1, boundary, 1});
      CAPTURE(text, to_text(boundary));
      for (std::size_t i = 0; i < limit.values.size(); ++i) CHECK(limit.values[i] == p(limit.axes[0].parameter(i)));
    }
  }
}

TEST_CASE("levels agree where their points do") {
  Random random;
  for (const std::string& text : schemes_with_limits) {
    const Mask mask = make_scheme(text).mask.curve();
    std::vector<Rational> data;
    for (std::size_t i = 0; i < AxisRefiner(mask, Boundary::regression).window() + 3; ++i)
      data.push_back(random.rational());
    for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::periodic}) {
      const auto coarse = limit_of_data(curve_data(data), {mask}, {0, boundary, 1});
      const auto fine = limit_of_data(curve_data(data), {mask}, {2, boundary, 1});
      CAPTURE(text, to_text(boundary));
      const auto ratio = static_cast<std::size_t>(mask.arity() * mask.arity());
      for (std::size_t i = 0; i < coarse.values.size(); ++i) CHECK(coarse.values[i] == fine.values[ratio * i]);
    }
  }
}

TEST_CASE("limits on surfaces, and interpolation") {
  Random random;
  const std::vector<Mask> masks{make_scheme("dual:n=2").mask.curve(), make_scheme("dd:n=2").mask.curve()};
  GridData<Rational> data{{}, 2, {Axis::of(7), Axis::of(6, true)}};
  for (std::size_t i = 0; i < 2 * data.points(); ++i) data.values.push_back(random.integer(-5, 5));
  const auto limit = limit_of_data(data, tensor_product(masks), {0, Boundary::regression, 2});
  REQUIRE(limit.points() == data.points());
  // Along the second axis the scheme interpolates, so each of its rows is the limit of that row.
  for (std::size_t j = 0; j < 6; ++j) {
    const std::vector<Rational> row(data.values.begin() + static_cast<long>(14 * j),
                                    data.values.begin() + static_cast<long>(14 * (j + 1)));
    const auto alone = limit_of_data(curve_data(row, 2), {masks[0]}, {0, Boundary::regression, 1});
    for (std::size_t i = 0; i < 14; ++i) CHECK(alone.values[i] == limit.values[14 * j + i]);
  }
}
