#pragma once
/// The page about Conjectures 7 and 8 of Dyn et al. for every n.

#include "report.hpp"

namespace subcert {

/// Statements, what Table 3 suggested, the verdicts of the theorems, means and ripples over n.
/// `printed`: cells of Table 3. Cost: half a minute on one thread, as all inequalities are run.
Section theorem_section(const std::vector<Comparison>& printed, const ReportOptions& options);

}  // namespace subcert
