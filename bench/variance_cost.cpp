// Cost of the certified variance range over n: measures, fits a power of n, draws the plot of docs/limit-enclosures.md.
// Usage: subcert_variance_cost FILE.svg [options of Google Benchmark]

#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/reports/formats/figure.hpp>
#include <subcert/schemes/specification.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <map>

namespace {

using namespace subcert;

constexpr int fit_from = 20;  // below, the number of cells governs the time

const std::vector<int> sizes{5, 7, 10, 14, 20, 28, 40, 56, 80};
const std::vector<int> degrees{1, 3, 5};

/// Seconds for each n, for each degree.
using Seconds = std::map<int, std::map<int, double>>;

/// Prints as usual and keeps the times.
class Collector : public benchmark::ConsoleReporter {
 public:
  explicit Collector(Seconds& seconds) : seconds_(seconds) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      int n = 0, degree = 0;
      if (std::sscanf(run.run_name.function_name.c_str(), "primal:n=%d,d=%d", &n, &degree) == 2)
        seconds_[degree][n] = run.cpu_accumulated_time / static_cast<double>(run.iterations);
    }
    ConsoleReporter::ReportRuns(runs);
  }

 private:
  Seconds& seconds_;
};

/// The slope of the least squares line through (log n, log seconds), n >= fit_from.
double exponent(const std::map<int, double>& seconds) {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [n, time] : seconds) {
    if (n < fit_from) continue;
    const double u = std::log(n), v = std::log(time);
    count += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  return (count * xy - x * y) / (count * xx - x * x);
}

void draw_cost(const Seconds& all, const std::string& file) {
  formats::Panel panel{"", "n", "seconds of one core", {}, true, "top left"};
  panel.log_x = true;
  for (const auto& [degree, seconds] : all) {
    char label[64];
    std::snprintf(label, sizeof label, "d = %d: n^{%.1f} from n = %d on", degree, exponent(seconds), fit_from);
    std::printf("%s\n", label);
    formats::Curve curve{label, {}, true};
    for (const auto& [n, time] : seconds) curve.points.emplace_back(n, time);
    panel.curves.push_back(curve);
  }
  formats::draw_file({"variance-cost", "", "", 1, {panel}}, file);
}

}  // namespace

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (count != 2 || !formats::is_picture_name(arguments[1])) {
    std::fprintf(stderr, "usage: subcert_variance_cost FILE.svg [options of Google Benchmark]\n");
    return 64;
  }
  for (int degree : degrees)
    for (int n : sizes) {
      const std::string name = "primal:n=" + std::to_string(n) + ",d=" + std::to_string(degree);
      benchmark::RegisterBenchmark(name.c_str(), [mask = make_scheme(name).mask.curve()](benchmark::State& state) {
        VarianceRange range;
        for (auto _ : state) range = variance_range(mask);
        state.counters["cells"] = static_cast<double>(range.cells);
      })->Unit(benchmark::kMillisecond);
    }
  Seconds seconds;
  Collector collector(seconds);
  benchmark::RunSpecifiedBenchmarks(&collector);
  try {
    draw_cost(seconds, arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "subcert_variance_cost: %s\n", error.what());
    return 70;
  }
}
