#pragma once
/// Table 3 and Figures 2, 8 and 9 of Dyn, Heard, Hormann & Sharon 2015.

#include "computed_quantities.hpp"

namespace subcert::reports {

/// The wanted ones among the items table3, fig2, fig8 and fig9. Ref: [DHHS15, sec. 3.1 and 4.3].
formats::Section variance_section(const ReportOptions& options, ComputedQuantities& quantities);

}  // namespace subcert::reports
