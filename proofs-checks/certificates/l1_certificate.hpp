#pragma once
/// Certificates of contractions under fits of least absolute deviations. Format: SPEC.md beside this.

#include "certificate.hpp"

#include <subcert/analysis/piecewise/contraction.hpp>
#include <subcert/analysis/piecewise/edge_orbit.hpp>

namespace subcert {

/// Proves the contraction and, where it is one, the lower end of the exponent that follows, and with an orbit an upper
/// one. Domain: `rule` is that of least absolute deviations, the others are of it; the contraction with its trees.
/// Errors: throws Error where trees are missing.
Certificate contraction_certificate(const piecewise::Rule& rule, const piecewise::Contraction& contraction,
                                    const std::optional<piecewise::EdgeOrbit>& edge = std::nullopt);

}  // namespace subcert
