#pragma once
/// What certificates hold of the characteristic map. Inner header.

#include "characteristic_map.hpp"
#include "vertex_smoothness.hpp"

namespace subcert::vertex {

/// Of the map with the eigenvalue lambda of this frequency; nothing where no approximate inverse is found. Domain: the
/// set and the map of the rules.
std::optional<VertexEvidence> evidence_of(const SectorRules& rules, const ClosedSet& set, const CharacteristicMap& map,
                                          long frequency, const Ball& lambda, const BallField& field, bool by_hulls);

}  // namespace subcert::vertex
