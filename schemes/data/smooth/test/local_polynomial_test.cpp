#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/smooth/smooth.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace subcert;
using namespace subcert::data;

namespace {

/// Positions with gaps between 1/8 and 2, multiples of 1/8, the mean distance 1.
std::vector<double> scattered(std::size_t count) {
  std::vector<double> positions{0};
  for (std::size_t i = 1; i < count; ++i)
    positions.push_back(positions.back() + static_cast<double>(1 + (i * 7919) % 16) / 8);
  const double mean = positions.back() / static_cast<double>(count - 1);
  for (double& x : positions) x /= mean;
  return positions;
}

Rational apply_row(const SmoothingRow& row, const std::vector<Rational>& data) {
  Rational sum = 0;
  for (std::size_t k = 0; k < row.weights.size(); ++k) sum += row.weights[k] * data[row.first + k];
  return sum;
}

Rational power_at(const Rational& x, int degree, int derivative) {
  Rational value = 1;
  for (int k = 0; k < derivative; ++k) value *= degree - k;
  return degree < derivative ? Rational(0) : Rational(value * power(x, degree - derivative));
}

}  // namespace

TEST_CASE("fits with weight reproduce polynomials and their derivatives, at any sites, exactly and in doubles") {
  const std::size_t count = 30;
  std::vector<Rational> weights(count, 1);
  weights[0] = weights[11] = weights[12] = 0;
  weights[20] = Rational(1, 3);
  for (const char* name : {"local:points=9,d=2,weight=box", "local:points=8,d=1", "local:width=7,d=3,weight=biweight",
                           "local:points=12,d=2,weight=triangle", "local:width=5,d=2,weight=epanechnikov"})
    for (const bool uniform : {true, false})
      for (const bool weighted : {false, true})
        for (const bool at_data : {false, true})
          for (const int derivative : {0, 1}) {
            CAPTURE(name, uniform, weighted, at_data, derivative);
            const LocalPolynomial method = make_local_polynomial(name);
            CHECK(to_text(make_local_polynomial(to_text(method))) == to_text(method));
            DataSites sites{count, weighted ? weights : std::vector<Rational>{}};
            if (!uniform) sites.positions = scattered(count);
            const LocalSmoother smoother(method, sites, {Boundary::regression, 1, derivative, 0, at_data});
            const auto rounded = smoother.rounded_rows();
            REQUIRE(rounded.size() == smoother.outputs());
            CHECK(smoother.outputs() == (at_data ? count : 2 * (count - 1) + 1));
            for (int q = 0; q <= method.degree; ++q) {
              std::vector<Rational> data;
              for (std::size_t i = 0; i < count; ++i)
                data.push_back(power_at(uniform ? Rational(i) : Rational(sites.positions[i]), q, 0));
              for (std::size_t o = 0; o < smoother.outputs(); o += 7)
                CHECK(apply_row(smoother.row(o), data) == power_at(smoother.position(o), q, derivative));
            }
            for (std::size_t o = 0; o < smoother.outputs(); ++o) {
              const SmoothingRow exact = smoother.row(o);
              CHECK(rounded[o].variance == Approx(static_cast<double>(exact.variance)).epsilon(1e-9));
              for (std::size_t k = 0; k < exact.weights.size(); ++k) {
                const std::size_t other = exact.first + k - rounded[o].first;
                const double weight = other < rounded[o].weights.size() ? rounded[o].weights[other] : 0;
                CHECK(weight == Approx(static_cast<double>(exact.weights[k])).margin(1e-10));
              }
            }
          }
}

TEST_CASE("a box about each datum is the filter of Savitzky and Golay") {
  const LocalSmoother smoother(make_local_polynomial("local:points=5,d=2,weight=box"), 9, {});
  const std::vector<Rational> quadratic{Rational(-3, 35), Rational(12, 35), Rational(17, 35), Rational(12, 35),
                                        Rational(-3, 35)};
  CHECK(smoother.row(4).weights == quadratic);
  CHECK(smoother.row(4).first == 2);
  // Within two data of an end the fit is to the five data there.
  CHECK(smoother.row(1).first == 0);
  CHECK(smoother.row(1).weights.size() == 5);
  const LocalSmoother slope(make_local_polynomial("local:points=5,d=2,weight=box"), 9, {Boundary::regression, 0, 1});
  CHECK(slope.row(4).weights ==
        std::vector<Rational>{Rational(-1, 5), Rational(-1, 10), 0, Rational(1, 10), Rational(1, 5)});
}

TEST_CASE("data continue past their ends for local polynomials as for schemes") {
  const std::vector<double> data{3, 1, 4, 1, 5, 9, 2, 6, 5, 3};
  for (const Boundary boundary : {Boundary::reflect, Boundary::periodic, Boundary::nearest, Boundary::constant}) {
    CAPTURE(to_text(boundary));
    const ExtendedData extended({boundary, 1, 0}, data.size());
    const LocalSmoother smoother(make_local_polynomial("local:points=5,d=1"), data.size(), {boundary, 1, 0, 2.5});
    std::vector<double> longer;
    for (long i = -10; i < 20; ++i) {
      const auto datum = extended.at<double>(i);
      longer.push_back(datum.outside * 2.5);
      for (const auto& [j, weight] : datum.terms) longer.back() += weight * data[j];
    }
    const LocalSmoother inner(make_local_polynomial("local:points=5,d=1"), longer.size(), {Boundary::regression, 1});
    const auto values = smoother.apply(data).values, wanted = inner.apply(longer).values;
    for (std::size_t o = 0; o < values.size(); ++o) CHECK(values[o] == Approx(wanted[o + 20]).margin(1e-13));
  }
}

TEST_CASE("a first fit at positions: on uniform ones the same limit, elsewhere polynomials are reproduced") {
  for (const char* name : {"primal:n=3", "dual:n=3", "primal:n=3,d=3", "ary:a=3,points=5,d=1"})
    for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::periodic, Boundary::nearest}) {
      CAPTURE(name, to_text(boundary));
      const Scheme scheme = make_scheme(name);
      const std::size_t count = 24;
      std::vector<double> places, data;
      for (std::size_t i = 0; i < count; ++i) {
        places.push_back(static_cast<double>(i));
        data.push_back(static_cast<double>((i * 7919) % 13));
      }
      const SmoothingOptions options{boundary, 1};
      const auto plain = SchemeSmoother(scheme.mask.curve(), count, options).apply(data).values;
      const SchemeSmoother placed(scheme.mask.curve(), {count, {}, places}, options, scheme.rules);
      const auto same = placed.apply(data).values;
      REQUIRE(same.size() == plain.size());
      for (std::size_t o = 0; o < plain.size(); ++o) CHECK(same[o] == Approx(plain[o]).margin(1e-11));

      const DataSites sites{count, {}, scattered(count)};
      const SchemeSmoother moved(scheme.mask.curve(), sites, options, scheme.rules);
      const auto rounded = moved.rounded_rows();
      for (std::size_t o = 0; o < moved.outputs(); o += 5) {
        const SmoothingRow row = moved.row(o);
        CHECK(rounded[o].variance == Approx(static_cast<double>(row.variance)).epsilon(1e-9));
        for (int q = 0; q <= (boundary == Boundary::regression ? scheme.rules->degree : 0); ++q) {
          std::vector<Rational> powers;
          for (const double x : sites.positions) powers.push_back(power(Rational(x), q));
          CHECK(apply_row(row, powers) == power(moved.position(o), q));
        }
      }
    }
}

TEST_CASE("indices and positions of continued data are inverse to each other") {
  const std::vector<double> at = scattered(9);
  for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::periodic}) {
    const ExtendedData data({boundary, 3, 1}, {9, {}, at});
    for (long i = -30; i < 40; ++i) {
      CAPTURE(to_text(boundary), i);
      CHECK(data.index_at(data.position(i)) == Approx(static_cast<double>(i)).margin(1e-9));
      CHECK(data.position(i) < data.position(i + 1));
    }
  }
}

TEST_CASE("the noise of several data at one position does not depend on their order") {
  std::vector<double> at, weights;
  for (const double x : scattered(30))
    for (int k = 0; k < 1 + static_cast<int>(x) % 4; ++k) {
      at.push_back(x);
      weights.push_back(k == 2 ? 0 : 1 + k);
    }
  std::mt19937_64 engine(1921);
  std::normal_distribution<double> gauss(0, 2);
  double sum = 0, squares = 0, nu = 0;
  constexpr int runs = 2000;
  for (int run = 0; run < runs; ++run) {
    std::vector<double> data, sorted_weights = weights;
    for (std::size_t i = 0; i < at.size(); ++i)
      data.push_back(5 * at[i] + (weights[i] > 0 ? gauss(engine) / std::sqrt(weights[i]) : 1e6));
    const NoiseEstimate noise = estimate_noise(data, weights, at);
    sum += noise.variance;
    squares += noise.variance * noise.variance;
    nu = noise.degrees_of_freedom;
    for (std::size_t i = 0, end = 0; i < at.size(); i = end) {
      while (end < at.size() && at[end] == at[i]) ++end;
      std::reverse(data.begin() + static_cast<std::ptrdiff_t>(i), data.begin() + static_cast<std::ptrdiff_t>(end));
      std::reverse(sorted_weights.begin() + static_cast<std::ptrdiff_t>(i),
                   sorted_weights.begin() + static_cast<std::ptrdiff_t>(end));
    }
    CHECK(estimate_noise(data, sorted_weights, at).variance == Approx(noise.variance));
  }
  const double mean = sum / runs;
  CHECK(mean == Approx(4).epsilon(0.03));
  CHECK(squares / runs - mean * mean == Approx(2 * 16 / nu).epsilon(0.15));
  // All at one position: the variance about the mean.
  const NoiseEstimate one = estimate_noise({1, 2, 6}, {}, {4, 4, 4});
  CHECK(one.variance == Approx(7));
  CHECK(one.degrees_of_freedom == Approx(2));
}

TEST_CASE("noise at scattered positions has the mean and the spread of its degrees of freedom") {
  const std::vector<double> at = scattered(60);
  std::mt19937_64 engine(1986);
  std::normal_distribution<double> gauss(0, 2);
  double sum = 0, squares = 0, nu = 0;
  constexpr int runs = 2000;
  for (int run = 0; run < runs; ++run) {
    std::vector<double> data;
    for (const double x : at) data.push_back(5 * x + gauss(engine));
    const NoiseEstimate noise = estimate_noise(data, {}, at);
    sum += noise.variance;
    squares += noise.variance * noise.variance;
    nu = noise.degrees_of_freedom;
  }
  const double mean = sum / runs;
  CHECK(mean == Approx(4).epsilon(0.03));
  CHECK(squares / runs - mean * mean == Approx(2 * 16 / nu).epsilon(0.15));
}

TEST_CASE("windows are chosen by their estimated error, schemes where data are uniform and nothing is said") {
  Samples samples{{{}}, {}, 0, 1, scattered(80)};
  std::mt19937_64 engine(3);
  std::normal_distribution<double> gauss(0, 0.1);
  for (const double x : samples.positions) samples.columns[0].push_back(std::sin(x / 5) + gauss(engine));
  const SmoothedSamples chosen = smooth(samples, "", {});
  REQUIRE(chosen.choice);
  CHECK(is_local_specification(chosen.method));
  double error = 0;
  for (std::size_t o = 0; o < chosen.positions.size(); ++o)
    error += std::pow(chosen.columns[0].values[o] - std::sin(chosen.positions[o] / 5), 2);
  CHECK(error / static_cast<double>(chosen.positions.size()) < 0.01 / 2);  // half the variance of the noise
  SmoothingOptions at_data;
  at_data.at_data = true;
  CHECK(smooth(samples, "local:d=2,weight=box", at_data).positions == samples.positions);
  samples.noise = 0.1;
  const SmoothedColumn known = smooth(samples, "local:points=9", at_data).columns[0];
  CHECK(known.noise->variance == Approx(0.01));
  CHECK(known.half_widths(0.95)[4] == Approx(1.959963985 * known.deviations[4]));
  CHECK(known.half_widths(0.95, BandKind::simultaneous)[4] > known.half_widths(0.95)[4]);
  // The width is in the units of the positions.
  Samples scaled = samples;
  for (double& x : scaled.positions) x = 3 + x / 10;
  scaled.origin = 3;
  scaled.spacing = Rational(1, 10);
  const auto a = smooth(samples, "local:width=4", at_data), b = smooth(scaled, "local:width=0.4", at_data);
  for (std::size_t i = 0; i < 80; ++i) CHECK(a.columns[0].values[i] == Approx(b.columns[0].values[i]).epsilon(1e-9));
}

TEST_CASE("several data at one position: each counts in a window, which grows where they are too few conditions") {
  subcert::testing::Random random;
  for (int round = 0; round < 40; ++round) {
    // Positions 0, 0, 1, 1, 1, 3, ... and a polynomial: fits that are determined keep it.
    std::vector<double> x{0};
    while (x.size() < 24) x.push_back(x.back() + static_cast<double>(random.integer(0, 2)));
    x.push_back(x.back() + 1);
    x.push_back(x.back() + 1);
    x.push_back(x.back() + 1);
    for (const int degree : {0, 1, 2})
      for (const auto weight : {LocalWeight::box, LocalWeight::tricube})
        for (const std::size_t points : {3, 7}) {
          CAPTURE(round, degree, points);
          std::vector<double> y;
          for (const double at : x) y.push_back(1 + (degree > 0 ? 2 * at : 0) - (degree > 1 ? at * at : 0));
          const LocalSmoother smoother({degree, weight, points, 0}, DataSites(x.size(), {}, x), {.at_data = true});
          const SmoothedData smoothed = smoother.apply(y);
          for (std::size_t i = 0; i < x.size(); ++i) {
            CHECK(std::abs(smoothed.values[i] - y[i]) < 1e-8 * (1 + std::abs(y[i])));
            const SmoothingRow row = smoother.row(i);
            Rational sum = 0;
            for (const Rational& one : row.weights) sum += one;
            CHECK(sum == 1);
          }
        }
  }
  // The same fit as by the means with their numbers as weights, where the window holds all.
  const std::vector<double> x{0, 1, 1, 2, 2, 2, 5}, y{1, 4, 2, 3, 5, 7, 2};
  Samples samples{{y}};
  samples.positions = x;
  const Samples means = merged(samples);
  CHECK(means.columns.front() == std::vector<double>{1, 3, 5, 2});
  CHECK(means.weights == std::vector<Rational>{1, 2, 3, 1});
  CHECK(samples.repeated());
  CHECK_FALSE(means.repeated());
  const auto fit = [](const Samples& of) {
    return smooth(of, "local:width=9,d=1,weight=box", {.at_data = true}).columns.front().values;
  };
  CHECK(fit(samples)[1] == Approx(fit(means)[1]).epsilon(1e-12));
  CHECK(fit(samples)[6] == Approx(fit(means)[3]).epsilon(1e-12));
  // The noise of data at one position is their variance.
  CHECK(estimate_noise({1, 2, 4}, {}, {0, 0, 0}).variance == Approx(7.0 / 3));
}

TEST_CASE("thousands of data at a few positions cost as the positions do, and all of them have one value") {
  Samples samples{{{}, {}}};
  for (int i = 0; i < 10'000; ++i) {
    samples.positions.push_back(std::floor(i / 2000.0));
    samples.columns[0].push_back(samples.positions.back() + (i % 2 == 0 ? 0.5 : -0.5));
    samples.columns[1].push_back(1 - samples.columns[0].back());
  }
  for (const char* scheme : {"", "local:d=1,robust=2", "local:points=3000"}) {  // hours if each datum had its own fit
    CAPTURE(scheme);
    const SmoothedSamples smoothed = smooth(samples, scheme, {.at_data = true, .path = false});
    for (std::size_t i = 0; i < samples.count(); i += 997) {
      const double at = samples.positions[i];
      CHECK(smoothed.columns[0].values[i] == smoothed.columns[0].values[static_cast<std::size_t>(at) * 2000]);
      CHECK(smoothed.columns[0].values[i] == Approx(at).margin(1e-9));
      CHECK(smoothed.columns[1].values[i] == Approx(1 - at).margin(1e-9));
    }
  }
}

TEST_CASE("several functions at once are smoothed as one after another") {
  subcert::testing::Random random;
  std::vector<std::vector<double>> columns(3);
  std::vector<double> x;
  for (int i = 0; i < 5000; ++i) {
    x.push_back(i == 0 ? 0 : x.back() + static_cast<double>(random.integer(0, 3)));
    for (auto& column : columns) column.push_back(static_cast<double>(random.integer(-99, 99)));
  }
  for (const std::size_t points : {9, 2100})
    for (const bool uniform : {true, false}) {
      const LocalSmoother smoother({1, LocalWeight::tricube, points},
                                   DataSites(x.size(), {}, uniform ? std::vector<double>() : x),
                                   {.at_data = true, .path = points < 100});
      const std::vector<SmoothedData> all = smoother.apply_to(columns);
      for (std::size_t c = 0; c < columns.size(); ++c) {
        const SmoothedData one = smoother.apply(columns[c]);
        CHECK(all[c].values == one.values);
        CHECK(all[c].variances == one.variances);
        CHECK(all[c].leverages == one.leverages);
        CHECK(all[c].path == one.path);
      }
    }
}

TEST_CASE("values at given positions, in any order, are those of the data there, and NaN where there are none") {
  subcert::testing::Random random;
  Samples uneven{{{}, {}}}, even{{{}, {}}};
  std::vector<double> x;
  for (int i = 0; i < 60; ++i) {
    x.push_back((i == 0 ? 2 : x.back()) + static_cast<double>(random.integer(i % 7 == 3 ? 0 : 1, 4)) / 4);
    for (Samples* samples : {&uneven, &even})
      for (auto& column : samples->columns) column.push_back(static_cast<double>(random.integer(-99, 99)));
  }
  uneven.put_at(x);
  std::vector<double> grid;
  for (int i = 0; i < 60; ++i) grid.push_back(0.5 + 0.1 * i);
  for (double& at : grid) at = std::round(at * 10) / 10;
  even.put_at(grid);
  for (const Samples& samples : {uneven, even})
    for (const char* text : {"local:points=9,d=2", "local:points=9,d=1,robust=2", "primal:n=2", "dual:n=3,d=1", "",
                             "l1:points=6,d=1,iterations=3"})
      for (const int derivative : {0, 1}) {
        if (derivative == 1 && std::string(text).starts_with("l1")) continue;
        CAPTURE(text, derivative, samples.uniform());
        SmoothingOptions options{Boundary::regression, 2, derivative, 0, true, false};
        options.sparse = false;
        const SmoothedSamples at_data = smooth(samples, text, options);
        options.at_data = false;
        const double nan = std::numeric_limits<double>::quiet_NaN();
        std::vector<std::size_t> order;
        for (int k = 0; k < 30; ++k) order.push_back(static_cast<std::size_t>(random.integer(0, 59)));
        const std::vector<double>& own = samples.uniform() ? samples.given : samples.positions;
        for (const std::size_t i : order) options.places.push_back(own[i]);
        options.places[7] = own.front() - 0.25;
        options.places[9] = own.back() + 0.25;
        const SmoothedSamples there = smooth(samples, text, options);
        CHECK(there.positions == options.places);
        CHECK(there.outside == 2);
        for (std::size_t c = 0; c < 2; ++c)
          for (std::size_t k = 0; k < order.size(); ++k) {
            const bool outside = k == 7 || k == 9;
            const double value = there.columns[c].values[k];
            CHECK(std::isnan(value) == outside);
            if (outside) continue;
            CHECK(std::abs(value - at_data.columns[c].values[order[k]]) < 1e-9);
            if (at_data.columns[c].deviations.empty()) continue;
            CHECK(std::abs(there.columns[c].deviations[k] - at_data.columns[c].deviations[order[k]]) < 1e-9);
          }
        options.places = {own.front() - 1, nan};
        CHECK_FAILS(smooth(samples, text, options), domain);
        options.places.pop_back();
        CHECK_FAILS(smooth(samples, text, options), data);
      }
}

TEST_CASE("the order of positions") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PositionOrder rising = order_of({0, 1, 1, 2}), falling = order_of({3, 2, 2, 1}),
                      mixed = order_of({2, nan, 0, 2, 1});
  CHECK(rising.rising);
  CHECK(rising.repeated == std::size_t{2});
  CHECK((falling.falling && !falling.rising));
  CHECK(falling.rows == std::vector<std::size_t>{3, 2, 1, 0});
  CHECK((!mixed.falling && !mixed.rising));
  CHECK(mixed.rows == std::vector<std::size_t>{2, 4, 0, 3});
  CHECK_FALSE(order_of({0, 1}).repeated);
  CHECK(order_of({nan}).rows.empty());
}

TEST_CASE("local polynomials that do not exist say why") {
  for (const char* text : {"local:points=1,d=2", "local:points=3,width=2", "local:width=0", "local:weight=round",
                           "local:d=-1", "local:points=3,points=4", "local:x=1"})
    CHECK_FAILS(make_local_polynomial(text), usage);
  CHECK_FAILS(smooth(Samples{{{1, 2, 3}}}, "local:points=1,d=1", {}), usage);  // of values without slopes
  CHECK_FAILS(smooth(Samples{{{1, 2, 3}}}, "local:points=5", {}), data);
  CHECK_FAILS(smooth(Samples{{{1, 2, 3, 4, 5}}}, "local:width=1/2", {}), data);
  CHECK_FAILS(smooth(Samples{{{1, 2, 3, 4, 5}}}, "local:points=3", {Boundary::regression, 0, 2}), domain);
  SmoothingOptions at_data;
  at_data.at_data = true;
  Samples scattered_samples{{{1, 2, 3, 4, 5}}, {}, 0, 1, {0, 1, 3, 4, 5}};
  CHECK_FAILS(smooth(scattered_samples, "bspline:degree=3", {}), domain);
}
