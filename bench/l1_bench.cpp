// Data-dependent refinement: output points per second of one core.

#include <subcert/schemes/data/l1/l1_refinement.hpp>

#include <benchmark/benchmark.h>

#include <random>

namespace {

using namespace subcert;

data::GridData<double> noise(const std::vector<data::Axis>& axes, std::size_t dimension) {
  std::mt19937 engine(1);
  std::normal_distribution<double> gauss;
  data::GridData<double> data{{}, dimension, axes};
  for (std::size_t i = 0; i < data.points() * dimension; ++i) data.values.push_back(gauss(engine));
  return data;
}

void refine_while_asked(benchmark::State& state, const data::GridData<double>& data, const L1Scheme& scheme) {
  std::size_t outputs = 0;
  for (auto _ : state) {
    const data::GridData<double> fine = refine(data, scheme, {});
    outputs += fine.points();
    benchmark::DoNotOptimize(fine.values.data());
  }
  state.counters["outputs/s"] = benchmark::Counter(static_cast<double>(outputs), benchmark::Counter::kIsRate);
}

/// points, degree, iterations, coordinates.
void BM_l1_curve(benchmark::State& state) {
  L1Scheme scheme{{static_cast<int>(state.range(0))}, static_cast<int>(state.range(1))};
  scheme.options.iterations = static_cast<int>(state.range(2));
  const data::GridData<double> data = noise({data::Axis::of(100'000)}, static_cast<std::size_t>(state.range(3)));
  refine_while_asked(state, data, scheme);
}
BENCHMARK(BM_l1_curve)
    ->Args({6, 1, 6, 1})
    ->Args({6, 1, 6, 2})
    ->Args({6, 1, 6, 3})
    ->Args({6, 1, 0, 1})
    ->Args({6, 1, 12, 1})
    ->Args({8, 1, 6, 1})
    ->Args({6, 0, 6, 1})
    ->Args({6, 2, 6, 1})
    ->Args({8, 3, 6, 1})
    ->Unit(benchmark::kMillisecond);

/// points, degree: the exact fits.
void BM_l1_exact(benchmark::State& state) {
  L1Scheme scheme{{static_cast<int>(state.range(0))}, static_cast<int>(state.range(1))};
  scheme.options.exact = true;
  const data::GridData<double> data = noise({data::Axis::of(100'000)}, 1);
  refine_while_asked(state, data, scheme);
}
BENCHMARK(BM_l1_exact)->Args({6, 1})->Args({8, 1})->Args({6, 3})->Args({16, 1})->Unit(benchmark::kMillisecond);

/// points along each axis, degree.
void BM_l1_grid(benchmark::State& state) {
  const int points = static_cast<int>(state.range(0));
  const L1Scheme scheme{{points, points}, static_cast<int>(state.range(1))};
  const data::GridData<double> data = noise({data::Axis::of(120), data::Axis::of(120)}, 1);
  refine_while_asked(state, data, scheme);
}
BENCHMARK(BM_l1_grid)->Args({4, 1})->Args({6, 1})->Args({6, 2})->Args({6, 3})->Unit(benchmark::kMillisecond);

}  // namespace
