#include "least_absolute_deviation.hpp"

#include <subcert/analysis/symbol/mask.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/l1_scheme.hpp>

#include <cmath>

using namespace subcert;
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

DataGrid curve(const std::vector<double>& values) { return {values, values.size()}; }

}  // namespace

TEST_CASE("with all weights one the scheme is the linear one, exactly") {
  for (int points = 2; points <= 12; ++points)
    for (int degree = 0; degree <= std::min(3, points - 1); ++degree) {
      const L1Scheme scheme{{points}, degree};
      const auto rules = linear_rules(l1_window(scheme));
      const LocalRegression linear = l1_linear_part(scheme);
      const Mask mask = regression_mask(linear);
      for (long o = 0; o < 2; ++o)
        for (int i = 0; i < points; ++i) {
          const long datum = linear.rules[0].first + i;
          CHECK(rules[static_cast<std::size_t>(o)][static_cast<std::size_t>(i)] ==
                mask.symbol().coefficient(linear.first_output + o - 2 * datum));
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

TEST_CASE("polynomials are reproduced, with outliers where the windows can tell them") {
  for (const int points : {6, 7, 8})
    for (int degree = 0; degree <= 3; ++degree) {
      DataGrid data;
      data.columns = 40;
      const auto p = [&](double x) { return degree == 0 ? 2.5 : 1 + std::pow(x / 10, degree) - x / 7; };
      for (int i = 0; i < 40; ++i) data.values.push_back(p(i));
      for (int level = 0; level < 3; ++level) data = l1_refine_complete({{points}, degree}, data);
      for (std::size_t i = 0; i < data.columns; ++i) {
        const double x = static_cast<double>(Rational(data.first_x + data.step * static_cast<long>(i)));
        CHECK(std::abs(data.values[i] - p(x)) < 1e-11 * (1 + std::abs(p(x))));
      }
    }
  DataGrid line;
  line.columns = 41;
  for (int i = 0; i < 41; ++i) line.values.push_back(i == 20 ? 1000 : 2 * i);
  const DataGrid fine = l1_refine_complete({{8}, 1, {1e-16, 100, 0, false}}, line);
  for (std::size_t i = 0; i < fine.columns; ++i)
    CHECK(fine.values[i] == Approx(2 * static_cast<double>(Rational(fine.first_x + fine.step * static_cast<long>(i)))));
}

TEST_CASE("grids reproduce polynomials of total degree and keep rows and columns apart") {
  for (const auto& points : {std::vector<int>{6, 6}, std::vector<int>{5, 4}})
    for (int degree = 0; degree <= 3; ++degree) {
      DataGrid data;
      data.columns = 14;
      data.rows = 11;
      data.dimension = 2;
      const auto p = [&](double x, double y) { return degree == 0 ? 1 : std::pow(x - 2 * y, degree) + x + 3; };
      const auto q = [&](double x, double y) { return degree == 0 ? 2 : std::pow(y / 3, degree) - x; };
      for (int j = 0; j < 11; ++j)
        for (int i = 0; i < 14; ++i) {
          data.values.push_back(p(i, j));
          data.values.push_back(q(i, j));
        }
      const DataGrid fine = l1_refine_complete({points, degree}, data, 2);
      REQUIRE(fine.columns == static_cast<std::size_t>(2 * (14 - points[0] + 1)));
      REQUIRE(fine.rows == static_cast<std::size_t>(2 * (11 - points[1] + 1)));
      for (std::size_t j = 0; j < fine.rows; ++j)
        for (std::size_t i = 0; i < fine.columns; ++i) {
          const double x = static_cast<double>(Rational(fine.first_x + fine.step * static_cast<long>(i)));
          const double y = static_cast<double>(Rational(fine.first_y + fine.step * static_cast<long>(j)));
          const double* at = fine.values.data() + 2 * (j * fine.columns + i);
          CHECK(at[0] == Approx(p(x, y)).margin(1e-9));
          CHECK(at[1] == Approx(q(x, y)).margin(1e-9));
        }
    }
}

TEST_CASE("the result does not depend on threads or on neighbouring windows") {
  Random random;
  DataGrid data;
  data.columns = 20000;
  for (std::size_t i = 0; i < data.columns; ++i) data.values.push_back(static_cast<double>(random.integer(-1000, 1000)) / 64);
  const L1Scheme scheme{{6}, 1};
  const DataGrid one = l1_refine_complete(scheme, data, 1), two = l1_refine_complete(scheme, data, 2);
  CHECK(one.values == two.values);
  const L1Fitter fitter(l1_window(scheme), scheme.options);
  for (std::size_t w = 0; w < one.columns / 2; w += 1237) {
    const auto begin = data.values.begin() + static_cast<std::ptrdiff_t>(w);
    const auto fits = fitter.fit({begin, begin + 6});
    CHECK(fits == std::vector<double>{one.values[2 * w], one.values[2 * w + 1]});
  }
}

TEST_CASE("two points give Chaikin's scheme whatever the weights") {
  const DataGrid fine = l1_refine_complete({{2}, 1}, curve({0, 4, -4}));
  CHECK(fine.values == std::vector<double>{1, 3, 2, -2});
  CHECK(fine.first_x == Rational(1, 4));
}

TEST_CASE("the impulse response lives on the support of the mask") {
  for (const int points : {6, 7, 8}) {
    const DataGrid phi = l1_impulse_response({{points}, 1}, 6);
    double largest = 0;
    for (std::size_t i = 0; i < phi.columns; ++i) {
      const Rational x = phi.first_x + phi.step * static_cast<long>(i);
      const double value = phi.values[i];
      largest = std::max(largest, std::abs(value));
      if (2 * abs(x) > 2 * points - 1) CHECK(value == 0);
      CHECK(value == Approx(phi.values[phi.columns - 1 - i]).margin(1e-12));
    }
    CHECK(phi.first_x <= -Rational(2 * points - 1, 2));
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
  CHECK_THROWS_WITH(l1_refine_complete({{6}, 1}, curve({1, 2, 3})), Catch::Matchers::Contains("at least 6 data, got 3 x 1"));
  CHECK_THROWS_WITH(l1_refine_complete({{4, 4}, 1}, curve({1, 2, 3, 4, 5})), Catch::Matchers::Contains("4 x 4 data"));
  CHECK_THROWS_WITH(l1_window({{}, 1}), Catch::Matchers::Contains("one or two"));
  CHECK_THROWS_WITH(l1_impulse_response({{6}, 1}, 17), Catch::Matchers::Contains("level <= 16"));
}
