#pragma once
/// Bounds of the variance curve of one scheme from its symbol, for the sources of this floor. Proofs:
/// docs/theorems/variance-curves.tex, section 1; its notation is used.

#include <subcert/analysis/symbol/masks/mask.hpp>

namespace subcert::theorems {

/// With I the mean of psi: |psi - I| <= ripple and |psi'| <= slope everywhere. The upper end of ripple or slope is
/// absent where the hypothesis of Proposition 1 is not proved with this many cells.
struct CurveBounds {
  Enclosure mean;
  Enclosure ripple;
  Enclosure slope;
};

/// Domain: binary symmetric mask with two sum rules, cells >= 1 a power of two (of each shell). Errors: throws a
/// domain error. Cost: for 200 coefficients and 16 cells a twentieth of a second.
CurveBounds curve_bounds(const Mask& mask, int cells);

}  // namespace subcert::theorems
