// Families with a parameter: the cost of a range over the width that it leaves open, and of a curve over its pieces.

#include <subcert/analysis/family/exponent_curve.hpp>
#include <subcert/analysis/family/property_map.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace subcert;

constexpr const char* ternary =
    "mask:[-1/18+1/6*u,-1/18-1/6*u,0,7/18-1/2*u,13/18+1/2*u,1,13/18+1/2*u,7/18-1/2*u,0,-1/18-1/6*u,-1/18+1/"
    "6*u],arity=3";
// Matrices of size 12.
constexpr const char* eight_point =
    "mask:[-5/2048-w,0,49/2048,0,-245/2048,0,1225/2048+w,1,1225/2048+w,0,-245/2048,0,49/2048,0,-5/2048-w]";

/// Ten to the power of minus the argument is the width.
void BM_range(benchmark::State& state, const char* scheme, const char* property, int low, int high) {
  const ParametricMask mask = make_parametric_scheme(scheme).mask;
  const RangeOptions options{power(Rational(10), -state.range(0)), 2, {Deadline::in(60)}};
  std::size_t intervals = 0;
  for (auto _ : state) {
    const PropertyRange range = property_range(mask, *parse_range_property(property), low, high, options);
    intervals = range.proofs.size();
  }
  state.counters["intervals"] = static_cast<double>(intervals);
}
BENCHMARK_CAPTURE(BM_range, four_point_C1, "four-point:w", "C1", -1, 1)
    ->DenseRange(2, 12, 2)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_range, six_point_H3, "six-point:w", "sobolev>=3", 0, 1)
    ->DenseRange(2, 12, 2)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_range, ternary_C2, ternary, "C2", 0, 1)
    ->DenseRange(2, 12, 2)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void BM_curve(benchmark::State& state, const char* scheme, const Rational& low, const Rational& high) {
  const ParametricMask mask = make_parametric_scheme(scheme).mask;
  const CurveOptions options{static_cast<int>(state.range(0)), 2, {Deadline::in(60)}};
  double widest = 0;
  for (auto _ : state) {
    widest = 0;
    for (const CurvePiece& piece : exponent_curve(mask, low, high, options).pieces)
      if (piece.exponent.is_bounded())
        widest = std::max(widest, Rational(*piece.exponent.upper - *piece.exponent.lower).convert_to<double>());
  }
  state.counters["apart"] = widest;
}
BENCHMARK_CAPTURE(BM_curve, four_point, "four-point:w", Rational(0), Rational(1, 4))
    ->Arg(50)
    ->Arg(100)
    ->Arg(200)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_curve, size_12, eight_point, Rational(-1, 100), Rational(1, 100))
    ->Arg(200)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// The argument is the resolution.
void BM_map(benchmark::State& state, const char* scheme, const std::vector<std::string>& names, const char* property,
            const Box& box) {
  const auto [text, letters] = in_letters(scheme, names);
  const ParametricMask mask = make_parametric_mask(text, letters);
  double undecided = 0;
  for (auto _ : state)
    undecided = property_map(mask, *parse_range_property(property), box,
                             {static_cast<int>(state.range(0)), 2, {Deadline::in(60)}})
                    .share(Truth::unknown)
                    .convert_to<double>();
  state.counters["undecided"] = undecided;
}
BENCHMARK_CAPTURE(BM_map, six_point_C1, "mask:[t,0,-w-3*t,0,1/2+w+2*t,1,1/2+w+2*t,0,-w-3*t,0,t]", {"w", "t"}, "C1",
                  Box{{Rational(-1, 8), Rational(-1, 16)}, {Rational(1, 4), Rational(1, 16)}})
    ->RangeMultiplier(2)
    ->Range(8, 64)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_map, merrien_HC1, "merrien:lambda,mu", {"lambda", "mu"}, "HC1",
                  Box{{Rational(-1, 4), Rational(-3)}, {Rational(0), Rational(1)}})
    ->RangeMultiplier(2)
    ->Range(8, 32)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The argument is the order n of D(2n).
void BM_daubechies(benchmark::State& state) {
  for (auto _ : state) {
    const Scheme scheme = make_scheme("daubechies:n=" + std::to_string(state.range(0)));
    benchmark::DoNotOptimize(
        holder_regularity(scheme.mask.curve(), 16, {Deadline::in(60)}, HolderProof::shortest, scheme.rounding));
  }
}
BENCHMARK(BM_daubechies)->Arg(2)->Arg(10)->Arg(21)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
