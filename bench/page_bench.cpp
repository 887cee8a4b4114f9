// Pages: pictures as SVG, surfaces as data, formulas as MathML.

#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/reports/formats/mathml.hpp>
#include <subcert/reports/formats/surface_figure.hpp>
#include <subcert/reports/formats/svg.hpp>

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace subcert;

/// A curve with as many waves as make a picture full of lines.
void BM_svg_curve(benchmark::State& state) {
  formats::Curve curve{"curve", {}};
  const auto count = static_cast<double>(state.range(0));
  for (double i = 0; i < count; ++i) curve.points.emplace_back(i, std::sin(40 * i / count) * std::cos(i / count));
  const formats::Panel panel{"curve", "x", "y", {curve}};
  for (auto _ : state) benchmark::DoNotOptimize(formats::svg(panel));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_svg_curve)->RangeMultiplier(10)->Range(1000, 100000)->Unit(benchmark::kMillisecond);

void BM_surface_data(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(0));
  formats::DrawnSurface surface{"surface", size, size, false, false, {}, true};
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t i = 0; i < size; ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(size),
                   y = static_cast<double>(j) / static_cast<double>(size);
      surface.points.push_back({x, y, std::sin(5 * x) * std::cos(3 * y)});
    }
  for (auto _ : state) benchmark::DoNotOptimize(formats::surface_view(surface));
}
BENCHMARK(BM_surface_data)->Arg(96)->Arg(400)->Unit(benchmark::kMillisecond);

/// The printed forms of all statements, then with the corrected ones beside them.
void BM_mathml(benchmark::State& state) {
  for (auto _ : state)
    for (const statements::Statement& statement : statements::statements())
      benchmark::DoNotOptimize(formats::formula_html(printed_latex(statement)));
}
BENCHMARK(BM_mathml)->Unit(benchmark::kMillisecond);

void BM_formula_differences(benchmark::State& state) {
  for (auto _ : state)
    for (const statements::Statement& statement : statements::statements())
      if (!statement.corrected.empty())
        benchmark::DoNotOptimize(formats::marked_difference(printed_latex(statement), corrected_latex(statement)));
}
BENCHMARK(BM_formula_differences)->Unit(benchmark::kMillisecond);

}  // namespace
