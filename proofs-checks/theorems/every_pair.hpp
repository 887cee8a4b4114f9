#pragma once
/// Bounds of mean and ripple of the variance curves from the responses of the two rules, for the sources of this floor.
/// Proofs: docs/theorems/every-degree.tex, Theorem T; its notation is used.

#include <subcert/analysis/symbol/balls.hpp>

namespace subcert::theorems {

/// K_M(0): the central weight of the fit of this degree on M points. Domain: odd degree, odd M or M > degree.
Rational central_weight(int degree, int M);

/// What the mean of psi_n can lie below (K_{2n-1}(0) + K_{2n}(0))/2, and psi_n can deviate from its mean.
struct LargeBounds {
  Ball deficit;  ///< T
  Ball ripple;   ///< Z
};

/// Domain: odd degree >= 5, n >= 60, n >= (degree - 2)^2.
LargeBounds large_bounds(int degree, int n);

/// 2 mean - ceiling <= psi_n <= ceiling, for one scheme.
struct CurveEnds {
  Rational mean;     ///< I_n
  Rational ceiling;  ///< at least U_n
};

/// Domain: odd degree <= 2n - 1. Cost: that of the exact mean. Errors: throws undecided.
CurveEnds curve_ends(int n, int degree);

}  // namespace subcert::theorems
