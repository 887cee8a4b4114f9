#pragma once
/// The mirror symmetry psi(x) = psi(1 - x) of variance curves.

#include <subcert/analysis/limit/limit_cells.hpp>

namespace subcert {

/// Whether the part with this digit of the cell of the form lies in [1/2, 1] and so mirrors one in [0, 1/2].
inline bool is_mirror_image(const CellForm& form, int digit, int arity) {
  std::int64_t count = arity;
  for (int l = 0; l < form.level; ++l) count *= arity;
  return 2 * (form.index * arity + digit) > count - 1;
}

}  // namespace subcert
