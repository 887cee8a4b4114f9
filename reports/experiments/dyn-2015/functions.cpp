// [DHHS15, sec. 3.2 and 4.4, Figures 3 to 7 and 10 to 13]: error over the signal-to-noise ratio.

#include "limit_trial.hpp"
#include "parts.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/reports/experiments/figures.hpp>
#include <subcert/reports/experiments/local_polynomial.hpp>
#include <subcert/reports/experiments/noise_levels.hpp>
#include <subcert/reports/experiments/noisy_data.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

namespace subcert::experiments::dyn_2015 {
namespace {

struct TestFunction {
  std::string name;
  double (*value)(double);
};

/// Local regression among the methods: linear with the bandwidth by medians, or of a degree with the bandwidth by
/// leaving out each datum; the others are specifications of schemes.
const std::string by_medians = "local", leaving_out = "local:degree=";
const std::vector<Method> baselines{{"LLR, leaving out", leaving_out + "1"},
                                    {"local cubic, leaving out", leaving_out + "3"},
                                    {"Chaikin", "bspline:degree=2"},
                                    {"cubic B-spline", "bspline:degree=3"}};

/// What the paper leaves open about the data and the reconstructions.
struct Setting {
  double first = 0, spacing = 1;  ///< data at first, first + spacing, ..., 100
  double factor = 20;             ///< of log10 in the decibel
  data::Boundary ends = data::Boundary::regression;

  explicit Setting(const Run& run)
      : first(run.chosen("interval") == "1 to 100" ? 1 : 0),
        spacing(run.number("spacing")),
        factor(run.number("decibel")),
        ends(data::parse_boundary(run.chosen("ends")).value()) {}
};

/// A function sampled on an interval, and its reconstructions at the multiples of a quarter of the spacing.
class FunctionTrial {
 public:
  /// Domain: the spacing divides the interval, at least 8 samples.
  FunctionTrial(const TestFunction& function, const Setting& setting, const std::vector<Method>& methods)
      : setting_(setting) {
    const auto count = static_cast<std::size_t>(std::lround((100 - setting.first) / setting.spacing)) + 1,
               outputs = ((count - 1) << level) + 1;
    std::vector<double> positions;
    for (std::size_t i = 0; i < outputs; ++i) {
      positions.push_back(std::ldexp(static_cast<double>(i), -level));
      truth_.push_back(function.value(x_of(i)));
    }
    for (std::size_t i = 0; i < count; ++i) samples_.push_back(truth_[i << level]);
    for (const auto& [name, specification, levels] : methods)
      if (specification == by_medians)
        methods_.emplace_back(name, ByMedians{});
      else if (specification.starts_with(leaving_out))
        methods_.emplace_back(name, LocalPolynomialRegression(specification.back() - '0', count, positions));
      else
        methods_.emplace_back(name, limit_matrix(specification, count, setting.ends, level));
  }

  /// The relative errors at all levels of noise.
  Measured errors(const ExperimentOptions& options) const {
    Measured result;
    for (const auto& [name, method] : methods_)
      for (int decibel = loudest; decibel <= quietest; ++decibel)
        result.samples[error_at(name, decibel)].resize(options.runs);
    parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
      const auto noise = noise_of(options.seed, run);
      for (const auto& [name, method] : methods_) {
        const Reconstruction reconstruction = reconstructed(method, noise);
        for (int decibel = loudest; decibel <= quietest; ++decibel)
          result.samples.at(error_at(name, decibel))[run] = relative_error(reconstruction(deviation(decibel)), truth_);
      }
    });
    return result;
  }

  /// The parts of these errors: "S_5, deterministic", that without noise, and "S_5, noise", the norm of what the noise
  /// adds over that of the truth. Domain: all methods are schemes.
  Measured parts(const ExperimentOptions& options) const {
    Measured result;
    for (const auto& [name, method] : methods_) {
      const auto& scheme = std::get<DenseMatrix>(method);
      std::vector<double> noise(options.runs);  // of deviation 1
      parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
        noise[run] = relative_error(sum(truth_, 1, scheme * noise_of(options.seed, run)), truth_);
      });
      for (int decibel = loudest; decibel <= quietest; ++decibel) {
        result.samples[error_at(name + ", deterministic", decibel)].assign(options.runs,
                                                                           relative_error(scheme * samples_, truth_));
        auto& scaled = result.samples[error_at(name + ", noise", decibel)] = noise;
        for (double& value : scaled) value *= deviation(decibel);
      }
    }
    return result;
  }

  /// Samples, truth and reconstructions for sample 0 of the noise.
  struct Shown {
    std::vector<double> data, truth;
    std::vector<std::vector<double>> reconstructions;
  };
  Shown shown(double decibel, std::uint64_t seed) const {
    const auto noise = noise_of(seed, 0);
    Shown result{sum(samples_, deviation(decibel), noise), truth_, {}};
    for (const auto& [name, method] : methods_)
      result.reconstructions.push_back(reconstructed(method, noise)(deviation(decibel)));
    return result;
  }

 private:
  static constexpr int level = 2;
  struct ByMedians {};
  using AnyMethod = std::variant<DenseMatrix, LocalPolynomialRegression, ByMedians>;
  /// Of samples + sigma * noise, for any sigma.
  using Reconstruction = std::function<std::vector<double>(double sigma)>;

  static std::vector<double> sum(std::vector<double> values, double factor, const std::vector<double>& others) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += factor * others[i];
    return values;
  }
  double x_of(std::size_t output) const {
    return setting_.first + std::ldexp(setting_.spacing, -level) * static_cast<double>(output);
  }
  Reconstruction reconstructed(const AnyMethod& method, const std::vector<double>& noise) const {
    if (const auto* scheme = std::get_if<DenseMatrix>(&method))
      return [signal = *scheme * samples_, error = *scheme * noise](double sigma) { return sum(signal, sigma, error); };
    if (const auto* regression = std::get_if<LocalPolynomialRegression>(&method))
      return [both = RegressionOfSum(*regression, samples_, noise)](double sigma) mutable { return both(sigma); };
    return [this, &noise](double sigma) {
      const std::vector<double> data = sum(samples_, sigma, noise);
      return local_linear(data, median_bandwidth(data, setting_.spacing), level);
    };
  }
  std::vector<double> noise_of(std::uint64_t seed, std::size_t run) const {
    auto engine = generator(seed, run);
    return normal_noise(engine, samples_.size());
  }
  double deviation(double decibel) const { return noise_deviation(mean_square(samples_), decibel, setting_.factor); }

  Setting setting_;
  std::vector<double> samples_, truth_;
  std::vector<std::pair<std::string, AnyMethod>> methods_;
};

double cube(double x) { return x * x * x; }
const TestFunction f1{"f_1", [](double x) { return std::sin(x / 10) + x * x / 2500; }};
const TestFunction f2{"f_2", [](double x) { return std::cos(x * 2 / 5) + cube(x / 40 - 1); }};
const TestFunction f3{"f_3", [](double x) { return std::cos(x / 10) - cube(x / 50 - 1); }};
const TestFunction f4{"f_4", [](double x) { return std::cos(x * 2 / 5) - cube(x / 50 - 0.8); }};

/// LLR with the bandwidth that the run chooses.
std::string regression(const Run& run) {
  return run.chosen("bandwidth") == "leaving out" ? leaving_out + "1" : by_medians;
}

struct FunctionFigure {
  TestFunction function;
  std::array<Method, 2> compared;
  double shown;                     // dB of the reconstruction
  std::vector<Method> beside = {};  // what a claim names besides

  bool has_regression() const { return compared[1].specification == by_medians; }
  /// Both methods of the figure; as taken, for comparison the others, too.
  std::vector<Method> methods(const Run& run) const {
    std::vector<Method> result(compared.begin(), compared.end());
    if (has_regression()) result[1].specification = regression(run);
    if (!run.is_alternative()) result.insert(result.end(), baselines.begin(), baselines.end());
    result.insert(result.end(), beside.begin(), beside.end());
    return result;
  }
};

formats::Figure figure_of(const FunctionFigure& figure, const FunctionTrial& trial, const Measured& errors,
                          const Run& run) {
  const auto& [function, compared, decibel_shown, beside] = figure;
  const std::string colours[] = {colour::blue, colour::red, colour::violet};
  const std::vector<Method> methods = figure.methods(run);
  const auto over_x = [](const std::vector<double>& values) {
    return over_steps(values, 100.0 / static_cast<double>(values.size() - 1));
  };
  const FunctionTrial::Shown sample = trial.shown(decibel_shown, run.seed);
  formats::Panel over_noise{function.name, "SNR (dB)", "relative error", {}};
  formats::Panel shown = plain_panel(
      "data with " + short_number(decibel_shown) + " dB noise",
      {dots("data", over_x(sample.data), colour::grey), line(function.name, over_x(sample.truth), colour::amber)});
  shown.x_label = "x";
  for (std::size_t m = 0; m < (figure.has_regression() ? 3u : 2u); ++m) {
    const std::string& name = methods[m].name;
    Points means;
    for (int decibel = loudest; decibel <= quietest; ++decibel)
      means.emplace_back(decibel, mean_interval(errors.at(error_at(name, decibel))).mean);
    over_noise.curves.push_back(line(name, means, colours[m]));
    over_noise.curves.back().marked = true;
    shown.curves.push_back(line(name, over_x(sample.reconstructions[m]), colours[m]));
  }
  return {run.experiment.id,
          "Comparison of " + compared[0].name + " and " + compared[1].name + " for " + function.name,
          "Left: mean relative error over the signal-to-noise ratio. Right: one reconstruction.",
          2,
          {over_noise, shown}};
}

MeansTable errors_table(const std::vector<Method>& methods, const Run& run) {
  MeansTable table{run.experiment.id + "-errors", "Mean relative errors", {"SNR (dB)"}, {}, {}};
  for (int decibel = loudest; decibel <= quietest; ++decibel)
    table.rows.push_back({{std::to_string(decibel)}, std::to_string(decibel)});
  for (const Method& method : methods) table.columns.push_back({method.name, method.name});
  return table;
}

MeansTable errors_table(const FunctionFigure& figure, const Run& run) {
  MeansTable table = errors_table(figure.methods(run), run);
  table.columns.push_back({"first minus second", figure.compared[0].name, figure.compared[1].name});
  return table;
}

Measured measured(const FunctionFigure& figure, const Run& run) {
  const FunctionTrial trial(figure.function, Setting(run), figure.methods(run));
  Measured result = trial.errors(run);
  if (run.is_alternative()) return result;
  result.tables = {errors_table(figure, run).filled(result)};
  result.figures = {figure_of(figure, trial, result, run)};
  return result;
}

/// All that Figures 3 to 7 compare: "S_3 on f_1".
Measured measured_together(const Run& run) {
  const std::pair<TestFunction, std::vector<int>> compared[]{{f1, {3, 5, 7}}, {f2, {3, 5}}};
  Measured result;
  std::vector<Method> all;
  for (const auto& [function, sizes] : compared) {
    std::vector<Method> methods{{"LLR on " + function.name, regression(run)}};
    for (const int n : sizes) {
      const std::string scheme = "primal:n=" + std::to_string(n);
      methods.push_back({scheme_name(scheme) + " on " + function.name, scheme});
    }
    result.samples.merge(FunctionTrial(function, Setting(run), methods).errors(run).samples);
    all.insert(all.end(), methods.begin(), methods.end());
  }
  if (!run.is_alternative()) result.tables = {errors_table(all, run).filled(result)};
  return result;
}

/// What Figures 10 and 11 compare, "S_5 on f_3", with both parts, and "gain of S_5^3 on f_3".
Measured measured_parts(const Run& run) {
  Measured result;
  std::vector<Method> all;
  for (const TestFunction& function : {f3, f4}) {
    const std::string on = " on " + function.name, linear = "S_5" + on, cubic = "S_5^3" + on, gain = "gain of " + cubic;
    const FunctionTrial trial(function, Setting(run), {{linear, "primal:n=5"}, {cubic, "primal:n=5,d=3"}});
    result.samples.merge(trial.errors(run).samples);
    result.samples.merge(trial.parts(run).samples);
    for (int decibel = loudest; decibel <= quietest; ++decibel) {
      std::vector<double> gained = result.at(error_at(linear, decibel));
      for (std::size_t r = 0; r < gained.size(); ++r) gained[r] -= result.at(error_at(cubic, decibel))[r];
      result.samples[error_at(gain, decibel)] = std::move(gained);
    }
    for (const std::string& scheme : {linear, cubic})
      for (const char* part : {"", ", deterministic", ", noise"}) all.push_back({scheme + part, ""});
    all.push_back({gain, ""});
  }
  if (!run.is_alternative()) result.tables = {errors_table(all, run).filled(result)};
  return result;
}

/// The scheme and the second method compared on a function.
Measure compared(const TestFunction& function, const std::string& scheme, const Method& second, double shown,
                 const std::vector<Method>& beside = {}) {
  return [figure = FunctionFigure{function, {Method{scheme_name(scheme), scheme}, second}, shown, beside}](
             const Run& run) { return measured(figure, run); };
}

}  // namespace

Measures functions() {
  const Method llr{"LLR", by_medians}, s53{"S_5^3", "primal:n=5,d=3"}, s93{"S_9^3", "primal:n=9,d=3"};
  return {{"fig3", compared(f1, "primal:n=3", llr, 6.5)},
          {"fig4", compared(f1, "primal:n=5", llr, 7)},
          {"fig5", compared(f1, "primal:n=7", llr, 7.9)},
          {"fig6", compared(f2, "primal:n=3", llr, 6.2, {{"S_5", "primal:n=5"}})},
          {"fig7", compared(f2, "primal:n=5", llr, 8)},
          {"figs3-7", measured_together},
          {"fig10", compared(f3, "primal:n=5", s53, 8.2)},
          {"fig11", compared(f4, "primal:n=5", s53, 7.2)},
          {"figs10-11", measured_parts},
          {"fig12", compared(f3, "primal:n=6,d=3", s93, 8.4)},
          {"fig13", compared(f4, "primal:n=6,d=3", s93, 9.5)}};
}

}  // namespace subcert::experiments::dyn_2015
