#pragma once
/// The page about Conjectures 7 and 8 of Dyn et al. for every n.

#include "report.hpp"

namespace subcert::reports {

/// Statements, the verdicts of the theorems, means and ripples over n. Cost: half a minute on one thread,
/// as all inequalities are run.
formats::Section theorem_section(const ReportOptions& options);

}  // namespace subcert::reports
