// [DHHS15, sec. 3.2 and 4.4, Figures 3 to 7 and 10 to 13]: error over the signal-to-noise ratio.

#include "families.hpp"
#include "function_trial.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::experiments::functions {
namespace {

constexpr int loudest = FunctionTrial::loudest, quietest = FunctionTrial::quietest;

double cube(double x) { return x * x * x; }
const TestFunction f1{"f_1", "sin(x/10) + (x/50)^2", [](double x) { return std::sin(x / 10) + x * x / 2500; }};
const TestFunction f2{"f_2", "cos(2x/5) + (x/40 - 1)^3",
                      [](double x) { return std::cos(x * 2 / 5) + cube(x / 40 - 1); }};
const TestFunction f3{"f_3", "cos(x/10) - (x/50 - 1)^3", [](double x) { return std::cos(x / 10) - cube(x / 50 - 1); }};
const TestFunction f4{"f_4", "cos(2x/5) - (x/50 - 4/5)^3",
                      [](double x) { return std::cos(x * 2 / 5) - cube(x / 50 - 0.8); }};

/// At all levels of noise from `from` to `to` dB, or at some, the mean error of `better` is smaller than that of
/// `worse`; with a tolerance: the ratio of their means is at most that far from 1.
struct Assertion {
  std::string sentence;
  std::string place;
  std::string better;
  std::string worse;
  Verdict recorded = Verdict::confirmed;
  int from = loudest;
  int to = quietest;
  std::optional<double> tolerance = std::nullopt;
  bool somewhere = false;
};

struct FunctionFigure {
  std::string id;
  TestFunction function;
  std::string first;
  std::string second;
  double shown;  // dB of the reconstruction
  std::vector<Assertion> assertions;
};

/// "1 to 4, 6".
std::string levels_text(const std::vector<int>& levels) {
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

Claim decide(const Assertion& assertion, const std::vector<std::string>& names, const FunctionTrial::Errors& errors) {
  const auto index = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  const auto& better = errors[index(assertion.better)];
  const auto& worse = errors[index(assertion.worse)];
  const std::string range = std::to_string(assertion.from) + " to " + std::to_string(assertion.to) + " dB";
  Claim claim{assertion.sentence, assertion.place, "", Verdict::confirmed, "", assertion.recorded};
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
  const std::string ratios = "ratio of mean errors " + method_name(assertion.better) + " / " +
                             method_name(assertion.worse) + ": " + short_number(least) + " ... " +
                             short_number(largest);
  if (assertion.tolerance) {
    claim.statistic = "the ratio of the mean errors differs from 1 by at most " + short_number(*assertion.tolerance) +
                      " at each level, " + range;
    if (least < 1 - *assertion.tolerance || largest > 1 + *assertion.tolerance) claim.finding = Verdict::not_confirmed;
    claim.numbers = ratios;
    return claim;
  }
  claim.statistic = "mean of the paired difference of errors, " + method_name(assertion.better) + " minus " +
                    method_name(assertion.worse) + ", negative with its whole interval at " +
                    (assertion.somewhere ? "some level, " : "each level, ") + range;
  if (assertion.somewhere ? shown.empty() : !contrary.empty() || !undecided.empty())
    claim.finding = Verdict::not_confirmed;
  claim.numbers = "negative at " + levels_text(shown) + " dB; positive at " + levels_text(contrary) +
                  "; undecided at " + levels_text(undecided) + "; " + ratios;
  return claim;
}

formats::Curve over_x(const std::string& label, const std::vector<double>& values, bool joined,
                      const std::string& colour) {
  formats::Curve result{label, {}, !joined, joined, colour};
  const double step = 100.0 / static_cast<double>(values.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i) result.points.emplace_back(step * static_cast<double>(i), values[i]);
  return result;
}

formats::Figure figure_of(const FunctionFigure& figure, const FunctionTrial& trial, const FunctionTrial::Errors& errors,
                          std::uint64_t seed) {
  const std::string names[] = {method_name(figure.first), method_name(figure.second)};
  const std::string colours[] = {"#0b559f", "#c0392b"};
  formats::Panel over_noise{figure.function.name, "SNR (dB)", "relative error", {}};
  formats::Panel shown{"data with " + short_number(figure.shown) + " dB noise", "x", "", {}, false, "below"};
  const FunctionTrial::Shown sample = trial.shown(figure.shown, seed);
  shown.curves = {over_x("data", sample.data, false, "#8a97a3"),
                  over_x(figure.function.name, sample.truth, true, "#e0a030")};
  for (std::size_t m = 0; m < 2; ++m) {
    formats::Curve curve{names[m], {}, true, true, colours[m]};
    for (int decibel = loudest; decibel <= quietest; ++decibel)
      curve.points.emplace_back(decibel, mean_interval(errors[m][static_cast<std::size_t>(decibel - loudest)]).mean);
    over_noise.curves.push_back(curve);
    shown.curves.push_back(over_x(names[m], sample.reconstructions[m], true, colours[m]));
  }
  return {figure.id,
          "Comparison of " + names[0] + " and " + names[1] + " for " + figure.function.name,
          "Left: mean relative error over the signal-to-noise ratio. Right: one reconstruction.",
          2,
          {over_noise, shown}};
}

formats::PlainTable errors_table(const FunctionFigure& figure, const std::vector<std::string>& names,
                                 const FunctionTrial::Errors& errors) {
  formats::PlainTable table{figure.id + "-errors", "Mean relative errors", {"SNR (dB)"}, {}};
  for (const std::string& name : names) table.head.push_back(method_name(name));
  table.head.push_back("first minus second");
  for (int decibel = loudest; decibel <= quietest; ++decibel) {
    const auto k = static_cast<std::size_t>(decibel - loudest);
    std::vector<std::string> row{std::to_string(decibel)};
    for (std::size_t m = 0; m < names.size(); ++m) row.push_back(mean_interval(errors[m][k]).text());
    row.push_back(mean_difference(errors[0][k], errors[1][k]).text());
    table.rows.push_back(row);
  }
  return table;
}

/// The claims decided with other spacings of the data.
formats::PlainTable spacings_table(const FunctionFigure& figure, const ExperimentOptions& options) {
  formats::PlainTable table{figure.id + "-spacings",
                            "The same claims with other spacings of the data",
                            {"claim", "spacing", "finding", "numbers"},
                            {}};
  const std::vector<std::string> names{figure.first, figure.second};
  for (const double h : {0.5, 2.0}) {
    const auto errors = FunctionTrial(figure.function, h, names).errors(options);
    for (const Assertion& assertion : figure.assertions) {
      const Claim claim = decide(assertion, names, errors);
      table.rows.push_back({claim.sentence, short_number(h), to_text(claim.finding), claim.numbers});
    }
  }
  return table;
}

ExperimentResult run(const FunctionFigure& figure, const ExperimentOptions& options) {
  std::vector<std::string> names{figure.first, figure.second};
  const std::vector<std::string> baselines{local_linear, local_cubic, "bspline:degree=2", "bspline:degree=3"};
  for (const std::string& baseline : baselines)
    if (std::find(names.begin(), names.end(), baseline) == names.end()) names.push_back(baseline);
  const FunctionTrial trial(figure.function, 1, names);
  const auto errors = trial.errors(options);
  ExperimentResult result{
      {figure.function.name + "(x) = " + figure.function.formula +
           ". The paper names neither interval nor spacing; here x = 0, 1, ..., 100, and a table has the spacings "
           "1/2 and 2. The limits are compared at the multiples of a quarter of the spacing, the ends continued by "
           "the scheme's own fit (interp).",
       "The noise is normal, with the deviation that gives the signal-to-noise ratio in the mean; 20 log10 of the "
       "ratio of norms. One sample of the noise serves all methods and, scaled, all levels. LLR: normal kernel, the "
       "bandwidth by leaving out each datum in turn; local cubic: the same with cubic polynomials."}};
  for (const Assertion& assertion : figure.assertions) result.claims.push_back(decide(assertion, names, errors));
  result.tables = {errors_table(figure, names, errors), spacings_table(figure, options)};
  result.figures.push_back(figure_of(figure, trial, errors, options.seed));
  return result;
}

std::vector<FunctionFigure> figures() {
  const std::string s3 = "primal:n=3", s5 = "primal:n=5", s7 = "primal:n=7", s53 = "primal:n=5,d=3",
                    s63 = "primal:n=6,d=3", s93 = "primal:n=9,d=3";
  return {{"fig3",
           f1,
           s3,
           local_linear,
           6.5,
           {{"For all levels of noise, LLR gives a smaller error than S_3.", "Sec. 3.2, Fig. 3", local_linear, s3}}},
          {"fig4",
           f1,
           s5,
           local_linear,
           7,
           {{"S_5 behaves almost identically to LLR.", "Sec. 3.2, Fig. 4", s5, local_linear, Verdict::not_confirmed,
             loudest, quietest, 0.1}}},
          {"fig5",
           f1,
           s7,
           local_linear,
           7.9,
           {{"S_7 is even better than LLR.", "Sec. 3.2, Fig. 5", s7, local_linear, Verdict::not_confirmed},
            {"There is a range of parameters for which a scheme outperforms LLR (S_7 on f_1).", "Sec. 3.2, end", s7,
             local_linear, Verdict::confirmed, loudest, quietest, std::nullopt, true}}},
          {"fig6",
           f2,
           s3,
           local_linear,
           6.2,
           {{"S_3 suits f_2 better than LLR, except for extremely high noise (read as: from 5 dB).", "Sec. 3.2, Fig. 6",
             s3, local_linear, Verdict::not_confirmed, 5}}},
          {"fig7",
           f2,
           s5,
           local_linear,
           8,
           {{"S_5 is inferior to LLR for any reasonable level of noise (read as: from 5 dB).", "Sec. 3.2, Fig. 7",
             local_linear, s5, Verdict::confirmed, 5}}},
          {"fig10",
           f3,
           s5,
           s53,
           8.2,
           {{"S_5^1 is better as long as the noise is significant (read as: to 12 dB).", "Sec. 4.4, Fig. 10", s5, s53,
             Verdict::confirmed, 1, 12},
            {"S_5^3 is more accurate as the noise decays (read as: from 18 dB).", "Sec. 4.4, Fig. 10", s53, s5,
             Verdict::not_confirmed, 18}}},
          {"fig11",
           f4,
           s5,
           s53,
           7.2,
           {{"S_5^3 outperforms S_5^1 for all noise levels.", "Sec. 4.4, Fig. 11", s53, s5, Verdict::not_confirmed}}},
          {"fig12",
           f3,
           s63,
           s93,
           8.4,
           {{"The larger support of S_9^3 helps to smooth out noise.", "Sec. 4.4, Fig. 12", s93, s63}}},
          {"fig13",
           f4,
           s63,
           s93,
           9.5,
           {{"The smaller support of S_6^3 leads to smaller errors for all noise levels.", "Sec. 4.4, Fig. 13", s63,
             s93, Verdict::not_confirmed}}}};
}

}  // namespace

std::vector<Experiment> all() {
  std::vector<Experiment> result;
  for (const FunctionFigure& figure : figures())
    result.push_back({figure.id, "dyn-2015",
                      "Figure " + figure.id.substr(3) + ": " + method_name(figure.first) + " and " +
                          method_name(figure.second) + " on " + figure.function.name,
                      [figure](const ExperimentOptions& options) { return run(figure, options); }});
  return result;
}

}  // namespace subcert::experiments::functions
