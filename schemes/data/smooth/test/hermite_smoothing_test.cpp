#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/smooth/robust_local.hpp>
#include <subcert/schemes/data/smooth/smooth.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace subcert;
using namespace subcert::data;

namespace {

/// The derivative of t^q.
Rational monomial(const Rational& t, int q, int derivative) {
  if (q < derivative) return 0;
  Rational value = 1;
  for (int k = 0; k < derivative; ++k) value *= q - k;
  return value * power(t, q - derivative);
}

struct Observation {
  Rational node, weight;
  int order;
};

/// The weights with which observations enter the derivative at x of the fit, by normal equations in monomials about x.
std::vector<Rational> by_normal_equations(const std::vector<Observation>& data, int degree, const Rational& x,
                                          int derivative) {
  const auto n = static_cast<std::size_t>(degree) + 1;
  const auto term = [&](const Observation& one, std::size_t q) {
    return monomial(one.node - x, static_cast<int>(q), one.order);
  };
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(n + data.size(), 0));
  for (std::size_t p = 0; p < n; ++p)
    for (std::size_t i = 0; i < data.size(); ++i) {
      for (std::size_t q = 0; q < n; ++q) rows[p][q] += data[i].weight * term(data[i], p) * term(data[i], q);
      rows[p][n + i] = data[i].weight * term(data[i], p);
    }
  for (std::size_t p = 0; p < n; ++p) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(p), rows.end(),
                                    [&](const auto& row) { return row[p] != 0; });
    REQUIRE(pivot != rows.end());
    std::swap(rows[p], *pivot);
    const Rational lead = rows[p][p];
    for (Rational& entry : rows[p]) entry /= lead;
    for (std::size_t other = 0; other < n; ++other)
      if (const Rational factor = rows[other][p]; other != p && factor != 0)
        for (std::size_t c = 0; c < rows[p].size(); ++c) rows[other][c] -= factor * rows[p][c];
  }
  std::vector<Rational> result(data.size());
  for (std::size_t i = 0; i < data.size(); ++i)
    result[i] = rows[static_cast<std::size_t>(derivative)][n + i] * monomial(1, derivative, derivative);
  return result;
}

Rational factor_at(LocalWeight weight, const Rational& u) { return u > 1 ? Rational(0) : distance_factor(weight, u); }

/// Sites of values with slopes; positions are multiples of 1/8, weights of 1/4, some 0.
DataSites random_sites(testing::Random& random, std::size_t rows) {
  DataSites sites{2 * rows};
  sites.derivatives = 1;
  double x = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    if (i > 0) x += static_cast<double>(random.integer(0, 10)) / 8;
    const long w = random.integer(0, 9);
    for (int k = 0; k < 2; ++k) {
      sites.positions.push_back(x);
      sites.weights.push_back(w == 0 ? Rational(0) : Rational(w + 5 * k, 4));
    }
  }
  return sites;
}

std::vector<Rational> whole_row(const SmoothingRow& row, std::size_t count) {
  std::vector<Rational> all(count, 0);
  for (std::size_t k = 0; k < row.weights.size(); ++k) all[row.first + k] = row.weights[k];
  return all;
}

/// A function with its slopes and noise for both.
Samples hermite_samples(std::size_t count, double value_noise, double slope_noise, unsigned seed, bool uniform) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> anywhere(0, 1);
  std::vector<double> x;
  for (std::size_t i = 0; i < count; ++i)
    x.push_back(uniform ? static_cast<double>(i) / 8 : static_cast<double>(count) / 8 * anywhere(random));
  std::ranges::sort(x);
  Samples samples{{{}, {}}};
  samples.slopes = true;
  for (const double at : x) {
    samples.columns[0].push_back(std::sin(at) + value_noise * normal(random));
    samples.columns[1].push_back(std::cos(at) + slope_noise * normal(random));
  }
  samples.put_at(std::move(x));
  return samples;
}

}  // namespace

TEST_CASE("fits of values and slopes are those of normal equations, exactly and in doubles") {
  testing::Random random;
  int tried = 0;
  for (const auto round : testing::rounds(60)) {
    const DataSites sites = random_sites(random, 14);
    const int degree = static_cast<int>(random.integer(0, 5)), derivative = round % (std::min(degree, 2) + 1);
    const auto kind = static_cast<LocalWeight>(random.integer(0, 4));
    LocalPolynomial method{degree, kind};
    method.width = 2.5;
    const LocalSmoother smoother(method, sites, {Boundary::regression, 1, derivative, 0, round % 3 == 0});
    bool complete = true;
    for (std::size_t o = 0; o < smoother.outputs(); ++o) {
      CAPTURE(o, degree, derivative);
      const Rational x = smoother.position(o);
      std::vector<Observation> data;
      std::set<double> counted;
      for (std::size_t i = 0; i < sites.count; ++i) {
        const Rational at(sites.positions[i]);
        const Rational weight = sites.weights[i] * factor_at(kind, abs(at - x) / Rational(method.width));
        if (weight > 0) counted.insert(sites.positions[i]);
        data.push_back({at, weight, static_cast<int>(i % 2)});
      }
      if (2 * counted.size() <= static_cast<std::size_t>(degree)) {
        CHECK_FAILS(smoother.row(o), data);
        complete = false;
        continue;
      }
      ++tried;
      const std::vector<Rational> expected = by_normal_equations(data, degree, x, derivative);
      const SmoothingRow row = smoother.row(o);
      CHECK(whole_row(row, sites.count) == expected);
      Rational variance = 0;
      for (std::size_t i = 0; i < sites.count; ++i)
        if (expected[i] != 0) variance += expected[i] * expected[i] / sites.weights[i];
      CHECK(row.variance == variance);
    }
    if (!complete) continue;
    const auto rounded = smoother.rounded_rows();
    for (std::size_t o = 0; o < smoother.outputs(); ++o) {
      const std::vector<Rational> exact = whole_row(smoother.row(o), sites.count);
      double size = 0;
      for (const Rational& weight : exact) size = std::max(size, std::abs(static_cast<double>(weight)));
      for (std::size_t k = 0; k < rounded[o].weights.size(); ++k)
        CHECK(std::abs(rounded[o].weights[k] - static_cast<double>(exact[rounded[o].first + k])) <= 1e-8 * size);
    }
  }
  CHECK(tried > 300);
}

TEST_CASE("two points and a box are cubic Hermite interpolation, and slopes of data are those of the fit") {
  DataSites sites{8, {}, {0, 0, 1, 1, 3, 3, 4, 4}};
  sites.derivatives = 1;
  const LocalPolynomial method = make_local_polynomial("local:points=2,d=3,weight=box");
  SmoothingOptions options;
  options.places = {0.5, 2};
  const LocalSmoother middle(method, sites, options);
  CHECK(middle.row(0).weights ==
        std::vector<Rational>{Rational(1, 2), Rational(1, 8), Rational(1, 2), Rational(-1, 8)});
  CHECK(middle.row(1).first == 2);
  CHECK(middle.row(1).weights ==
        std::vector<Rational>{Rational(1, 2), Rational(1, 4), Rational(1, 2), Rational(-1, 4)});
  CHECK_FAILS(LocalSmoother(make_local_polynomial("local:points=2,d=4,weight=box"), sites, options), usage);
  CHECK_FAILS(LocalSmoother(method, 8, options), usage);

  SmoothingOptions there{Boundary::regression, 0, 0, 0, true};
  there.as_observed = true;
  const LocalSmoother observed(make_local_polynomial("local:points=3,d=3,weight=box"), sites, there);
  CHECK(observed.outputs() == 8);
  std::vector<Rational> data;
  for (std::size_t i = 0; i < 8; ++i)
    data.push_back(monomial(Rational(sites.positions[i]), 3, static_cast<int>(i % 2)));
  for (std::size_t i = 0; i < 8; ++i) {
    const std::vector<Rational> row = whole_row(observed.row(i), 8);
    Rational sum = 0;
    for (std::size_t k = 0; k < 8; ++k) sum += row[k] * data[k];
    CHECK(sum == data[i]);
  }
  std::vector<double> rounded;
  for (const Rational& datum : data) rounded.push_back(static_cast<double>(datum));
  const std::vector<double> fits = observed.values(rounded, std::vector<double>(8, 1), 1);
  for (std::size_t i = 0; i < 8; ++i) CHECK(fits[i] == Approx(rounded[i]).margin(1e-11));
}

TEST_CASE("closed values with slopes go on as those of a longer file") {
  testing::Random random;
  const std::size_t rows = 9;
  DataSites once{2 * rows}, thrice{6 * rows};
  once.derivatives = thrice.derivatives = 1;
  for (std::size_t i = 0; i < 3 * rows; ++i)
    for (int k = 0; k < 2; ++k) {
      thrice.positions.push_back(static_cast<double>(i));
      if (i < rows) once.positions.push_back(static_cast<double>(i));
    }
  for (std::size_t i = 0; i < 2 * rows; ++i) once.weights.push_back(Rational(random.integer(1, 5)));
  for (std::size_t i = 0; i < 6 * rows; ++i) thrice.weights.push_back(once.weights[i % (2 * rows)]);
  for (const char* name : {"local:points=5,d=3", "local:width=3,d=4,weight=box", "local:points=2,d=1,weight=box"}) {
    const LocalSmoother closed(make_local_polynomial(name), once, {Boundary::periodic, 1});
    const LocalSmoother longer(make_local_polynomial(name), thrice, {Boundary::regression, 1});
    for (std::size_t o = 0; o < closed.outputs(); ++o) {
      CAPTURE(name, o);
      std::vector<Rational> folded(2 * rows, 0);
      const std::vector<Rational> row = whole_row(longer.row(o + 2 * rows), 6 * rows);
      for (std::size_t i = 0; i < row.size(); ++i) folded[i % (2 * rows)] += row[i];
      CHECK(whole_row(closed.row(o), 2 * rows) == folded);
    }
  }
  for (const Boundary boundary : {Boundary::reflect, Boundary::nearest, Boundary::constant})
    CHECK_FAILS(LocalSmoother(make_local_polynomial("local:points=5,d=3"), once, {boundary}), domain);
}

TEST_CASE("values with slopes: the answer has both, in any units, and less noise than from values alone") {
  for (const bool uniform : {true, false}) {
    const Samples samples = hermite_samples(200, 0.1, 0.1, 3, uniform);
    SmoothingOptions options{Boundary::regression, 0, 0, 0, true};
    const SmoothedSamples both = smooth(samples, "local:points=21,d=3", options);
    REQUIRE(both.columns.size() == 2);
    CHECK(both.positions == (uniform ? samples.given : samples.positions));
    Samples values = samples;
    values.slopes = false;
    values.columns.pop_back();
    const SmoothedSamples alone = smooth(values, "local:points=21,d=3", options);
    double error = 0, error_alone = 0, error_of_slopes = 0;
    for (std::size_t i = 0; i < both.positions.size(); ++i) {
      error += std::pow(both.columns[0].values[i] - std::sin(both.positions[i]), 2);
      error_of_slopes += std::pow(both.columns[1].values[i] - std::cos(both.positions[i]), 2);
      error_alone += std::pow(alone.columns[0].values[i] - std::sin(both.positions[i]), 2);
    }
    CHECK(error < 0.8 * error_alone);
    CHECK(error_of_slopes < 200 * 0.05 * 0.05);
    CHECK(std::sqrt(both.columns[0].noise->variance) == Approx(0.1).epsilon(0.25));
    CHECK(std::sqrt(both.columns[1].noise->variance) == Approx(0.1).epsilon(0.25));

    // x in units that are 1000 times as small, y 7 times: the same answer.
    Samples scaled = samples;
    for (double& value : scaled.columns[0]) value *= 7;
    for (double& value : scaled.columns[1]) value *= 7.0 / 1024;
    std::vector<double> x = uniform ? samples.given : samples.positions;
    for (double& at : x) at *= 1024;
    scaled.given.clear(), scaled.positions.clear();
    scaled.put_at(x);
    const SmoothedSamples other = smooth(scaled, "local:points=21,d=3", options);
    for (std::size_t i = 0; i < both.positions.size(); ++i) {
      CHECK(other.columns[0].values[i] == Approx(7 * both.columns[0].values[i]).margin(1e-9));
      CHECK(other.columns[1].values[i] == Approx(7.0 / 1024 * both.columns[1].values[i]).margin(1e-12));
      CHECK(other.columns[1].deviations[i] == Approx(7.0 / 1024 * both.columns[1].deviations[i]).epsilon(1e-9));
    }
    // The derivative that is asked for is that of the answer.
    options.derivative = 1;
    const SmoothedSamples slopes = smooth(samples, "local:points=21,d=3", options);
    REQUIRE(slopes.columns.size() == 1);
    CHECK(slopes.columns[0].values == both.columns[1].values);
  }
}

TEST_CASE("bands from values and slopes cover as often as they say") {
  int covered = 0, slopes_covered = 0;
  constexpr int draws = 300;
  for (int draw = 0; draw < draws; ++draw) {
    Samples samples = hermite_samples(60, 0.1, 0.3, 100 + static_cast<unsigned>(draw), draw % 2 == 0);
    for (std::size_t i = 0; i < samples.count(); ++i) {  // a line
      const double at = samples.uniform() ? samples.given[i] : samples.positions[i];
      samples.columns[0][i] += 2 * at - std::sin(at);
      samples.columns[1][i] += 2 - std::cos(at);
    }
    SmoothingOptions options;
    const double first = samples.uniform() ? samples.given.front() : samples.positions.front();
    options.places = {first + 3};
    const SmoothedSamples made = smooth(samples, "local:points=15,d=1", options);
    const double expected = 2 * (first + 3);
    covered += std::abs(made.columns[0].values[0] - expected) <= made.columns[0].half_widths(0.9)[0] ? 1 : 0;
    slopes_covered += std::abs(made.columns[1].values[0] - 2) <= made.columns[1].half_widths(0.9)[0] ? 1 : 0;
  }
  const double deviation = std::sqrt(0.9 * 0.1 * draws);
  for (const int count : {covered, slopes_covered}) {
    CHECK(count > 0.88 * draws - 4 * deviation);
    CHECK(count < 0.95 * draws + 4 * deviation);
  }
}

namespace {

void check_windows(std::size_t count) {
  for (const Selection selection : {Selection::risk, Selection::cross_validation})
    for (const int derivative : {0, 1}) {
      CAPTURE(count, selection == Selection::risk, derivative);
      double chosen = 0, best = 0;
      for (unsigned seed = 1; seed <= 4; ++seed) {
        const Samples samples = hermite_samples(count, 0.2, 0.2, seed, seed % 2 == 0);
        SmoothingOptions options{Boundary::regression, 0, derivative, 0, true};
        options.selection = selection;
        options.path = false;
        const auto error = [&](const SmoothedSamples& made) {
          double sum = 0;
          for (std::size_t i = 0; i < made.positions.size(); ++i) {
            const double x = made.positions[i];
            sum += std::pow(made.columns[0].values[i] - (derivative == 0 ? std::sin(x) : std::cos(x)), 2);
          }
          return sum;
        };
        const SmoothedSamples made = smooth(samples, "", options);
        REQUIRE(made.choice);
        double least = error(made);
        chosen += least;
        for (const SmoothingCandidate& one : made.choice->candidates)
          least = std::min(least, error(smooth(samples, one.specification, options)));
        best += least;
      }
      CHECK(chosen < 1.6 * best);
    }
}

}  // namespace

TEST_CASE("windows for values with slopes are near the best, for values and for slopes") { check_windows(100); }

TEST_CASE("windows for values with slopes are near the best, of more samples", "[long]") { check_windows(300); }

TEST_CASE("robust fits of values and slopes leave outliers of either out") {
  Samples samples = hermite_samples(120, 0.05, 0.05, 5, true);
  const SmoothingOptions options{Boundary::regression, 0, 0, 0, true};
  const SmoothedSamples clean = smooth(samples, "local:points=21,d=2,robust=3", options);
  for (std::size_t i = 10; i < 120; i += 15) samples.columns[i % 2][i] += 5;
  const SmoothedSamples spoiled = smooth(samples, "local:points=21,d=2,robust=3", options);
  const SmoothedSamples linear = smooth(samples, "local:points=21,d=2", options);
  double moved = 0, moved_linear = 0;
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < 120; ++i) {
      moved = std::max(moved, std::abs(spoiled.columns[c].values[i] - clean.columns[c].values[i]));
      moved_linear = std::max(moved_linear, std::abs(linear.columns[c].values[i] - clean.columns[c].values[i]));
    }
  CHECK(moved < 0.1);
  CHECK(moved_linear > 0.3);
  CHECK(spoiled.columns[0].deviations.size() == 120);
  CHECK(linear.columns[0].outliers + linear.columns[1].outliers > 0);
}

TEST_CASE("what values with slopes cannot be smoothed by is refused") {
  Samples samples = hermite_samples(30, 0.1, 0.1, 1, true);
  CHECK_FAILS(smooth(samples, "primal:n=2", {}), domain);
  CHECK_FAILS(smooth(samples, "l1:points=6", {}), domain);
  CHECK_FAILS(smooth(samples, "", {Boundary::regression, 0, 2}), domain);
  CHECK_FAILS(smooth(samples, "local:points=9,d=1", {Boundary::reflect}), domain);
  samples.columns.pop_back();
  CHECK_FAILS(smooth(samples, "", {}), data);
}

TEST_CASE("exact data give an exact fit, whatever the noise of slopes is said to be") {
  Samples samples{{{}, {}}};
  samples.slopes = true;
  std::vector<double> x{0, 0.5, 2, 2.5, 4, 7, 8, 8.5, 9};
  for (const double at : x) {
    samples.columns[0].push_back(1 - at + at * at * at);
    samples.columns[1].push_back(-1 + 3 * at * at);
  }
  samples.put_at(x);
  for (const auto& noise : {std::optional<double>(), std::optional(1e-9), std::optional(1e9)}) {
    samples.slope_noise = noise;
    const SmoothedSamples made = smooth(samples, "local:points=4,d=3", {Boundary::regression, 2});
    for (std::size_t o = 0; o < made.positions.size(); ++o) {
      const double at = made.positions[o];
      CHECK(made.columns[0].values[o] == Approx(1 - at + at * at * at).margin(1e-6));
      CHECK(made.columns[1].values[o] == Approx(-1 + 3 * at * at).margin(1e-6));
    }
  }
}
