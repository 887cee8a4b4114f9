#pragma once
/// Facts about the schemes of least absolute deviations.

#include "fact.hpp"

#include <subcert/schemes/data/l1/least_absolute_limit.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::facts {

/// What is true of the exact rule behind the scheme. Domain: `limit` is that of its points and degree.
Facts l1_facts(const DataDependentScheme& scheme, const data::LeastAbsoluteLimit& limit);

/// The points and the degree of a scheme of curves with separate residuals. Errors: throws a usage error for others.
int points_of_curve(const DataDependentScheme& scheme);

}  // namespace subcert::facts
