// One spectral radius in place of a joint one: section 4.11 of ../certificates/SPEC.md.
#pragma once

#include "exact_radius.hpp"
#include "scheme.hpp"

namespace subcert_check {

/// What is shown of a family of one mask.
struct SingleRadius {
  mpq_class bound;        // of the joint spectral radius
  std::size_t power = 0;  // with an exact radius: products of length n grow like n^power radius^n
};

/// Reads a section whose first line has these fields. With `exact` it shows that this is the radius.
SingleRadius read_single(const Family& family, const Fields& fields, const ExactRadius* exact, Reader& reader,
                         Arithmetic& arithmetic);

/// Reads a line `recurrence` of a family whose symbol is a sum of squares, shows that this is its joint spectral
/// radius, and returns the power.
std::size_t read_power(const Family& family, const ExactRadius& exact, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
