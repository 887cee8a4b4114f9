#pragma once
/// The experiments of one paper as a part of its report.

#include "experiments/experiment.hpp"

#include <subcert/reports/report.hpp>

namespace subcert::reports {

/// The ids of the paper's experiments, in order.
std::vector<std::string> experiment_ids(const std::string& paper);

/// Runs the paper's experiments, those of options.only where it is not empty, and appends their sections.
void add_experiments(Report& report, const ReportOptions& options);

}  // namespace subcert::reports
