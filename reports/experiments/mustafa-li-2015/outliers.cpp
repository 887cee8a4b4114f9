// [MLZD15, sec. 2.5, Experiments 1, 2 and 4, Figures 1, 3, 5 and 7, Tables 1 and 2]: a function with outliers.

#include "damped_sine.hpp"

#include <subcert/reports/experiments/figures.hpp>

#include <cmath>

namespace subcert::experiments::mustafa_li_2015 {
namespace {

const std::string change = "largest change by the outliers", changes = "the " + change;

/// "Greatly affected" and "no response" are on two sides of this.
double tenth_of_range() { return 0.1 * damped::range(); }

/// The claims that the paper makes in Experiment 1 and repeats in Experiment 2; what is recorded of the second and the
/// last.
std::vector<Claim> claims_about_responses(const std::string& place, Verdict no_response, Verdict l1_complexity) {
  return {
      {.sentence = "The curves of S_6, S_7 and S_8 are greatly affected by the outliers (read as: moved by more "
                   "than a tenth of the range of f_1).",
       .place = place,
       .relation = above(change, tenth_of_range(), means("response", least_squares))},
      {.sentence = "D_6, D_7 and D_8 do not respond to the outliers (read as: they move by less than a tenth of the "
                   "range of f_1).",
       .place = place,
       .relation = below(change, tenth_of_range(), means("response", l1_schemes)),
       .recorded = no_response},
      {.sentence = "Schemes of large complexity respond less to outliers: least squares.",
       .place = place,
       .relation = smaller(more_least_squares_points, "response", changes)},
      {.sentence = "Schemes of large complexity respond less to outliers: l1.",
       .place = place,
       .relation = smaller(more_l1_points, "response", changes),
       .recorded = l1_complexity}};
}

/// A panel for each method.
Picture sample_picture(const std::string& id, const std::string& title, const std::string& caption, int columns = 3,
                       const std::vector<Method>& methods = curve_methods()) {
  return [=](const OutlierSample& sample) { return damped::figure(id, title, caption, columns, methods, sample); };
}

const std::string above_and_below = "One sample. Above least squares, below l1 regression.";

/// A part of the data, in percent, is replaced by numbers uniform in [-8, 8].
NoisyData with_impulses(int percent) {
  NoisyData data = damped::with_outliers(damped::count * static_cast<std::size_t>(percent) / 100, 0);
  data.sigma.reset();
  data.displace = [](std::mt19937_64& engine, double* height) { *height = 8 * (2 * uniform(engine) - 1); };
  return data;
}

constexpr int quarter = 25;
const std::vector<int> parts_of_impulses{10, 20, quarter, 30, 40, 50};

std::string percent_text(int percent) { return std::to_string(percent) + " %"; }

/// The errors also with the method as the measure and the part of impulses as the subject.
Measured measured_impulses(const ExperimentOptions& options) {
  Measured result;
  formats::Panel over_parts{
      "error over the part of impulses", "impulses (%)", "mean squared error", {}, true, "bottom right"};
  for (const int percent : parts_of_impulses)
    study(result, with_impulses(percent), curve_methods(), {error_measure}, options, percent_text(percent) + ": ");
  for (const Method& method : curve_methods()) {
    Points errors;
    for (const int percent : parts_of_impulses) {
      const auto& error = result.at({percent_text(percent) + ": error", method.name});
      errors.emplace_back(percent, mean_interval(error).mean);
      result.samples[{method.name, percent_text(percent)}] = error;
    }
    over_parts.curves.push_back(line(method.name, errors, ""));
    over_parts.curves.back().marked = true;
  }
  result.figures = {
      {"l1-exp4-parts", "How many impulses the schemes bear", "Means over the samples.", 1, {over_parts}}};
  return result;
}

}  // namespace

Experiment outliers_under_linear_schemes() {
  const std::vector<Method> methods{{"Chaikin", "bspline:degree=2"}, {"S_6", "dual:n=3"}};
  return with_curve_study(
      {.id = "l1-fig1",
       .title = "Figure 1: Chaikin's scheme and least squares against outliers",
       .setup = {damped::setup(), "Two outliers; the least squares scheme of the figure is not named, here S_6."},
       .claims =
           {{.sentence = "Outliers perturb the least squares curve significantly (read as: by more than a tenth "
                         "of the range of f_1).",
             .place = "Sec. 2.1, Fig. 1(b)",
             .relation = above(change, tenth_of_range(), means("response", {"S_6"}))},
            {.sentence = "Classical schemes do not deal with outliers (read as: Chaikin's curve moves by more than "
                         "a tenth of the range of f_1).",
             .place = "Sec. 1; Sec. 2.1, Fig. 1(a)",
             .relation = above(change, tenth_of_range(), means("response", {"Chaikin"}))},
            {.sentence = "One outlier can damage the whole model (read as: it moves more than nine tenths of the "
                         "curve).",
             .place = "Sec. 1",
             .relation = above("part of the curve that one outlier among 101 data moves", 0.9,
                               means("moved", {"Chaikin", "S_6"})),
             .recorded = Verdict::not_confirmed}},
       .measure =
           [=](const ExperimentOptions& options) {
             Measured result;
             study(result, damped::with_outliers(1, 0), methods, {moved_measure}, options);
             return result;
           }},
      "Two outliers", damped::with_outliers(2, 0), methods,
      sample_picture("l1-fig1", "Outliers under Chaikin's scheme and a least squares scheme", "One sample.", 2,
                     methods));
}

Experiment two_outliers() {
  std::vector<Claim> claims = claims_about_responses("Sec. 2.5, Experiment 1, Fig. 3", Verdict::confirmed,
                                                     Verdict::not_confirmed);
  claims.push_back({.sentence = "Each D_k has a smaller error than S_k.",
                    .place = "Sec. 2.5, Table 1",
                    .relation = smaller(l1_over_least_squares)});
  claims.push_back({.sentence = "D_6 has the smallest error.",
                    .place = "Sec. 2.5, Table 1; Experiment 2",
                    .relation = smaller(six_over_others)});
  return with_curve_study({.id = "l1-exp1",
                           .title = "Experiment 1, Figure 3 and Table 1: two outliers",
                           .setup = {damped::setup(), "Two outliers, no noise."},
                           .claims = claims,
                           .printed = "table1"},
                          "Two outliers", damped::with_outliers(2, 0), curve_methods(),
                          sample_picture("l1-exp1", "Two outliers", above_and_below));
}

Experiment noise_and_outliers() {
  const std::string place = "Sec. 2.5, Experiment 2, Fig. 5";
  std::vector<Claim> claims = claims_about_responses(place, Verdict::not_confirmed, Verdict::confirmed);
  const std::vector<Claim> more{
      {.sentence = "The l1 schemes have smaller errors than the least squares schemes.",
       .place = place + ", Table 2",
       .relation = smaller(l1_over_least_squares)},
      {.sentence = "The l1 schemes approximate with a much smaller error (read as: at most half).",
       .place = "Sec. 4",
       .relation = below("paired differences of the errors", 0, differences("error", l1_over_least_squares, 0.5))},
      {.sentence = "Schemes of high complexity have larger errors than those of low complexity.",
       .place = place + ", Table 2",
       .relation = larger(more_over_fewer_points),
       .recorded = Verdict::not_confirmed},
      {.sentence = "D_6 fits better than the other schemes.",
       .place = place + ", Table 2",
       .relation = smaller(six_over_others),
       .recorded = Verdict::not_confirmed},
      {.sentence = "The l1 schemes fit best with outliers and without.",
       .place = "Sec. 1",
       .relation = smaller(l1_over_least_squares, "error without", "the errors without outliers, noise alone"),
       .recorded = Verdict::not_confirmed}};
  claims.insert(claims.end(), more.begin(), more.end());
  return with_curve_study({.id = "l1-exp2",
                           .title = "Experiment 2, Figure 5 and Table 2: noise and thirteen outliers",
                           .setup = {damped::setup(), "Thirteen outliers and normal noise of variance 0.1."},
                           .claims = claims,
                           .printed = "table2"},
                          "Noise and thirteen outliers", damped::with_outliers(13, std::sqrt(0.1)), curve_methods(),
                          sample_picture("l1-exp2", "Noise and thirteen outliers", above_and_below));
}

Experiment impulsive_noise() {
  const std::string place = "Sec. 2.5, Experiment 4, Fig. 7";
  const double bound = damped::mean_square_of_samples() / 10;
  MeansTable errors{"l1-exp4-errors", "Mean squared errors over the part of impulses", {"impulses (%)"}, {}, {}};
  for (const int percent : parts_of_impulses) errors.rows.push_back({{std::to_string(percent)}, percent_text(percent)});
  for (const Method& method : curve_methods()) errors.columns.push_back({method.name, method.name});
  return with_curve_study(
      {.id = "l1-exp4",
       .title = "Experiment 4 and Figure 7: impulsive noise",
       .setup = {damped::setup(),
                 "The paper names neither the data of this experiment nor the impulses; here f_1, and a quarter of "
                 "the data is replaced by numbers uniform in [-8, 8]."},
       .claims = {{.sentence = "The l1 schemes restore data with 25 % impulsive noise (read as: with an error below a "
                               "tenth of the mean square of f_1).",
                   .place = place + "; Highlights",
                   .relation = below("error", bound, means("error", l1_schemes)),
                   .recorded = Verdict::not_confirmed},
                  {.sentence = "The least squares schemes do not handle impulsive noise (read as: their error is "
                               "above a tenth of the mean square of f_1).",
                   .place = "Sec. 1; " + place,
                   .relation = above("error", bound, means("error", least_squares))},
                  {.sentence = "The l1 schemes fit data with impulsive noise better than the others.",
                   .place = "Sec. 1",
                   .relation = smaller(l1_over_least_squares)},
                  {.sentence = "D_6 fits better than the other schemes, in the other experiments too.",
                   .place = "Sec. 2.5, Experiment 2",
                   .relation = smaller(six_over_others),
                   .recorded = Verdict::not_confirmed}},
       .tables = {errors},
       .measure = measured_impulses},
      "A quarter of impulses", with_impulses(quarter), curve_methods(),
      sample_picture("l1-exp4", "Impulsive noise",
                     "One sample, 25 % impulses. Above least squares, below l1 regression."));
}

}  // namespace subcert::experiments::mustafa_li_2015
