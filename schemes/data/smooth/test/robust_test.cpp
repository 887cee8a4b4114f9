#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/data/smooth/robust_local.hpp>
#include <subcert/schemes/data/smooth/smooth.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace subcert;
using namespace subcert::data;

namespace {

SmoothingOptions at_data() { return {.at_data = true}; }

/// As robust_reference.R.
Samples reference_data() {
  Samples samples{{{}}};
  for (int i = 0; i < 30; ++i) {
    const double x = (20 * i + (i * 7919) % 13) / 20.0;
    samples.positions.push_back(x);
    samples.columns[0].push_back(x * x / 40 + ((i * i * 7919) % 101) / 100.0 + (i % 6 == 2 ? 8 : 0));
  }
  return samples;
}

/// Uneven positions from 0 on, the mean distance 1.
std::vector<double> uneven(std::size_t count, std::mt19937_64& engine) {
  std::uniform_real_distribution<double> gap(0.1, 1.9);
  std::vector<double> positions{0};
  while (positions.size() < count) positions.push_back(positions.back() + gap(engine));
  for (double& x : positions) x *= static_cast<double>(count - 1) / positions.back();
  return positions;
}

/// f at the positions with normal noise, and every `outlier_every`-th datum 20 deviations off, on both sides.
template <class Function>
std::vector<double> noisy(const std::vector<double>& positions, const Function& f, double sigma, int outlier_every,
                          std::mt19937_64& engine) {
  std::normal_distribution<double> gauss(0, sigma);
  std::uniform_int_distribution<int> any(0, 2 * std::max(1, outlier_every) - 1);
  std::vector<double> data;
  for (const double x : positions) {
    data.push_back(f(x) + gauss(engine));
    if (outlier_every == 0) continue;
    const int hit = any(engine);
    if (hit < 2) data.back() += (hit == 0 ? 20 : -20) * sigma;
  }
  return data;
}

}  // namespace

TEST_CASE("bisquare steps give the values of R's loess and lowess") {
  const Samples samples = reference_data();
  // By robust_reference.R, R 4.2.2: loess(span = 0.5, family = "symmetric", surface = "direct"); lowess for degree 1.
  const std::vector<std::vector<double>> wanted{
      {1.23687104099349, 1.34095511434967, 2.45563503182495, 5.62485166829819, 11.4538328869701, 13.3895909780658},
      {-0.0794386229737225, 0.557420464379229, 2.45712100101998, 5.69029786566373, 11.9417758258761, 21.7073807489814},
      {0.114946661070274, 0.518213652470612, 2.37477075674436, 5.44328449535381, 11.6199084080799, 21.8657624176357}};
  const std::size_t at[] = {0, 2, 8, 14, 21, 29};
  for (int degree = 0; degree < 3; ++degree)
    for (const int threads : {1, 2}) {
      const auto values =
          smooth(samples, fmt::format("local:points=15,d={},robust=3", degree), at_data(), threads).columns[0].values;
      for (std::size_t k = 0; k < std::size(at); ++k)
        CHECK(values[at[k]] == Approx(wanted[static_cast<std::size_t>(degree)][k]).epsilon(1e-12));
    }
  Samples weighted = samples;
  for (int i = 0; i < 30; ++i) weighted.weights.push_back(1 + (i * 5) % 3);
  const double once[] = {1.54514917768781, 2.10890092664742, 3.54927667869832,
                         6.82674169186287, 13.1548860396041, 22.3715342958069};
  const auto values = smooth(weighted, "local:points=15,d=1", at_data()).columns[0].values;
  for (std::size_t k = 0; k < std::size(at); ++k) CHECK(values[at[k]] == Approx(once[k]).epsilon(1e-12));
}

TEST_CASE("outliers do not move a robust fit: polynomials stay, at any positions, boundaries, weights and sizes") {
  subcert::testing::Random random;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const std::size_t count = 40;
    const int degree = static_cast<int>(random.integer(0, 2));
    const double unit = std::pow(10.0, static_cast<double>(random.integer(-100, 100)));
    Samples samples{{{}}};
    double x = 0;
    for (std::size_t i = 0; i < count; ++i) {
      samples.positions.push_back(x);
      x += static_cast<double>(random.integer(0, 3)) / 2;  // several data at one position
    }
    if (round % 3 == 0) samples.positions.clear();
    if (round % 2 == 0)
      for (std::size_t i = 0; i < count; ++i) samples.weights.push_back(Rational(random.integer(1, 3)));
    std::vector<double> truth;
    for (std::size_t i = 0; i < count; ++i) {
      const double at = samples.uniform() ? static_cast<double>(i) : samples.positions[i];
      truth.push_back(unit * (2 + (degree > 0 ? 3 * at : 0) - (degree > 1 ? at * at / 8 : 0)));
    }
    samples.columns[0] = truth;
    for (const std::size_t i : {8, 19, 30}) samples.columns[0][i] += unit * static_cast<double>(random.integer(50, 99));
    const auto fit = smooth(samples, fmt::format("local:points=17,d={},robust=12", degree), at_data()).columns[0];
    for (std::size_t i = 0; i < count; ++i)
      CHECK(std::abs(fit.values[i] - truth[i]) < 1e-3 * unit * (1 + std::abs(truth[i] / unit)));
  }
}

TEST_CASE("robust fits of equal values, of one datum, of too few, and at the edges of windows") {
  Samples equal{{std::vector<double>(12, 7)}};
  const auto same = smooth(equal, "local:points=5,robust=3", {});
  for (const double value : same.columns[0].values) CHECK(value == Approx(7));
  for (const double deviation : same.columns[0].deviations) CHECK(deviation == 0);
  CHECK(smooth(Samples{{{7}}}, "local:points=1,d=0,robust=3", {}).columns[0].values == std::vector<double>{7});
  CHECK(smooth(Samples{{{7}}}, "local:points=1,d=0,robust=3", {}).columns[0].half_widths(0.9).empty());
  CHECK_FAILS(smooth(Samples{{{1, 2, 3}}}, "local:points=5,robust=3", {}), data);
  // A window all of whose data are outliers of the whole keeps its fit.
  std::vector<double> far(60, 0);
  for (std::size_t i = 30; i < 40; ++i) far[i] = 100;
  const auto kept = smooth(Samples{{far}}, "local:points=5,weight=box,robust=3", at_data()).columns[0].values;
  CHECK(kept[35] == Approx(100));
  for (const Boundary boundary : {Boundary::reflect, Boundary::periodic, Boundary::nearest, Boundary::constant}) {
    SmoothingOptions options = at_data();
    options.boundary = boundary;
    options.constant = 7;
    const SmoothedSamples fit = smooth(equal, "local:points=5,robust=2", options);
    for (const double value : fit.columns[0].values) CHECK(value == Approx(7));
  }
  CHECK(to_text(make_local_polynomial("local:robust=2,points=9")) == "local:points=9,d=1,weight=tricube,robust=2");
  CHECK_FAILS(make_local_polynomial("local:points=9,robust=-1"), usage);
}

TEST_CASE("bands of robust fits cover as often as they say, with and without outliers, by the sandwich") {
  std::mt19937_64 engine(20);
  const auto line = [](double x) { return 3 + x / 7; };
  for (const int outlier_every : {0, 5}) {
    int inside = 0, all = 0;
    for (int run = 0; run < 150; ++run) {
      Samples samples{{{}}};
      samples.positions = uneven(200, engine);
      samples.columns[0] = noisy(samples.positions, line, 0.3, outlier_every, engine);
      const SmoothedSamples fit = smooth(samples, "local:points=41,d=1,robust=3", at_data());
      CHECK(fit.band_method == BandMethod::sandwich);
      const auto half = fit.columns[0].half_widths(0.95);
      for (std::size_t i = 10; i < 200; i += 60) {
        inside += std::abs(fit.columns[0].values[i] - line(samples.positions[i])) <= half[i] ? 1 : 0;
        ++all;
      }
    }
    CAPTURE(outlier_every, inside, all);
    // Four standard deviations of a count with the probability 0.95, and one hundredth for the asymptotics.
    const double spread = 4 * std::sqrt(0.95 * 0.05 / all) + 0.01;
    CHECK(std::abs(static_cast<double>(inside) / all - 0.95) < spread);
  }
}

TEST_CASE("the deviations and pseudodata of robust fits are those of the sandwich, summed up from its formula") {
  subcert::testing::Random random;
  for (const std::size_t count : {60, 61})
    for (const bool weighted : {false, true}) {
      CAPTURE(count, weighted);
      // Residuals of all sizes, so that some lie near the ends of the weights, on both sides.
      std::vector<double> x, y;
      std::vector<Rational> weights;
      for (std::size_t i = 0; i < count; ++i) {
        x.push_back(i == 0 ? 0 : x.back() + 1 + static_cast<double>(i % 3) / 4);
        const double size = i % 5 == 0 ? 7 : 1;
        y.push_back(std::sin(x.back() / 9) + size * static_cast<double>(random.integer(-99, 99)) / 100);
        if (weighted) weights.emplace_back(1 + static_cast<long>(i % 4));
      }
      const LocalPolynomial method{1, LocalWeight::tricube, 17, 0, 2};
      const DataSites sites(count, weights, x);
      const RobustFit fit = robust_fit(method, sites, {.at_data = true, .path = false}, y, 1);
      const SmoothedData plain = LocalSmoother(method, sites, {.at_data = true, .path = false}).apply(y);
      const auto weight = [&](std::size_t i) { return weighted ? static_cast<double>(weights[i]) : 1.0; };
      std::vector<double> residuals, moduli;
      for (std::size_t i = 0; i < count; ++i) {
        residuals.push_back(std::sqrt(weight(i)) * (y[i] - fit.values[i]));
        moduli.push_back(std::abs(residuals.back()));
      }
      std::ranges::sort(moduli);
      const double scale = 6 * (moduli[(count - 1) / 2] + moduli[count / 2]) / 2;
      double squares = 0, slope = 0, freedom = static_cast<double>(count);
      std::size_t beyond = 0, between = 0;
      const auto psi = [&](double r) { return std::abs(r) < scale ? r * std::pow(1 - r * r / scale / scale, 2) : 0; };
      for (std::size_t i = 0; i < count; ++i) {
        const double u = residuals[i] / scale;
        beyond += std::abs(u) >= 1 && std::abs(u) < 1.8 ? 1 : 0;
        between += std::abs(u) > 0.5 && std::abs(u) < 1 ? 1 : 0;
        squares += psi(residuals[i]) * psi(residuals[i]);
        slope += std::abs(u) < 1 ? (1 - u * u) * (1 - 5 * u * u) / static_cast<double>(count) : 0;
        freedom += weight(i) * plain.variances[i] - 2 * plain.leverages[i];
      }
      CHECK((beyond > 0 && between > 0));
      const double kappa = squares / (slope * slope * freedom);
      CHECK(fit.noise.variance == Approx(kappa).epsilon(1e-9));
      CHECK(fit.noise.degrees_of_freedom == Approx(freedom).epsilon(1e-9));
      for (std::size_t i = 0; i < count; ++i) {
        CHECK(fit.deviations[i] == Approx(std::sqrt(kappa * plain.variances[i])).epsilon(1e-9));
        CHECK(fit.pseudodata[i] ==
              Approx(fit.values[i] + psi(residuals[i]) / std::sqrt(weight(i)) / slope).epsilon(1e-9));
      }
    }
}

TEST_CASE("the window of a robust fit is chosen as if there were no outliers") {
  std::mt19937_64 engine(30);
  const auto wave = [](double x) { return std::sin(x / 20); };
  Samples samples{{{}}};
  samples.positions = uneven(1000, engine);
  samples.columns[0] = noisy(samples.positions, wave, 0.2, 5, engine);
  const auto error = [&](const SmoothedSamples& fit) {
    double sum = 0;
    for (std::size_t i = 0; i < 1000; ++i) sum += std::pow(fit.columns[0].values[i] - wave(samples.positions[i]), 2);
    return std::sqrt(sum / 1000);
  };
  double best = 1;
  for (const int points : {11, 15, 21, 29, 41, 57, 81})
    best = std::min(best, error(smooth(samples, fmt::format("local:points={},d=1,robust=3", points), at_data())));
  const SmoothedSamples chosen = smooth(samples, "local:d=1,robust=3", at_data());
  CAPTURE(chosen.method, best);
  CHECK(error(chosen) < 1.25 * best);
  CHECK(error(smooth(samples, "local:d=1", at_data())) > 2 * best);
}

TEST_CASE("wide windows, fitted at some places and interpolated, leave the fit by little of its deviation") {
  std::mt19937_64 engine(35);
  const auto wave = [](double x) { return std::sin(x / 300); };
  for (const bool uniform : {false, true})
    for (const char* name :
         {"local:points=150,d=1,robust=3", "local:points=601,d=1,robust=2", "local:points=900,d=2,robust=1",
          "local:points=2500,d=1", "local:points=2500,d=3,weight=biweight", "local:points=2100,d=1,weight=triangle"})
      for (const Boundary boundary : {Boundary::regression, Boundary::reflect}) {
        Samples samples{{{}}};
        samples.positions = uneven(4000, engine);
        if (uniform)
          for (std::size_t i = 0; i < 4000; ++i) samples.positions[i] = static_cast<double>(i);
        samples.columns[0] = noisy(samples.positions, wave, 0.3, 5, engine);
        if (uniform) samples.positions.clear();
        SmoothingOptions options{.boundary = boundary, .level = uniform ? 1 : 0, .path = false};
        const SmoothedColumn fast = smooth(samples, name, options).columns[0];
        options.sparse = false;
        const SmoothedColumn exact = smooth(samples, name, options).columns[0];
        REQUIRE(fast.values.size() == exact.values.size());
        double most = 0, squares = 0, spread = 0;
        for (std::size_t o = 0; o < exact.values.size(); ++o) {
          const double apart = std::abs(fast.values[o] - exact.values[o]) / exact.deviations[o];
          most = std::max(most, apart);
          squares += apart * apart / static_cast<double>(exact.values.size());
          spread = std::max(spread, std::abs(fast.deviations[o] / exact.deviations[o] - 1));
        }
        CAPTURE(uniform, name, to_text(boundary));
        CHECK(most < 0.1);
        CHECK(std::sqrt(squares) < 0.02);
        CHECK(spread < 0.01);
      }
}

TEST_CASE("outliers are counted where they spoil the noise, and nothing else is") {
  std::mt19937_64 engine(40);
  const auto wave = [](double x) { return std::sin(x / 9); };
  for (int run = 0; run < 50; ++run) {
    const auto at = uneven(300, engine);
    CHECK(count_outliers(noisy(at, wave, 0.1, 0, engine), {}, at) == 0);
    CHECK(count_outliers(noisy(at, wave, 0.1, 15, engine), {}, at) > 3);
  }
  std::vector<double> growth, step(50, 0), lattice, saw;
  for (int i = 0; i < 50; ++i) {
    growth.push_back(std::exp(i / 3.0));
    step[static_cast<std::size_t>(i)] = i < 25 ? 0 : 1;
    lattice.push_back(i % 2);
    saw.push_back((i * 7919) % 13);
  }
  for (const auto& data : {growth, step, lattice, saw, std::vector<double>{1, 2}, std::vector<double>(9, 4)})
    CHECK(count_outliers(data) == 0);
  // Two to five side by side, on one side, among noise; not a bend, nor steps that are the data.
  for (const std::size_t length : {2U, 3U, 5U, 6U}) {
    constexpr int runs = 40;
    int counted = 0, bends = 0;
    for (int run = 0; run < runs; ++run) {
      const auto at = uneven(200, engine);
      std::vector<double> data = noisy(at, wave, 0.1, 0, engine), peak = data, waves = data;
      for (std::size_t i = 0; i < length; ++i) data[80 + i] += 3;
      for (std::size_t i = 0; i < peak.size(); ++i) {
        peak[i] += 3 * std::exp(-0.2 * std::pow(static_cast<double>(i) - 80, 2));
        waves[i] += i / 4 % 2 == 0 ? 3 : 0;
      }
      counted += count_outliers(data, {}, at) == length ? 1 : 0;
      bends += count_outliers(peak, {}, at) > 0 ? 1 : 0;
      CHECK(count_outliers(waves, {}, at) == 0);
    }
    CHECK((length <= 5 ? counted > runs * 8 / 10 : counted == 0));
    CHECK(bends < runs / 8);
  }
  // At an end, and beside a missing datum.
  CHECK(count_outliers({1, 99, 1, 2, 1, 3, 2, 1, 2, 1, 3, 1}) == 1);
  CHECK(count_outliers({1, 2, 1, 2, 9e9, 2, 1, 2, 1, 3, 1}, {1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1}) == 0);
}

TEST_CASE("noise that is correlated from datum to datum is told, independent noise is not") {
  std::mt19937_64 engine(41);
  std::normal_distribution<double> normal(0, 0.1);
  const auto wave = [](double x) { return std::sin(x / 9); };
  const auto told = [&](std::size_t count, double rho, bool is_uneven) {
    int number = 0;
    for (int run = 0; run < 200; ++run) {
      const auto at = is_uneven ? uneven(count, engine) : std::vector<double>();
      std::vector<double> data, weights;
      double noise = 0;
      for (std::size_t i = 0; i < count; ++i) {
        noise = rho * noise + std::sqrt(1 - rho * rho) * normal(engine);
        const double weight = is_uneven ? 1 + static_cast<double>(i % 3) : 1;
        weights.push_back(weight);
        data.push_back(wave(is_uneven ? at[i] : static_cast<double>(i)) + noise / std::sqrt(weight));
      }
      number += correlated_differences(data, weights, at) ? 1 : 0;
    }
    return number;
  };
  for (const bool is_uneven : {false, true}) {
    CHECK(told(60, 0, is_uneven) <= 1);
    CHECK(told(1000, 0, is_uneven) <= 1);
    CHECK(told(1000, 0.5, is_uneven) > 180);
  }
  CHECK(told(200, 0.9, false) > 60);
  CHECK(told(20, 0.9, false) == 0);
  // Not of curves without noise, constant data, and where the noise is given.
  std::vector<double> curve;
  for (int i = 0; i < 200; ++i) curve.push_back(std::sin(i / 9.0));
  CHECK_FALSE(correlated_differences(curve));
  CHECK_FALSE(correlated_differences(std::vector<double>(100, 4)));
  CHECK_FALSE(correlated_differences({}));
}

TEST_CASE("l1 schemes at positions: on uniform ones the same values, elsewhere polynomials without the outliers") {
  std::mt19937_64 engine(50);
  for (const char* name : {"l1:points=6", "l1:points=7", "l1:points=8,d=2,iterations=20", "l1:points=5,d=0,delta=1e-4",
                           "l1:points=6,tolerance=1e-3"})
    for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::periodic}) {
      CAPTURE(name, to_text(boundary));
      const DataDependentScheme scheme = make_l1_scheme(name);
      std::vector<double> places;
      for (int i = 0; i < 30; ++i) places.push_back(i);
      const auto data = noisy(
          places, [](double x) { return std::sin(x / 3); }, 0.2, 6, engine);
      const SmoothingOptions options{boundary, 1};
      const auto plain = L1Smoother(scheme, {30}, options).values(data, 1);
      const auto placed = L1Smoother(scheme, {30, {}, places}, options).values(data, 1);
      const auto weighted = L1Smoother(scheme, {30, std::vector<Rational>(30, 1)}, options).values(data, 2);
      REQUIRE(plain.size() == placed.size());
      for (std::size_t o = 0; o < plain.size(); ++o) {
        CHECK(placed[o] == Approx(plain[o]).margin(1e-7));
        CHECK(weighted[o] == placed[o]);
      }
    }
  for (const char* name : {"l1:points=12,iterations=60,delta=1e-14", "l1:points=11,iterations=60,delta=1e-14"})
    for (const bool ties : {false, true}) {
      CAPTURE(name, ties);
      Samples samples{{{}}};
      samples.positions = uneven(60, engine);
      if (ties)
        for (std::size_t i = 1; i + 1 < 60; i += 3) samples.positions[i] = samples.positions[i - 1];
      for (const double x : samples.positions) samples.columns[0].push_back(5 - x / 3);
      for (std::size_t i = 4; i < 60; i += 7) samples.columns[0][i] += 30;
      for (std::size_t i = 0; i < 60; ++i) samples.weights.push_back(i % 11 == 5 ? 0 : 1 + i % 2);
      samples.columns[0][5] = 1e9;
      samples.drop_missing();
      for (SmoothingOptions options : {SmoothingOptions{}, at_data()}) {
        const SmoothedSamples fit = smooth(samples, make_l1_scheme(name), options);
        for (std::size_t o = 0; o < fit.positions.size(); ++o)
          CHECK(fit.columns[0].values[o] == Approx(5 - fit.positions[o] / 3).margin(0.01));
      }
    }
}

TEST_CASE("where more than half of the data are fitted exactly, the mean of the residuals tells the outliers") {
  Samples samples{{std::vector<double>(60, 0)}};
  samples.columns[0][30] = 1;
  CHECK(smooth(samples, "local:points=9,d=0", at_data()).columns[0].values[30] > 0.2);
  const SmoothedSamples robust = smooth(samples, "local:points=9,d=0,robust=3", at_data());
  for (const double value : robust.columns[0].values) CHECK(std::abs(value) < 1e-12);
}

TEST_CASE("l1 regression of degree 0 to all data is their median, where each counts as the root of its weight") {
  // The medians by weights, without weights and by inverse roots are others: 10, anything from 3 to 4, and 3.
  const DataDependentScheme scheme = make_l1_scheme("l1:points=6,d=0,iterations=300,delta=1e-20");
  const DataSites sites(6, {1, 1, 1, 1, 6, 1}, {0, 1.25, 2, 3.5, 4.5, 6});
  for (const double value : L1Smoother(scheme, sites, at_data()).values({20, 4, 1, 3, 10, 2}, 1))
    CHECK(value == Approx(4).epsilon(1e-6));
}

TEST_CASE("the bootstrap of l1 schemes is the one of its definition, for the median of all data") {
  constexpr std::size_t count = 9;
  const DataDependentScheme scheme = make_l1_scheme("l1:points=9,d=0,iterations=400,delta=1e-20");
  const std::vector<Rational> weights{1, 4, 1, Rational(1, 4), 1, 9, 1, 2, 1};
  const DataSites sites(count, weights, {0, 1.25, 2, 3.5, 4.5, 6, 6.5, 7.25, 9});
  SmoothingOptions options = at_data();
  options.resamples = 7;
  options.seed = 11;
  const L1Smoother smoother(scheme, sites, options);
  const std::vector<double> data{3, 1, 4, 1.5, 9, 2.6, 5, 3.5, 8};
  const auto fit_of = [&](const std::vector<double>& some) { return smoother.values(some, 1).front(); };
  const auto root = [&](std::size_t i) { return std::sqrt(static_cast<double>(weights[i])); };
  const auto scaled = [&](const std::vector<double>& some, double fit) {
    std::vector<double> residuals;
    for (std::size_t i = 0; i < count; ++i) residuals.push_back(root(i) * (some[i] - fit));
    return residuals;
  };
  const auto middle_modulus = [](std::vector<double> values) {
    for (double& value : values) value = std::abs(value);
    return median(std::move(values));
  };
  std::mt19937_64 engine(11);
  std::normal_distribution<double> gauss;
  std::vector<double> noise;
  for (std::size_t i = 0; i < count; ++i) noise.push_back(gauss(engine) / root(i));
  const double kept = middle_modulus(scaled(noise, fit_of(noise))) / middle_modulus(scaled(noise, 0));
  const double fit = fit_of(data);
  std::vector<double> left = scaled(data, fit);
  const double middle = median(left);
  CHECK(std::abs(middle) > 0.01);
  CHECK(std::abs(kept - 1) > 0.01);
  for (double& r : left) r = (r - middle) / kept;
  std::uniform_int_distribution<std::size_t> any(0, count - 1);
  std::vector<double> again;
  for (int run = 0; run < 7; ++run) {
    std::vector<double> drawn;
    for (std::size_t i = 0; i < count; ++i) drawn.push_back(left[any(engine)] / root(i));
    for (double& value : drawn) value += fit;
    again.push_back(fit_of(drawn));
  }
  double mean = 0, squares = 0;
  for (const double value : again) mean += value / 7;
  for (const double value : again) squares += (value - mean) * (value - mean);
  const L1Smoother::Spread spread = smoother.bootstrap(data, 1);
  for (const double deviation : spread.deviations) CHECK(deviation == Approx(std::sqrt(squares / 6)).epsilon(1e-6));
  // A quartile of the normal law, and the efficiency of the median of moduli beside the mean square.
  CHECK(std::sqrt(spread.noise.variance) == Approx(middle_modulus(left) / 0.6744897501960817).epsilon(1e-6));
  CHECK(spread.noise.degrees_of_freedom == Approx(0.37 * count));
}

TEST_CASE("bands of l1 schemes are drawn, and cover about as often as they say") {
  std::mt19937_64 engine(60);
  const auto line = [](double x) { return 1 - x / 5; };
  int inside = 0, all = 0;
  for (int run = 0; run < 60; ++run) {
    Samples samples{{{}}};
    samples.positions = uneven(60, engine);
    samples.columns[0] = noisy(samples.positions, line, 0.3, 8, engine);
    SmoothingOptions options;
    options.resamples = 60;
    const SmoothedSamples fit = smooth(samples, make_l1_scheme("l1:points=14,iterations=12"), options);
    CHECK(fit.band_method == BandMethod::bootstrap);
    const auto half = fit.columns[0].half_widths(0.95);
    for (std::size_t o = 5; o < fit.positions.size(); o += 16) {
      inside += std::abs(fit.columns[0].values[o] - line(fit.positions[o])) <= half[o] ? 1 : 0;
      ++all;
    }
  }
  CAPTURE(inside, all);
  // Four standard deviations of the count, and three hundredths for what is not exact in 60 drawings.
  CHECK(std::abs(static_cast<double>(inside) / all - 0.95) < 4 * std::sqrt(0.95 * 0.05 / all) + 0.03);
}

TEST_CASE("what robust methods cannot do is said") {
  const Samples few{{{1, 2, 3, 4, 5}}, {}, 0, 1, {0, 1, 3, 4, 5}};
  CHECK_FAILS(smooth(few, "l1:points=4,exact", {}), domain);
  CHECK_FAILS(smooth(few, "l1:points=6", {}), data);
  CHECK_FAILS(smooth(few, "l1:points=4", {Boundary::nearest}), domain);
  CHECK_FAILS(smooth(few, "l1:points=4", {Boundary::regression, 0, 1}), domain);
  Samples known = few;
  known.noise = 0.1;
  CHECK_FAILS(smooth(known, "l1:points=4", {}), domain);
  CHECK_FAILS(smooth(known, "local:points=4,robust=1", {}), domain);
  Samples coarse = few;
  coarse.spacing = 3;
  CHECK_FAILS(smooth(coarse, "l1:points=4", {}), data);
  CHECK_FAILS(smooth(coarse, "l1:points=3,d=0", {Boundary::periodic}), domain);
}
