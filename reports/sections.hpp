#pragma once
/// Sections of pages that tell of theorems, conjectures and variance curves.

#include "computed_quantities.hpp"
#include "report.hpp"

namespace subcert::reports {

/// Statements, the verdicts of the theorems, means and ripples over n. Cost: half a minute on one thread,
/// as all inequalities are run.
formats::Section theorem_section(const ReportOptions& options);

/// Ref: [DHHS15, sec. 4.3]; proofs: docs/limit-constants.md, docs/theorems/README.md.
formats::Section conjecture_7_section(ComputedQuantities& quantities);

/// The wanted ones among the items table3, fig2, fig8 and fig9. Ref: [DHHS15, sec. 3.1 and 4.3].
formats::Section variance_section(const ReportOptions& options, ComputedQuantities& quantities);

}  // namespace subcert::reports
