#pragma once
/// A page on which a parameter is moved: mask, limit function, exponent and variance curve follow.

#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <string>

namespace subcert::reports {

struct ExplorerOptions {
  int steps = 60;    ///< between the first value and the last
  int pieces = 200;  ///< of the curve of the exponent
  int jobs = 1;
  Budget budget{Deadline::in(60)};
};

/// One page, all in one file: the values low, ..., high in equal steps, and rational ones between them at which the
/// scheme has more sum rules or its shifts may be unstable. What is said of a value is proved: the exponent between the
/// envelopes of exponent_curve(), or exactly where that is known. Functions are exact at their points before they are
/// rounded; they are drawn where the scheme is proved to converge. Domain and errors: as exponent_curve. Cost: that of
/// the curve, and a limit function for each value while there is time.
std::string explorer_html(const ParametricScheme& scheme, const Rational& low, const Rational& high,
                          const ExplorerOptions& options);

}  // namespace subcert::reports
