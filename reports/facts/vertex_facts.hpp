#pragma once
/// Facts about the surfaces of a scheme at vertices.

#include "fact.hpp"
#include "stencil_facts.hpp"

#include <subcert/analysis/vertex/every_valence.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <vector>

namespace subcert::facts {

/// Its name, and what is proved of it away from vertices.
Facts regular_part_facts(const VertexScheme& scheme, const RegularPart& regular);

/// What is proved of a scheme at the vertices of each valence, in a table, of all that follow, and of stencils. Domain:
/// at least one valence; where there is a `rest`, all up to the first of it; stencils of all or of none.
Facts vertex_facts(const VertexScheme& scheme, const RegularPart& regular,
                   const std::vector<VertexSmoothness>& valences,
                   const std::optional<EveryValence>& rest = std::nullopt,
                   const std::vector<StencilsAt>& stencils = {});

/// The table of valences for papers, below names of its columns; all that follow are its last row.
std::vector<std::vector<std::string>> vertex_rows(const std::vector<VertexSmoothness>& valences,
                                                  const std::optional<EveryValence>& rest = std::nullopt);

/// Of all these valences: no where it is no for one.
Truth all_of(const std::vector<VertexSmoothness>& valences, const std::optional<EveryValence>& rest = std::nullopt);

}  // namespace subcert::facts
