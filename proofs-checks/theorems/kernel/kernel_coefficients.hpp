#pragma once
/// The polynomials behind the masks of the least squares schemes, for all large sizes at once, for the sources of this
/// floor. Proofs: docs/theorems/variance-curves.tex, section 7.

#include <subcert/analysis/symbol/numbers/balls.hpp>

#include <vector>

namespace subcert::theorems {

/// Domain: 0 <= k <= n.
Rational binomial(int n, int k);

/// The first `count` coefficients of t/sinh(t) in t^2.
std::vector<Rational> reciprocal_sinc(int count);

/// Of K(t) = sum over l of omega_l(tau) P_l(t), for all tau in [0, last], P_l the Legendre polynomials:
/// omega_l(tau) = limit_l + tau slope_l(tau), and the derivative in tau.
struct KernelCoefficients {
  std::vector<Rational> limit;
  std::vector<Ball> value, slope, derivative;
};

/// The parts of the kernel of one degree with one argument t_0 = y sqrt(tau): even has the even l, odd has the odd l,
/// divided by t_0. Domain: degree >= 0, last < 1/degree^2. Cost: exact, grows like the fourth power of the degree.
struct KernelParts {
  KernelCoefficients even, odd;
};
KernelParts kernel_parts(int degree, const Rational& y, const Rational& last, slong bits);

}  // namespace subcert::theorems
