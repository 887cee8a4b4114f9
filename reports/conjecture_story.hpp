#pragma once
/// Conjecture 7 of [DHHS15] told with certified numbers: what was conjectured, what the paper's table suggested, what
/// is true.

#include "computed_quantities.hpp"

namespace subcert::reports {

/// Ref: [DHHS15, sec. 4.3]; proofs: docs/limit-constants.md, docs/theorems/README.md.
formats::Section conjecture_7_section(ComputedQuantities& quantities);

}  // namespace subcert::reports
