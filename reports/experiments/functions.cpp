// [DHHS15, sec. 3.2 and 4.4, Figures 3 to 7 and 10 to 13]: error over the signal-to-noise ratio.

#include "families.hpp"
#include "measures.hpp"

#include <subcert/reports/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace subcert {
namespace {

constexpr std::size_t count = 101;
constexpr int level = 2;  // outputs at the multiples of 1/4
constexpr int loudest = 1, quietest = 20;
const std::string regression = "llr";

struct TestFunction {
  std::string name;
  std::string formula;
  double (*value)(double);
};

double cube(double x) { return x * x * x; }
const TestFunction f1{"f_1", "sin(x/10) + (x/50)^2", [](double x) { return std::sin(x / 10) + x * x / 2500; }};
const TestFunction f2{"f_2", "cos(2x/5) + (x/40 - 1)^3", [](double x) { return std::cos(x * 2 / 5) + cube(x / 40 - 1); }};
const TestFunction f3{"f_3", "cos(x/10) - (x/50 - 1)^3", [](double x) { return std::cos(x / 10) - cube(x / 50 - 1); }};
const TestFunction f4{"f_4", "cos(2x/5) - (x/50 - 4/5)^3", [](double x) { return std::cos(x * 2 / 5) - cube(x / 50 - 0.8); }};

/// At all levels of noise from `from` to `to` dB the mean error of `better` is smaller than that of `worse`; with a
/// tolerance: the ratio of their means is at most that far from 1.
struct Assertion {
  std::string sentence;
  std::string place;
  std::string better;
  std::string worse;
  Finding recorded = Finding::confirmed;
  int from = loudest;
  int to = quietest;
  std::optional<double> tolerance = std::nullopt;
};

struct FunctionFigure {
  std::string id;
  TestFunction function;
  std::string first;
  std::string second;
  double shown;  // dB of the reconstruction
  std::vector<Assertion> assertions;
};

std::string name_of(const std::string& method) {
  if (method == regression) return "LLR";
  if (method == "bspline:degree=2") return "Chaikin";
  if (method == "bspline:degree=3") return "cubic B-spline";
  return scheme_name(method);
}

class Methods {
 public:
  explicit Methods(const std::vector<std::string>& names) : names_(names) {
    std::vector<double> positions;
    for (std::size_t i = 0; i <= (count - 1) << level; ++i) positions.push_back(std::ldexp(static_cast<double>(i), -level));
    for (const std::string& name : names)
      if (name == regression)
        regression_.emplace(count, positions);
      else
        matrices_.push_back(limit_matrix(name, count, Extension::interp, level));
  }
  std::vector<double> apply(std::size_t method, const std::vector<double>& data) const {
    std::size_t matrix = 0;
    for (std::size_t m = 0; m < method; ++m) matrix += names_[m] != regression;
    return names_[method] == regression ? (*regression_)(data) : matrices_[matrix] * data;
  }

 private:
  std::vector<std::string> names_;
  std::optional<LocalLinearRegression> regression_;
  std::vector<DenseMatrix> matrices_;
};

/// errors[method][dB - loudest][run], relative.
using Errors = std::vector<std::vector<std::vector<double>>>;

std::vector<double> noisy(const std::vector<double>& samples, const std::vector<double>& noise, double decibel) {
  const double sigma = noise_deviation(mean_square(samples), decibel);
  std::vector<double> result(samples);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] += sigma * noise[i];
  return result;
}

std::vector<double> sampled(const TestFunction& function, int at_level) {
  std::vector<double> result;
  for (std::size_t i = 0; i <= (count - 1) << at_level; ++i)
    result.push_back(function.value(std::ldexp(static_cast<double>(i), -at_level)));
  return result;
}

std::array<Coordinate, 1> one(const Coordinate& values) { return {values}; }

Errors measure(const TestFunction& function, const std::vector<std::string>& names, const Methods& methods,
               const ExperimentOptions& options) {
  const auto samples = sampled(function, 0), truth = sampled(function, level);
  Errors errors(names.size(), std::vector<std::vector<double>>(quietest - loudest + 1, std::vector<double>(options.runs)));
  parallel_for_each(options.runs, options.jobs, [&](std::size_t run) {
    auto engine = generator(options.seed, run);
    const auto noise = normal_noise(engine, count);
    for (int decibel = loudest; decibel <= quietest; ++decibel) {
      const auto data = noisy(samples, noise, decibel);
      for (std::size_t m = 0; m < names.size(); ++m)
        errors[m][static_cast<std::size_t>(decibel - loudest)][run] = relative_error(one(methods.apply(m, data)), one(truth));
    }
  });
  return errors;
}

std::string levels_text(const std::vector<int>& levels) {
  std::string text;
  for (const int decibel : levels) text += (text.empty() ? "" : ", ") + std::to_string(decibel);
  return text.empty() ? "none" : text;
}

Claim decide(const Assertion& assertion, const std::vector<std::string>& names, const Errors& errors) {
  const auto index = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  const auto& better = errors[index(assertion.better)];
  const auto& worse = errors[index(assertion.worse)];
  const std::string range = std::to_string(assertion.from) + " to " + std::to_string(assertion.to) + " dB";
  Claim claim{assertion.sentence, assertion.place, "", Finding::confirmed, "", assertion.recorded};
  std::vector<int> shown, contrary, undecided;
  double least = INFINITY, largest = 0;
  for (int decibel = assertion.from; decibel <= assertion.to; ++decibel) {
    const auto k = static_cast<std::size_t>(decibel - loudest);
    const MeanInterval difference = mean_difference(better[k], worse[k]);
    const double ratio = mean_interval(better[k]).mean / mean_interval(worse[k]).mean;
    least = std::min(least, ratio);
    largest = std::max(largest, ratio);
    (difference.is_negative() ? shown : difference.is_positive() ? contrary : undecided).push_back(decibel);
  }
  const std::string ratios = "ratio of mean errors " + name_of(assertion.better) + " / " + name_of(assertion.worse) + ": " +
                             short_number(least) + " ... " + short_number(largest);
  if (assertion.tolerance) {
    claim.statistic = "the ratio of the mean errors differs from 1 by at most " + short_number(*assertion.tolerance) +
                      " at each level, " + range;
    if (least < 1 - *assertion.tolerance || largest > 1 + *assertion.tolerance) claim.finding = Finding::not_confirmed;
    claim.numbers = ratios;
    return claim;
  }
  claim.statistic = "mean of the paired difference of errors, " + name_of(assertion.better) + " minus " +
                    name_of(assertion.worse) + ", negative with its whole interval at each level, " + range;
  if (!contrary.empty() || !undecided.empty()) claim.finding = Finding::not_confirmed;
  claim.numbers = "negative at " + levels_text(shown) + " dB; positive at " + levels_text(contrary) + "; undecided at " +
                  levels_text(undecided) + "; " + ratios;
  return claim;
}

Figure figure_of(const FunctionFigure& figure, const std::vector<std::string>& names, const Methods& methods,
                 const Errors& errors, const ExperimentOptions& options) {
  Panel over_noise{figure.function.name, "SNR (dB)", "relative error", {}};
  for (std::size_t m = 0; m < 2; ++m) {
    Curve curve{name_of(names[m]), {}, true};
    for (int decibel = loudest; decibel <= quietest; ++decibel)
      curve.points.emplace_back(decibel, mean_interval(errors[m][static_cast<std::size_t>(decibel - loudest)]).mean);
    over_noise.curves.push_back(curve);
  }
  Panel shown{"data with " + short_number(figure.shown) + " dB noise", "x", "", {}, false, "below"};
  auto engine = generator(options.seed, 0);
  const auto data = noisy(sampled(figure.function, 0), normal_noise(engine, count), figure.shown);
  const auto curve = [](const std::string& label, const std::vector<double>& values, bool joined, const std::string& colour) {
    Curve result{label, {}, !joined, joined, colour};
    const double step = 100.0 / static_cast<double>(values.size() - 1);
    for (std::size_t i = 0; i < values.size(); ++i) result.points.emplace_back(step * static_cast<double>(i), values[i]);
    return result;
  };
  shown.curves = {curve("data", data, false, "#8a97a3"),
                  curve(figure.function.name, sampled(figure.function, level), true, "#e0a030")};
  for (std::size_t m = 0; m < 2; ++m) shown.curves.push_back(curve(name_of(names[m]), methods.apply(m, data), true, m == 0 ? "#0b559f" : "#c0392b"));
  return {figure.id, "Comparison of " + name_of(figure.first) + " and " + name_of(figure.second) + " for " + figure.function.name,
          "Left: mean relative error over the signal-to-noise ratio. Right: one reconstruction.", 2, {over_noise, shown}};
}

ExperimentResult run(const FunctionFigure& figure, const ExperimentOptions& options) {
  std::vector<std::string> names{figure.first, figure.second};
  for (const char* baseline : {"llr", "bspline:degree=2", "bspline:degree=3"})
    if (std::find(names.begin(), names.end(), baseline) == names.end()) names.push_back(baseline);
  const Methods methods(names);
  const Errors errors = measure(figure.function, names, methods, options);
  ExperimentResult result{
      {figure.function.name + "(x) = " + figure.function.formula +
           ". The paper names neither interval nor spacing; here x = 0, 1, ..., 100. The limits are compared at the "
           "multiples of 1/4, the ends continued by the scheme's own fit (interp).",
       "The noise is normal, with the deviation that gives the signal-to-noise ratio in the mean; 20 log10 of the ratio of "
       "norms. One sample of the noise serves all methods and, scaled, all levels. LLR: normal kernel, the bandwidth by "
       "leaving out each datum in turn."}};
  for (const Assertion& assertion : figure.assertions) result.claims.push_back(decide(assertion, names, errors));
  PlainTable table{figure.id + "-errors", "Mean relative errors", {"SNR (dB)"}, {}};
  for (const std::string& name : names) table.head.push_back(name_of(name));
  table.head.push_back("first minus second");
  for (int decibel = loudest; decibel <= quietest; ++decibel) {
    const auto k = static_cast<std::size_t>(decibel - loudest);
    std::vector<std::string> row{std::to_string(decibel)};
    for (std::size_t m = 0; m < names.size(); ++m) row.push_back(mean_interval(errors[m][k]).text());
    row.push_back(mean_difference(errors[0][k], errors[1][k]).text());
    table.rows.push_back(row);
  }
  result.tables.push_back(table);
  result.figures.push_back(figure_of(figure, names, methods, errors, options));
  return result;
}

std::vector<FunctionFigure> figures() {
  const std::string s3 = "primal:n=3", s5 = "primal:n=5", s7 = "primal:n=7", s53 = "primal:n=5,d=3", s63 = "primal:n=6,d=3",
                    s93 = "primal:n=9,d=3";
  return {
      {"fig3", f1, s3, regression, 6.5,
       {{"For all levels of noise, LLR gives a smaller error than S_3.", "Sec. 3.2, Fig. 3", regression, s3}}},
      {"fig4", f1, s5, regression, 7,
       {{"S_5 behaves almost identically to LLR.", "Sec. 3.2, Fig. 4", s5, regression, Finding::not_confirmed, loudest, quietest, 0.1}}},
      {"fig5", f1, s7, regression, 7.9, {{"S_7 is even better than LLR.", "Sec. 3.2, Fig. 5", s7, regression, Finding::not_confirmed}}},
      {"fig6", f2, s3, regression, 6.2,
       {{"S_3 suits f_2 better than LLR, except for extremely high noise (read as: from 5 dB).", "Sec. 3.2, Fig. 6", s3,
         regression, Finding::not_confirmed, 5}}},
      {"fig7", f2, s5, regression, 8,
       {{"S_5 is inferior to LLR for any reasonable level of noise (read as: from 5 dB).", "Sec. 3.2, Fig. 7", regression,
         s5, Finding::confirmed, 5}}},
      {"fig10", f3, s5, s53, 8.2,
       {{"S_5^1 is better as long as the noise is significant (read as: to 12 dB).", "Sec. 4.4, Fig. 10", s5, s53, Finding::confirmed, 1, 12},
        {"S_5^3 is more accurate as the noise decays (read as: from 18 dB).", "Sec. 4.4, Fig. 10", s53, s5, Finding::not_confirmed, 18}}},
      {"fig11", f4, s5, s53, 7.2,
       {{"S_5^3 outperforms S_5^1 for all noise levels.", "Sec. 4.4, Fig. 11", s53, s5, Finding::not_confirmed}}},
      {"fig12", f3, s63, s93, 8.4,
       {{"The larger support of S_9^3 helps to smooth out noise.", "Sec. 4.4, Fig. 12", s93, s63}}},
      {"fig13", f4, s63, s93, 9.5,
       {{"The smaller support of S_6^3 leads to smaller errors for all noise levels.", "Sec. 4.4, Fig. 13", s63, s93, Finding::not_confirmed}}}};
}

}  // namespace

std::vector<Experiment> function_experiments() {
  std::vector<Experiment> result;
  for (const FunctionFigure& figure : figures())
    result.push_back({figure.id, "dyn-2015",
                      "Figure " + figure.id.substr(3) + ": " + name_of(figure.first) + " and " + name_of(figure.second) +
                          " on " + figure.function.name,
                      [figure](const ExperimentOptions& options) { return run(figure, options); }});
  return result;
}

}  // namespace subcert
