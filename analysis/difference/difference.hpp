#pragma once
/// Sum rules and the schemes for divided differences.

#include <subcert/analysis/symbol/mask.hpp>

namespace subcert {

/// The number of sum rules: the multiplicity of 1 + z + ... + z^(arity-1) in the symbol. Ref: [CDM91], [DL02].
int sum_rules(const Mask& mask);

/// The scheme for the divided differences of this order, with symbol a(z) / ((1 + ... + z^(arity-1)) / arity)^order;
/// its limits are the derivatives of this order. Domain: 0 <= order <= sum_rules(mask). Errors: throws
/// Error. Ref: [DL02, sec. 4].
Mask divided_difference_scheme(const Mask& mask, int order);

/// The maximum norm of the subdivision operator: the largest sum of |a_i| over a coset modulo the dilation.
Rational operator_norm(const Mask& mask);
Rational operator_norm(const LatticeMask& mask);

}  // namespace subcert
