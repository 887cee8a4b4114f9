#pragma once
/// Sobolev (L2) regularity.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

namespace subcert {

/// With m sum rules and b = the divided difference scheme of order m, the matrix C_{jk} = sum over i of
/// b_i b_{i + arity*j - k}, |j|, |k| <= N/(arity-1), satisfies sum |coefficients of b^[L]|^2 = (C^L)_{00}; with its
/// spectral radius r the basic limit function lies in H^s for all s < exponent = m - log_arity(r / arity) / 2, and for
/// no larger s where the shifts are stable. All of this is about the reduced mask (reduced_mask.hpp), which has the
/// same exponent and stable shifts; where that has no sum rule it is about the mask itself, and the exponent has no
/// upper end. Ref: [Eir92], [Vil92].
struct SobolevRegularity {
  int sum_rules;
  Enclosure spectral_radius;
  Enclosure exponent;
};

/// Domain: at least one sum rule, N/(arity-1) <= 400. Errors: throws Error. Error: exponent to 1e-15 or better. Cost:
/// one exact characteristic polynomial and its roots.
SobolevRegularity sobolev_regularity(const Mask& mask);
/// Nothing where it would take longer than that.
std::optional<SobolevRegularity> sobolev_regularity(const Mask& mask, const Deadline& deadline);
/// Nothing either for masks whose matrices take more than about a second.
std::optional<SobolevRegularity> sobolev_if_small(const Mask& mask, const Deadline& deadline = {});

}  // namespace subcert
