// [MLZD15, sec. 2.5, Experiments 1 and 2, Figures 3 and 5, Tables 1 and 2].

#include "damped_sine.hpp"
#include "families.hpp"

#include <cmath>

namespace subcert::experiments::l1_functions {
namespace {

/// "Greatly affected" and "no response" are on two sides of this part of the range of f_1.
constexpr double noticed = 0.1;

/// The claims that the paper makes in Experiment 1 and repeats in Experiment 2; what is recorded of the second and the
/// last.
std::vector<Claim> claims_about_responses(const std::vector<Outcome>& outcomes, const std::string& place,
                                          Verdict no_response, Verdict robust_complexity) {
  const double bound = noticed * damped::range();
  return {
      all_above({"The curves of S_6, S_7 and S_8 are greatly affected by the outliers (read as: moved by more than a "
                 "tenth of the range of f_1).",
                 place},
                "largest change by the outliers", bound, means(outcomes, least_squares, &Outcome::response)),
      all_below(
          {"D_6, D_7 and D_8 do not respond to the outliers (read as: they move by less than a tenth of the range "
           "of f_1).",
           place},
          "largest change by the outliers", bound, means(outcomes, robust, &Outcome::response), no_response),
      all_below({"Schemes of large complexity respond less to outliers: least squares.", place},
                "paired differences of the largest change by the outliers", 0,
                differences(outcomes, more_least_squares_points, &Outcome::response)),
      all_below({"Schemes of large complexity respond less to outliers: l1.", place},
                "paired differences of the largest change by the outliers", 0,
                differences(outcomes, more_robust_points, &Outcome::response), robust_complexity)};
}

/// The printed table beside the measures, and a picture of sample 0.
void add_measures(ExperimentResult& result, const std::string& id, const std::string& title, const std::string& table,
                  const OutlierCase& what, const std::vector<Outcome>& outcomes, std::uint64_t seed) {
  result.claims.push_back(printed_errors_claim(table, outcomes));
  result.comparisons.push_back(printed_errors(table, outcomes));
  result.tables.push_back(outcome_table(id + "-measures", title, outcomes));
  auto engine = generator(seed, 0);
  result.figures.push_back(damped::figure(id, title, "One sample. Above least squares, below l1 regression.",
                                          curve_methods(), what.draw(engine)));
}

ExperimentResult run_experiment_1(const ExperimentOptions& options) {
  const OutlierCase what = damped::with_outliers(2, 0);
  const auto outcomes = study(what, curve_methods(), options);
  const std::string place = "Sec. 2.5, Experiment 1, Fig. 3";
  ExperimentResult result{{damped::setup(), "Two outliers, no noise."}};
  result.claims = claims_about_responses(outcomes, place, Verdict::confirmed, Verdict::not_confirmed);
  result.claims.push_back(all_below({"Each D_k has a smaller error than S_k.", "Sec. 2.5, Table 1"},
                                    "paired differences of the errors", 0,
                                    differences(outcomes, robust_over_least_squares, &Outcome::error)));
  result.claims.push_back(all_below({"D_6 has the smallest error.", "Sec. 2.5, Table 1; Experiment 2"},
                                    "paired differences of the errors", 0,
                                    differences(outcomes, six_over_others, &Outcome::error)));
  add_measures(result, "l1-exp1", "Two outliers", "table1", what, outcomes, options.seed);
  return result;
}

ExperimentResult run_experiment_2(const ExperimentOptions& options) {
  const double sigma = std::sqrt(0.1);
  const OutlierCase what = damped::with_outliers(13, sigma);
  const auto outcomes = study(what, curve_methods(), options);
  const std::string place = "Sec. 2.5, Experiment 2, Fig. 5";
  ExperimentResult result{{damped::setup(), "Thirteen outliers and normal noise of variance 0.1."}};
  result.claims = claims_about_responses(outcomes, place, Verdict::not_confirmed, Verdict::confirmed);
  result.claims.push_back(all_below(
      {"The l1 schemes have smaller errors than the least squares schemes.", place + ", Table 2"},
      "paired differences of the errors", 0, differences(outcomes, robust_over_least_squares, &Outcome::error)));
  result.claims.push_back(all_below(
      {"The l1 schemes approximate with a much smaller error (read as: at most half).", "Sec. 4"},
      "paired differences of the errors", 0, differences(outcomes, robust_over_least_squares, &Outcome::error, 0.5)));
  result.claims.push_back(
      all_above({"Schemes of high complexity have larger errors than those of low complexity.", place + ", Table 2"},
                "paired differences of the errors", 0, differences(outcomes, more_over_fewer_points, &Outcome::error),
                Verdict::not_confirmed));
  result.claims.push_back(all_below({"D_6 fits better than the other schemes.", place + ", Table 2"},
                                    "paired differences of the errors", 0,
                                    differences(outcomes, six_over_others, &Outcome::error), Verdict::not_confirmed));
  result.claims.push_back(all_below({"The l1 schemes fit best with outliers and without.", "Sec. 1"},
                                    "paired differences of the errors without outliers, noise alone", 0,
                                    differences(outcomes, robust_over_least_squares, &Outcome::error_without),
                                    Verdict::not_confirmed));
  add_measures(result, "l1-exp2", "Noise and thirteen outliers", "table2", what, outcomes, options.seed);
  return result;
}

/// How much of the curve one outlier moves.
std::vector<double> moved_parts(const Method& method, const ExperimentOptions& options) {
  const OutlierCase what = damped::with_outliers(1, 0);
  Batch data{what.axes, 1, {}};
  for (std::size_t run = 0; run < options.runs; ++run) {
    auto engine = generator(options.seed, run);
    const OutlierSample sample = what.draw(engine);
    data.sets.push_back(sample.without);
    data.sets.push_back(sample.with);
  }
  const Batch fine = refined(method.specification, data, what.levels);
  std::vector<double> parts;
  for (std::size_t k = 0; k < fine.sets.size(); k += 2) {
    std::size_t moved = 0;
    for (std::size_t i = 0; i < fine.sets[k].size(); ++i) moved += fine.sets[k][i] != fine.sets[k + 1][i];
    parts.push_back(static_cast<double>(moved) / static_cast<double>(fine.sets[k].size()));
  }
  return parts;
}

ExperimentResult run_figure_1(const ExperimentOptions& options) {
  const std::vector<Method> methods{{"Chaikin", "bspline:degree=2"}, {"S_6", "dual:n=3"}};
  const OutlierCase what = damped::with_outliers(2, 0);
  const auto outcomes = study(what, methods, options);
  const double bound = noticed * damped::range();
  ExperimentResult result{
      {damped::setup(), "Two outliers; the least squares scheme of the figure is not named, here S_6."}};
  result.claims.push_back(
      all_above({"Outliers perturb the least squares curve significantly (read as: by more than a tenth of "
                 "the range of f_1).",
                 "Sec. 2.1, Fig. 1(b)"},
                "largest change by the outliers", bound, means(outcomes, {"S_6"}, &Outcome::response)));
  result.claims.push_back(
      all_above({"Classical schemes do not deal with outliers (read as: Chaikin's curve moves by more "
                 "than a tenth of the range of f_1).",
                 "Sec. 1; Sec. 2.1, Fig. 1(a)"},
                "largest change by the outliers", bound, means(outcomes, {"Chaikin"}, &Outcome::response)));
  std::vector<NamedMean> moved;
  for (const Method& method : methods) moved.push_back({method.name, mean_interval(moved_parts(method, options))});
  result.claims.push_back(
      all_above({"One outlier can damage the whole model (read as: it moves more than nine tenths of the "
                 "curve).",
                 "Sec. 1"},
                "part of the curve that one outlier among 101 data moves", 0.9, moved, Verdict::not_confirmed));
  result.tables.push_back(outcome_table("l1-fig1-measures", "Two outliers", outcomes));
  auto engine = generator(options.seed, 0);
  formats::Figure figure = damped::figure("l1-fig1", "Outliers under Chaikin's scheme and a least squares scheme",
                                          "One sample.", methods, what.draw(engine));
  figure.columns = 2;
  result.figures.push_back(figure);
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  const std::string paper = "mustafa-li-2015";
  return {
      {"l1-fig1", paper, "Figure 1: Chaikin's scheme and least squares against outliers", run_figure_1},
      {"l1-exp1", paper, "Experiment 1, Figure 3 and Table 1: two outliers", run_experiment_1, true},
      {"l1-exp2", paper, "Experiment 2, Figure 5 and Table 2: noise and thirteen outliers", run_experiment_2, true}};
}

}  // namespace subcert::experiments::l1_functions
