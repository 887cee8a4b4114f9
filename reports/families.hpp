#pragma once
/// Families with a parameter: the ranges that the literature publishes, beside those that are proved.

#include "report.hpp"

namespace subcert::reports {

const std::vector<std::string>& family_items();

/// Domain: options.only names items of family_items(). Error: as property_range.
Report report_families(const ReportOptions& options);

}  // namespace subcert::reports
