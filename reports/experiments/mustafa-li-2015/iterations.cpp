// [MLZD15, Figure 4 and App. A.1]: error over iterations, refinements and delta.

#include "damped_sine.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::experiments::mustafa_li_2015 {
namespace {

/// D_6 with other parameters, and the label that claims and pictures give it.
struct Setting {
  std::string label;
  int fits;
  int refinements = 1;
  std::string delta = "1e-8";

  std::string specification() const { return "l1:points=6,iterations=" + std::to_string(fits) + ",delta=" + delta; }
  std::string subject() const { return specification() + ",refinements=" + std::to_string(refinements); }
};
/// Settings that claims compare: the measure "error over ..." has the label as its subject.
struct Series {
  std::string over;
  std::vector<Setting> settings;
};

const std::vector<Setting> more_fits{{"1 fit", 1}, {"2 fits", 2}, {"4 fits", 4}, {"10 fits", 10}};
const std::vector<Setting> more_refinements{{"1", 6, 1}, {"2", 6, 2}, {"4", 6, 4}, {"6", 6, 6}};
const std::vector<Series> all_series{
    {"fits", more_fits},
    {"fits", {{"0 fits", 0}, {"m = 5", 6}, {"m = 6", 7}, {"100 fits", 100}}},
    {"refinements", more_refinements},
    {"delta",
     {{"1", 30, 1, "1"}, {"1e-2", 30, 1, "1e-2"}, {"1e-4", 30, 1, "1e-4"}, {"1e-6", 30, 1, "1e-6"}, {"1e-8", 30}}}};

formats::Figure drawn(const OutlierSample& sample) {
  formats::Figure figure{"l1-fig4",
                         "D_6 at work",
                         "One sample of Experiment 2. Above: the first refinement with 1, 2, 4 and 10 reweighted fits. "
                         "Below: 1, 2, 4 and 6 refinements with 6 fits.",
                         4,
                         {}};
  for (const Setting& s : more_fits)
    figure.panels.push_back(damped::panel(sample, {s.label, s.specification(), s.refinements}));
  for (const Setting& s : more_refinements)
    figure.panels.push_back(damped::panel(
        sample, {s.label + (s.refinements == 1 ? " refinement" : " refinements"), s.specification(), s.refinements}));
  return figure;
}

}  // namespace

Measured iterations(const Run& run) {
  const NoisyData data = damped::setting(run).with_outliers(13, noise_deviation_of(run));
  MeansTable table{"l1-fig4-errors",
                   "Errors of D_6",
                   {"reweighted fits", "delta", "refinements"},
                   {},
                   {{"mean squared error", "error"}}};
  std::vector<Method> methods;
  for (const Series& series : all_series)
    for (const Setting& s : series.settings) {
      table.rows.push_back({{std::to_string(s.fits), s.delta, std::to_string(s.refinements)}, s.subject()});
      if (std::none_of(methods.begin(), methods.end(), [&](const Method& m) { return m.name == s.subject(); }))
        methods.push_back({s.subject(), s.specification(), s.refinements});
    }
  Measured result;
  study(result, data, methods, {error_measure}, run);
  for (const auto& [over, settings] : all_series)
    for (const Setting& s : settings)
      result.samples[{"error over " + over, s.label}] = result.at({"error", s.subject()});
  if (run.is_alternative()) return result;
  result.tables = {table.filled(result)};
  result.figures = {drawn(data.first_sample(run.seed))};
  return result;
}

}  // namespace subcert::experiments::mustafa_li_2015
