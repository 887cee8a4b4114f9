#pragma once
/// Joint spectral radii of families of the literature, beside the values that it publishes.

#include "report.hpp"

namespace subcert::reports {

const std::vector<std::string>& joint_spectral_radius_items();

/// With the matrices and a certificate of each family. Domain: options.only names items of
/// joint_spectral_radius_items(). Error: as joint_spectral_radius.
Report report_joint_spectral_radii(const ReportOptions& options);

}  // namespace subcert::reports
