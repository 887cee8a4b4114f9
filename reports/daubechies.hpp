#pragma once
/// Daubechies' orthonormal scaling functions: published Hoelder exponents beside the certified ones.

#include "report.hpp"

namespace subcert::reports {

const std::vector<std::string>& daubechies_items();

/// With a certificate for each of D4, ..., D42. Domain: options.only names items of daubechies_items().
Report report_daubechies(const ReportOptions& options);

}  // namespace subcert::reports
