#pragma once
/// Certificates of contractions under fits of least absolute deviations. Format: SPEC.md beside this.

#include "certificate.hpp"

#include <subcert/analysis/piecewise/contraction.hpp>

namespace subcert {

/// Proves the contraction and, where it is one, the exponent that follows. Domain: `contraction` with its trees, of the
/// rule of least absolute deviations of this degree on so many points. Errors: throws Error where trees are missing.
Certificate contraction_certificate(int points, int degree, const piecewise::Contraction& contraction);

}  // namespace subcert
