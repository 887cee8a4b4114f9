#pragma once
/// Facts about the schemes of least absolute deviations.

#include "fact.hpp"

#include <subcert/schemes/data/l1/least_absolute_limit.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::facts {

/// The part of a budget in which `limit` is best sought, so that some is left for the rule itself.
constexpr double share_of_limit = 0.8;

/// What is true of the exact rule behind the scheme and of the rule itself; of the latter as far as the time suffices.
/// Domain: `limit` is that of its points and degree.
Facts l1_facts(const DataDependentScheme& scheme, const data::LeastAbsoluteLimit& limit, const Deadline& deadline);

/// The points and the degree of a scheme of curves with separate residuals. Errors: throws a usage error for others.
int points_of_curve(const DataDependentScheme& scheme);

}  // namespace subcert::facts
