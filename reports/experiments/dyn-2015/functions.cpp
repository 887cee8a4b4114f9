// [DHHS15, sec. 3.2 and 4.4, Figures 3 to 7 and 10 to 13]: error over the signal-to-noise ratio.

#include "limit_trial.hpp"
#include "parts.hpp"

#include <subcert/analysis/symbol/parallel.hpp>
#include <subcert/reports/experiments/figures.hpp>
#include <subcert/reports/experiments/local_polynomial.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

namespace subcert::experiments::dyn_2015 {
namespace {

constexpr int loudest = 1, quietest = 20;  // decibel

struct TestFunction {
  std::string name;
  std::string formula;
  double (*value)(double);
};

/// Local linear and local cubic regression among the methods; the others are specifications of schemes.
const std::string local_linear = "local:degree=1", local_cubic = "local:degree=3";

std::string method_name(const std::string& method) {
  if (method == local_linear) return "LLR";
  if (method == local_cubic) return "local cubic";
  if (method == "bspline:degree=2") return "Chaikin";
  if (method == "bspline:degree=3") return "cubic B-spline";
  return scheme_name(method);
}

/// A function sampled at 0, h, ..., 100, and its reconstructions at the multiples of h/4.
class FunctionTrial {
 public:
  /// Domain: h divides 100, at least 8 samples.
  FunctionTrial(const TestFunction& function, double h, const Names& methods) {
    constexpr int level = 2;
    const auto count = static_cast<std::size_t>(std::lround(100 / h)) + 1, outputs = ((count - 1) << level) + 1;
    std::vector<double> positions;
    for (std::size_t i = 0; i < count; ++i) samples_.push_back(function.value(h * static_cast<double>(i)));
    for (std::size_t i = 0; i < outputs; ++i) {
      positions.push_back(std::ldexp(static_cast<double>(i), -level));
      truth_.push_back(function.value(std::ldexp(h, -level) * static_cast<double>(i)));
    }
    for (const std::string& method : methods)
      if (method == local_linear || method == local_cubic)
        methods_.emplace_back(method, LocalPolynomialRegression(method == local_linear ? 1 : 3, count, positions));
      else
        methods_.emplace_back(method, limit_matrix(method, count, data::Boundary::regression, level));
  }

  /// The relative errors: the measure is the method, the subject the level of noise, "1", ..., "20".
  Measured errors(const ExperimentOptions& options) const {
    Measured result;
    for (const auto& [name, method] : methods_)
      for (int decibel = loudest; decibel <= quietest; ++decibel)
        result.samples[{name, std::to_string(decibel)}].resize(options.runs);
    const std::vector<Coordinate> truth{truth_};
    parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
      const auto noise = noise_of(options.seed, run);
      for (const auto& [name, method] : methods_) {
        const Reconstruction reconstruction = reconstructed(method, noise);
        for (int decibel = loudest; decibel <= quietest; ++decibel) {
          auto& found = result.samples.at({name, std::to_string(decibel)});
          found[run] = relative_error({reconstruction(deviation(decibel))}, truth);
        }
      }
    });
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
  using Method = std::variant<DenseMatrix, LocalPolynomialRegression>;
  /// Of samples + sigma * noise, for any sigma.
  using Reconstruction = std::function<std::vector<double>(double sigma)>;

  static std::vector<double> sum(std::vector<double> values, double factor, const std::vector<double>& others) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += factor * others[i];
    return values;
  }
  Reconstruction reconstructed(const Method& method, const std::vector<double>& noise) const {
    if (const auto* scheme = std::get_if<DenseMatrix>(&method))
      return [signal = *scheme * samples_, error = *scheme * noise](double sigma) { return sum(signal, sigma, error); };
    const auto& regression = std::get<LocalPolynomialRegression>(method);
    return [both = RegressionOfSum(regression, samples_, noise)](double sigma) mutable { return both(sigma); };
  }
  std::vector<double> noise_of(std::uint64_t seed, std::size_t run) const {
    auto engine = generator(seed, run);
    return normal_noise(engine, samples_.size());
  }
  double deviation(double decibel) const { return noise_deviation(mean_square(samples_), decibel); }

  std::vector<double> samples_, truth_;
  std::vector<std::pair<std::string, Method>> methods_;
};

double cube(double x) { return x * x * x; }
const TestFunction f1{"f_1", "sin(x/10) + (x/50)^2", [](double x) { return std::sin(x / 10) + x * x / 2500; }};
const TestFunction f2{"f_2", "cos(2x/5) + (x/40 - 1)^3",
                      [](double x) { return std::cos(x * 2 / 5) + cube(x / 40 - 1); }};
const TestFunction f3{"f_3", "cos(x/10) - (x/50 - 1)^3", [](double x) { return std::cos(x / 10) - cube(x / 50 - 1); }};
const TestFunction f4{"f_4", "cos(2x/5) - (x/50 - 4/5)^3",
                      [](double x) { return std::cos(x * 2 / 5) - cube(x / 50 - 0.8); }};

/// Levels of noise in decibel.
struct Levels {
  int from = loudest;
  int to = quietest;

  std::string text() const { return std::to_string(from) + " to " + std::to_string(to) + " dB"; }
};

/// "1 to 4, 6".
std::string listed(const std::vector<int>& levels) {
  std::string text;
  for (std::size_t i = 0; i < levels.size();) {
    std::size_t end = i + 1;
    while (end < levels.size() && levels[end] == levels[end - 1] + 1) ++end;
    text += (text.empty() ? "" : ", ") + std::to_string(levels[i]) +
            (end > i + 1 ? " to " + std::to_string(levels[end - 1]) : "");
    i = end;
  }
  return text.empty() ? "none" : text;
}

/// The errors of two methods at several levels of noise, by the paired differences, and the ratios of their means.
struct MethodComparison {
  std::vector<int> smaller = {}, larger = {}, undecided = {};
  double least = INFINITY, largest = 0;
  std::string ratios = {};

  MethodComparison(const Measured& errors, const std::string& first, const std::string& second, Levels levels) {
    for (int decibel = levels.from; decibel <= levels.to; ++decibel) {
      const auto &a = errors.at({first, std::to_string(decibel)}), &b = errors.at({second, std::to_string(decibel)});
      const MeanInterval difference = mean_difference(a, b);
      const double ratio = mean_interval(a).mean / mean_interval(b).mean;
      least = std::min(least, ratio);
      largest = std::max(largest, ratio);
      (difference.is_negative() ? smaller : difference.is_positive() ? larger : undecided).push_back(decibel);
    }
    ratios = "ratio of mean errors " + method_name(first) + " / " + method_name(second) + ": " + short_number(least) +
             " ... " + short_number(largest);
  }
};

enum class At { each_level, some_level };

/// `better` has a smaller mean error than `worse`.
Relation smaller_error(const std::string& better, const std::string& worse, Levels levels = {},
                       At where = At::each_level) {
  return {"mean of the paired difference of errors, " + method_name(better) + " minus " + method_name(worse) +
              ", negative with its whole interval at " + (where == At::some_level ? "some level, " : "each level, ") +
              levels.text(),
          [=](const Measured& errors) {
            const MethodComparison found(errors, better, worse, levels);
            return finding(
                where == At::some_level ? !found.smaller.empty() : found.larger.empty() && found.undecided.empty(),
                "negative at " + listed(found.smaller) + " dB; positive at " + listed(found.larger) +
                    "; undecided at " + listed(found.undecided) + "; " + found.ratios);
          }};
}

/// The ratio of the mean errors is at most `tolerance` away from 1 at each level.
Relation nearly_equal_error(const std::string& first, const std::string& second, double tolerance) {
  return {"the ratio of the mean errors differs from 1 by at most " + short_number(tolerance) + " at each level, " +
              Levels{}.text(),
          [=](const Measured& errors) {
            const MethodComparison found(errors, first, second, {});
            return finding(found.least >= 1 - tolerance && found.largest <= 1 + tolerance, found.ratios);
          }};
}

struct FunctionFigure {
  std::string id;
  TestFunction function;
  std::string first;
  std::string second;
  double shown;  // dB of the reconstruction
  std::vector<Claim> claims;
};

formats::Figure figure_of(const FunctionFigure& figure, const FunctionTrial& trial, const Measured& errors,
                          std::uint64_t seed) {
  const std::string methods[] = {figure.first, figure.second}, colours[] = {colour::blue, colour::red};
  const auto over_x = [](const std::vector<double>& values) {
    return over_steps(values, 100.0 / static_cast<double>(values.size() - 1));
  };
  const FunctionTrial::Shown sample = trial.shown(figure.shown, seed);
  formats::Panel over_noise{figure.function.name, "SNR (dB)", "relative error", {}};
  formats::Panel shown = plain_panel("data with " + short_number(figure.shown) + " dB noise",
                                     {dots("data", over_x(sample.data), colour::grey),
                                      line(figure.function.name, over_x(sample.truth), colour::amber)});
  shown.x_label = "x";
  for (std::size_t m = 0; m < 2; ++m) {
    const std::string name = method_name(methods[m]);
    Points means;
    for (int decibel = loudest; decibel <= quietest; ++decibel)
      means.emplace_back(decibel, mean_interval(errors.at({methods[m], std::to_string(decibel)})).mean);
    over_noise.curves.push_back(line(name, means, colours[m]));
    over_noise.curves.back().marked = true;
    shown.curves.push_back(line(name, over_x(sample.reconstructions[m]), colours[m]));
  }
  return {figure.id,
          "Comparison of " + method_name(figure.first) + " and " + method_name(figure.second) + " for " +
              figure.function.name,
          "Left: mean relative error over the signal-to-noise ratio. Right: one reconstruction.",
          2,
          {over_noise, shown}};
}

/// Both methods of the figure, and for comparison the others.
Names methods_of(const FunctionFigure& figure) {
  Names result{figure.first, figure.second};
  for (const std::string& other :
       {local_linear, local_cubic, std::string("bspline:degree=2"), std::string("bspline:degree=3")})
    if (std::find(result.begin(), result.end(), other) == result.end()) result.push_back(other);
  return result;
}

MeansTable errors_table(const FunctionFigure& figure) {
  MeansTable table{figure.id + "-errors", "Mean relative errors", {"SNR (dB)"}, {}, {}};
  for (int decibel = loudest; decibel <= quietest; ++decibel)
    table.rows.push_back({{std::to_string(decibel)}, std::to_string(decibel)});
  for (const std::string& method : methods_of(figure)) table.columns.push_back({method_name(method), method});
  table.columns.push_back({"first minus second", figure.first, figure.second});
  return table;
}

Measured measured(const FunctionFigure& figure, const ExperimentOptions& options) {
  const FunctionTrial trial(figure.function, 1, methods_of(figure));
  Measured result = trial.errors(options);
  formats::PlainTable spacings{figure.id + "-spacings",
                               "The same claims with other spacings of the data",
                               {"claim", "spacing", "finding", "numbers"},
                               {}};
  for (const double h : {0.5, 2.0}) {
    const Measured errors = FunctionTrial(figure.function, h, {figure.first, figure.second}).errors(options);
    for (const Claim& claim : figure.claims) {
      const Finding found = claim.relation.decide(errors);
      spacings.rows.push_back({claim.sentence, short_number(h), to_text(found.verdict), found.numbers});
    }
  }
  result.tables = {spacings};
  result.figures = {figure_of(figure, trial, result, options.seed)};
  return result;
}

Experiment function_experiment(const std::string& id, const TestFunction& function, const std::string& first,
                               const std::string& second, double shown, const std::vector<Claim>& claims) {
  const FunctionFigure figure{id, function, first, second, shown, claims};
  return {
      .id = figure.id,
      .title = "Figure " + figure.id.substr(3) + ": " + method_name(figure.first) + " and " +
               method_name(figure.second) + " on " + figure.function.name,
      .setup = {figure.function.name + "(x) = " + figure.function.formula +
                    ". The paper names neither interval nor spacing; here x = 0, 1, ..., 100, and a table has the "
                    "spacings 1/2 and 2. The limits are compared at the multiples of a quarter of the spacing, the "
                    "ends continued by the scheme's own fit (interp).",
                "The noise is normal, with the deviation that gives the signal-to-noise ratio in the mean; 20 log10 "
                "of the ratio of norms. One sample of the noise serves all methods and, scaled, all levels. LLR: "
                "normal kernel, the bandwidth by leaving out each datum in turn; local cubic: the same with cubic "
                "polynomials."},
      .claims = figure.claims,
      .tables = {errors_table(figure)},
      .measure = [figure](const ExperimentOptions& options) { return measured(figure, options); }};
}

}  // namespace

std::vector<Experiment> function_experiments() {
  const std::string s3 = "primal:n=3", s5 = "primal:n=5", s7 = "primal:n=7", s53 = "primal:n=5,d=3",
                    s63 = "primal:n=6,d=3", s93 = "primal:n=9,d=3", llr = local_linear;
  return {
      function_experiment("fig3", f1, s3, llr, 6.5,
                          {{.sentence = "For all levels of noise, LLR gives a smaller error than S_3.",
                            .place = "Sec. 3.2, Fig. 3",
                            .relation = smaller_error(llr, s3)}}),
      function_experiment("fig4", f1, s5, llr, 7,
                          {{.sentence = "S_5 behaves almost identically to LLR.",
                            .place = "Sec. 3.2, Fig. 4",
                            .relation = nearly_equal_error(s5, llr, 0.1),
                            .recorded = Verdict::not_confirmed}}),
      function_experiment(
          "fig5", f1, s7, llr, 7.9,
          {{.sentence = "S_7 is even better than LLR.",
            .place = "Sec. 3.2, Fig. 5",
            .relation = smaller_error(s7, llr),
            .recorded = Verdict::not_confirmed},
           {.sentence = "There is a range of parameters for which a scheme outperforms LLR (S_7 on f_1).",
            .place = "Sec. 3.2, end",
            .relation = smaller_error(s7, llr, {}, At::some_level)}}),
      function_experiment(
          "fig6", f2, s3, llr, 6.2,
          {{.sentence = "S_3 suits f_2 better than LLR, except for extremely high noise (read as: from 5 dB).",
            .place = "Sec. 3.2, Fig. 6",
            .relation = smaller_error(s3, llr, {.from = 5}),
            .recorded = Verdict::not_confirmed}}),
      function_experiment(
          "fig7", f2, s5, llr, 8,
          {{.sentence = "S_5 is inferior to LLR for any reasonable level of noise (read as: from 5 dB).",
            .place = "Sec. 3.2, Fig. 7",
            .relation = smaller_error(llr, s5, {.from = 5})}}),
      function_experiment("fig10", f3, s5, s53, 8.2,
                          {{.sentence = "S_5^1 is better as long as the noise is significant (read as: to 12 dB).",
                            .place = "Sec. 4.4, Fig. 10",
                            .relation = smaller_error(s5, s53, {.to = 12})},
                           {.sentence = "S_5^3 is more accurate as the noise decays (read as: from 18 dB).",
                            .place = "Sec. 4.4, Fig. 10",
                            .relation = smaller_error(s53, s5, {.from = 18}),
                            .recorded = Verdict::not_confirmed}}),
      function_experiment("fig11", f4, s5, s53, 7.2,
                          {{.sentence = "S_5^3 outperforms S_5^1 for all noise levels.",
                            .place = "Sec. 4.4, Fig. 11",
                            .relation = smaller_error(s53, s5),
                            .recorded = Verdict::not_confirmed}}),
      function_experiment("fig12", f3, s63, s93, 8.4,
                          {{.sentence = "The larger support of S_9^3 helps to smooth out noise.",
                            .place = "Sec. 4.4, Fig. 12",
                            .relation = smaller_error(s93, s63)}}),
      function_experiment("fig13", f4, s63, s93, 9.5,
                          {{.sentence = "The smaller support of S_6^3 leads to smaller errors for all noise levels.",
                            .place = "Sec. 4.4, Fig. 13",
                            .relation = smaller_error(s63, s93),
                            .recorded = Verdict::not_confirmed}})};
}

}  // namespace subcert::experiments::dyn_2015
