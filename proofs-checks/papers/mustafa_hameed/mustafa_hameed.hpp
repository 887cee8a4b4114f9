#pragma once
/// Mustafa & Hameed [MH], statement by statement. The text that was available has lost its formulas and ends in section
/// 2.3: the forms checked here are derived from the construction that the words describe.

#include <subcert/proofs-checks/statements/paper.hpp>

namespace subcert::statements::mustafa_hameed {

/// What the ids of its statements begin with.
inline const std::string key_prefix = "mustafa-hameed/";

PaperStatements paper();

/// One part of the paper each; `to` grows.
void add_claims(PaperStatements& to);
void add_starting_values(PaperStatements& to);
void add_iteration(PaperStatements& to);

}  // namespace subcert::statements::mustafa_hameed
