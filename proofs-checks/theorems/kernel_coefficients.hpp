#pragma once
/// The polynomials behind the masks of the least squares schemes, for all large sizes at once, for the sources of this
/// floor. Proofs: docs/theorems/variance-curves.tex, section 7.

#include <subcert/analysis/symbol/balls.hpp>

#include <vector>

namespace subcert::theorems {

/// Domain: 0 <= k <= n.
Rational binomial(int n, int k);

/// The first `count` coefficients of t/sinh(t) in t^2.
std::vector<Rational> reciprocal_sinc(int count);

/// kappa_q(tau), q <= (d-1)/2, for all tau in [0, last], with kappa_q(tau) = kappa_q(0) + tau slope_q(tau), and the
/// derivative in tau.
struct KernelCoefficients {
  std::vector<Rational> limit;  ///< kappa_q(0)
  std::vector<Ball> value, slope, derivative;
};

/// Errors: throws undecided where the system is not proved regular on [0, last].
KernelCoefficients kernel_coefficients(int degree, const Rational& last, slong bits);

}  // namespace subcert::theorems
