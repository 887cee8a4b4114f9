#pragma once
/// For which values of several weights the limits of a scheme are smooth at a vertex.

#include "weight_range.hpp"

#include <subcert/analysis/symbol/polynomials/cell_map.hpp>

namespace subcert {

/// Decides a property over a box of values of letters by cells that are halved in each of them. Domain: rules with as
/// many letters (letter_stride) as the box has, two or more; 1 <= resolution <= 1024. Errors: as vertex_smoothness(),
/// and throws Error for another resolution. Error: none; what is not decided is left `unknown`. Cost: a proof for each
/// cell. Proof: docs/vertex-rules.md.
CellMap weight_map(const SectorRules& rules, const RegularPart& regular, WeightProperty property, const Box& box,
                   const MapOptions& options);

}  // namespace subcert
