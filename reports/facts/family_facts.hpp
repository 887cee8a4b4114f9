#pragma once
/// Facts about a scheme with a parameter.

#include "fact.hpp"

#include <subcert/schemes/parametric_specification.hpp>

namespace subcert::facts {

/// What holds for all values of the parameter, and for which values more does.
Facts family_facts(const ParametricScheme& scheme);

}  // namespace subcert::facts
