#pragma once
/// Certificates of smoothness around vertices.

#include "certificate.hpp"

#include <subcert/analysis/vertex/vertex_smoothness.hpp>

namespace subcert {

/// The rules as claims name them.
std::string rules_text(const SectorRules& rules);

/// That limits of the mask have at least an exponent above 1, and those of almost all data are C^1 around the vertex.
/// Domain: `regularity` is that of the mask of the rules, `smoothness` that of the rules. Errors: throws Error where
/// nothing above 1 is proved of the mask, smoothness is not, or not by hulls, and for what the checkers do not read.
Certificate vertex_certificate(const SectorRules& rules, const MultivariateRegularity& regularity,
                               const VertexSmoothness& smoothness);

}  // namespace subcert
