#pragma once
/// The experiments of one paper as a part of its report.

#include "experiments/experiment.hpp"

#include <subcert/reports/report.hpp>

namespace subcert::reports {

/// The ids of the paper's experiments, in order.
std::vector<std::string> experiment_ids(const std::string& paper);

/// The samples of an experiment in a report that asks for `runs`: four times as many where the paper prints values.
std::size_t report_runs(const experiments::Experiment& experiment, std::size_t runs);

/// Runs the paper's experiments, those of options.only where it is not empty, and appends their sections.
void add_experiments(Report& report, const ReportOptions& options);

}  // namespace subcert::reports
