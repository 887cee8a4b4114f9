// The joint spectral subradius: section 4.15 of ../certificates/SPEC.md.
#pragma once

#include "exact_radius.hpp"
#include "scheme.hpp"

#include <optional>

namespace subcert_check {

/// What is to be shown of the joint spectral subradius: lower <= it <= upper, and what it is, as far as they are there.
struct Subradius {
  std::optional<mpq_class> lower, upper;
  std::optional<ExactRadius> exact;
};

/// Reads what follows the lines `bounds`, `exact` and `root`, and shows that. Domain: no entry of the family is
/// negative.
void read_subradius(const Family& family, const Subradius& claim, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
