#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/schemes/data/smooth/smoothing_stream.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace subcert;
using namespace subcert::data;

namespace {

Samples waves() {
  Samples samples{{{}, {}}, {}, Rational(2), Rational(1, 10)};
  for (int i = 0; i < 40; ++i) {
    samples.columns[0].push_back(std::sin(0.2 * i) + 0.01 * ((i * 7919) % 13 - 6));
    samples.columns[1].push_back(3 + 0.5 * i);
  }
  return samples;
}

}  // namespace

TEST_CASE("columns are smoothed with deviations, bands and derivatives in units of the positions") {
  const Scheme scheme = make_scheme("primal:n=3");
  const SmoothedSamples limit = smooth(waves(), scheme, {Boundary::regression, 1});
  REQUIRE(limit.positions.size() == 79);
  CHECK(limit.positions[3] == 2.15);
  const SchemeSmoother smoother(scheme.mask.curve(), 40, {Boundary::regression, 1});
  CHECK(limit.columns[0].values == smoother.apply(waves().columns[0]).values);
  const NoiseEstimate noise = estimate_noise(waves().columns[0]);
  for (std::size_t o = 0; o < 79; ++o) {
    const double deviation = std::sqrt(noise.variance * static_cast<double>(smoother.row(o).variance));
    CHECK(limit.columns[0].deviations[o] == Approx(deviation));
    CHECK(limit.columns[0].half_widths(0.9)[o] == Approx(band_factor(0.9, noise) * deviation));
  }
  const SmoothedSamples slopes = smooth(waves(), scheme, {Boundary::regression, 0, 1});
  for (const double slope : slopes.columns[1].values) CHECK(slope == Approx(5));
  const SmoothedSamples single = smooth(Samples{{{7}}}, scheme, {});
  CHECK(single.columns[0].values == std::vector<double>{7});
  CHECK(single.columns[0].half_widths(0.9).empty());
}

TEST_CASE("the path of simultaneous bands is that of the rows, one after another") {
  const auto angles = [](const LinearSmoother& smoother, const std::vector<double>& weights) {
    double sum = 0;
    const RoundedRow* last = nullptr;
    const auto rows = smoother.rounded_rows();
    for (const auto& row : rows) {
      if (row.variance == 0) continue;
      double product = 0;
      for (std::size_t k = 0; last && k < row.weights.size(); ++k) {
        const std::size_t i = row.first + k;
        if (i >= last->first && i < last->first + last->weights.size() && row.weights[k] != 0)
          product += row.weights[k] * last->weights[i - last->first] / weights[i];
      }
      if (last) sum += std::acos(std::min(1.0, std::abs(product) / std::sqrt(row.variance * last->variance)));
      last = &row;
    }
    return sum;
  };
  for (const char* name : {"primal:n=3", "dual:n=4", "primal:n=4,d=3"})
    for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::constant, Boundary::periodic})
      for (const int level : {0, 2})
        for (const int kind : {0, 1, 2}) {  // equal weights, two runs of weights, a gap
          CAPTURE(name, to_text(boundary), level, kind);
          const Scheme scheme = make_scheme(name);
          std::vector<Rational> prior;
          std::vector<double> rounded(60, 1);
          if (kind > 0)
            for (int i = 0; i < 60; ++i) prior.push_back(kind == 1 ? (i < 25 ? 1 : 3) : i == 20 ? 0 : 1);
          for (std::size_t i = 0; i < prior.size(); ++i) rounded[i] = static_cast<double>(prior[i]);
          const SchemeSmoother smoother(scheme.mask.curve(), {60, prior}, {boundary, level}, scheme.rules);
          CHECK(smoother.apply(std::vector<double>(60, 1)).path == Approx(angles(smoother, rounded)).epsilon(1e-6));
        }
}

TEST_CASE("simultaneous bands cover all expected values at once at least as often as they say, and not much more") {
  NoiseEstimate known{1, 1e9, 1};
  CHECK(simultaneous_band_factor(0.95, known, 0) == Approx(band_factor(0.95, known)));
  CHECK(simultaneous_band_factor(0.99, known, 50) > simultaneous_band_factor(0.95, known, 50));
  CHECK(simultaneous_band_factor(0.95, {1, 10, 5}, 50) > simultaneous_band_factor(0.95, known, 50));
  CHECK_FAILS(simultaneous_band_factor(0, known, 1), domain);
  CHECK_FAILS(simultaneous_band_factor(0.9, known, -1), domain);

  const Scheme scheme = make_scheme("primal:n=4");
  const SchemeSmoother smoother(scheme.mask.curve(), 80, {Boundary::regression, 2});
  std::mt19937_64 generator(1986);
  std::normal_distribution<double> normal;
  std::vector<double> data(80);
  const double factor = simultaneous_band_factor(0.9, known, smoother.apply(data).path);
  constexpr int runs = 4000;
  int outside = 0;
  for (int run = 0; run < runs; ++run) {
    for (double& value : data) value = normal(generator);
    const auto smoothed = smoother.apply(data);
    bool left = false;
    for (std::size_t o = 0; o < smoothed.values.size(); ++o)
      left = left || std::abs(smoothed.values[o]) > factor * std::sqrt(smoothed.variances[o]);
    outside += left ? 1 : 0;
  }
  // Four standard deviations of the count above a tenth; no less than half of it.
  CHECK(outside < runs / 10 + 4 * std::sqrt(runs * 0.09));
  CHECK(outside > runs / 20);
}

TEST_CASE("samples are smoothed by l1 regression too, without bands where none are asked for") {
  const DataDependentScheme scheme = make_l1_scheme("l1:points=6");
  const SmoothedSamples limit = smooth(waves(), scheme, {Boundary::regression, 2});
  REQUIRE(limit.positions.size() == 157);
  for (std::size_t o = 0; o < 157; ++o)
    CHECK(limit.columns[1].values[o] == Approx(3 + 0.5 * (limit.positions[o] - 2) * 10));
  CHECK(limit.columns[1].half_widths(0.9).empty());
  CHECK_FALSE(limit.columns[1].noise);
}

TEST_CASE("what cannot be smoothed is said") {
  const Scheme scheme = make_scheme("primal:n=2");
  const DataDependentScheme l1 = make_l1_scheme("l1:points=6");
  Samples weighted = waves();
  weighted.weights.assign(40, 1);
  CHECK_FAILS(smooth(waves(), scheme, {Boundary::regression, 0, 3}), domain);
  CHECK_FAILS(smooth(waves(), make_scheme("mask:[1,1]"), {}), domain);
  CHECK_FAILS(smooth(waves(), l1, {Boundary::regression, 0, 1}), domain);
  CHECK_FAILS(smooth(waves(), l1, {Boundary::nearest}), domain);
  CHECK_FAILS(smooth(weighted, make_l1_scheme("l1:points=6,exact"), {}), domain);
  CHECK_FAILS(smooth(waves(), make_l1_scheme("l1:points=4x4"), {}), domain);
  CHECK_FAILS(smooth(Samples{{{1, 2, 3}}}, l1, {}), data);
}

TEST_CASE("a stream gives the same bits as all data at once, whatever comes at once") {
  constexpr std::size_t count = 700;
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal;
  Samples all{{{}, {}}, {}, Rational(2), Rational(1, 10)};
  all.noise = 0.5;
  for (std::size_t i = 0; i < count; ++i) {
    all.columns[0].push_back(std::sin(0.05 * static_cast<double>(i)) + normal(engine));
    all.columns[1].push_back(normal(engine));
  }
  std::vector<Rational> gaps(count, 1);
  for (const std::size_t i : {0, 1, 77, 78, 300, 690, 699}) gaps[i] = 0;
  gaps[400] = Rational(1, 3);
  const Samples head{{{}, {}}, {}, all.origin, all.spacing, {}, all.noise};
  for (const char* name :
       {"primal:n=5", "dual:n=3", "ary:a=3,points=5,d=1", "four-point:w=1/16", "local:points=9", "local:width=0.6,d=2"})
    for (const Boundary boundary : {Boundary::regression, Boundary::reflect, Boundary::nearest, Boundary::constant})
      for (const bool weighted : {false, true})
        for (const std::size_t part : {1, 13, 256, 1000}) {
          const std::string specification = name;
          if (weighted && (specification[0] == 'f' || specification == "local:points=9")) continue;
          CAPTURE(specification, to_text(boundary), weighted, part);
          all.weights = weighted ? gaps : std::vector<Rational>{};
          const SmoothingOptions options{boundary, 1, 0, 2.5};
          const SmoothedSamples wanted = smooth(all, specification, options);
          SmoothingStream stream(head, make_smoothing_method(specification), options, weighted);
          SmoothedSamples found{"", {}, {}, std::vector<SmoothedColumn>(2)};
          const auto append = [&](const SmoothedSamples& more) {
            found.positions.insert(found.positions.end(), more.positions.begin(), more.positions.end());
            for (std::size_t c = 0; c < 2; ++c) {
              const SmoothedColumn& from = more.columns[c];
              SmoothedColumn& to = found.columns[c];
              to.values.insert(to.values.end(), from.values.begin(), from.values.end());
              to.deviations.insert(to.deviations.end(), from.deviations.begin(), from.deviations.end());
            }
          };
          for (std::size_t begin = 0; begin < (part == 1 ? 100 : count); begin += part) {
            const auto cut = [&](const auto& values) {
              const auto first = static_cast<std::ptrdiff_t>(std::min(begin, values.size()));
              const auto last = static_cast<std::ptrdiff_t>(std::min(begin + part, values.size()));
              return std::decay_t<decltype(values)>(values.begin() + first, values.begin() + last);
            };
            stream.add({cut(all.columns[0]), cut(all.columns[1])}, cut(all.weights));
            append(stream.take());
          }
          if (part == 1) {  // the others wait for nothing but their windows
            CHECK(found.positions.size() > 100);
            continue;
          }
          append(stream.finish());
          CHECK(found.positions == wanted.positions);
          for (std::size_t c = 0; c < 2; ++c) {
            CHECK(found.columns[c].values == wanted.columns[c].values);
            CHECK(found.columns[c].deviations == wanted.columns[c].deviations);
          }
        }
  const SmoothingMethod scheme = make_scheme("primal:n=2");
  CHECK_FAILS(SmoothingStream(head, scheme, {Boundary::periodic}, false), domain);
  CHECK_FAILS(SmoothingStream(head, make_smoothing_method("local:points=5"), {}, true), domain);
  CHECK_FAILS(SmoothingStream(head, make_smoothing_method("local:d=1"), {}, false), domain);
  CHECK_FAILS(SmoothingStream(head, make_smoothing_method("l1:points=4"), {}, false), domain);
  CHECK_FAILS(SmoothingStream(head, scheme, {}, false).finish(), domain);
}
