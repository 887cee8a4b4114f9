#pragma once
/// The least squares schemes for surfaces and volumes of the four papers, which say nothing about their smoothness.

#include "report.hpp"

namespace subcert::reports {

const std::vector<std::string>& least_squares_surface_items();

/// Domain: options.only names items of least_squares_surface_items(). Error: as multivariate_regularity.
Report report_least_squares_surfaces(const ReportOptions& options);

}  // namespace subcert::reports
