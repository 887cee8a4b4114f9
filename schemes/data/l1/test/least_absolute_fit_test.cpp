// The least absolute polynomials against all polynomials through as many data as they have coefficients.

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/l1/least_absolute_fit.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <random>

using namespace subcert;
using data::LeastAbsoluteFit;
using data::LeastAbsoluteFitter;

namespace {

using Data = std::vector<Rational>;
const Data outputs{Rational(9, 4), Rational(11, 4), 0, Rational(-7, 3)};

/// Lagrange's formula through the data at the nodes.
Rational value_at(const Data& data, const std::vector<int>& nodes, const Rational& x) {
  Rational sum = 0;
  for (const int i : nodes) {
    Rational term = data[static_cast<std::size_t>(i)];
    for (const int j : nodes)
      if (j != i) term *= (x - j) / Rational(i - j);
    sum += term;
  }
  return sum;
}

Rational leading(const Data& data, const std::vector<int>& nodes) {
  Rational sum = 0;
  for (const int i : nodes) {
    Rational term = data[static_cast<std::size_t>(i)];
    for (const int j : nodes)
      if (j != i) term /= Rational(i - j);
    sum += term;
  }
  return sum;
}

LeastAbsoluteFit<Rational> by_enumeration(const Data& data, int degree) {
  const int count = static_cast<int>(data.size());
  std::vector<bool> chosen(data.size(), false);
  std::fill_n(chosen.begin(), degree + 1, true);
  std::optional<Rational> least;
  std::vector<int> low, high;
  do {
    std::vector<int> nodes;
    for (int i = 0; i < count; ++i)
      if (chosen[static_cast<std::size_t>(i)]) nodes.push_back(i);
    Rational sum = 0;
    for (int i = 0; i < count; ++i) sum += abs(data[static_cast<std::size_t>(i)] - value_at(data, nodes, i));
    if (!least || sum < *least) {
      least = sum;
      low = high = nodes;
    } else if (sum == *least) {
      if (leading(data, nodes) < leading(data, low)) low = nodes;
      if (leading(data, nodes) > leading(data, high)) high = nodes;
    }
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  LeastAbsoluteFit<Rational> fit{{}, leading(data, low) == leading(data, high)};
  for (const Rational& x : outputs) fit.values.push_back((value_at(data, low, x) + value_at(data, high, x)) / 2);
  return fit;
}

/// Small integers, so that ties and polynomials are frequent.
Data tied_data(std::mt19937& engine, int points) {
  const int size = std::uniform_int_distribution<int>(0, 9)(engine);
  Data data;
  for (int i = 0; i < points; ++i) data.emplace_back(std::uniform_int_distribution<int>(-size, size)(engine));
  return data;
}

std::vector<double> rounded(const Data& data) {
  std::vector<double> result;
  for (const Rational& value : data) result.push_back(static_cast<double>(value));
  return result;
}

double largest(const std::vector<double>& data) {
  double size = 0;
  for (const double value : data) size = std::max(size, std::abs(value));
  return size;
}

}  // namespace

TEST_CASE("least absolute polynomials are those of enumeration, with and without ties") {
  std::mt19937 engine(Catch::rngSeed());
  int ties = 0, unique = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const int degree = trial % 4;
    const int points = std::uniform_int_distribution<int>(degree + 1, degree < 2 ? 9 : 7)(engine);
    const Data data = tied_data(engine, points);
    const LeastAbsoluteFitter fitter(points, degree, outputs);
    const LeastAbsoluteFit<Rational> expected = by_enumeration(data, degree), fit = fitter.fit(data);
    CAPTURE(degree, points, data);
    CHECK(fit.values == expected.values);
    CHECK(fit.unique == expected.unique);
    (fit.unique ? unique : ties) += 1;
    for (const double unit : {1.0, 0x1p-1070, 0x1p890, 0x1p1000}) {
      std::vector<double> scaled = rounded(data);
      for (double& value : scaled) value *= unit;
      double out[4];
      CHECK(fitter.fit(scaled.data(), out) == expected.unique);
      for (std::size_t o = 0; o < outputs.size(); ++o)
        CHECK(std::abs(out[o] / unit - static_cast<double>(expected.values[o])) <=
              (unit < 1e-300 ? 1e3 : 1e-12 * (1 + largest(rounded(data)))));
    }
  }
  CHECK(ties > 100);
  CHECK(unique > 500);
}

TEST_CASE("decisions in double precision are those of the exact values of the doubles") {
  std::mt19937 engine(Catch::rngSeed());
  for (int trial = 0; trial < 400; ++trial) {
    const int degree = trial % 4, points = degree + 2 + trial % 5;
    // Polynomials rounded: residuals are a few units in the last place, of either sign or zero.
    const double slope = std::uniform_real_distribution<double>(-1, 1)(engine);
    std::vector<double> values;
    for (int i = 0; i < points; ++i) values.push_back(1.0 / 3 + slope * i + (degree > 1 ? 0.1 * i * i : 0));
    if (trial % 3 == 0) values[static_cast<std::size_t>(points / 2)] *= 1e300;
    const Data exact(values.begin(), values.end());
    const LeastAbsoluteFitter fitter(points, degree, outputs);
    const LeastAbsoluteFit<Rational> expected = by_enumeration(exact, degree);
    CHECK(fitter.fit(exact).values == expected.values);
    double out[4];
    CHECK(fitter.fit(values.data(), out) == expected.unique);
    for (std::size_t o = 0; o < 2; ++o)
      CHECK(std::abs(out[o] - static_cast<double>(expected.values[o])) <=
            1e-14 * (1 + std::abs(static_cast<double>(expected.values[o]))) * points * points);
  }
}

TEST_CASE("least absolute polynomials turn, grow and shift with their data") {
  std::mt19937 engine(Catch::rngSeed());
  for (int trial = 0; trial < 400; ++trial) {
    const int degree = trial % 4, points = std::uniform_int_distribution<int>(degree + 1, 24)(engine);
    const Rational low(2 * points - 3, 4), high(2 * points - 1, 4);  // about the centre of the window
    const LeastAbsoluteFitter fitter(points, degree, {low, high});
    const Data data = tied_data(engine, points);
    const Data fit = fitter.fit(data).values;
    const Data reversed = fitter.fit(Data(data.rbegin(), data.rend())).values;
    CHECK(reversed == Data{fit[1], fit[0]});
    Data changed = data;
    const auto added = [&](const Rational& x) {
      return 3 - x / 7 * (degree > 0 ? 1 : 0) + (degree > 2 ? x * x * x : 0);
    };
    for (int i = 0; i < points; ++i) {
      Rational& value = changed[static_cast<std::size_t>(i)];
      value = Rational(-5, 3) * value + added(i);
    }
    CHECK(fitter.fit(changed).values ==
          Data{Rational(-5, 3) * fit[0] + added(low), Rational(-5, 3) * fit[1] + added(high)});
    CHECK(fitter.fit(changed).unique == fitter.fit(data).unique);
  }
}

TEST_CASE("known least absolute lines: ties, outliers, medians") {
  const auto line = [](const Data& data, int degree = 1) {
    const int n = static_cast<int>(data.size());
    return LeastAbsoluteFitter(n, degree, {Rational(2 * n - 3, 4), Rational(2 * n - 1, 4)}).fit(data);
  };
  CHECK(line({1, 2, 3, 4, 5, 1'000'000}).values == Data{Rational(13, 4), Rational(15, 4)});
  CHECK(line({1, -1, -1, 1, 1, -1, -1, 1}).values == Data{Rational(-1, 6), Rational(-1, 6)});
  CHECK_FALSE(line({1, -1, -1, 1, 1, -1, -1, 1}).unique);
  CHECK_FALSE(line({0, 1, 4, 9}).unique);
  CHECK(line({0, 0, 1, -1, -1, 1}).values[1] == 0);
  CHECK(line({Rational(-1, 100), Rational(1, 100), 1, -1, -1, 1}).values[1] == Rational(9, 200));
  CHECK(line({0, 1, 5, 9}, 0).values == Data{3, 3});
  CHECK(line({7, 1, 5}, 0).values == Data{5, 5});
  CHECK(line({4, 9}).unique);
  CHECK_THROWS_AS(LeastAbsoluteFitter(2, 2, {}), Error);
  CHECK_THROWS_AS(LeastAbsoluteFitter(65, 1, {}), Error);
  CHECK_THROWS_AS(LeastAbsoluteFitter(6, 1, {}).fit(Data{1, 2}), Error);
  const std::vector<double> bad{1, 2, std::numeric_limits<double>::quiet_NaN(), 4, 5, 6};
  double out[1];
  CHECK_THROWS_AS(LeastAbsoluteFitter(6, 1, {0}).fit(bad.data(), out), Error);
}

TEST_CASE("exact refinement is what reweighting comes near to where the minimiser is unique") {
  std::mt19937 engine(Catch::rngSeed());
  std::normal_distribution<double> gauss;
  std::vector<double> values(40);
  for (double& value : values) value = gauss(engine);
  for (const int degree : {0, 1, 3}) {
    L1Scheme exact{{degree == 0 ? 5 : 6}, degree}, near = exact;
    exact.options.exact = true;
    near.options.iterations = 3000;
    near.options.delta = 1e-22;
    for (const data::Boundary boundary :
         {data::Boundary::regression, data::Boundary::reflect, data::Boundary::shrink}) {
      const auto a = refine(data::curve_data(values), exact, {1, boundary});
      const auto b = refine(data::curve_data(values), near, {1, boundary});
      REQUIRE(a.values.size() == b.values.size());
      for (std::size_t i = 0; i < a.values.size(); ++i) CHECK(std::abs(a.values[i] - b.values[i]) < 1e-5);
    }
  }
}

TEST_CASE("the kink of exact lines on 6 points: factor 5/12 for ever") {
  L1Scheme scheme{{6}, 1};
  scheme.options.exact = true;
  std::vector<double> kink;
  for (int i = -12; i <= 12; ++i) kink.push_back(std::max(0, i));
  const auto fine = refine(data::curve_data(kink), scheme, {8, data::Boundary::shrink});
  const auto first = std::find_if(fine.values.begin(), fine.values.end(), [](double v) { return v != 0; });
  CHECK(*first == Approx(std::pow(5.0 / 12, 8)).epsilon(1e-13));
  CHECK(first[1] / first[0] == Approx(1.4).epsilon(1e-13));
}
