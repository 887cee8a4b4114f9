// Polytopes with products that attain the joint spectral radius: section 4.10 of ../certificates/SPEC.md.
#pragma once

#include "exact_radius.hpp"
#include "polytope.hpp"

namespace subcert_check {

/// Reads the lines from `cycle` on after those of the polytope, and shows that the joint spectral radius of its family
/// is this number.
void check_attained(const Polytope& body, const ExactRadius& radius, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
