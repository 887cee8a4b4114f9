#pragma once
/// Masks whose coefficients are algebraic numbers: rounded, with a proved distance.

#include <subcert/analysis/symbol/mask.hpp>

namespace subcert {

/// A mask with rational coefficients and exact sum rules, and how far it is from the one that is meant.
struct RoundedMask {
  Mask mask;
  MaskRounding rounding;
};

/// The orthonormal scaling function D(2n) of Daubechies with the symbol 2 ((1+z)/2)^n q(z), q(1) = 1, |q|^2 the
/// polynomial of degree n - 1 in sin^2 that makes the shifts orthonormal, and the zeros of q outside of the unit
/// circle. Domain: 1 <= n <= 40. Error: the distance, 2^-(100 + 100 n) or less, proved by balls about the zeros. Ref:
/// [Dau88].
RoundedMask daubechies_mask(int n);

/// The scaling function that is dual to the B-spline of order n and has m sum rules, shortest, with exact coefficients.
/// Domain: n, m >= 1, n + m even. Ref: [CDF92].
Mask dual_spline_mask(int n, int m);

}  // namespace subcert
