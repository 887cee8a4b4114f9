#pragma once
/// Bivariate schemes of the literature: what is published about their smoothness, beside what is proved.

#include "report.hpp"

namespace subcert::reports {

const std::vector<std::string>& bivariate_items();

/// Domain: options.only names items of bivariate_items(). Error: as multivariate_regularity.
Report report_bivariate(const ReportOptions& options);

}  // namespace subcert::reports
