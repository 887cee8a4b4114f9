#pragma once
/// Mustafa & Hameed [MH], statement by statement. The text that was available has lost its formulas and ends in section
/// 2.3: the forms checked here are derived from the construction that the words describe.

#include "../registry.hpp"

namespace subcert::statements {

/// What the ids of its statements begin with.
inline const std::string mustafa_hameed_key = "mustafa-hameed/";

PaperStatements mustafa_hameed();

/// One part of the paper each; `to` grows.
void add_mustafa_hameed_claims(PaperStatements& to);
void add_mustafa_hameed_starting_values(PaperStatements& to);
void add_mustafa_hameed_iteration(PaperStatements& to);

}  // namespace subcert::statements
