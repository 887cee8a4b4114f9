// [MLZD15, Figure 4 and App. A.1]: error over iterations, refinements and delta.

#include "damped_sine.hpp"
#include "families.hpp"

#include <subcert/schemes/data/runtime/parallel.hpp>

#include <cmath>

namespace subcert::experiments::l1_iterations {
namespace {

struct Setting {
  int fits;
  int refinements;
  std::string delta;
};

std::string specification(const Setting& s) {
  return "l1:points=6,iterations=" + std::to_string(s.fits) + ",delta=" + s.delta;
}

/// The errors of the curves of D_6.
std::vector<double> errors(const Setting& setting, const Batch& data) {
  const Batch fine = refined(specification(setting), data, setting.refinements);
  const auto at = parameters(fine.axes[0]);
  std::vector<double> result;
  for (const auto& set : fine.sets) {
    double sum = 0;
    for (std::size_t i = 0; i < set.size(); ++i) sum += std::pow(set[i] - damped_sine(damped::position(at[i])), 2);
    result.push_back(sum / static_cast<double>(set.size()));
  }
  return result;
}

class Errors {
 public:
  Errors(std::vector<Setting> settings, const Batch& data, int jobs)
      : settings_(std::move(settings)), values_(settings_.size()) {
    runtime::parallel_for_each(settings_.size(), jobs, [&](std::size_t i) { values_[i] = errors(settings_[i], data); });
  }
  /// The differences of neighbours in the list, the later minus the earlier.
  std::vector<NamedMean> steps(const std::function<std::string(const Setting&)>& name) const {
    std::vector<NamedMean> result;
    for (std::size_t i = 0; i + 1 < values_.size(); ++i)
      result.push_back(
          {name(settings_[i + 1]) + " - " + name(settings_[i]), mean_difference(values_[i + 1], values_[i])});
    return result;
  }
  void add_rows(formats::PlainTable& table) const {
    for (std::size_t i = 0; i < values_.size(); ++i)
      table.rows.push_back({std::to_string(settings_[i].fits), settings_[i].delta,
                            std::to_string(settings_[i].refinements), mean_interval(values_[i]).text()});
  }
  const std::vector<double>& operator[](std::size_t i) const { return values_[i]; }

 private:
  std::vector<Setting> settings_;
  std::vector<std::vector<double>> values_;
};

formats::Figure drawn(const OutlierSample& sample) {
  formats::Figure figure{"l1-fig4",
                         "D_6 at work",
                         "One sample of Experiment 2. Above: the first refinement with 1, 2, 4 and 10 reweighted "
                         "fits. Below: 1, 2, 4 and 6 refinements with 6 fits.",
                         4,
                         {}};
  for (const int fits : {1, 2, 4, 10})
    figure.panels.push_back(damped::panel(std::to_string(fits) + (fits == 1 ? " fit" : " fits"),
                                          specification({fits, 1, "1e-8"}), sample, 1));
  for (const int refinements : {1, 2, 4, 6})
    figure.panels.push_back(
        damped::panel(std::to_string(refinements) + (refinements == 1 ? " refinement" : " refinements"),
                      specification({6, refinements, "1e-8"}), sample, refinements));
  return figure;
}

ExperimentResult run(const ExperimentOptions& options) {
  const OutlierCase what = damped::with_outliers(13, std::sqrt(0.1));
  Batch data{what.axes, 1, {}};
  for (std::size_t r = 0; r < options.runs; ++r) {
    auto engine = generator(options.seed, r);
    data.sets.push_back(what.draw(engine).with);
  }
  const Errors fits({{1, 1, "1e-8"}, {2, 1, "1e-8"}, {4, 1, "1e-8"}, {10, 1, "1e-8"}}, data, options.jobs);
  const Errors refinements({{6, 1, "1e-8"}, {6, 2, "1e-8"}, {6, 4, "1e-8"}, {6, 6, "1e-8"}}, data, options.jobs);
  const Errors sufficient({{6, 1, "1e-8"}, {7, 1, "1e-8"}, {100, 1, "1e-8"}}, data, options.jobs);
  const Errors deltas({{30, 1, "1"}, {30, 1, "1e-2"}, {30, 1, "1e-4"}, {30, 1, "1e-6"}, {30, 1, "1e-8"}}, data,
                      options.jobs);
  ExperimentResult result{
      {"The data of Experiment 2 (l1-exp2). The figure does not name the scheme; here D_6. Error: mean "
       "squared distance from f_1. m of the paper counts from 0: m = 5 stands for 6 reweighted fits."}};
  const auto fits_of = [](const Setting& s) { return std::to_string(s.fits) + (s.fits == 1 ? " fit" : " fits"); };
  result.claims.push_back(
      all_below({"The curve gets better as the iterations increase: 1, 2, 4, 10 in the first refinement.",
                 "Sec. 2.5, Fig. 4, first row"},
                "paired differences of the errors", 0, fits.steps(fits_of)));
  result.claims.push_back(all_below(
      {"The curve gets better with 1, 2, 4, 6 refinements.", "Sec. 2.5, Fig. 4, second row"},
      "paired differences of the errors", 0,
      refinements.steps([](const Setting& s) { return std::to_string(s.refinements); }), Verdict::not_confirmed));
  std::vector<NamedMean> excess;
  for (const std::size_t i : {0u, 1u}) {
    std::vector<double> bound = sufficient[2];
    for (double& value : bound) value *= 1.05;
    excess.push_back({std::string("m = ") + (i == 0 ? "5" : "6"), mean_difference(sufficient[i], bound)});
  }
  result.claims.push_back(
      all_below({"m = 5 or 6 is sufficient (read as: the error is at most a twentieth larger than after 100 "
                 "fits).",
                 "App. A.1"},
                "paired differences of the error and 1.05 of that after 100 fits", 0, excess, Verdict::not_confirmed));
  result.claims.push_back(
      all_below({"A small delta is a good choice (read as: from 1 down to 1e-8 in steps of 1/100 each error "
                 "is smaller than the one before).",
                 "App. A.1"},
                "paired differences of the errors with 30 fits", 0,
                deltas.steps([](const Setting& s) { return s.delta; }), Verdict::not_confirmed));
  formats::PlainTable table{
      "l1-fig4-errors", "Errors of D_6", {"reweighted fits", "delta", "refinements", "mean squared error"}, {}};
  for (const Errors* part : {&fits, &sufficient, &refinements, &deltas}) part->add_rows(table);
  result.tables.push_back(table);
  auto engine = generator(options.seed, 0);
  result.figures.push_back(drawn(what.draw(engine)));
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  return {{"l1-fig4", "mustafa-li-2015", "Figure 4: iterations, refinements and delta", run}};
}

}  // namespace subcert::experiments::l1_iterations
