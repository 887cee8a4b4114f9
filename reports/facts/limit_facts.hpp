#pragma once
/// Facts about the basic limit function between grid points, and about the variance curve.

#include "fact.hpp"

#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/variance/variance_range.hpp>

namespace subcert::facts {

Facts limit_facts(const LimitRange& range);
Facts variance_facts(const VarianceRange& range);

/// `1/2, -1`.
std::string coordinates_text(const std::vector<Rational>& point);

}  // namespace subcert::facts
