// The joint spectral subradius: section 4.15 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

#include <optional>

namespace subcert_check {

/// Reads what follows the line `bounds` and shows lower <= joint spectral subradius <= upper, for the ends there are.
/// Domain: no entry of the family is negative.
void read_subradius(const Family& family, const std::optional<mpq_class>& lower, const std::optional<mpq_class>& upper,
                    Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
