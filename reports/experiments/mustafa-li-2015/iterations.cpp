// [MLZD15, Figure 4 and App. A.1]: error over iterations, refinements and delta.

#include "damped_sine.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::experiments::mustafa_li_2015 {
namespace {

/// D_6 with other parameters, under the label that claims and pictures give it.
struct Setting {
  std::string label;
  int fits;
  int refinements = 1;
  std::string delta = "1e-8";

  std::string specification() const { return "l1:points=6,iterations=" + std::to_string(fits) + ",delta=" + delta; }
  std::string subject() const { return specification() + ",refinements=" + std::to_string(refinements); }
};
using Series = std::vector<Setting>;

const Series more_fits{{"1 fit", 1}, {"2 fits", 2}, {"4 fits", 4}, {"10 fits", 10}};
const Series sufficient{{"m = 5", 6}, {"m = 6", 7}, {"100 fits", 100}};
const Series more_refinements{{"1", 6, 1}, {"2", 6, 2}, {"4", 6, 4}, {"6", 6, 6}};
const Series deltas{
    {"1", 30, 1, "1"}, {"1e-2", 30, 1, "1e-2"}, {"1e-4", 30, 1, "1e-4"}, {"1e-6", 30, 1, "1e-6"}, {"1e-8", 30}};

Series all_settings() {
  Series result;
  for (const Series* series : {&more_fits, &sufficient, &more_refinements, &deltas})
    result.insert(result.end(), series->begin(), series->end());
  return result;
}

/// The error of the first minus `factor` times that of the second.
Mean difference(const std::string& name, const Setting& first, const Setting& second, double factor = 1) {
  return {name, {"error", first.subject()}, Quantity{"error", second.subject()}, factor};
}

/// The differences of neighbours in the list, the later minus the earlier.
Means steps(const Series& series) {
  Means result;
  for (std::size_t i = 0; i + 1 < series.size(); ++i)
    result.push_back(difference(series[i + 1].label + " - " + series[i].label, series[i + 1], series[i]));
  return result;
}

formats::Figure drawn(const OutlierSample& sample) {
  formats::Figure figure{"l1-fig4",
                         "D_6 at work",
                         "One sample of Experiment 2. Above: the first refinement with 1, 2, 4 and 10 reweighted "
                         "fits. Below: 1, 2, 4 and 6 refinements with 6 fits.",
                         4,
                         {}};
  for (const Setting& s : more_fits)
    figure.panels.push_back(damped::panel(sample, {s.label, s.specification(), s.refinements}));
  for (const Setting& s : more_refinements)
    figure.panels.push_back(damped::panel(
        sample, {s.label + (s.refinements == 1 ? " refinement" : " refinements"), s.specification(), s.refinements}));
  return figure;
}

Measured measured(const ExperimentOptions& options) {
  const NoisyData data = damped::with_outliers(13, std::sqrt(0.1));
  std::vector<Method> methods;
  for (const Setting& s : all_settings())
    if (std::none_of(methods.begin(), methods.end(), [&](const Method& m) { return m.name == s.subject(); }))
      methods.push_back({s.subject(), s.specification(), s.refinements});
  Measured result;
  study(result, data, methods, {error_measure}, options);
  result.figures = {drawn(data.first_sample(options.seed))};
  return result;
}

}  // namespace

Experiment iterations() {
  const std::string errors = "paired differences of the errors";
  MeansTable table{"l1-fig4-errors",
                   "Errors of D_6",
                   {"reweighted fits", "delta", "refinements"},
                   {},
                   {{"mean squared error", "error"}}};
  for (const Setting& s : all_settings())
    table.rows.push_back({{std::to_string(s.fits), s.delta, std::to_string(s.refinements)}, s.subject()});
  return {.id = "l1-fig4",
          .title = "Figure 4: iterations, refinements and delta",
          .setup = {"The data of Experiment 2 (l1-exp2). The figure does not name the scheme; here D_6. Error: mean "
                    "squared distance from f_1. m of the paper counts from 0: m = 5 stands for 6 reweighted fits."},
          .claims =
              {{.sentence = "The curve gets better as the iterations increase: 1, 2, 4, 10 in the first refinement.",
                .place = "Sec. 2.5, Fig. 4, first row",
                .relation = below(errors, 0, steps(more_fits))},
               {.sentence = "The curve gets better with 1, 2, 4, 6 refinements.",
                .place = "Sec. 2.5, Fig. 4, second row",
                .relation = below(errors, 0, steps(more_refinements)),
                .recorded = Verdict::not_confirmed},
               {.sentence = "m = 5 or 6 is sufficient (read as: the error is at most a twentieth larger than after 100 "
                            "fits).",
                .place = "App. A.1",
                .relation = below("paired differences of the error and 1.05 of that after 100 fits", 0,
                                  {difference("m = 5", sufficient[0], sufficient[2], 1.05),
                                   difference("m = 6", sufficient[1], sufficient[2], 1.05)}),
                .recorded = Verdict::not_confirmed},
               {.sentence = "A small delta is a good choice (read as: from 1 down to 1e-8 in steps of 1/100 each error "
                            "is smaller than the one before).",
                .place = "App. A.1",
                .relation = below(errors + " with 30 fits", 0, steps(deltas)),
                .recorded = Verdict::not_confirmed}},
          .tables = {table},
          .measure = measured};
}

}  // namespace subcert::experiments::mustafa_li_2015
