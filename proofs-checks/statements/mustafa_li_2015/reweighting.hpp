#pragma once
/// What the curve and the surface part of [MLZD15] have in common.

#include "../reweighted.hpp"

namespace subcert::statements {

/// The weights 1/bracket^exponent belong to the smoothed modulus h(t) = smoothed^smoothed_exponent: w = h'(t)/t for the
/// residual t, as identities in f and the other names.
Trial weights_of_modulus(const Formula& bracket, const Rational& exponent, const Formula& residual,
                         const std::vector<Variable>& names);

/// term = w r^i s^j for the k-th pair (i, j), and the sums run over 2n (even) or 2n+1 consecutive indices about 1/2 or
/// 0.
Trial entries_of_normal_equations(const std::vector<Formula>& terms, const std::vector<std::string>& expected);
Trial summation_range(const Formula& first, const Formula& last, bool even);

}  // namespace subcert::statements
