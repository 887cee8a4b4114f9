#pragma once
/// Certified quantities of schemes, computed once for all statements. Safe to call from several threads.

#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/regularity/holder_bound.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/variance/variance_order.hpp>
#include <subcert/analysis/variance/variance_range.hpp>

namespace subcert::statements {

/// Domain of all: a scheme specification. Errors: as the functions of the library that they call.
const Mask& mask_of(const std::string& scheme);
const VarianceRange& variance_of(const std::string& scheme);
const LimitRange& limit_range_of(const std::string& scheme);
/// After 16 levels.
const HolderBound& holder_bound_of(const std::string& scheme);
const HolderRegularity& holder_regularity_of(const std::string& scheme);
/// psi of the first below psi of the second.
const VarianceOrder& variance_order_of(const std::string& first, const std::string& second);

/// `primal:n=3,d=1`.
std::string specification(const std::string& family, int n, int degree = 1);

}  // namespace subcert::statements
