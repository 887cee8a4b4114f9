#pragma once
/// What `subcert limit` prints: values of the basic limit function and its derivatives, or its extremes and sign.

#include <subcert/analysis/family/limit_values_of_levels.hpp>
#include <subcert/analysis/limit/field_values.hpp>
#include <subcert/cli/paper_form.hpp>

namespace subcert::cli {

struct LimitPageOptions : CommonOptions {
  int level = -1;  ///< not given
  std::string width = "1/1000000";
  double budget = 10;
  PaperForm form;
};

/// Domain: level >= 0; an order for each variable, such that the derivative is continuous.
ExitCode print_limit_values(const Scheme& scheme, const LatticePoint& orders, const LimitPageOptions& options,
                            const Deadline& deadline);

/// The same of masks that change from level to level: exact values, or enclosures.
ExitCode print_limit_values(const std::string& scheme, const LimitValues& values, const LimitPageOptions& options);
ExitCode print_limit_values(const std::string& scheme, const EnclosedLimitValues& values,
                            const LimitPageOptions& options);

/// The same of a vector of functions with these values at M^-level i, i their indices.
ExitCode print_vector_values(const Scheme& scheme, const FieldValues& values, const LatticePoint& orders,
                             const LimitPageOptions& options);

/// Domain: schemes that converge; of one variable by contraction, else the answer is a refusal. Errors: throws a usage
/// error for a width that is no positive number.
ExitCode print_limit_range(const Scheme& scheme, const LimitPageOptions& options, const Deadline& deadline);

}  // namespace subcert::cli
