#pragma once
/// Bounds of mean and ripple of the variance curves from the responses of the two rules, for the sources of this floor.
/// Proofs: docs/theorems/every-degree.tex, Theorem T; its notation is used.

#include <subcert/analysis/symbol/balls.hpp>

namespace subcert::theorems {

/// K_M(0): the central weight of the fit of this degree on M points. Domain: odd degree, odd M or M > degree.
Rational central_weight(int degree, int M);

/// The least n from which on max psi_n of this degree < min psi_n of degree + 2 is proved at once. Domain: degree >= 5.
int large_n(int degree);

/// What the mean of psi_n can lie below (K_{2n-1}(0) + K_{2n}(0))/2, and psi_n can deviate from its mean.
struct LargeBounds {
  Ball deficit;  ///< T
  Ball ripple;   ///< Z
};

/// Domain: odd degree >= 5, n >= 50, n >= 4 degree - 4.
LargeBounds large_bounds(int degree, int n);

/// At least U_n: psi_n <= U_n, and 2 I_n - U_n <= psi_n with its mean I_n. Domain: odd degree <= 2n - 1. Errors: throws
/// undecided.
Rational curve_ceiling(int n, int degree);

}  // namespace subcert::theorems
