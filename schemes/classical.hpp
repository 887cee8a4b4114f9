#pragma once
/// Classical schemes to compare with.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/masks/parametric_mask.hpp>

#include <functional>
#include <string>
#include <vector>

namespace subcert {

/// (1 + z + ... + z^(arity-1))^(degree+1) / arity^degree, centred at 0 or -1/2. Domain: degree >= 1, arity >= 2.
/// Ref: [CDM91].
Mask bspline_mask(int degree, int arity = 2);

/// Interpolatory 2n-point scheme of Deslauriers and Dubuc. Domain: n >= 1, arity >= 2. Ref: [DD89].
Mask deslauriers_dubuc_mask(int n, int arity = 2);

/// The pseudo-spline of order (m, l): the shortest symmetric mask with 2m sum rules that reproduces polynomials of
/// degree 2l + 1, or 2m - 1 if that is less. For whole m of type II, from the B-spline of degree 2m - 1 (l = 0) to the
/// 2m-point scheme of Deslauriers and Dubuc (l = m - 1); for half an odd number m dual, from the B-spline of degree 2m
/// - 1. With l = 1 the schemes of cubic precision. Domain: 2m whole, 0 <= l < m. Ref: [DS07], [DHSS08], [HS08].
Mask pseudo_spline_mask(const Rational& m, int l);

/// The 4-point scheme with tension w: [-w, 0, 1/2+w, 1, 1/2+w, 0, -w]. Ref: [DLG87].
Mask four_point_mask(const Rational& w);

/// A family of the literature with the parameter w.
struct ClassicalFamily {
  std::string name, title;
  std::string example;                          ///< a value of w
  std::function<const ParametricMask&()> mask;  ///< made when it is asked for the first time
};

/// In the order of docs/schemes.md.
const std::vector<ClassicalFamily>& classical_families();

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
