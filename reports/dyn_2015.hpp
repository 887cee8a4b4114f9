#pragma once
/// Dyn, Heard, Hormann & Sharon 2015, recomputed.

#include "report.hpp"

namespace subcert::reports {

/// The items in the order of the page.
const std::vector<std::string>& dyn_2015_items();

/// Domain: options.only names items of dyn_2015_items(). Ref: [DHHS15].
Report report_dyn_2015(const ReportOptions& options);

}  // namespace subcert::reports
