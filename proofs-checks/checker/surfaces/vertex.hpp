// Smoothness around a vertex, or none: sections 5.11 and 5.14 of ../../certificates/SPEC.md.
#pragma once

#include "sector.hpp"

namespace subcert_check {

/// Reads the lines from `vertex` or `not-c1` on, and rejects unless they prove that the limits of almost all data are
/// C^1 around the vertex, or are not. Domain: two variables, m times the unit matrix; limits of the mask are C^1.
void check_vertex(const Mask& mask, const Dilation& dilation, const SectorRules& rules, bool not_c1, Reader& reader,
                  Arithmetic& arithmetic);

}  // namespace subcert_check
