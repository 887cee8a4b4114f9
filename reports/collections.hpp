#pragma once
/// Results of the literature beside what is proved of them: one report a paper or collection. Domain: options.only
/// names items of the report.

#include "report.hpp"

namespace subcert::reports {

/// Ref: [DHHS15].
Report report_dyn_2015(const ReportOptions& options);
/// Its items in the order of the page.
std::vector<std::string> dyn_2015_items();

/// Smoothness of surface schemes: what is published, and the least squares schemes of the four papers, of which they
/// say nothing. Errors: as multivariate_regularity.
Report report_bivariate(const ReportOptions& options);
Report report_least_squares_surfaces(const ReportOptions& options);

/// Ranges of parameters. Errors: as property_range.
Report report_families(const ReportOptions& options);

/// With a certificate for each of D4, ..., D50.
Report report_daubechies(const ReportOptions& options);

/// Masks that change from level to level. With a certificate of each interval. Errors: as property_of_levels.
Report report_levels(const ReportOptions& options);

/// Hermite schemes and multiwavelets. Errors: as regularity_of.
Report report_vectors(const ReportOptions& options);

/// Surfaces at extraordinary vertices. With a certificate for each scheme that is C^1 at all of them, where there is
/// one. Errors: as vertex_smoothness and every_valence.
Report report_vertices(const ReportOptions& options);

/// With the matrices and a certificate of each family. Errors: as joint_spectral_radius.
Report report_joint_spectral_radii(const ReportOptions& options);

/// The ids of the paper's experiments, in order.
std::vector<std::string> experiment_ids(const std::string& paper);

}  // namespace subcert::reports
