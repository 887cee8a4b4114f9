#pragma once
/// Facts about the surfaces of a scheme at vertices.

#include "fact.hpp"

#include <subcert/analysis/vertex/every_valence.hpp>
#include <subcert/schemes/specification.hpp>

#include <vector>

namespace subcert::facts {

/// What is proved of a scheme at the vertices of each valence, in a table, and of all that follow. Domain: at least one
/// valence; where there is a `rest`, all up to the first of it.
Facts vertex_facts(const Scheme& scheme, const RegularPart& regular, const std::vector<VertexSmoothness>& valences,
                   const std::optional<EveryValence>& rest = std::nullopt);

/// Of all these valences: no where it is no for one.
Truth all_of(const std::vector<VertexSmoothness>& valences, const std::optional<EveryValence>& rest = std::nullopt);

}  // namespace subcert::facts
