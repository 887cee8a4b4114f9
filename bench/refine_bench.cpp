// Refinement of data. BM_copy moves the same memory as one level: one read, and one write of `arity` times as much.

#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/specification.hpp>

#include <benchmark/benchmark.h>

#include <random>

namespace {

using namespace subcert;

std::vector<double> random_data(std::size_t count) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> data(count);
  for (double& value : data) value = uniform(engine);
  return data;
}

constexpr std::size_t points = 10'000'000;

void BM_copy(benchmark::State& state) {
  const std::vector<double> data = random_data(points);
  std::vector<double> out(2 * points);
  for (auto _ : state) {
    for (std::size_t i = 0; i < points; ++i) out[2 * i] = out[2 * i + 1] = data[i];
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * 24 * static_cast<std::int64_t>(points));
}
BENCHMARK(BM_copy)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One level of a function in double precision: range(0) / 2 points of the stencil, range(1) threads.
void BM_refine(benchmark::State& state) {
  const Mask mask = make_scheme("dual:n=" + std::to_string(state.range(0) / 2)).mask.curve();
  const int threads = static_cast<int>(state.range(1));
  const std::vector<double> data = random_data(points);
  data::AxisRefiner refiner(mask, data::Boundary::regression);
  const data::AxisRefinement<double> rows = converted<double>(refiner.step(data::Axis::of(points)));
  std::vector<double> out(rows.outputs());
  for (auto _ : state) {
    apply(rows, data.data(), out.data(), 1, 1, threads);
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * 24 * static_cast<std::int64_t>(points));
  state.counters["points/s"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * static_cast<double>(rows.outputs()), benchmark::Counter::kIsRate);
}
BENCHMARK(BM_refine)->ArgsProduct({{2, 4, 6, 8, 16}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

/// One level of heights on a grid of 2000 x 2000 points, 4 x 4 data for each output: as a product and as one mask.
void BM_refine_surface(benchmark::State& state) {
  const auto scheme = make_linear_scheme(state.range(0) == 0 ? "tensor:(dual:n=2)x(dual:n=2)" : "grid:points=4x4,d=1");
  const data::GridData<double> data{random_data(4'000'000), 1, {data::Axis::of(2000), data::Axis::of(2000)}};
  const data::RefineOptions options{1, data::Boundary::regression, 1};
  for (auto _ : state) benchmark::DoNotOptimize(refine(data, scheme.mask, options));
  state.counters["points/s"] = benchmark::Counter(static_cast<double>(state.iterations()) * 16'000'000,
                                                  benchmark::Counter::kIsRate);
}
BENCHMARK(BM_refine_surface)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
