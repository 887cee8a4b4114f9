#pragma once
/// Facts about the surfaces of a scheme at vertices.

#include "fact.hpp"

#include <subcert/analysis/vertex/vertex_smoothness.hpp>
#include <subcert/schemes/specification.hpp>

#include <vector>

namespace subcert::facts {

/// What is proved of a scheme at the vertices of each valence, in a table. Domain: at least one valence.
Facts vertex_facts(const Scheme& scheme, const RegularPart& regular, const std::vector<VertexSmoothness>& valences);

/// Of all these valences: no where it is no for one.
Truth all_of(const std::vector<VertexSmoothness>& valences);

}  // namespace subcert::facts
