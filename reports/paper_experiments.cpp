#include "collections.hpp"

namespace subcert::reports {

std::vector<std::string> experiment_ids(const std::string& paper) {
  std::vector<std::string> result;
  for (const experiments::Experiment& candidate : experiments::experiments())
    if (candidate.paper == paper) result.push_back(candidate.id);
  return result;
}

void add_experiments(Report& report, const ReportOptions& options) {
  for (const std::string& id : experiment_ids(report.paper)) {
    if (!options.wants(id)) continue;
    if (options.progress) options.progress(id);
    report.experiments.push_back(
        experiments::run_experiment(experiments::experiment(id), {options.seed, options.runs, options.jobs}));
    report.sections.push_back(experiments::experiment_section(report.experiments.back()));
  }
}

}  // namespace subcert::reports
