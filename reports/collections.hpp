#pragma once
/// Results of the literature beside what is proved of them: one report a paper or collection.

#include "experiments/experiment.hpp"
#include "report.hpp"

#include <subcert/reports/report.hpp>

namespace subcert::reports {

const std::vector<std::string>& daubechies_items();

/// With a certificate for each of D4, ..., D42. Domain: options.only names items of daubechies_items().
Report report_daubechies(const ReportOptions& options);

const std::vector<std::string>& bivariate_items();

/// Domain: options.only names items of bivariate_items(). Error: as multivariate_regularity.
Report report_bivariate(const ReportOptions& options);

const std::vector<std::string>& family_items();

/// Domain: options.only names items of family_items(). Error: as property_range.
Report report_families(const ReportOptions& options);

const std::vector<std::string>& joint_spectral_radius_items();

/// With the matrices and a certificate of each family. Domain: options.only names items of
/// joint_spectral_radius_items(). Error: as joint_spectral_radius.
Report report_joint_spectral_radii(const ReportOptions& options);

const std::vector<std::string>& least_squares_surface_items();

/// Domain: options.only names items of least_squares_surface_items(). Error: as multivariate_regularity.
Report report_least_squares_surfaces(const ReportOptions& options);

/// The items in the order of the page.
const std::vector<std::string>& dyn_2015_items();

/// Domain: options.only names items of dyn_2015_items(). Ref: [DHHS15].
Report report_dyn_2015(const ReportOptions& options);

/// The ids of the paper's experiments, in order.
std::vector<std::string> experiment_ids(const std::string& paper);

/// Runs the paper's experiments, those of options.only where it is not empty, and appends their sections.
void add_experiments(Report& report, const ReportOptions& options);

}  // namespace subcert::reports
