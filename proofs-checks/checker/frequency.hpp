// A bound of the joint spectral radius by frequencies: section 4.17 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

namespace subcert_check {

/// Reads a section whose first line has these fields; the bound that it proves of the family of one mask.
mpq_class read_frequency(const Family& family, const Fields& fields, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
