#pragma once
/// Facts about the schemes of least absolute deviations.

#include "fact.hpp"

#include <subcert/schemes/data/l1/least_absolute_limit.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::facts {

/// The part of a budget in which `limit` is best sought, so that some is left for the rule itself.
constexpr double share_of_limit = 0.8;

/// Of what is tried to prove about the rule itself.
struct RuleLimits {
  Deadline deadline;
  bool thorough = false;  ///< with many boxes: half a minute for 6 points and 6 fits, in place of a second
};

/// What is true of the exact rule behind the scheme and of the rule itself; of the latter as far as the limits allow.
/// Domain: `limit` is that of its points and degree.
Facts l1_facts(const DataDependentScheme& scheme, const data::LeastAbsoluteLimit& limit, const RuleLimits& limits);

/// The points and the degree of a scheme of curves with separate residuals. Errors: throws a usage error for others.
int points_of_curve(const DataDependentScheme& scheme);

}  // namespace subcert::facts
