#pragma once
/// What `subcert mask` and `subcert analyze` say about a scheme of two or three variables.

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/cli/command.hpp>

namespace subcert::cli {

/// Nested arrays of exact numbers, the last variable outermost.
Json coefficients_json(const MultivariateMask& mask);

/// One {"lower", "upper"} for each variable.
Json limit_support_json(const MultivariateMask& mask);

/// Prints the page, and says whether the scheme converges.
Decision analyze_multivariate(const MultivariateScheme& scheme, const ProofLimits& limits,
                              const CommonOptions& options);

}  // namespace subcert::cli
