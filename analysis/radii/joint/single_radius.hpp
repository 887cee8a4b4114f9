#pragma once
/// Joint spectral radii of transition matrices that are one spectral radius: Rioul's method, for any arity.

#include <subcert/analysis/symbol/masks/mask.hpp>

namespace subcert {

/// How the largest coefficient of b(z) b(z^a) ... b(z^(a^(n-1))) grows: between two positive multiples of n^power
/// radius^n. It is a linear recurrence for the vectors C^n e_0, C the central matrix, and the radius its largest real
/// zero.
struct CoefficientGrowth {
  Enclosure radius;  ///< one number exactly where it is rational
  int power = 0;
  LaurentPolynomial recurrence = {};  ///< integer coefficients without a common factor, no negative exponents
};

/// Domain: b(z) = b(1/z), b >= 0 on the unit circle, b(1) > 0; arity >= 2. at most 401 central coefficients.
/// Errors: throws Error. Error: radius to 2^-192. Cost: two characteristic polynomials of the central matrix, one
/// factorisation. Ref: docs/single-radius.md, theorem 2.
CoefficientGrowth central_growth(const LaurentPolynomial& symbol, int arity);

/// The joint spectral radius of the transition matrices T_0, ..., T_{arity-1} of a mask, where its cosine polynomial is
/// proved to be non-negative: then it is the spectral radius of T_letter.
struct SingleRadius {
  Decision applies;  ///< yes, or no with the hypothesis that fails, or unknown where the mask is too long to decide
  CoefficientGrowth growth;
  int letter = 0;
  LaurentPolynomial symbol = {};  ///< of the mask, centred
};

/// Domain: any mask; meant for the divided difference scheme of the largest order, as no lower order does better
/// (docs/single-radius.md, proposition 3). Cost: one Sturm sequence and central_growth. Ref: [Rio92], [FM13], [Mun17].
SingleRadius single_spectral_radius(const Mask& mask);

}  // namespace subcert
