#include "least_absolute_deviation.hpp"

#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>

using namespace subcert;
using namespace subcert::data;
using subcert::testing::least_absolute_deviation;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

using Float = boost::multiprecision::cpp_bin_float_100;

/// The closed forms of [MLZD15] for a window r = first, ..., last with the outputs x.
template <class Number>
std::vector<Number> closed_form_curve(int first, int last, const std::vector<Number>& w, const std::vector<Number>& f,
                                      const std::vector<Number>& positions) {
  Number t1 = 0, t2 = 0, t3 = 0;
  for (int r = first; r <= last; ++r) {
    const Number& weight = w[static_cast<std::size_t>(r - first)];
    t1 += weight;
    t2 += r * weight;
    t3 += r * r * weight;
  }
  std::vector<Number> result;
  for (const Number& x : positions) {
    Number sum = 0;
    for (int r = first; r <= last; ++r) {
      const auto i = static_cast<std::size_t>(r - first);
      sum += (1 - (t2 - x * t1) * ((r * t1 - t2) / (t1 * t3 - t2 * t2))) * w[i] * f[i];
    }
    result.push_back(sum / t1);
  }
  return result;
}

/// Eq. (10) to (14) of [MLZD15], the factor psi_1 multiplied into the brackets.
template <class Number>
std::vector<Number> closed_form_grid(int first, int last, const std::vector<Number>& w, const std::vector<Number>& f,
                                     const std::vector<std::pair<Number, Number>>& positions) {
  Number t1 = 0, t2 = 0, t3 = 0, t4 = 0, t5 = 0, t6 = 0;
  std::size_t i = 0;
  for (int s = first; s <= last; ++s)
    for (int r = first; r <= last; ++r, ++i) {
      t1 += w[i];
      t2 += r * w[i];
      t3 += s * w[i];
      t4 += r * r * w[i];
      t5 += r * s * w[i];
      t6 += s * s * w[i];
    }
  const Number kappa = t1 * t4 * t6 - t1 * t5 * t5 - t2 * t2 * t6 + 2 * t2 * t3 * t5 - t3 * t3 * t4;
  const Number l1 = t4 * t6 - t5 * t5, l2 = t2 * t6 - t3 * t5, l3 = t2 * t5 - t3 * t4, l4 = t1 * t6 - t3 * t3,
               l5 = t1 * t5 - t2 * t3, l6 = t1 * t4 - t2 * t2;
  std::vector<Number> result;
  for (const auto& [x, y] : positions) {
    Number sum = 0;
    i = 0;
    for (int s = first; s <= last; ++s)
      for (int r = first; r <= last; ++r, ++i) {
        const Number p1 = l1 - l2 * r + l3 * s, p2 = -l2 + l4 * r - l5 * s, p3 = l3 - l5 * r + l6 * s;
        sum += (p1 + x * p2 + y * p3) / kappa * w[i] * f[i];
      }
    result.push_back(sum);
  }
  return result;
}

std::vector<Rational> random_rationals(Random& random, std::size_t count) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(random.rational());
  return result;
}

std::vector<Rational> random_weights(Random& random, std::size_t count) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(abs(random.nonzero()));
  return result;
}

/// The smallest and largest node of a window along an axis.
std::pair<int, int> range(int points) {
  return points % 2 == 0 ? std::pair{1 - points / 2, points / 2} : std::pair{-(points / 2), points / 2};
}

template <class Number>
std::vector<Number> positions(int points) {
  const Number first = (points % 2 == 0 ? Number(1) : Number(-1)) / 4;
  return {first, first + Number(1) / 2};
}

template <class Number>
std::vector<std::pair<Number, Number>> grid_positions(int points) {
  const auto at = positions<Number>(points);
  return {{at[0], at[0]}, {at[1], at[0]}, {at[0], at[1]}, {at[1], at[1]}};
}

/// Window of a smooth signal with noise and with outliers.
std::vector<double> noisy_window(Random& random, std::size_t count) {
  std::vector<double> data;
  for (std::size_t i = 0; i < count; ++i) {
    double value = std::sin(0.7 * static_cast<double>(i)) + static_cast<double>(random.integer(-100, 100)) / 1000;
    if (random.chance(20)) value += static_cast<double>(random.integer(-90, 90)) / 10;
    data.push_back(value);
  }
  return data;
}

/// Exact sum of moduli of the residuals of the polynomial next to `fitted`, which rounding has moved off the
/// polynomials.
Rational sum_of_moduli(const RegressionWindow& window, const std::vector<double>& data,
                       const std::vector<double>& fitted) {
  const std::vector<Rational> values(fitted.begin(), fitted.end());
  const auto polynomial = weighted_fit(window, std::vector<Rational>(window.nodes(), 1), values);
  Rational sum = 0;
  for (std::size_t i = 0; i < data.size(); ++i) sum += abs(Rational(data[i]) - polynomial[i]);
  return sum;
}

}  // namespace

TEST_CASE("the basis of a window is orthogonal and has largest modulus 1") {
  for (const L1Scheme& scheme : {L1Scheme{{6}, 3}, L1Scheme{{7}, 2}, L1Scheme{{4, 4}, 3}, L1Scheme{{5, 4}, 2}}) {
    const RegressionWindow window = l1_window(scheme);
    for (std::size_t k = 0; k < window.terms(); ++k) {
      Rational largest = 0;
      for (const Rational& value : window.at_nodes()[k]) largest = std::max(largest, Rational(abs(value)));
      CHECK(largest == 1);
      for (std::size_t l = 0; l < k; ++l) {
        Rational sum = 0;
        for (std::size_t i = 0; i < window.nodes(); ++i) sum += window.at_nodes()[k][i] * window.at_nodes()[l][i];
        CHECK(sum == 0);
      }
    }
  }
}

TEST_CASE("weighted fits are the closed forms of the paper, exactly") {
  Random random;
  for (const auto round : rounds(10))
    for (int points = 2; points <= 9; ++points) {
      const auto [first, last] = range(points);
      const RegressionWindow line = l1_window({{points}, 1});
      auto w = random_weights(random, line.nodes()), f = random_rationals(random, line.nodes());
      CHECK(weighted_fit(line, w, f) == closed_form_curve(first, last, w, f, positions<Rational>(points)));
      if (points > 6) continue;
      const RegressionWindow grid = l1_window({{points, points}, 1});
      w = random_weights(random, grid.nodes());
      f = random_rationals(random, grid.nodes());
      CHECK(weighted_fit(grid, w, f) == closed_form_grid(first, last, w, f, grid_positions<Rational>(points)));
    }
}

TEST_CASE("starting values are those of the paper") {
  Random random;
  for (int n = 1; n <= 5; ++n) {
    const RegressionWindow window = l1_window({{2 * n}, 1});
    const auto f = random_rationals(random, window.nodes());
    Rational slope = 0, mean = 0;  // eq. (9)
    for (int r = -n + 1; r <= n; ++r) {
      slope += Rational(6 * r - 3, 4 * n * n * n - n) * f[static_cast<std::size_t>(r + n - 1)];
      mean += f[static_cast<std::size_t>(r + n - 1)] / (2 * n);
    }
    const Rational constant = mean - slope / 2;
    CHECK(weighted_fit(window, std::vector<Rational>(window.nodes(), 1), f) ==
          std::vector<Rational>{constant + slope / 4, constant + 3 * slope / 4});

    const RegressionWindow grid = l1_window({{2 * n, 2 * n}, 1});
    const auto g = random_rationals(random, grid.nodes());
    const Rational xi(1, 2 * n * n * (4 * n * n - 1));
    Rational b1 = 0, b2 = 0, b3 = 0;  // eq. (20)
    std::size_t i = 0;
    for (int s = -n + 1; s <= n; ++s)
      for (int r = -n + 1; r <= n; ++r, ++i) {
        b1 += xi / 2 * (4 * n * n + 5 - 6 * r - 6 * s) * g[i];
        b2 += 3 * xi * (2 * r - 1) * g[i];
        b3 += 3 * xi * (2 * s - 1) * g[i];
      }
    const auto at = [&](const Rational& x, const Rational& y) { return Rational(b1 + x * b2 + y * b3); };
    const Rational a(1, 4), b(3, 4);
    CHECK(weighted_fit(grid, std::vector<Rational>(grid.nodes(), 1), g) ==
          std::vector<Rational>{at(a, a), at(b, a), at(a, b), at(b, b)});
  }
}

TEST_CASE("iteratively reweighted fits agree with the closed forms in long arithmetic") {
  Random random;
  for (int points : {5, 6, 7, 8}) {
    const L1Scheme scheme{{points}, 1, {1e-8, 6, 0, false}};
    const L1Fitter fitter(l1_window(scheme), scheme.options);
    const auto [first, last] = range(points);
    for (const auto round : rounds(20)) {
      const std::vector<double> data = noisy_window(random, static_cast<std::size_t>(points));
      const std::vector<Float> f(data.begin(), data.end());
      std::vector<Float> nodes, w(f.size(), 1);
      for (int r = first; r <= last; ++r) nodes.emplace_back(r);
      for (int m = 0; m < scheme.options.iterations; ++m) {
        const auto fitted = closed_form_curve<Float>(first, last, w, f, nodes);
        for (std::size_t i = 0; i < f.size(); ++i)
          w[i] = 1 / sqrt((f[i] - fitted[i]) * (f[i] - fitted[i]) + Float(scheme.options.delta));
      }
      const auto expected = closed_form_curve<Float>(first, last, w, f, positions<Float>(points));
      const auto got = fitter.fit(data);
      for (std::size_t o = 0; o < 2; ++o) CHECK(abs(expected[o] - got[o]) < 1e-11);
    }
  }
  const L1Scheme scheme{{4, 4}, 1, {1e-6, 4, 0, false}};
  const L1Fitter fitter(l1_window(scheme), scheme.options);
  for (const auto round : rounds(10)) {
    const std::vector<double> data = noisy_window(random, 16);
    const std::vector<Float> f(data.begin(), data.end());
    std::vector<std::pair<Float, Float>> nodes;
    for (int s = -1; s <= 2; ++s)
      for (int r = -1; r <= 2; ++r) nodes.emplace_back(r, s);
    std::vector<Float> w(f.size(), 1);
    for (int m = 0; m < scheme.options.iterations; ++m) {
      const auto fitted = closed_form_grid<Float>(-1, 2, w, f, nodes);
      for (std::size_t i = 0; i < f.size(); ++i)
        w[i] = 1 / sqrt((f[i] - fitted[i]) * (f[i] - fitted[i]) + Float(scheme.options.delta));
    }
    const auto expected = closed_form_grid<Float>(-1, 2, w, f, grid_positions<Float>(4));
    const auto got = fitter.fit(data);
    for (std::size_t o = 0; o < 4; ++o) CHECK(abs(expected[o] - got[o]) < 1e-11);
  }
}

TEST_CASE("the smoothed objective reaches the least absolute deviation as delta shrinks") {
  Random random;
  struct Case {
    std::vector<int> points;
    int degree;
    int count;
  };
  for (const Case& c : {Case{{6}, 0, 20}, Case{{6}, 1, 40}, Case{{7}, 1, 40}, Case{{8}, 2, 20}, Case{{8}, 3, 20},
                        Case{{3, 3}, 1, 20}, Case{{4, 4}, 1, 5}, Case{{3, 3}, 2, 10}}) {
    L1Scheme scheme{c.points, c.degree};
    RegressionWindow window = l1_window(scheme);
    window = {window.node_points(), c.degree, window.node_points()};
    for (const auto round : rounds(c.count)) {
      const std::vector<double> data = noisy_window(random, window.nodes());
      const auto exact = least_absolute_deviation(window, {data.begin(), data.end()});
      const double optimum = static_cast<double>(exact.objective);
      double previous = INFINITY;
      for (const double delta : {1e-6, 1e-10, 1e-14, 1e-18}) {
        const L1Fitter fitter(window, {delta, 20000, 1e-13, false});
        const std::vector<double> fitted = fitter.fit(data);
        const double smoothed = fitter.objective(data, fitted);
        CHECK(smoothed <= previous * (1 + 1e-9));
        previous = smoothed;
        CHECK(sum_of_moduli(window, data, fitted) >= exact.objective);
      }
      INFO("points " << c.points[0] << ", degree " << c.degree << ", optimum " << optimum << ", reached " << previous);
      CHECK(previous <= optimum * (1 + 1e-6));
    }
  }
}

TEST_CASE("fits exist where the quotients of the closed forms vanish") {
  // psi_1 of eq. (10) is 0 for some node: the bracket 1 + psi_2 / (4 psi_1) + ... has no value, its product with psi_1
  // has.
  const RegressionWindow grid = l1_window({{3, 3}, 1});
  const std::vector<Rational> w(9, 1), f{1, 2, 3, 4, 5, 6, 7, 8, 10};
  CHECK_NOTHROW(weighted_fit(grid, w, f));
  // Data on a line but for one point: residuals are 0 but for rounding, weights differ by 1e11.
  const L1Scheme scheme{{6}, 1, {1e-22, 500, 0, false}};
  const L1Fitter fitter(l1_window(scheme), scheme.options);
  const auto fits = fitter.fit({1, 2, 3, 4, 5, 1e6});
  CHECK(std::abs(fits[0] - 3.25) < 1e-9);
  CHECK(std::abs(fits[1] - 3.75) < 1e-9);
  // Constant data have no residuals at all.
  CHECK(fitter.fit({7, 7, 7, 7, 7, 7}) == std::vector<double>{7, 7});
}

TEST_CASE("joint residuals weigh points, separate ones coordinates") {
  Random random;
  const RegressionWindow window = l1_window({{6}, 1});
  const L1Fitter separate(window, {1e-8, 6, 0, false}), joint(window, {1e-8, 6, 0, true});
  const std::vector<double> x = noisy_window(random, 6), y = noisy_window(random, 6);
  std::vector<double> points;
  for (std::size_t i = 0; i < 6; ++i) {
    points.push_back(x[i]);
    points.push_back(y[i]);
  }
  CHECK(joint.fit(x) == separate.fit(x));
  const auto both = L1Fitter(window, {1e-8, 6, 0, true}).fit(points, 2);
  // One weight per point commutes with rotations of the plane.
  std::vector<double> turned;
  for (std::size_t i = 0; i < 6; ++i) {
    turned.push_back(0.6 * x[i] - 0.8 * y[i]);
    turned.push_back(0.8 * x[i] + 0.6 * y[i]);
  }
  const auto turned_fit = joint.fit(turned, 2);
  for (std::size_t o = 0; o < 2; ++o) {
    CHECK(std::abs(turned_fit[2 * o] - (0.6 * both[2 * o] - 0.8 * both[2 * o + 1])) < 1e-12);
    CHECK(std::abs(turned_fit[2 * o + 1] - (0.8 * both[2 * o] + 0.6 * both[2 * o + 1])) < 1e-12);
  }
}

TEST_CASE("a tolerance stops each window by itself") {
  Random random;
  const RegressionWindow window = l1_window({{6}, 1});
  const L1Fitter fitter(window, {1e-8, 1000, 1e-6, false});
  constexpr std::size_t lanes = L1Fitter::lanes;
  std::vector<std::vector<double>> data;
  std::vector<double> in(6 * lanes), out(2 * lanes);
  for (std::size_t l = 0; l < lanes; ++l) {
    data.push_back(l == 0 ? std::vector<double>(6, 1.5) : noisy_window(random, 6));
    for (std::size_t i = 0; i < 6; ++i) in[i * lanes + l] = data[l][i];
  }
  L1Fitter::Workspace workspace;
  fitter.fit(in.data(), 1, out.data(), workspace);
  const L1Fitter longer(window, {1e-8, 20000, 0, false});
  for (std::size_t l = 0; l < lanes; ++l) {
    const auto alone = fitter.fit(data[l]), limit = longer.fit(data[l]);
    for (std::size_t o = 0; o < 2; ++o) {
      CHECK(out[o * lanes + l] == alone[o]);
      CHECK(std::abs(alone[o] - limit[o]) < 1e-2);
    }
  }
}

TEST_CASE("broken preconditions of fits are named") {
  const RegressionWindow window = l1_window({{6}, 1});
  CHECK_THROWS_WITH(L1Fitter(window, {0, 6, 0, false}), Catch::Matchers::Contains("delta > 0"));
  CHECK_THROWS_WITH(L1Fitter(window, {1, -1, 0, false}), Catch::Matchers::Contains("iterations >= 0, got -1"));
  CHECK_THROWS_WITH(L1Fitter(window, {1, 1, NAN, false}), Catch::Matchers::Contains("tolerance >= 0"));
  CHECK_THROWS_WITH(l1_window({{6}, 4}), Catch::Matchers::Contains("degree <= 3, got 4"));
  CHECK_THROWS_WITH(l1_window({{3}, 3}), Catch::Matchers::Contains("points > degree = 3, got 3"));
  CHECK_THROWS_WITH(weighted_fit(window, {1, 1}, {1, 1}), Catch::Matchers::Contains("got 2 and 2 for 6"));
}
