// Smoothness around a vertex: section 5.11 of ../../certificates/SPEC.md.
#pragma once

#include "sector.hpp"

namespace subcert_check {

/// Reads the lines from `vertex` on, and rejects unless they prove that the limits of almost all data are C^1 around
/// the vertex. Domain: two variables, m times the unit matrix; limits of the mask are C^1.
void check_vertex(const Mask& mask, const Dilation& dilation, const SectorRules& rules, Reader& reader,
                  Arithmetic& arithmetic);

}  // namespace subcert_check
