#pragma once
/// Classical schemes to compare with.

#include <subcert/analysis/symbol/mask.hpp>

namespace subcert {

/// (1 + z + ... + z^(arity-1))^(degree+1) / arity^degree, centred at 0 or -1/2. Domain: degree >= 1, arity >= 2.
/// Ref: [CDM91].
Mask bspline_mask(int degree, int arity = 2);

/// Interpolatory 2n-point scheme of Deslauriers and Dubuc. Domain: n >= 1. Ref: [DD89].
Mask deslauriers_dubuc_mask(int n);

/// The 4-point scheme with tension w: [-w, 0, 1/2+w, 1, 1/2+w, 0, -w]. Ref: [DLG87].
Mask four_point_mask(const Rational& w);

}  // namespace subcert
