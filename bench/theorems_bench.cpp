// Limit constants, the bounds of the degree-1 theorems, and those of single schemes. The counter `digits` stands beside
// the time.

#include <subcert/analysis/regularity/frequency/frequency_bound.hpp>
#include <subcert/proofs-checks/theorems/curve_bounds.hpp>
#include <subcert/proofs-checks/theorems/degree_one.hpp>
#include <subcert/proofs-checks/theorems/limit_constant.hpp>
#include <subcert/schemes/specification.hpp>

#include <benchmark/benchmark.h>

namespace {

using namespace subcert::theorems;

void BM_limit_constant_sum(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(limit_constant(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  state.counters["digits"] = static_cast<double>(state.range(1));
}
BENCHMARK(BM_limit_constant_sum)
    ->ArgsProduct({{1, 3, 5, 7, 9}, {30}})
    ->Args({1, 10})
    ->Args({1, 20})
    ->Args({1, 40})
    ->Args({1, 60})
    ->Unit(benchmark::kMillisecond);

void BM_limit_constant_quadrature(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(
        limit_constant_by_quadrature(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  state.counters["digits"] = static_cast<double>(state.range(1));
}
BENCHMARK(BM_limit_constant_quadrature)->ArgsProduct({{1, 9}, {10, 30}})->Unit(benchmark::kMillisecond);

/// A lower end of the exponent of the primal scheme of this n and degree.
void BM_frequency_bound(benchmark::State& state) {
  const subcert::Mask mask = subcert::make_scheme("primal:n=" + std::to_string(state.range(0)) +
                                                  ",d=" + std::to_string(state.range(1)))
                                 .mask.curve();
  for (auto _ : state) benchmark::DoNotOptimize(subcert::frequency_bound(mask));
}
BENCHMARK(BM_frequency_bound)
    ->Args({5, 1})
    ->Args({20, 3})
    ->Args({100, 1})
    ->Args({200, 3})
    ->Unit(benchmark::kMillisecond);

void BM_degree_one_bounds(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(degree_one_bounds(static_cast<int>(state.range(0))));
}
BENCHMARK(BM_degree_one_bounds)->Arg(10)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

/// Arguments: n, degree, cells of each shell.
void BM_curve_bounds(benchmark::State& state) {
  const subcert::Mask mask = subcert::make_scheme("primal:n=" + std::to_string(state.range(0)) +
                                                  ",d=" + std::to_string(state.range(1)))
                                 .mask.curve();
  for (auto _ : state) benchmark::DoNotOptimize(curve_bounds(mask, static_cast<int>(state.range(2))));
  state.counters["ripple"] = curve_bounds(mask, static_cast<int>(state.range(2))).ripple.upper->convert_to<double>();
}
BENCHMARK(BM_curve_bounds)
    ->Args({20, 5, 1})
    ->Args({20, 5, 32})
    ->Args({100, 5, 1})
    ->Args({100, 5, 32})
    ->Unit(benchmark::kMillisecond);

}  // namespace
