// Limit constants and the bounds of the degree-1 theorems. The counter `digits` stands beside the time.

#include <subcert/proofs-checks/theorems/degree_one.hpp>
#include <subcert/proofs-checks/theorems/limit_constant.hpp>

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

void BM_degree_one_bounds(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(degree_one_bounds(static_cast<int>(state.range(0))));
}
BENCHMARK(BM_degree_one_bounds)->Arg(10)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
