// A parameter that each level takes from the one before: sections 6.5 and 6.10 of ../certificates/SPEC.md, which proves
// each step.
#pragma once

#include "parameter.hpp"
#include "scheme.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace subcert_check {

/// w -> STEP or the root of it, from all values of a range, which may be unbounded; from the level `from` on, or from
/// one that is not said.
struct Recurrence {
  Mask step;  // one coefficient
  bool is_root;
  Range start;
  std::optional<std::size_t> from;
};

/// `[P]/D`, `[P]/(Q)` or `sqrt` before them; LOW..HIGH or LOW..inf; a number or `some`.
Recurrence parse_recurrence(std::string_view step, std::string_view start, std::string_view from, char letter);

/// Rejects unless the lines `level` show that all values come into the range and stay there.
void read_recurrence(const Recurrence& recurrence, const Range& range, Reader& reader, Arithmetic& arithmetic);

/// Masks of a family whose parameter is from a range from some level on and tends to a number, by a recurrence.
struct MasksToLimit {
  Mask family;
  Range range;
  Recurrence recurrence;
  mpq_class limit;

  /// Rejects unless the lines that follow show that all values come into the range, and tend to the limit, and that
  /// there are masks at all of the range. Returns the numbers of the line `exponentials`, if there is one: then values
  /// are the cosines of an angle that is halved from level to level.
  std::vector<std::size_t> read(unsigned arity, Reader& reader, Arithmetic& arithmetic) const;

  /// Rejects unless the masks sum to the arity for all values, and so many factors divide all of them: powers of
  /// 1 + 2 T_j z + z^2 by the numbers of `exponentials`, T_j the Chebyshev polynomial in the parameter, j = 1, 2, ...,
  /// and sum rules.
  void check_factors(unsigned arity, std::size_t count, const std::vector<std::size_t>& exponentials,
                     Arithmetic& arithmetic) const;
};

/// The mask for one value of the parameter, without zeros at its ends. Rejects where there is none.
Mask mask_at(const Mask& family, const mpq_class& value);

}  // namespace subcert_check
