#pragma once
/// The limits C_d of n * max psi_n for the primal least squares schemes of degree d as n grows, with proved digits.
/// Statements and proofs: docs/limit-constants.md, abbreviated [LC].

#include <subcert/analysis/symbol/numbers/numbers.hpp>

namespace subcert::theorems {

/// The integral of t^order k_d(t) over [-1, 1], where k_d is the Christoffel-Darboux kernel of the Legendre polynomials
/// of degree at most d with one argument 0. Equals 1 for order 0 and 0 for 1 <= order <= d.
/// Domain: 0 <= degree <= 99, 0 <= order <= 1000. Ref: [LC, sec. 1].
Rational kernel_moment(int degree, int order);

/// The Fourier transform of k_d at s. Domain: 0 <= degree <= 99, |s| <= 10^6, 1 <= digits <= 100.
/// Error: width at most 10^-digits. Ref: [LC, Lemma 1].
Enclosure kernel_transform(int degree, const Rational& s, int digits);

/// Phi_d(s), the product over j >= 1 of the transform of k_d at s / 2^j: the Fourier transform of the scaled basic
/// limit function for n to infinity. Domain and error: as kernel_transform. Ref: [LC, Lemma 3].
Enclosure limit_transform(int degree, const Rational& s, int digits);

/// C_d = 1/4 + 1/2 * sum over k >= 1 of Phi_d(k pi)^2. Even degrees have the value of degree + 1, as their schemes do.
/// Domain: 0 <= degree <= 99, 1 <= digits <= 100. Error: width at most 10^-digits. Cost: the number of terms grows
/// like 2^sqrt(3.4 digits). Ref: [LC, thm 5, Lemma 4].
Enclosure limit_constant(int degree, int digits);

/// C_d = 1/(2 pi) * integral of Phi_d^2 over [0, oo), by rigorous quadrature: the same number by another way.
/// Domain, error: as limit_constant, digits <= 60. Ref: [LC, thm 5, Lemma 4], [Joh18].
Enclosure limit_constant_by_quadrature(int degree, int digits);

}  // namespace subcert::theorems
