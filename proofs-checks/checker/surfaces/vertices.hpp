// Smoothness around vertices of all valences from one on: section 5.12 of ../../certificates/SPEC.md.
#pragma once

#include "hull.hpp"
#include "sector.hpp"

namespace subcert_check {

/// Reads the lines from `vertices` on, and rejects unless they prove that the limits of almost all data are C^1 around
/// the vertices. Domain: rules as check_vertex() has checked them.
void check_vertices(const LatticeMask& mask, const SectorRules& rules, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
