#pragma once
/// Bounds of mean and ripple of the variance curves from the responses of the two rules, for the sources of this floor.
/// Proofs: docs/theorems/every-pair.tex, Theorem T; its notation is used.

#include <subcert/analysis/symbol/numbers/balls.hpp>

namespace subcert::theorems {

/// Numbers that the proofs of Theorems P and T round; each stands in an inequality of its own, (P.5) to (P.9) and (T.6)
/// to (T.11).
namespace rounded {
inline const Rational rise(28, 100);        ///< of c^2 v'^2 at pi/2 for odd M, over gamma^2 M
inline const Rational spread(315, 10000);   ///< the mean of (1 - cos w)^2/sin^2 w up to pi/4
inline const Rational cosine(17, 10);       ///< 1 + cos w up to pi/4
inline const Rational envelopes(68, 10);    ///< sum over the octaves of the bounds e_j
inline const Rational constants(171, 100);  ///< the same of the constant
inline const Rational halving(199, 100);    ///< sin w/sin(w/2) up to w_0/2
inline const Rational sine(23, 100);        ///< sin w_0
inline const Rational turning(19, 100);     ///< r at the first zero of v
inline const Rational excess(53, 1000);     ///< epsilon for odd M
inline const Rational gammas(108, 100);     ///< gamma^4 pi^2/(4 nu)
}  // namespace rounded

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
