#pragma once
/// Certificates of smoothness around vertices, or of none.

#include "certificate.hpp"

#include <subcert/analysis/vertex/every_valence.hpp>

namespace subcert {

/// The rules as claims name them.
std::string rules_text(const SectorRules& rules);
/// Those of all valences n >= first.
std::string rules_text(const SectorRuleFamily& family, long first);

/// What certificates need of the mask itself, where derivatives are in hulls of differences or not: then a lower end
/// above 1 with a short proof, if one is found. Domain: a mask of rules at vertices. Cost: that of regularity_of().
MultivariateRegularity regularity_around(const LatticeMask& mask, bool by_hulls, const Budget& budget);

/// That limits of the mask have at least an exponent above 1, and those of almost all data are C^1 around the vertex,
/// or are not. Domain: `regularity` is that of the mask of the rules, `smoothness` that of the rules. Errors: throws
/// Error where nothing above 1 is proved of the mask, smoothness is not decided, and for what the checkers do not read.
Certificate vertex_certificate(const SectorRules& rules, const MultivariateRegularity& regularity,
                               const VertexSmoothness& smoothness);

/// The same around the vertices of all valences n >= smoothness.first. Domain: `smoothness` is that of the family.
/// Errors: as above, and where the derivatives are not in hulls.
Certificate vertex_certificate(const SectorRuleFamily& family, const MultivariateRegularity& regularity,
                               const EveryValence& smoothness);

}  // namespace subcert
