#pragma once
/// What is proved about the smoothness of surface schemes, as rows of tables.

#include "report.hpp"

#include <subcert/analysis/regularity/multivariate_regularity.hpp>

#include <limits>

namespace subcert::reports {

struct SurfaceFacts {
  std::string specification;  ///< canonical
  std::vector<Interval> support;
  MultivariateRegularity regularity;

  /// The cells before, then those of surface_facts_head().
  std::vector<std::string> row(std::vector<std::string> before) const;
  /// A Hoelder exponent that the search leaves open is rounded outward to the places that its width deserves.
  std::string holder_text() const;
  std::string sobolev_text() const;
};

/// The cells before, then sum rules, convergence, Hoelder and Sobolev exponent, stability, support.
std::vector<std::string> surface_facts_head(std::vector<std::string> before);

/// Of each scheme, in this order, on at most options.jobs threads. The search for the exponent takes at most so many
/// seconds a scheme, or options.budget where that is given; else masks of more than `most_searched` coefficients are
/// not searched, and their Sobolev exponent alone encloses the Hoelder exponent, whatever the clock.
/// Domain: specifications of several variables, with an isotropic dilation or of tensor products. Errors: as
/// make_linear_scheme and multivariate_regularity.
std::vector<SurfaceFacts> surface_facts(const std::vector<std::string>& specifications, const ReportOptions& options,
                                        double seconds, long most_searched = std::numeric_limits<long>::max());

}  // namespace subcert::reports
