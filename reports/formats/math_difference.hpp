#pragma once
/// What two formulas do not have in common.

#include "latex_math.hpp"

namespace subcert::formats {

/// Marks the leaves of both as `changed` that are not in common. In common is a longest subsequence of leaves,
/// preferably in long runs, or one of each part where the relations and commas between the parts are the same; leaves
/// are equal with the same symbol in the same kind of place: the index of an exponent, the radicand in a numerator and
/// so on. A few equal leaves between more changed ones are marked, too; all are where only their grouping differs.
/// Cost: the product of the numbers of leaves.
void mark_difference(MathNode& printed, MathNode& corrected);

}  // namespace subcert::formats
