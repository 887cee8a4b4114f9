// Smoothing of data, and the text of its answer.

#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/smooth/smoothing_stream.hpp>
#include <subcert/schemes/data/smooth/uniform_grid.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace {

using namespace subcert;

std::vector<double> noisy_wave(std::size_t count) {
  std::mt19937_64 engine(1);
  std::normal_distribution<double> noise(0, 0.1);
  std::vector<double> data(count);
  for (std::size_t i = 0; i < count; ++i)
    data[i] = std::sin(20 * static_cast<double>(i) / static_cast<double>(count)) + noise(engine);
  return data;
}

void count_outputs(benchmark::State& state, std::size_t outputs) {
  state.counters["outputs/s"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * static_cast<double>(outputs), benchmark::Counter::kIsRate);
}

/// 10^6 data, level range(0), primal:n=10; range(1): 0 without weights, 1 with a gap in every 50 data.
void BM_smooth(benchmark::State& state) {
  constexpr std::size_t count = 1'000'000;
  const Scheme scheme = make_scheme("primal:n=10");
  const std::vector<double> data = noisy_wave(count);
  std::vector<Rational> weights;
  if (state.range(1) == 1) weights.assign(count, 1);
  for (std::size_t i = 25; i < weights.size(); i += 50) weights[i] = 0;
  const data::SchemeSmoother smoother(scheme.mask.curve(), {count, weights},
                                      {data::Boundary::regression, static_cast<int>(state.range(0)), 0}, scheme.rules);
  for (auto _ : state) benchmark::DoNotOptimize(smoother.apply(data));
  count_outputs(state, smoother.outputs());
}
BENCHMARK(BM_smooth)->ArgsProduct({{0, 2}, {0}})->Args({0, 1})->Unit(benchmark::kMillisecond)->UseRealTime();

/// 10^5 data, local polynomials of 21 points; range(0): 0 uniform, 1 scattered, values at the data.
void BM_local(benchmark::State& state) {
  constexpr std::size_t count = 100'000;
  data::Samples samples{{noisy_wave(count)}};
  std::mt19937_64 engine(2);
  std::exponential_distribution<double> gap(1);
  if (state.range(0) == 1)
    for (double x = 0; samples.positions.size() < count; x += gap(engine)) samples.positions.push_back(x);
  data::SmoothingOptions options;
  options.at_data = true;
  const data::LocalPolynomial method = data::make_local_polynomial("local:points=21,d=1");
  const data::LocalSmoother smoother(method, samples.sites(), options);
  for (auto _ : state) benchmark::DoNotOptimize(smoother.apply(samples.columns.front()));
  count_outputs(state, count);
}
BENCHMARK(BM_local)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

/// 10^5 data, primal:n=10 at level 0: at once, or range(0) at a time.
void BM_smooth_stream(benchmark::State& state) {
  constexpr std::size_t count = 100'000;
  const auto part = static_cast<std::size_t>(state.range(0));
  const data::SmoothingMethod scheme = make_scheme("primal:n=10");
  const data::Samples all{{noisy_wave(count)}}, head{{{}}};
  for (auto _ : state) {
    if (part == count) {
      benchmark::DoNotOptimize(smooth(all, scheme, {}));
      continue;
    }
    data::SmoothingStream stream(head, scheme, {}, false);
    for (std::size_t begin = 0; begin < count; begin += part) {
      const auto* const first = all.columns[0].data() + begin;
      stream.add({{first, first + std::min(part, count - begin)}});
      benchmark::DoNotOptimize(stream.take());
    }
    benchmark::DoNotOptimize(stream.finish());
  }
  count_outputs(state, count);
}
BENCHMARK(BM_smooth_stream)->Arg(100)->Arg(4000)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The choice among the schemes, range(0) data.
void BM_choose_scheme(benchmark::State& state) {
  const data::Samples samples{{noisy_wave(static_cast<std::size_t>(state.range(0)))}};
  for (auto _ : state) benchmark::DoNotOptimize(choose_method(samples, {}));
}
BENCHMARK(BM_choose_scheme)->Arg(1000)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Whether 10^6 positions with two decimal places are uniform.
void BM_uniform_grid(benchmark::State& state) {
  std::vector<double> positions(1'000'000);
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = static_cast<double>(i) / 100;
  for (auto _ : state) benchmark::DoNotOptimize(data::uniform_grid(positions));
}
BENCHMARK(BM_uniform_grid)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The text of 10^6 rows of two numbers, range(0) threads.
void BM_write_rows(benchmark::State& state) {
  const std::vector<double> x = noisy_wave(1'000'000), y = noisy_wave(1'000'000);
  std::ostringstream stream;
  for (auto _ : state) {
    stream.str({});
    data::write_rows(stream, {{x.data()}, {y.data()}}, x.size(), ',', static_cast<int>(state.range(0)));
  }
}
BENCHMARK(BM_write_rows)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
