#include "least_absolute_deviation.hpp"

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>

#include <cmath>

using namespace subcert;
using namespace subcert::data;
using subcert::testing::least_absolute_deviation;
using subcert::testing::Random;

namespace {

/// [o][i]: the weight of datum i in output o when all weights of the fit are 1.
std::vector<std::vector<Rational>> linear_rules(const RegressionWindow& window) {
  std::vector<std::vector<Rational>> rules(window.outputs());
  for (std::size_t i = 0; i < window.nodes(); ++i) {
    std::vector<Rational> unit(window.nodes(), 0);
    unit[i] = 1;
    const auto fits = weighted_fit(window, std::vector<Rational>(window.nodes(), 1), unit);
    for (std::size_t o = 0; o < rules.size(); ++o) rules[o].push_back(fits[o]);
  }
  return rules;
}

GridData<double> curve(const std::vector<double>& values) { return curve_data(values); }

double parameter(const GridData<double>& data, int axis, std::size_t i) {
  return static_cast<double>(data.axes[static_cast<std::size_t>(axis)].parameter(i));
}

const std::vector<Boundary> reproducing{Boundary::regression, Boundary::shrink};

}  // namespace

TEST_CASE("with all weights one the scheme is the linear one, exactly") {
  for (int points = 2; points <= 12; ++points)
    for (int degree = 0; degree <= std::min(3, points - 1); ++degree) {
      const int arity = 2 + (points + degree) % 4;
      const L1Scheme scheme{{points}, degree, {}, arity};
      const auto rules = linear_rules(l1_window(scheme));
      const LocalRegression linear = l1_linear_part(scheme);
      const Mask mask = regression_mask(linear);
      for (long o = 0; o < arity; ++o)
        for (int i = 0; i < points; ++i) {
          const long datum = linear.rules[0].first + i;
          CHECK(rules[static_cast<std::size_t>(o)][static_cast<std::size_t>(i)] ==
                mask.symbol().coefficient(linear.first_output + o - arity * datum));
        }
    }
}

TEST_CASE("with all weights one the surfaces are the printed least squares schemes") {
  for (int n = 1; n <= 4; ++n) {
    const Rational xi(1, 2 * n * n * (4 * n * n - 1));
    const auto even = linear_rules(l1_window({{2 * n, 2 * n}, 1}));
    std::size_t i = 0;
    for (int s = -n + 1; s <= n; ++s)
      for (int r = -n + 1; r <= n; ++r, ++i) {
        CHECK(even[0][i] == xi / 4 * (8 * n * n - 6 * r - 6 * s + 4));
        CHECK(even[1][i] == xi / 4 * (8 * n * n + 6 * r - 6 * s - 2));
        CHECK(even[2][i] == xi / 4 * (8 * n * n - 6 * r + 6 * s - 2));
        CHECK(even[3][i] == xi / 4 * (8 * n * n + 6 * r + 6 * s - 8));
      }
    const auto odd = linear_rules(l1_window({{2 * n + 1, 2 * n + 1}, 1}));
    i = 0;
    for (int s = -n; s <= n; ++s)
      for (int r = -n; r <= n; ++r, ++i)
        for (int o = 0; o < 4; ++o) {
          const int a = o % 2 == 0 ? -3 : 3, b = o / 2 == 0 ? -3 : 3;
          CHECK(odd[static_cast<std::size_t>(o)][i] ==
                Rational(1, (2 * n + 1) * (2 * n + 1)) * (1 + Rational(a * r + b * s, 4 * n * (n + 1))));
        }
  }
}

TEST_CASE("polynomials are reproduced up to the ends, and outliers where the windows can tell them are not") {
  for (const Boundary boundary : reproducing)
    for (const int points : {6, 7, 8})
      for (int degree = 0; degree <= 3; ++degree) {
        const auto p = [&](double x) { return degree == 0 ? 2.5 : 1 + std::pow(x / 10, degree) - x / 7; };
        std::vector<double> values;
        for (int i = 0; i < 20; ++i) values.push_back(p(i));
        const GridData<double> fine = refine(curve(values), {{points}, degree}, {3, boundary});
        if (boundary == Boundary::regression) {
          CHECK(parameter(fine, 0, 0) == 0.0625);
          CHECK(parameter(fine, 0, fine.points() - 1) == 18.9375);
        }
        for (std::size_t i = 0; i < fine.points(); ++i)
          CHECK(std::abs(fine.values[i] - p(parameter(fine, 0, i))) < 1e-11 * (1 + std::abs(p(parameter(fine, 0, i)))));
      }
  std::vector<double> line;
  for (int i = 0; i < 41; ++i) line.push_back(i == 20 ? 1000 : 2 * i);
  const GridData<double> fine = refine(curve(line), {{8}, 1, {1e-16, 100, 0, false}}, {});
  for (std::size_t i = 0; i < fine.points(); ++i) CHECK(fine.values[i] == Approx(2 * parameter(fine, 0, i)));
}

TEST_CASE("grids reproduce polynomials of total degree up to the ends and keep rows and columns apart") {
  for (const Boundary boundary : reproducing)
    for (const auto& points : {std::vector<int>{6, 6}, std::vector<int>{5, 4}})
      for (int degree = 0; degree <= 3; ++degree) {
        const auto p = [&](double x, double y) { return degree == 0 ? 1 : std::pow(x - 2 * y, degree) + x + 3; };
        const auto q = [&](double x, double y) { return degree == 0 ? 2 : std::pow(y / 3, degree) - x; };
        GridData<double> data{{}, 2, {Axis::of(14), Axis::of(11)}};
        for (int j = 0; j < 11; ++j)
          for (int i = 0; i < 14; ++i) {
            data.values.push_back(p(i, j));
            data.values.push_back(q(i, j));
          }
        const GridData<double> fine = refine(data, {points, degree}, {1, boundary, 2});
        REQUIRE(fine.is_canonical());
        for (std::size_t j = 0; j < fine.axes[1].count; ++j)
          for (std::size_t i = 0; i < fine.axes[0].count; ++i) {
            const double x = parameter(fine, 0, i), y = parameter(fine, 1, j);
            const double* at = fine.values.data() + 2 * (j * fine.axes[0].count + i);
            CHECK(at[0] == Approx(p(x, y)).margin(1e-9));
            CHECK(at[1] == Approx(q(x, y)).margin(1e-9));
          }
      }
}

TEST_CASE("volumes reproduce polynomials of total degree, and are grids where nothing depends on a variable") {
  const std::vector<int> points{4, 5, 3};
  for (const Boundary boundary : reproducing)
    for (int degree = 0; degree <= 2; ++degree) {
      const auto p = [&](double x, double y, double z) {
        return degree == 0 ? 1 : std::pow(x - 2 * y + z / 2, degree) + x - z;
      };
      GridData<double> data{{}, 1, {Axis::of(6), Axis::of(7), Axis::of(5)}};
      for (int k = 0; k < 5; ++k)
        for (int j = 0; j < 7; ++j)
          for (int i = 0; i < 6; ++i) data.values.push_back(p(i, j, k));
      const GridData<double> fine = refine(data, {points, degree}, {1, boundary, 2});
      REQUIRE(fine.is_canonical());
      std::size_t at = 0;
      for (std::size_t k = 0; k < fine.axes[2].count; ++k)
        for (std::size_t j = 0; j < fine.axes[1].count; ++j)
          for (std::size_t i = 0; i < fine.axes[0].count; ++i)
            CHECK(fine.values[at++] ==
                  Approx(p(parameter(fine, 0, i), parameter(fine, 1, j), parameter(fine, 2, k))).margin(1e-9));
    }
  Random random;
  std::vector<double> values;
  for (int i = 0; i < 7 * 6; ++i) values.push_back(static_cast<double>(random.integer(-1000, 1000)) / 64);
  for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::periodic}) {
    const GridData<double> grid{values, 1, {Axis::of(7), Axis::of(6)}};
    const GridData<double> flat = refine(grid, {{5, 4}, 1}, {1, boundary});
    GridData<double> volume{{}, 1, {Axis::of(7), Axis::of(6), Axis::of(4)}};
    for (int k = 0; k < 4; ++k) volume.values.insert(volume.values.end(), values.begin(), values.end());
    const GridData<double> fine = refine(volume, {{5, 4, 3}, 1}, {1, boundary});
    REQUIRE(fine.values.size() == fine.axes[2].count * flat.values.size());
    for (std::size_t i = 0; i < fine.values.size(); ++i)
      CHECK(fine.values[i] == Approx(flat.values[i % flat.values.size()]).margin(1e-9));
  }
}

TEST_CASE("without reweighting the schemes refine as the linear ones, with every boundary") {
  Random random;
  for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::periodic, Boundary::shrink})
    for (int points = 2; points <= 9; ++points)
      for (int degree = 0; degree <= std::min(3, points - 1); ++degree)
        for (const int count : {points, points + 1, 3 * points}) {
          if (boundary == Boundary::shrink && count < 3 * points) continue;  // nothing is left after a few levels
          std::vector<double> values;
          for (int i = 0; i < 2 * count; ++i) values.push_back(static_cast<double>(random.integer(-1000, 1000)) / 64);
          L1Scheme scheme{{points}, degree, {}, 2 + (points + degree + count) % 3};
          scheme.options.iterations = 0;
          const Mask mask = regression_mask(l1_linear_part(scheme));
          const GridData<double> data = curve_data(values, 2);
          const GridData<double> expected = refine(data, mask, {2, boundary}),
                                 got = refine(data, scheme, {2, boundary});
          INFO("points " << points << ", degree " << degree << ", arity " << scheme.arity << ", count " << count << ", "
                         << to_text(boundary));
          REQUIRE(got.axes[0].count == expected.axes[0].count);
          CHECK(got.axes[0].first == expected.axes[0].first);
          CHECK(got.axes[0].step == expected.axes[0].step);
          CHECK(got.axes[0].closed == expected.axes[0].closed);
          // At the ends the linear scheme fits polynomials of its reproduction degree, which may exceed its own.
          const int reproduced = degree % 2 == 0 && points % 2 == 0 ? degree + 1 : degree;
          if (boundary == Boundary::regression && reproduced != degree) continue;
          for (std::size_t i = 0; i < got.values.size(); ++i)
            CHECK(got.values[i] == Approx(expected.values[i]).margin(1e-10));
        }
}

TEST_CASE("the result does not depend on threads or on neighbouring windows") {
  Random random;
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i) values.push_back(static_cast<double>(random.integer(-1000, 1000)) / 64);
  const L1Scheme scheme{{6}, 1};
  const GridData<double> data = curve(values);
  const auto one = refine(data, scheme, {1, Boundary::shrink, 1}), two = refine(data, scheme, {1, Boundary::shrink, 2});
  CHECK(one.values == two.values);
  const L1Fitter fitter(l1_window(scheme), scheme.options);
  for (std::size_t w = 0; w < one.points() / 2; w += 1237) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(w);
    const auto fits = fitter.fit({begin, begin + 6});
    CHECK(fits[0] == Approx(one.values[2 * w]).epsilon(1e-12));
    CHECK(fits[1] == Approx(one.values[2 * w + 1]).epsilon(1e-12));
  }
}

TEST_CASE("closed data turn with the curve") {
  Random random;
  std::vector<double> values;
  for (int i = 0; i < 12; ++i) values.push_back(static_cast<double>(random.integer(-1000, 1000)) / 64);
  std::vector<double> turned(values.begin() + 5, values.end());
  turned.insert(turned.end(), values.begin(), values.begin() + 5);
  const L1Scheme scheme{{7}, 1};
  const auto a = refine(curve_data(values, 1, true), scheme, {1}), b = refine(curve_data(turned, 1, true), scheme, {1});
  REQUIRE(a.points() == 24);
  CHECK(a.axes[0].closed);
  for (std::size_t i = 0; i < 24; ++i) CHECK(b.values[i] == Approx(a.values[(i + 10) % 24]).epsilon(1e-12));
}

TEST_CASE("two points give Chaikin's scheme whatever the weights") {
  const GridData<double> fine = refine(curve({0, 4, -4}), L1Scheme{{2}, 1}, {});
  CHECK(fine.values == std::vector<double>{1, 3, 2, -2});
  CHECK(fine.axes[0].first == Rational(1, 4));
}

TEST_CASE("the impulse response lives on the support of the mask") {
  for (const int points : {6, 7, 8}) {
    const GridData<double> phi = l1_impulse_response({{points}, 1}, 6);
    double largest = 0;
    for (std::size_t i = 0; i < phi.points(); ++i) {
      const Rational x = phi.axes[0].parameter(i);
      const double value = phi.values[i];
      largest = std::max(largest, std::abs(value));
      if (2 * abs(x) > 2 * points - 1) CHECK(value == 0);
      CHECK(value == Approx(phi.values[phi.points() - 1 - i]).margin(1e-12));
    }
    CHECK(phi.axes[0].first <= -Rational(2 * points - 1, 2));
    CHECK(largest > 0);
  }
}

TEST_CASE("the exact least absolute deviation of a single impulse is zero for degree 1 and 6 to 8 points") {
  for (const int points : {6, 7, 8}) {
    const RegressionWindow window = l1_window({{points}, 1});
    for (std::size_t at = 0; at < window.nodes(); ++at) {
      std::vector<Rational> impulse(window.nodes(), 0);
      impulse[at] = 1;
      const auto exact = least_absolute_deviation(window, impulse);
      CHECK(exact.objective == 1);
      CHECK(exact.unique);
      CHECK(exact.fitted == std::vector<Rational>(window.nodes(), 0));
    }
  }
}

TEST_CASE("sizes of the schemes on data are checked") {
  const auto contains = [](const std::string& part) { return Catch::Matchers::Contains(part); };
  CHECK_THROWS_WITH(refine(curve({1, 2, 3}), L1Scheme{{6}, 1}, {}), contains("at least 6 points, got 3"));
  CHECK_THROWS_WITH(refine(curve({1, 2, 3, 4, 5}), L1Scheme{{4, 4}, 1}, {}), contains("got 2 for 1"));
  CHECK_THROWS_WITH(refine(curve({1, 2, 3}), L1Scheme{{2}, 1}, {-1}), contains("levels >= 0, got -1"));
  CHECK_FAILS(refine(curve({1, 2, 3}), L1Scheme{{2}, 1}, {100'000'000}), size);
  CHECK_THROWS_WITH(l1_window({{}, 1}), contains("one to three"));
  CHECK_THROWS_WITH(l1_impulse_response({{6}, 1}, 17), contains("level <= 16"));
}
