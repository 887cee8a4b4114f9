// [MLZD15, sec. 2.5, Experiment 4, Figure 7]: impulsive noise.

#include "damped_sine.hpp"
#include "families.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::experiments::l1_impulses {
namespace {

constexpr double largest_impulse = 8;

/// A part of the data, in percent, is replaced by numbers uniform in [-8, 8].
OutlierCase with_impulses(int percent) {
  OutlierCase what = damped::with_outliers(0, 0);
  what.draw = [percent](std::mt19937_64& engine) {
    OutlierSample sample{damped::samples(), damped::samples()};
    const std::size_t replaced = damped::count * static_cast<std::size_t>(percent) / 100;
    for (const std::size_t i : chosen_indices(engine, replaced, damped::count))
      sample.with[i] = largest_impulse * (2 * uniform(engine) - 1);
    return sample;
  };
  return what;
}

ExperimentResult run(const ExperimentOptions& options) {
  const std::vector<int> parts{10, 20, 25, 30, 40, 50};
  formats::Panel over_parts{
      "error over the part of impulses", "impulses (%)", "mean squared error", {}, true, "bottom right"};
  formats::PlainTable table{"l1-exp4-errors", "Mean squared errors over the part of impulses", {"impulses (%)"}, {}};
  for (const Method& method : curve_methods()) {
    over_parts.curves.push_back({method.name, {}, true});
    table.head.push_back(method.name);
  }
  std::vector<Outcome> shown;
  for (const int percent : parts) {
    auto outcomes = study(with_impulses(percent), curve_methods(), options);
    table.rows.push_back({std::to_string(percent)});
    for (std::size_t m = 0; m < outcomes.size(); ++m) {
      const MeanInterval mean = mean_interval(outcomes[m].error);
      over_parts.curves[m].points.emplace_back(percent, mean.mean);
      table.rows.back().push_back(mean.text());
    }
    if (percent == 25) shown = std::move(outcomes);
  }
  const std::string place = "Sec. 2.5, Experiment 4, Fig. 7";
  const double signal = mean_square(damped::samples());
  ExperimentResult result{{damped::setup(),
                           "The paper names neither the data of this experiment nor the impulses; here f_1, and a "
                           "quarter of the data is replaced by numbers uniform in [-8, 8]."}};
  result.claims = {
      all_below({"The l1 schemes restore data with 25 % impulsive noise (read as: with an error below a tenth of the "
                 "mean square of "
                 "f_1).",
                 place + "; Highlights"},
                "error", signal / 10, means(shown, robust, &Outcome::error), Verdict::not_confirmed),
      all_above({"The least squares schemes do not handle impulsive noise (read as: their error is above a tenth of "
                 "the mean square "
                 "of f_1).",
                 "Sec. 1; " + place},
                "error", signal / 10, means(shown, least_squares, &Outcome::error)),
      all_below({"The l1 schemes fit data with impulsive noise better than the others.", "Sec. 1"},
                "paired differences of the errors", 0, differences(shown, robust_over_least_squares, &Outcome::error)),
      all_below({"D_6 fits better than the other schemes, in the other experiments too.", "Sec. 2.5, Experiment 2"},
                "paired differences of the errors", 0, differences(shown, six_over_others, &Outcome::error),
                Verdict::not_confirmed)};
  result.tables = {outcome_table("l1-exp4-measures", "A quarter of impulses", shown), table};
  auto engine = generator(options.seed, 0);
  const OutlierSample sample = with_impulses(25).draw(engine);
  result.figures = {
      damped::figure("l1-exp4", "Impulsive noise",
                     "One sample, 25 % impulses. Above least squares, below l1 regression.", curve_methods(), sample),
      {"l1-exp4-parts", "How many impulses the schemes bear", "Means over the samples.", 1, {over_parts}}};
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  return {{"l1-exp4", "mustafa-li-2015", "Experiment 4 and Figure 7: impulsive noise", run}};
}

}  // namespace subcert::experiments::l1_impulses
