#pragma once
/// Mustafa & Hameed [MH], statement by statement. The text that was available has lost its formulas and ends in section
/// 2.3: the forms checked here are derived from the construction that the words describe.

#include <subcert/proofs-checks/statements/statement.hpp>

namespace subcert::statements::mustafa_hameed {

/// Of one part of the paper each.
Checks claims();
Checks starting_values();
Checks iteration();

/// All of them.
inline Checks checks() { return joined({claims(), iteration(), starting_values()}); }

}  // namespace subcert::statements::mustafa_hameed
