// [DHHS15, sec. 3.2 and 4.4, Figures 3 to 7 and 10 to 13]: error over the signal-to-noise ratio.

#include "function_trial.hpp"
#include "parts.hpp"

#include <subcert/reports/experiments/figures.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::experiments::dyn_2015 {
namespace {

constexpr int loudest = FunctionTrial::loudest, quietest = FunctionTrial::quietest;

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

std::vector<FunctionFigure> all_figures() {
  const std::string s3 = "primal:n=3", s5 = "primal:n=5", s7 = "primal:n=7", s53 = "primal:n=5,d=3",
                    s63 = "primal:n=6,d=3", s93 = "primal:n=9,d=3", llr = local_linear;
  return {
      {.id = "fig3",
       .function = f1,
       .first = s3,
       .second = llr,
       .shown = 6.5,
       .claims = {{.sentence = "For all levels of noise, LLR gives a smaller error than S_3.",
                   .place = "Sec. 3.2, Fig. 3",
                   .relation = smaller_error(llr, s3)}}},
      {.id = "fig4",
       .function = f1,
       .first = s5,
       .second = llr,
       .shown = 7,
       .claims = {{.sentence = "S_5 behaves almost identically to LLR.",
                   .place = "Sec. 3.2, Fig. 4",
                   .relation = nearly_equal_error(s5, llr, 0.1),
                   .recorded = Verdict::not_confirmed}}},
      {.id = "fig5",
       .function = f1,
       .first = s7,
       .second = llr,
       .shown = 7.9,
       .claims = {{.sentence = "S_7 is even better than LLR.",
                   .place = "Sec. 3.2, Fig. 5",
                   .relation = smaller_error(s7, llr),
                   .recorded = Verdict::not_confirmed},
                  {.sentence = "There is a range of parameters for which a scheme outperforms LLR (S_7 on f_1).",
                   .place = "Sec. 3.2, end",
                   .relation = smaller_error(s7, llr, {}, At::some_level)}}},
      {.id = "fig6",
       .function = f2,
       .first = s3,
       .second = llr,
       .shown = 6.2,
       .claims = {{.sentence = "S_3 suits f_2 better than LLR, except for extremely high noise (read as: from 5 dB).",
                   .place = "Sec. 3.2, Fig. 6",
                   .relation = smaller_error(s3, llr, {.from = 5}),
                   .recorded = Verdict::not_confirmed}}},
      {.id = "fig7",
       .function = f2,
       .first = s5,
       .second = llr,
       .shown = 8,
       .claims = {{.sentence = "S_5 is inferior to LLR for any reasonable level of noise (read as: from 5 dB).",
                   .place = "Sec. 3.2, Fig. 7",
                   .relation = smaller_error(llr, s5, {.from = 5})}}},
      {.id = "fig10",
       .function = f3,
       .first = s5,
       .second = s53,
       .shown = 8.2,
       .claims = {{.sentence = "S_5^1 is better as long as the noise is significant (read as: to 12 dB).",
                   .place = "Sec. 4.4, Fig. 10",
                   .relation = smaller_error(s5, s53, {.to = 12})},
                  {.sentence = "S_5^3 is more accurate as the noise decays (read as: from 18 dB).",
                   .place = "Sec. 4.4, Fig. 10",
                   .relation = smaller_error(s53, s5, {.from = 18}),
                   .recorded = Verdict::not_confirmed}}},
      {.id = "fig11",
       .function = f4,
       .first = s5,
       .second = s53,
       .shown = 7.2,
       .claims = {{.sentence = "S_5^3 outperforms S_5^1 for all noise levels.",
                   .place = "Sec. 4.4, Fig. 11",
                   .relation = smaller_error(s53, s5),
                   .recorded = Verdict::not_confirmed}}},
      {.id = "fig12",
       .function = f3,
       .first = s63,
       .second = s93,
       .shown = 8.4,
       .claims = {{.sentence = "The larger support of S_9^3 helps to smooth out noise.",
                   .place = "Sec. 4.4, Fig. 12",
                   .relation = smaller_error(s93, s63)}}},
      {.id = "fig13",
       .function = f4,
       .first = s63,
       .second = s93,
       .shown = 9.5,
       .claims = {{.sentence = "The smaller support of S_6^3 leads to smaller errors for all noise levels.",
                   .place = "Sec. 4.4, Fig. 13",
                   .relation = smaller_error(s63, s93),
                   .recorded = Verdict::not_confirmed}}}};
}

}  // namespace

std::vector<Experiment> function_experiments() {
  std::vector<Experiment> result;
  for (const FunctionFigure& figure : all_figures())
    result.push_back(
        {.id = figure.id,
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
         .measure = [figure](const ExperimentOptions& options) { return measured(figure, options); }});
  return result;
}

}  // namespace subcert::experiments::dyn_2015
